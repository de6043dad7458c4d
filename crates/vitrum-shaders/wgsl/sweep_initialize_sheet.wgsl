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
struct type_11 {
member: array<f32>,
}
struct type_13 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_15 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_16 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_17 {
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
struct type_18 {
member: type_5,
member_1: type_5,
}
struct type_19 {
member: type_7,
member_1: u32,
}
struct type_20 {
member: type_2,
member_1: u32,
member_2: type_13,
member_3: type_14,
member_4: u32,
member_5: type_15,
member_6: type_16,
member_7: type_16,
member_8: type_17,
member_9: type_18,
member_10: f32,
member_11: type_15,
member_12: type_4,
member_13: type_9,
member_14: type_19,
member_15: type_19,
member_16: type_19,
member_17: type_19,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_21 {
member: type_20,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_21;
@group(0) @binding(2)
var<storage, read_write> global_2: type_11;
@group(0) @binding(1)
var<storage> global_3: type_11;
fn function_() {
switch bitcast<i32>(0u) {
default: {
let _e20 = global;
let _e25 = global_1.member.member_2;
let _e28 = global_1.member.member;
let _e36 = (_e20.x + _e25.member);
let _e38 = (_e20.y + _e25.member_1);
if (_e36 < _e25.member_2) {
if (_e38 < _e25.member_3) {
let _e41 = (_e28.member * _e28.member_1);
let _e43 = ((_e38 * _e28.member) + _e36);
let _e46 = global_1.member.member_10;
let _e50 = global_1.member.member_8.member_1;
let _e51 = (_e50 + 1u);
let _e53 = select(1u, _e51, (_e51 > 0u));
if (_e53 == 0u) {
break;
}
let _e57 = bitcast<i32>(((_e38 / _e53) * 3u));
let _e59 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e61 = select(_e59, _e57, (_e57 < _e59));
let _e67 = global_3.member[bitcast<u32>(select(0i, _e61, (_e61 > 0i)))];
let _e68 = (_e57 + 1i);
let _e70 = select(_e59, _e68, (_e68 < _e59));
let _e76 = global_3.member[bitcast<u32>(select(0i, _e70, (_e70 > 0i)))];
let _e77 = (_e57 + 2i);
let _e79 = select(_e59, _e77, (_e77 < _e59));
let _e85 = global_3.member[bitcast<u32>(select(0i, _e79, (_e79 > 0i)))];
global_2.member[_e43] = 0f;
global_2.member[(_e41 + _e43)] = 0f;
global_2.member[((2u * _e41) + _e43)] = 0f;
global_2.member[((3u * _e41) + _e43)] = 0f;
global_2.member[((4u * _e41) + _e43)] = _e67;
global_2.member[((5u * _e41) + _e43)] = _e76;
global_2.member[((6u * _e41) + _e43)] = _e85;
global_2.member[((7u * _e41) + _e43)] = _e46;
global_2.member[((8u * _e41) + _e43)] = _e46;
global_2.member[((9u * _e41) + _e43)] = _e46;
global_2.member[((10u * _e41) + _e43)] = 0f;
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
