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
@group(0) @binding(1)
var<storage, read_write> global_2: type_16;
fn function_() {
let _e8 = global;
let _e11 = global_1.member.member_2;
let _e14 = global_1.member.member;
let _e22 = (_e8.x + _e11.member);
let _e24 = (_e8.y + _e11.member_1);
if (_e22 < _e11.member_2) {
if (_e24 < _e11.member_3) {
let _e27 = (_e14.member * _e14.member_1);
let _e29 = ((_e24 * _e14.member) + _e22);
global_2.member[_e29] = 0f;
global_2.member[(_e27 + _e29)] = 0f;
global_2.member[((2u * _e27) + _e29)] = 0f;
global_2.member[((3u * _e27) + _e29)] = 0f;
global_2.member[((4u * _e27) + _e29)] = 0f;
global_2.member[((5u * _e27) + _e29)] = 0f;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
