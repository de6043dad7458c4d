struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_8 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_9 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_8,
member_6: type_8,
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
struct type_10 {
member: type_9,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_10;
@group(0) @binding(1)
var<storage, read_write> global_2: type_6;
fn function_() {
let _e14 = global;
let _e17 = global_1.member.member_1;
let _e20 = (_e14.x + _e17.x);
let _e23 = (_e14.y + _e17.y);
if (_e20 < _e17.z) {
if (_e23 < _e17.w) {
let _e31 = global_1.member.member[0u];
let _e35 = global_1.member.member[1u];
let _e36 = (_e31 * _e35);
let _e38 = ((_e23 * _e31) + _e20);
let _e42 = global_1.member.member_10.member;
let _e46 = global_1.member.member_10.member_1;
let _e50 = global_1.member.member_10.member_2;
global_2.member[_e38] = 1f;
global_2.member[(_e36 + _e38)] = 1f;
global_2.member[((2u * _e36) + _e38)] = 1f;
global_2.member[((3u * _e36) + _e38)] = _e42;
global_2.member[((4u * _e36) + _e38)] = _e46;
global_2.member[((5u * _e36) + _e38)] = _e50;
global_2.member[((6u * _e36) + _e38)] = 0f;
global_2.member[((7u * _e36) + _e38)] = 0f;
global_2.member[((8u * _e36) + _e38)] = 1f;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
