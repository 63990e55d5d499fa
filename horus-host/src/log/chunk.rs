use mcap::{
    McapError,
    records::op,
    sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions},
};

use super::record;

/// Why a chunk could not be opened or read.
pub(super) enum ChunkError {
    /// The container crate refused it.
    Mcap(McapError),
    /// Its fields contradict each other.
    Malformed(record::Malformed),
}

/// Yields the records inside chunks, one chunk after the other.
///
/// A chunk is taken whole and its checksum verified before its first record comes out. Its lengths
/// are checked before the container crate sees it, because that subtracts the lengths of records
/// in an uncompressed chunk without looking.
pub(super) struct ChunkReader {
    reader: LinearReader,
    limit: usize,
    is_open: bool,
}

impl ChunkReader {
    /// A reader for chunks of at most `limit` bytes, compressed or not.
    pub fn new(limit: usize) -> Self {
        let options = LinearReaderOptions::default()
            .with_skip_start_magic(true)
            .with_skip_end_magic(true)
            .with_prevalidate_chunk_crcs(true)
            .with_record_length_limit(limit);
        Self {
            reader: LinearReader::new_with_options(options),
            limit,
            is_open: false,
        }
    }

    /// Takes the chunk record `chunk` (without opcode and length).
    pub fn open(&mut self, chunk: &[u8]) -> Result<(), ChunkError> {
        let header = record::chunk(chunk).map_err(ChunkError::Malformed)?;
        if usize::try_from(header.uncompressed_size).map_or(true, |size| size > self.limit) {
            return Err(ChunkError::Mcap(McapError::ChunkTooLarge(
                header.uncompressed_size,
            )));
        }
        if !header.is_compressed && !record::are_whole_records(header.records) {
            return Err(ChunkError::Malformed(
                "the records of a chunk do not fill it exactly",
            ));
        }
        let len = record::PREFIX_LEN + chunk.len();
        let buffer = self.reader.insert(len);
        buffer[0] = op::CHUNK;
        buffer[1..record::PREFIX_LEN].copy_from_slice(&(chunk.len() as u64).to_le_bytes());
        buffer[record::PREFIX_LEN..len].copy_from_slice(chunk);
        self.reader.notify_read(len);
        self.is_open = true;
        Ok(())
    }

    /// The next record of the open chunk: opcode and fields. `None` if it has no more.
    pub fn next(&mut self) -> Option<Result<(u8, &[u8]), McapError>> {
        if !self.is_open {
            return None;
        }
        match self.reader.next_event()? {
            Ok(LinearReadEvent::Record { opcode, data }) => Some(Ok((opcode, data))),
            // The chunk was given whole, so a request for bytes asks for the one after it.
            Ok(LinearReadEvent::ReadRequest(_)) => {
                self.is_open = false;
                None
            }
            Err(error) => Some(Err(error)),
        }
    }
}
