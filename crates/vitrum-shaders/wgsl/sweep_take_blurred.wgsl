struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_18 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_18,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_19,
member_8: type_20,
member_9: type_20,
member_10: type_21,
member_11: type_22,
member_12: type_14,
member_13: type_19,
member_14: type_4,
member_15: type_9,
member_16: type_23,
member_17: type_23,
member_18: type_23,
member_19: type_23,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_25 {
member: type_24,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(2)
var<storage, read_write> global_2: type_16;
@group(0) @binding(1)
var<storage> global_3: type_16;
fn function_() {
let _e23 = global;
let _e30 = global_1.member.member_2;
let _e33 = global_1.member.member;
let _e41 = (_e23.x + _e30.member);
let _e43 = (_e23.y + _e30.member_1);
if (_e41 < _e30.member_2) {
if (_e43 < _e30.member_3) {
let _e46 = (_e33.member * _e33.member_1);
let _e48 = ((_e43 * _e33.member) + _e41);
let _e49 = bitcast<i32>(_e48);
let _e51 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e53 = select(_e51, _e49, (_e49 < _e51));
let _e59 = global_2.member[bitcast<u32>(select(0i, _e53, (_e53 > 0i)))];
let _e60 = (_e46 + _e48);
let _e61 = bitcast<i32>(_e60);
let _e63 = select(_e51, _e61, (_e61 < _e51));
let _e69 = global_2.member[bitcast<u32>(select(0i, _e63, (_e63 > 0i)))];
let _e71 = ((2u * _e46) + _e48);
let _e72 = bitcast<i32>(_e71);
let _e74 = select(_e51, _e72, (_e72 < _e51));
let _e80 = global_2.member[bitcast<u32>(select(0i, _e74, (_e74 > 0i)))];
let _e82 = ((3u * _e46) + _e48);
let _e83 = bitcast<i32>(_e82);
let _e85 = select(_e51, _e83, (_e83 < _e51));
let _e91 = global_2.member[bitcast<u32>(select(0i, _e85, (_e85 > 0i)))];
let _e93 = ((4u * _e46) + _e48);
let _e94 = bitcast<i32>(_e93);
let _e96 = select(_e51, _e94, (_e94 < _e51));
let _e102 = global_2.member[bitcast<u32>(select(0i, _e96, (_e96 > 0i)))];
let _e104 = ((5u * _e46) + _e48);
let _e105 = bitcast<i32>(_e104);
let _e107 = select(_e51, _e105, (_e105 < _e51));
let _e113 = global_2.member[bitcast<u32>(select(0i, _e107, (_e107 > 0i)))];
let _e115 = ((9u * _e46) + _e48);
let _e116 = bitcast<i32>(_e115);
let _e118 = select(_e51, _e116, (_e116 < _e51));
let _e124 = global_2.member[bitcast<u32>(select(0i, _e118, (_e118 > 0i)))];
let _e126 = ((10u * _e46) + _e48);
let _e127 = bitcast<i32>(_e126);
let _e129 = select(_e51, _e127, (_e127 < _e51));
let _e135 = global_2.member[bitcast<u32>(select(0i, _e129, (_e129 > 0i)))];
let _e137 = ((11u * _e46) + _e48);
let _e138 = bitcast<i32>(_e137);
let _e140 = select(_e51, _e138, (_e138 < _e51));
let _e146 = global_2.member[bitcast<u32>(select(0i, _e140, (_e140 > 0i)))];
let _e148 = ((13u * _e46) + _e48);
let _e149 = bitcast<i32>(_e148);
let _e151 = select(_e51, _e149, (_e149 < _e51));
let _e157 = global_2.member[bitcast<u32>(select(0i, _e151, (_e151 > 0i)))];
if (select(0u, 3u, (_e146 == 0f)) > 1u) {
let _e165 = global_1.member.member_12.member_4.member;
let _e166 = (_e165 + 1u);
let _e171 = global_1.member.member_12.member_4.member_1;
let _e174 = bitcast<i32>((_e166 * (_e171 + 1u)));
let _e177 = bitcast<i32>(((_e43 * _e166) + _e41));
let _e179 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e181 = select(_e179, _e177, (_e177 < _e179));
let _e187 = global_3.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e188 = (_e174 + _e177);
let _e190 = select(_e179, _e188, (_e188 < _e179));
let _e196 = global_3.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e198 = ((2i * _e174) + _e177);
let _e200 = select(_e179, _e198, (_e198 < _e179));
let _e206 = global_3.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e208 = ((3i * _e174) + _e177);
let _e210 = select(_e179, _e208, (_e208 < _e179));
let _e216 = global_3.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
global_2.member[_e48] = _e59;
global_2.member[_e60] = _e69;
global_2.member[_e71] = _e80;
global_2.member[_e82] = _e91;
global_2.member[_e93] = _e102;
global_2.member[_e104] = _e113;
global_2.member[((6u * _e46) + _e48)] = _e187;
global_2.member[((7u * _e46) + _e48)] = _e196;
global_2.member[((8u * _e46) + _e48)] = _e206;
global_2.member[_e115] = _e124;
global_2.member[_e126] = _e135;
global_2.member[_e137] = _e146;
global_2.member[((12u * _e46) + _e48)] = _e216;
global_2.member[_e148] = _e157;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
