use horus_core::distance::{DistanceBuffers, DistanceCell, DistanceMap, EnvelopeVertex};
use horus_core::evidence::{
    self, BeamLimits, BinaryMap, BinaryThresholds, EvidenceF32, EvidenceFusion, EvidenceU8, EvidenceU16,
    Flatscan, FusionOperator, FusionRule, Inpaint, InpaintFrame, Lattice, LocalMapping, LocalMappingBuffers,
    LocalMappingConfig, MappingBuffers, MassCell, Masses, SensorConfig, SensorGrid, SensorModel, SensorScan,
    class_bytes,
};
use horus_core::prelude::*;
use horus_footprint::{need, opaque};

/// Evidence grids of every cell, with every type of distances.
pub fn call(ranges: &[f32]) {
    let masses = opaque(Masses::new(opaque(0.1), opaque(0.2), opaque(0.7)));
    let Ok(masses) = masses.and(Masses::known(opaque(0.1), opaque(0.2))) else {
        return;
    };
    need((masses.free(), masses.occupied(), masses.uncertain()));
    need((masses.pignistic(), masses.occupancy(opaque(0.5))));
    need(LocalMappingBuffers::<4, 8, 8, 2, 4>::empty().split());
    of::<EvidenceU16, u16>(masses, ranges);
    of::<EvidenceU8, u32>(masses, ranges);
    of::<EvidenceF32, i16>(masses, ranges);
    of::<EvidenceU16, i32>(masses, ranges);
    let steps = |cell: EvidenceU16| (cell.free_steps(), cell.occupied_steps());
    need(opaque(EvidenceU16::from_steps(opaque(3), opaque(4))).map(steps));
}

fn of<M: MassCell, D: DistanceCell>(masses: Masses, ranges: &[f32]) {
    let cell = M::from_masses(masses);
    need((cell.masses(), cell.is_vacuous()));
    let lattice = Lattice::new(
        opaque(4),
        opaque(3),
        opaque(0.5),
        opaque([-0.5; 2]),
        opaque("odom"),
    );
    let Ok(lattice) = opaque(lattice) else { return };
    need((lattice.validate(), lattice.info(), lattice.cells()));
    need((
        lattice.index(opaque(1), opaque(2)),
        lattice.center(opaque(1), opaque(2)),
    ));
    let operator = opaque("pcr6")
        .parse()
        .unwrap_or(opaque(FusionOperator::JosangAverage));
    need(operator.as_str());
    let rule = opaque(FusionRule::new(operator));
    need((rule.validate(), M::supports(rule)));
    let scan = opaque(Flatscan {
        angles: opaque(ranges),
        ranges,
        invalid_range_threshold: 0.1,
        out_of_range_threshold: 8.0,
        visibilities: opaque(Some(ranges)),
    });
    let model = opaque(SensorModel {
        m_free: masses,
        ..SensorModel::default()
    });
    need((scan.validate(), model.validate()));

    let (one, two) = (&mut opaque([cell; 12])[..], &mut opaque([cell; 12])[..]);
    need(evidence::fuse(rule, opaque(&mut *one), opaque(two)));
    let pose = opaque(Pose2D::new(1.0, 2.0, 3.0));
    need(evidence::resample(
        opaque(one),
        &lattice,
        opaque(two),
        &opaque(lattice),
        pose,
    ));
    let limits = &mut opaque([BeamLimits::EMPTY; 360])[..];
    need(evidence::scan_to_evidence(
        &scan,
        pose,
        &lattice,
        &model,
        opaque(&mut *limits),
        opaque(two),
    ));
    need(evidence::evidence_to_occupancy(
        opaque(one),
        opaque(0.5),
        &mut opaque([0i8; 12])[..],
    ));
    let classes = &mut opaque([0u8; 64])[..];
    need(class_bytes(opaque(3), opaque(4)));
    fusion(opaque(one), (lattice, model, rule), &scan, classes, limits);
    let distance = DistanceBuffers {
        cells: &mut opaque([D::default(); 12])[..],
        vertices: &mut opaque([EnvelopeVertex::EMPTY; 12])[..],
    };
    binary(one, distance);
    let distance = DistanceBuffers {
        cells: &mut opaque([D::default(); 12])[..],
        vertices: &mut opaque([EnvelopeVertex::EMPTY; 12])[..],
    };
    let buffers = MappingBuffers {
        cells: opaque(one),
        classes,
        limits,
        binary: &mut opaque([0u32; 8])[..],
        distance,
    };
    mapping(buffers, (lattice, model, rule, masses), scan);
}

fn fusion<M: MassCell>(
    cells: &mut [M],
    (lattice, model, rule): (Lattice, SensorModel, FusionRule),
    scan: &Flatscan<'_>,
    classes: &mut [u8],
    limits: &mut [BeamLimits],
) {
    let pose = opaque(Pose2D::new(1.0, 2.0, 3.0));
    let seen = &opaque([M::VACUOUS; 12])[..];
    let Ok(mut fused) = EvidenceFusion::new_in(cells, lattice, rule) else {
        return;
    };
    let Ok(mut sensor) = SensorGrid::new_in(classes, lattice, model) else {
        return;
    };
    need((sensor.lattice().rows, sensor.model().wall_thickness));
    need(sensor.project(scan, pose, limits));
    let class = sensor.class(opaque(1), opaque(2));
    need((class.masses(&model), sensor.cell::<M>(opaque(1), opaque(2))));
    need(fused.fuse(&sensor, pose));
    sensor.clear();
    need(fused.fuse_evidence(opaque(seen), &lattice, pose));
    need(fused.recenter(pose));
    need((fused.info().width(), fused.rule(), fused.cells().len()));
    let (gx, gy) = (opaque(1), opaque(2));
    need((
        fused.cell_at(gx, gy),
        fused.masses_at(gx, gy),
        fused.masses(opaque(0.1), opaque(0.2)),
    ));
    need(fused.load(opaque(seen)));
    fused.clear();
}

fn binary<M: MassCell, D: DistanceCell>(cells: &[M], distance: DistanceBuffers<'_, D>) {
    let thresholds = opaque(BinaryThresholds::default());
    need(thresholds.validate());
    let words = &mut opaque([0u32; 8])[..];
    let Ok(mut binary) = BinaryMap::new_in(words, opaque(4), opaque(3)) else {
        return;
    };
    need(binary.take(opaque(cells), thresholds));
    need((binary.width(), binary.height(), binary.words().len()));
    need((
        binary.is_occupied(opaque(1), opaque(2)),
        binary.row(opaque(1)).last(),
    ));
    let mut distance = DistanceMap::new_in(opaque(distance));
    need(evidence::binary_to_distance(
        &binary,
        opaque(0.5),
        opaque(2.0),
        &mut distance,
    ));
}

fn mapping<M: MassCell, D: DistanceCell>(
    buffers: MappingBuffers<'_, M, D>,
    (lattice, model, rule, masses): (Lattice, SensorModel, FusionRule, Masses),
    scan: Flatscan<'_>,
) {
    let pose = opaque(Pose2D::new(1.0, 2.0, 3.0));
    let sensors = opaque(
        [SensorConfig {
            lattice,
            mount: pose,
            model,
        }; 2],
    );
    let inpaint = opaque(
        [Inpaint {
            frame: InpaintFrame::World,
            x: [0.0, 1.0],
            y: [0.0, 1.0],
            masses,
        }; 2],
    );
    let config = LocalMappingConfig {
        lattice,
        rule,
        sensors: opaque(&sensors[..]),
        inpaint: opaque(&inpaint[..]),
        thresholds: opaque(BinaryThresholds::default()),
        max_distance: opaque(2.0),
    };
    need((config.validate(), sensors[0].validate(), inpaint[0].validate()));
    let Ok(mut map) = LocalMapping::new_in(buffers, config) else {
        return;
    };
    let scans = opaque([SensorScan { sensor: 0, scan }; 2]);
    need(map.tick(opaque(&scans[..]), pose));
    need(map.tick_within(opaque(&scans[..]), pose, opaque(3)));
    let (gx, gy) = (opaque(1), opaque(2));
    need((
        map.config().max_distance,
        map.info().width(),
        map.evidence().cells().len(),
    ));
    need((map.inpainted_at(gx, gy), map.binary().is_occupied(gx, gy)));
    need((map.distance().metres_at(gx, gy), map.distance_info().height()));
    need((map.class_at(gx, gy), map.last_sensor()));
}
