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
}
struct type_14 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
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
member_2: type_14,
member_3: type_13,
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
let _e21 = global;
let _e26 = global_1.member.member_2;
let _e29 = global_1.member.member;
let _e37 = (_e21.x + _e26.member);
let _e39 = (_e21.y + _e26.member_1);
if (_e37 < _e26.member_2) {
if (_e39 < _e26.member_3) {
let _e42 = (_e29.member * _e29.member_1);
let _e44 = ((_e39 * _e29.member) + _e37);
let _e47 = global_1.member.member_10;
let _e51 = global_1.member.member_8.member_1;
let _e52 = (_e51 + 1u);
let _e54 = select(1u, _e52, (_e52 > 0u));
if (_e54 == 0u) {
break;
}
let _e58 = bitcast<i32>(((_e39 / _e54) * 3u));
let _e60 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e62 = select(_e60, _e58, (_e58 < _e60));
let _e68 = global_3.member[bitcast<u32>(select(0i, _e62, (_e62 > 0i)))];
let _e69 = (_e58 + 1i);
let _e71 = select(_e60, _e69, (_e69 < _e60));
let _e77 = global_3.member[bitcast<u32>(select(0i, _e71, (_e71 > 0i)))];
let _e78 = (_e58 + 2i);
let _e80 = select(_e60, _e78, (_e78 < _e60));
let _e86 = global_3.member[bitcast<u32>(select(0i, _e80, (_e80 > 0i)))];
global_2.member[_e44] = 0f;
global_2.member[(_e42 + _e44)] = 0f;
global_2.member[((2u * _e42) + _e44)] = 0f;
global_2.member[((3u * _e42) + _e44)] = 0f;
global_2.member[((4u * _e42) + _e44)] = _e68;
global_2.member[((5u * _e42) + _e44)] = _e77;
global_2.member[((6u * _e42) + _e44)] = _e86;
global_2.member[((7u * _e42) + _e44)] = _e47;
global_2.member[((8u * _e42) + _e44)] = _e47;
global_2.member[((9u * _e42) + _e44)] = _e47;
global_2.member[((10u * _e42) + _e44)] = 0f;
global_2.member[((11u * _e42) + _e44)] = 0f;
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
