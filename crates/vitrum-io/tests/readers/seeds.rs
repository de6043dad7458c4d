//! Whole files of every format, which mutations start from.

use std::fs;
use std::io::Write;

use zip::CompressionMethod;

use vitrum_io::{Picture, WriteOptions, write_picture_with};

use crate::common::dicom::{
    Dicom, FRAMES, JPEG, JPEG_2000, JPEG_2000_WORDS, JPEG_LS, JPEG_LS_WORDS, LOSSLESS, POSITION, RLE, element, rle,
};
use crate::common::mesh::{cuboid, files, glb, globe, gltf};
use crate::common::tiff::{Page, Value, stack_u8, tiff};
use crate::common::vtk::{LITTLE, appended, base64, vti, vti_text, vtk, word, zlib_blocks};
use crate::common::{Folder, NiftiHeader, attached, gzip, hex, metaimage, npy, npy_with, npz, nrrd, zlib};

/// The files of a target.
pub fn seeds(target: &str) -> Vec<Vec<u8>> {
    match target {
        "nrrd" => nrrd_files(),
        "nifti" => nifti_files(),
        "metaimage" => metaimage_files(),
        "numpy" => vec![
            npy(">i2", &[1; 24]),
            npy("<f8", &[0; 96]),
            npy_with((2, 0), "{'descr': '<f4', 'fortran_order': True, 'shape': (3, 2, 2)}", &[1; 48]),
            npy_with((3, 0), "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 2, 3)}", &[1; 12]),
            npy_with((1, 0), "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 2, 2, 3)}", &[1; 24]),
        ],
        "npz" => {
            let arrays = [npy("<f2", &[1; 24]), npy("|u1", &[1; 12])];
            let archive = |packing| npz(&[("a.npy", packing, &arrays[0]), ("b.npy", packing, &arrays[1])]);
            vec![archive(CompressionMethod::Stored), archive(CompressionMethod::Deflated)]
        }
        "vti" => vti_files(),
        "vtk" => vec![
            vtk("ASCII", "short", b"1 2 3 4 5 6 7 8 9 10 11 12"),
            vtk("BINARY", "float", &[1; 48]),
            vtk("BINARY", "unsigned_char 1", &[1; 12]),
        ],
        "pvd" => vec![
            b"<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0\" part=\"0\" file=\"b.vti\"/></Collection></VTKFile>".to_vec(),
            b"<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"2\" file=\"a.vti\"/><DataSet file=\"b.vti\"/></Collection></VTKFile>"
                .to_vec(),
        ],
        "transfer" => transfers(),
        "stack" => stacks(),
        "dicom" => dicom_files(),
        "raw" => vec![
            b"_3x2x2_uint8.raw\nabcdefghijkl".to_vec(),
            b"_3x2x2_int16_le.raw\nabcdefghijklabcdefghijkl".to_vec(),
            [&b"_3x2x2_float32_be.bin.gz\n"[..], &gzip(&[1; 48])].concat(),
        ],
        "mtl" => {
            vec![b"newmtl a\nKd 1 0.5 0\nd 0.5\nNi 1.5\nTf 1 1 0\nPr 0.1\nnewmtl b\nTr 0.5\nmap_Kd a.png\n".to_vec()]
        }
        "obj" | "ply" | "stl" | "gltf" => meshes(target),
        "hdr" | "exr" | "png" | "jpeg" | "tiff" => pictures(target),
        other => panic!("{other} has no seeds"),
    }
}

fn nrrd_files() -> Vec<Vec<u8>> {
    let more = "endian: big\nspace: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (1,2,3)\n\
                space units: \"mm\" \"mm\" \"mm\"\nkinds: domain domain domain\n";
    vec![
        attached(&nrrd("int16", "raw", more), &[1; 24]),
        attached(&nrrd("float", "gzip", more), &gzip(&[1; 48])),
        attached(&nrrd("uint8", "text", "spacings: 1 2 3\n"), b"1 2 3 4 5 6 7 8 9 10 11 12"),
        attached(&nrrd("uint8", "hex", "byte skip: 0\nline skip: 0\n"), &hex(&[9; 12])),
        nrrd("uint8", "raw", "data file: slice%d 1 2 1 2\n").into_bytes(),
        nrrd("uint8", "raw", "data file: LIST\nslice1\nslice2\n").into_bytes(),
        nrrd("uint8", "raw", "byte skip: -1\ndata file: a.bin\n").into_bytes(),
        attached(&nrrd("uint8", "gzip", "byte skip: -1\n"), &[&gzip(&[1; 20])[..], &[0; 9]].concat()),
    ]
}

fn nifti_files() -> Vec<Vec<u8>> {
    let first = NiftiHeader::new(4, 2, false);
    vec![
        first.with(&[1; 24]),
        gzip(&first.with(&[1; 24])),
        NiftiHeader::second(4, 2, true).with(&[1; 24]),
        first.pair().bytes,
        NiftiHeader::second(2, 1, false).pair().bytes,
        NiftiHeader::new(2, 1, false).i16(40, 4).i16(48, 2).with(&[1; 24]),
    ]
}

fn metaimage_files() -> Vec<Vec<u8>> {
    let placed = "BinaryDataByteOrderMSB = True\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 1 2 3\n\
                  ElementSpacing = 1 2 3\nHeaderSize = 0\n";
    vec![
        attached(&metaimage("MET_SHORT", placed, "LOCAL"), &[1; 24]),
        attached(&metaimage("MET_FLOAT", "CompressedData = True\nCompressedDataSize = 9\n", "LOCAL"), &zlib(&[1; 48])),
        attached(&metaimage("MET_UCHAR", "BinaryData = False\n", "LOCAL"), b"1 2 3 4 5 6 7 8 9 10 11 12"),
        metaimage("MET_UCHAR", "HeaderSize = -1\n", "slice%d 1 2 1").into_bytes(),
        metaimage("MET_UCHAR", "", "LIST 2\nslice1\nslice2").into_bytes(),
        attached(
            &metaimage("MET_UCHAR", "", "LOCAL").replace("NDims = 3", "NDims = 4").replace("3 2 2", "3 2 2 2"),
            &[1; 24],
        ),
    ]
}

fn vti_files() -> Vec<Vec<u8>> {
    let (header, data) = zlib_blocks(&[1; 24], 10, 8, false);
    let file = format!("{LITTLE} header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"");
    let plain = base64(&[word(24, 4, true), vec![1; 24]].concat());
    vec![
        vti_text().into_bytes(),
        vti("byte_order=\"BigEndian\"", "type=\"Int16\" format=\"binary\"", &plain, b""),
        vti(&file, "type=\"Int16\" format=\"binary\"", &(base64(&header) + &base64(&data)), b""),
        vti(&file, "type=\"UInt16\" format=\"appended\" offset=\"0\"", "", &appended("raw", &[header, data].concat())),
    ]
}

/// A transfer function in each form.
fn transfers() -> Vec<Vec<u8>> {
    let texts = [
        "1\n1\n0.9\n0.1\n0.2\n10\n4 0 0 100 0.5\n4 0 1 255 1\n8 0 0 0 0 200 1 0.5 0.25\n",
        "<MRML><VolumeProperty name=\"a\" gradientOpacity=\"2 0 1\" scalarOpacity=\"2 7 1\" colorTransfer=\"4 7 1 1 1\"/></MRML>",
        "<ColorMap name=\"a\" space=\"Lab\"><Point x=\"0\" o=\"0\" r=\"0\" g=\"0\" b=\"0\"/><Point x=\"1\" o=\"1\" r=\"1\" g=\"0\" b=\"1\"/></ColorMap>",
        "<a><ColorTransferFunction ColorSpace=\"3\"><Point X=\"0\" Value=\"0 0 1\"/><Point X=\"2\" Value=\"1 0 0\" MidPoint=\"0.2\" Sharpness=\"0.5\"/>\
         </ColorTransferFunction><PiecewiseFunction><Point X=\"0\" Value=\"0\"/></PiecewiseFunction></a>",
        "<a><Proxy group=\"lookup_tables\"><Property name=\"RGBPoints\"><Element value=\"0\"/><Element value=\"0\"/><Element value=\"0\"/>\
         <Element value=\"0\"/></Property></Proxy></a>",
        "{\"volumeProperties\":[{\"components\":[{\"scalarOpacity\":{\"points\":[{\"x\":0,\"y\":0,\"midpoint\":0.5,\"sharpness\":0.5}]},\
         \"rgbTransferFunction\":{\"points\":[{\"x\":0,\"color\":[0,0,1]}]}}]}]}",
        "[{\"ColorSpace\":\"HSV\",\"RGBPoints\":[0,0,0,0,1,1,0,0],\"Points\":[0,0,0.5,0,1,1,0.5,0]}]",
        "{\"IndexedColors\":[1,0,0,0,0,1],\"Annotations\":[\"3\",\"a\",\"5\",\"b\"]}",
        "x a\n0 0\n1 0.5\n0 0 0 0\n1 255 0 0\n",
    ];
    texts.map(|text| text.as_bytes().to_vec()).into()
}

fn stacks() -> Vec<Vec<u8>> {
    let packed = Page::new(16, 2, &zlib(&[1; 12])).set(259, Value::Short(8));
    let noted = Page::new(32, 3, &[1; 24]).set(270, Value::Text("ImageJ=1.51n\nimages=2\nunit=mm\nspacing=8.8\n"));
    let noted = noted.set(282, Value::Rational(2, 1)).set(283, Value::Rational(2, 1)).set(296, Value::Short(3));
    let tiles = Page::bytes(&[1; 256]).without(273).without(278).without(279);
    let tiles = tiles.set(322, Value::Long(16)).set(323, Value::Long(16));
    let tiles = tiles.set(324, Value::Long(8)).set(325, Value::Long(256));
    let palette = Page::bytes(&[1; 6]).set(262, Value::Short(3));
    let in_strips = Page::bytes(&[1; 256]).without(278).set(322, Value::Long(16)).set(323, Value::Long(16));
    let behind = Page::new(16, 1, &[1; 36]).set(279, Value::Long(12));
    let behind = behind.set(270, Value::Text("ImageJ=1.11a\nimages=3\nslices=3\nc0=-32768\nc1=1\n"));
    let ome = "<OME><Image><Pixels DimensionOrder=\"XYZCT\" SizeC=\"2\" PhysicalSizeX=\"0.5\"><Channel Name=\"a\"/></Pixels></Image></OME>";
    let microscope = Page::bytes(&[1; 6]).set(270, Value::Text(ome));
    vec![
        stack_u8(|page| page),
        tiff(true, &[packed.clone(), packed]),
        tiff(true, &[noted]),
        tiff(false, &[tiles]),
        tiff(false, &[palette]),
        tiff(true, &[in_strips]),
        tiff(true, &[behind]),
        tiff(false, &[microscope.clone(), microscope]),
    ]
}

/// Every way to write pixels.
fn dicom_files() -> Vec<Vec<u8>> {
    let mut run_lengths = Dicom::words(0.0, &[], true);
    run_lengths.compressed(RLE, vec![rle(&[vec![1; 6], vec![2; 6]])]);
    let mut picture = Dicom::words(0.0, &[], false);
    picture.compressed(LOSSLESS, vec![JPEG.to_vec()]);
    let newer = [(JPEG_LS, JPEG_LS_WORDS.to_vec()), (JPEG_2000, JPEG_2000_WORDS.to_vec())].map(|(syntax, picture)| {
        let mut file = Dicom::words(0.0, &[], false);
        file.compressed(syntax, vec![picture]);
        file
    });
    let mut frames = Dicom::slice(0.0, &[1; 12]);
    frames.text(FRAMES, "IS", "2").remove(POSITION);
    let plain = [Dicom::slice(0.0, &[1, 2, 3, 4, 5, 6]), Dicom::words(1.0, &[1, 2, 3, 4, 5, 6], true)];
    let mut files: Vec<Vec<u8>> =
        plain.into_iter().chain([run_lengths, picture, frames]).chain(newer).map(|file| file.bytes()).collect();
    // Without a preamble, and deflated as a whole.
    let whole = files[0].clone();
    files.push(whole[132..].to_vec());
    let data_set = whole.windows(4).position(|window| window == [8, 0, 0x60, 0]).map_or(132, |start| start);
    let mut stream = flate2::write::DeflateEncoder::new(Vec::new(), flate2::Compression::default());
    let packed = stream.write_all(&whole[data_set..]).and_then(|()| stream.finish()).unwrap_or_default();
    let syntax = element((2, 0x10), "UI", b"1.2.840.10008.1.2.1.99");
    files.push([&[0; 128][..], b"DICM", &syntax, &packed].concat());
    files
}

fn meshes(target: &str) -> Vec<Vec<u8>> {
    let of = |shape| files(&shape).into_iter();
    let all = of(cuboid([0.0; 3], [1.0; 3])).chain(of(globe(1.0, 4, 3)));
    let end = |name: &str| name.ends_with(target) || target == "gltf" && name.ends_with("glb");
    let mut all: Vec<_> = all.filter(|(name, _)| end(name)).map(|(_, file)| file).collect();
    match target {
        "obj" => all.push(
            b"mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv .1 .1 0\nvn 0 0 1\nvt 0 0\nusemtl a\n\
              f 1/1/1 2//-1 3 4\nl 1 2\nf -4 -3 \\\n-2\n"
                .to_vec(),
        ),
        "ply" => all.push(
            b"ply\nformat ascii 1.0\nelement tristrips 1\nproperty list uchar int vertex_index\nelement vertex 4\n\
              property double x\nproperty double y\nproperty double z\nproperty uchar red\nproperty uchar green\n\
              property uchar blue\nend_header\n6 0 1 2 -1 3 2\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n1 1 0 1 2 3\n"
                .to_vec(),
        ),
        "gltf" => {
            let (json, data) = gltf(&cuboid([0.0; 3], [1.0; 3]));
            let sparse = r#""count":8,"sparse":{"count":1,"indices":{"bufferView":1,"componentType":5125},"values":{"bufferView":0}}"#;
            all.push(glb(&json.replace("URI", "").replace(r#""count":8"#, sparse), &data));
            all.push(json.replace("URI", r#""uri":"a.bin","#).into_bytes());
        }
        _ => {}
    }
    all
}

fn pictures(target: &str) -> Vec<Vec<u8>> {
    let folder = Folder::new();
    let extension = match target {
        "jpeg" => "jpg",
        "tiff" => "tif",
        other => other,
    };
    let pixels: Vec<_> = (0..64).map(|index| [index as f32 / 64.0, 0.5, 2.0, 0.25]).collect();
    let opaque = pixels.iter().map(|&[r, g, b, _]| [r, g, b]).collect();
    let mut all = Vec::new();
    for (index, picture) in [Picture::rgb(8, 8, opaque), Picture::rgba(8, 8, pixels)].into_iter().enumerate() {
        let path = folder.path(&format!("{index}.{extension}"));
        let options = WriteOptions { png_bits: if index == 0 { 8 } else { 16 }, ..WriteOptions::default() };
        let text = [("note".to_owned(), "a seed".to_owned())];
        write_picture_with(&path, &picture, &text, &options).expect("a written picture");
        all.push(fs::read(path).expect("a written picture"));
    }
    all
}
