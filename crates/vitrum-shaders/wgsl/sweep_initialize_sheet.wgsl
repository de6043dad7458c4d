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
let _e47 = global_1.member.member_8.member_1;
let _e48 = (_e47 + 1u);
let _e50 = select(1u, _e48, (_e48 > 0u));
if (_e50 == 0u) {
break;
}
let _e54 = bitcast<i32>(((_e38 / _e50) * 3u));
let _e56 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e58 = select(_e56, _e54, (_e54 < _e56));
let _e64 = global_3.member[bitcast<u32>(select(0i, _e58, (_e58 > 0i)))];
let _e65 = (_e54 + 1i);
let _e67 = select(_e56, _e65, (_e65 < _e56));
let _e73 = global_3.member[bitcast<u32>(select(0i, _e67, (_e67 > 0i)))];
let _e74 = (_e54 + 2i);
let _e76 = select(_e56, _e74, (_e74 < _e56));
let _e82 = global_3.member[bitcast<u32>(select(0i, _e76, (_e76 > 0i)))];
let _e85 = global_1.member.member_10;
global_2.member[_e43] = 0f;
global_2.member[(_e41 + _e43)] = 0f;
global_2.member[((2u * _e41) + _e43)] = 0f;
global_2.member[((3u * _e41) + _e43)] = 0f;
global_2.member[((4u * _e41) + _e43)] = _e64;
global_2.member[((5u * _e41) + _e43)] = _e73;
global_2.member[((6u * _e41) + _e43)] = _e82;
global_2.member[((7u * _e41) + _e43)] = _e85;
global_2.member[((8u * _e41) + _e43)] = _e85;
global_2.member[((9u * _e41) + _e43)] = _e85;
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
