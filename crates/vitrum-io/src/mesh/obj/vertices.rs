//! The first pass: everything that faces name.

use super::statements::{Statement, Statements};
use crate::error::Error;
use crate::image::srgb_to_linear;
use crate::mesh::build::Builder;
use crate::mesh::check;
use crate::mesh::words::any_number;

/// The vertex data of a file; positions and colours are in the builder.
#[derive(Debug, Default)]
pub(super) struct Vertices {
    pub normals: Vec<[f32; 3]>,
}

impl Vertices {
    pub fn read(bytes: &[u8], builder: &mut Builder) -> Result<Self, Error> {
        let mut vertices = Self::default();
        let mut weighted = 0;
        let mut statements = Statements::new(bytes);
        while let Some(statement) = statements.next() {
            match statement.keyword {
                b"v" => weighted += usize::from(add_position(builder, &statement)?),
                b"vn" => {
                    // One that cannot be read keeps its number, and is left out where it is named.
                    let mut words = statement.words().map(|word| any_number(word).unwrap_or(f32::NAN));
                    let normal = [0, 1, 2].map(|_| words.next().unwrap_or(f32::NAN));
                    builder.budget.push(&mut vertices.normals, normal)?;
                }
                _ => {}
            }
        }
        check::check_count(builder.report, builder.positions.len())?;
        if weighted > 0 {
            let note = format!("the weights of {weighted} vertices, which are for curves, were left out");
            builder.assumptions.push(note);
        }
        if !builder.colors.is_empty() {
            builder.assumptions.push("the colours of vertices were taken for sRGB, and decoded".to_owned());
        }
        Ok(vertices)
    }
}

/// Adds a vertex. The result says whether it has a weight other than 1.
fn add_position(builder: &mut Builder, statement: &Statement) -> Result<bool, Error> {
    let (numbers, count) = statement.position(builder.report)?;
    let [x, y, z, a, b, c, d, _] = numbers;
    let color = match count {
        6 => Some([a, b, c, 1.0]),
        7 => Some([a, b, c, d]),
        3 | 4 => None,
        _ => {
            builder.left_out.add("vertices' further numbers, neither a weight nor a colour");
            None
        }
    };
    let before = builder.positions.len();
    if color.is_some() || !builder.colors.is_empty() {
        const WHITE: [f32; 4] = [1.0; 4];
        while builder.colors.len() < before {
            builder.budget.push(&mut builder.colors, WHITE)?;
        }
        let [r, g, b, alpha] = color.unwrap_or(WHITE);
        let [r, g, b] = [r, g, b].map(|channel| srgb_to_linear(channel.clamp(0.0, 1.0)));
        builder.budget.push(&mut builder.colors, [r, g, b, alpha])?;
    }
    builder.budget.push(&mut builder.positions, [x, y, z])?;
    Ok(count == 4 && a != 1.0)
}
