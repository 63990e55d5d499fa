//! Sequences that are as long as the input allows, or short.

use arbitrary::{Arbitrary, Result, Unstructured};

/// As many elements as the rest of the input makes.
#[derive(Clone, Debug)]
pub struct Rest<T>(pub Vec<T>);

impl<'a, T: Arbitrary<'a>> Arbitrary<'a> for Rest<T> {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let mut elements = Vec::new();
        while !u.is_empty() {
            elements.push(u.arbitrary()?);
        }
        Ok(Self(elements))
    }
}

/// At most `MAX` elements.
#[derive(Clone, Debug)]
pub struct Short<T, const MAX: u8>(pub Vec<T>);

impl<'a, T: Arbitrary<'a>, const MAX: u8> Arbitrary<'a> for Short<T, MAX> {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let count = u.arbitrary::<u8>()? % (MAX + 1);
        (0..count).map(|_| u.arbitrary()).collect::<Result<_>>().map(Self)
    }
}
