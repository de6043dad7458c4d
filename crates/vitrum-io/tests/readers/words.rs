//! Words that are worth putting into a file.

/// Words of a format, in the form that they have in its files.
#[rustfmt::skip]
pub fn words(target: &str) -> &'static [&'static str] {
    match target {
        "nrrd" => &[
            "type:", "sizes:", "dimension:", "encoding:", "endian:", "space:", "space directions:", "space origin:",
            "spacings:", "units:", "kinds:", "centerings:", "byte skip:", "line skip:", "data file:", "LIST", "none",
            "left-posterior-superior", "raw", "gzip", "bzip2", "hex", "text", "block", "NaN", "%d", "..", "/",
        ],
        "metaimage" => &[
            "NDims =", "DimSize =", "ElementType =", "ElementDataFile =", "ElementSpacing =", "Offset =", "HeaderSize =",
            "TransformMatrix =", "CompressedData =", "CompressedDataSize =", "ElementNumberOfChannels =", "LOCAL", "LIST",
            "True", "MET_DOUBLE", "AnatomicalOrientation =", "RAI", "%03d", "..", "-1",
        ],
        "numpy" => &[
            "'descr':", "'fortran_order':", "'shape':", "True", "False", "<f2", "|b1", "{", "(", "[", ",)",
        ],
        "vti" => &[
            "<!DOCTYPE a [<!ENTITY b \"c\">]>", "&b;", "&#0;", "&lt;", "<![CDATA[", "]]>", "<!--", "-->", "<Piece",
            "Extent=", "WholeExtent=", "Direction=", "NumberOfComponents=", "RangeMin=", "<FieldData>", "<DataArray",
            "encoding=\"base64\"", "encoding=\"raw\"", "format=\"appended\"", "offset=", "header_type=\"UInt64\"",
        ],
        "pvd" => &["<DataSet", "timestep=", "part=", "file=\"b.vti\"", "file=\"../b.vti\"", "<Collection>", "nan", "1e999"],
        "transfer" => &[
            "RGBPoints", "Points", "ColorSpace", "Diverging", "Lab", "HSV", "Step", "IndexedColors", "Annotations", "volumeProperties",
            "components", "scalarOpacity", "rgbTransferFunction", "midpoint", "sharpness", "<ColorMap", "<Point", "x=", "Value=", "MidPoint=",
            "<Proxy", "lookup_tables", "piecewise_functions", "<Property", "<Element", "value=", "<VolumeProperty", "colorTransfer=",
            "<GradientOpacity>", "nan", "1e999", "-1e38", "<!DOCTYPE",
        ],
        "vtk" => &[
            "DATASET", "STRUCTURED_POINTS", "DIMENSIONS", "ORIGIN", "SPACING", "ASPECT_RATIO", "POINT_DATA", "CELL_DATA",
            "SCALARS", "LOOKUP_TABLE", "FIELD", "METADATA", "VECTORS", "ASCII", "BINARY", "double", "vtktypeint64",
        ],
        "obj" => &[
            "v ", "vn ", "vt ", "f ", "g ", "o ", "s off", "usemtl ", "mtllib ", "\\\n", "//", "#", "-1", "l ",
        ],
        "mtl" => &[
            "newmtl ", "Kd ", "Ks ", "Tf ", "Tr ", "Ni ", "Pr ", "d ", "map_Kd ", "illum ", "spectral", "xyz",
        ],
        "ply" => &[
            "element vertex", "element face", "element tristrips", "property list uchar int vertex_indices", "property",
            "property float nx", "property uchar red", "format ascii 1.0", "format binary_big_endian 1.0", "comment",
            "end_header", "double", "int16", "-1",
        ],
        "stl" => &[
            "solid", "facet normal", "outer loop", "vertex", "endloop", "endfacet", "endsolid", "COLOR=",
        ],
        "gltf" => &[
            "\"nodes\":[0]", "\"children\":[0]", "\"matrix\":", "\"scale\":[1,1,0]", "\"mesh\":0", "\"mode\":5",
            "\"sparse\":{", "\"byteStride\":", "\"byteOffset\":", "\"normalized\":true", "\"componentType\":5120",
            "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]", "\"uri\":\"../a\"", "\"NORMAL\":0",
            "\"COLOR_0\":0", "\"material\":0", "18446744073709551615", "1e999", "%2e%2e/", "[[[[[[[[",
        ],
        "hdr" => &[
            "FORMAT=32-bit_rle_rgbe\n", "EXPOSURE=", "-Y ", "+X ", "\n\n", "COLORCORR=",
        ],
        "exr" => &[
            "channels\0chlist\0", "compression\0compression\0", "dataWindow\0box2i\0", "tiles\0tiledesc\0",
        ],
        "png" => &[
            "IHDR", "IDAT", "PLTE", "tRNS", "iCCP", "zTXt", "acTL", "fcTL", "fdAT", "IEND",
        ],
        _ => &[],
    }
}
