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
let _e19 = global;
let _e22 = global_1.member.member_2;
let _e25 = global_1.member.member;
let _e33 = (_e19.x + _e22.member);
let _e35 = (_e19.y + _e22.member_1);
if (_e33 < _e22.member_2) {
if (_e35 < _e22.member_3) {
let _e38 = (_e25.member * _e25.member_1);
let _e40 = ((_e35 * _e25.member) + _e33);
let _e48 = global_1.member.member_12.member_9;
let _e52 = global_1.member.member_12.member_3;
let _e53 = (_e52 != 0u);
let _e61 = global_1.member.member_12.member_19.member_2;
let _e63 = select(1f, (_e48 - _e61), _e53);
let _e67 = global_1.member.member_12.member_5;
let _e71 = global_1.member.member_12.member_7;
let _e74 = ((_e67 + (f32(bitcast<i32>(_e33)) * _e71)) * _e63);
let _e78 = global_1.member.member_12.member_6;
let _e81 = ((_e78 + (f32(bitcast<i32>(_e35)) * _e71)) * _e63);
let _e82 = global_1.member.member_12.member_19;
let _e86 = (_e74 - _e82.member);
let _e87 = (_e81 - _e82.member_1);
let _e88 = (_e48 - _e82.member_2);
let _e93 = (((_e86 * _e86) + (_e87 * _e87)) + (_e88 * _e88));
let _e96 = sqrt(select(0f, _e93, (_e93 > 0f)));
let _e99 = (1f / select(1e-20f, _e96, (_e96 > 1e-20f)));
global_2.member[_e40] = _e74;
global_2.member[(_e38 + _e40)] = _e81;
global_2.member[((2u * _e38) + _e40)] = _e48;
global_2.member[((3u * _e38) + _e40)] = select(0f, (_e86 * _e99), _e53);
global_2.member[((4u * _e38) + _e40)] = select(0f, (_e87 * _e99), _e53);
global_2.member[((5u * _e38) + _e40)] = select(1f, (_e88 * _e99), _e53);
global_2.member[((6u * _e38) + _e40)] = 1f;
global_2.member[((7u * _e38) + _e40)] = 1f;
global_2.member[((8u * _e38) + _e40)] = 1f;
global_2.member[((9u * _e38) + _e40)] = 0f;
global_2.member[((10u * _e38) + _e40)] = 0f;
global_2.member[((11u * _e38) + _e40)] = 0f;
global_2.member[((12u * _e38) + _e40)] = 0f;
global_2.member[((13u * _e38) + _e40)] = 0f;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
