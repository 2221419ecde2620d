//! Pictures that are written, read again by their crates and by the reader of maps.

use corput::picture::{Size, exr, png};
use std::io::Cursor;

const SIZE: Size = Size {
    width: 3,
    height: 2,
    channels: 1,
};
const TWO: Size = Size {
    channels: 2,
    ..SIZE
};

fn decode(bytes: &[u8]) -> (::png::OutputInfo, Vec<u8>) {
    let mut reader = ::png::Decoder::new(Cursor::new(bytes))
        .read_info()
        .expect("a PNG");
    let mut data = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut data).expect("a frame");
    data.truncate(info.buffer_size());
    (info, data)
}

fn big_endian(bytes: &[u8]) -> Vec<u16> {
    bytes
        .chunks(2)
        .map(|b| u16::from_be_bytes([b[0], b[1]]))
        .collect()
}

#[test]
fn pngs_keep_all_sixteen_bits() {
    let samples: Vec<u16> = (0..12).map(|i| i * 5461 + 3).collect();
    let (info, data) = decode(&png(SIZE, &samples[..6]).expect("grey"));
    assert_eq!((info.width, info.height), (3, 2));
    assert_eq!(info.color_type, ::png::ColorType::Grayscale);
    assert_eq!(info.bit_depth, ::png::BitDepth::Sixteen);
    assert_eq!(big_endian(&data), samples[..6]);
    let (info, data) = decode(&png(TWO, &samples).expect("two channels"));
    assert_eq!(info.color_type, ::png::ColorType::Rgb);
    let wanted: Vec<u16> = samples.chunks(2).flat_map(|p| [p[0], p[1], 0]).collect();
    assert_eq!(big_endian(&data), wanted);
}

#[test]
fn exrs_keep_every_float() {
    let samples: Vec<f32> = (0..12u8).map(|i| f32::from(i) / 13.0).collect();
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("grey.exr");
    std::fs::write(&path, exr(SIZE, &samples[..6]).expect("grey")).expect("a file");
    let image = corput::image::load_exr(&path).expect("an image");
    assert_eq!((image.width, image.height), (3, 2));
    let wanted: Vec<[f32; 3]> = samples[..6].iter().map(|s| [*s; 3]).collect();
    assert_eq!(image.texels, wanted);

    use ::exr::prelude::{ReadChannels, ReadLayers};
    let bytes = exr(TWO, &samples).expect("two channels");
    let read = ::exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .expect("an image");
    let channels = &read.layer_data.channel_data.list;
    let names: Vec<String> = channels.iter().map(|c| c.name.to_string()).collect();
    assert_eq!(names, ["G", "R"]);
    for (channel, at) in channels.iter().zip([1, 0]) {
        let values: Vec<f32> = channel.sample_data.values_as_f32().collect();
        let wanted: Vec<f32> = samples.iter().skip(at).step_by(2).copied().collect();
        assert_eq!(values, wanted);
    }
}

#[test]
fn the_same_samples_give_the_same_bytes() {
    let samples = [7u16, 9, 11, 13, 15, 17];
    assert_eq!(png(SIZE, &samples).ok(), png(SIZE, &samples).ok());
    let floats = samples.map(f32::from);
    assert_eq!(exr(SIZE, &floats).ok(), exr(SIZE, &floats).ok());
}

#[test]
fn sizes_that_do_not_fit_are_refused() {
    let three = Size {
        channels: 3,
        ..SIZE
    };
    let none = Size { width: 0, ..SIZE };
    for (size, count) in [(SIZE, 5), (SIZE, 7), (TWO, 6), (three, 18), (none, 0)] {
        assert!(png(size, &vec![0; count]).is_err(), "{size:?} {count}");
        assert!(exr(size, &vec![0.0; count]).is_err(), "{size:?} {count}");
    }
}
