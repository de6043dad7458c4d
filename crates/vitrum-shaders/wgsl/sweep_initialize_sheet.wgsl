struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_9 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_10 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_9,
member_6: type_9,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: type_4,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: type_4,
member_25: vec4<u32>,
member_26: type_4,
member_27: type_4,
member_28: type_4,
member_29: type_4,
member_30: type_4,
member_31: type_4,
}
struct type_11 {
member: type_10,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_11;
@group(0) @binding(2)
var<storage, read_write> global_2: type_6;
@group(0) @binding(1)
var<storage> global_3: type_6;
fn function_() {
switch bitcast<i32>(0u) {
default: {
let _e20 = global;
let _e25 = global_1.member.member_1;
let _e28 = (_e20.x + _e25.x);
let _e31 = (_e20.y + _e25.y);
if (_e28 < _e25.z) {
if (_e31 < _e25.w) {
let _e39 = global_1.member.member[0u];
let _e43 = global_1.member.member[1u];
let _e44 = (_e39 * _e43);
let _e46 = ((_e31 * _e39) + _e28);
let _e50 = global_1.member.member_2[3u];
let _e51 = (_e50 + 1u);
let _e53 = select(1u, _e51, (_e51 > 0u));
if (_e53 == 0u) {
break;
}
let _e57 = bitcast<i32>(((_e31 / _e53) * 3u));
let _e59 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e61 = select(_e59, _e57, (_e57 < _e59));
let _e67 = global_3.member[bitcast<u32>(select(0i, _e61, (_e61 > 0i)))];
let _e68 = (_e57 + 1i);
let _e70 = select(_e59, _e68, (_e68 < _e59));
let _e76 = global_3.member[bitcast<u32>(select(0i, _e70, (_e70 > 0i)))];
let _e77 = (_e57 + 2i);
let _e79 = select(_e59, _e77, (_e77 < _e59));
let _e85 = global_3.member[bitcast<u32>(select(0i, _e79, (_e79 > 0i)))];
let _e89 = global_1.member.member_9.member_3;
global_2.member[_e46] = 0f;
global_2.member[(_e44 + _e46)] = 0f;
global_2.member[((2u * _e44) + _e46)] = 0f;
global_2.member[((3u * _e44) + _e46)] = 0f;
global_2.member[((4u * _e44) + _e46)] = _e67;
global_2.member[((5u * _e44) + _e46)] = _e76;
global_2.member[((6u * _e44) + _e46)] = _e85;
global_2.member[((7u * _e44) + _e46)] = _e89;
global_2.member[((8u * _e44) + _e46)] = _e89;
global_2.member[((9u * _e44) + _e46)] = _e89;
global_2.member[((10u * _e44) + _e46)] = 0f;
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
