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
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_17 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_18 {
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
struct type_19 {
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
struct type_20 {
member: type_5,
member_1: type_5,
}
struct type_21 {
member: type_7,
member_1: u32,
}
struct type_22 {
member: type_2,
member_1: u32,
member_2: type_16,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_17,
member_8: type_18,
member_9: type_18,
member_10: type_19,
member_11: type_20,
member_12: type_14,
member_13: type_17,
member_14: type_4,
member_15: type_9,
member_16: type_21,
member_17: type_21,
member_18: type_21,
member_19: type_21,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_23 {
member: type_22,
}
struct type_26 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(1)
var<storage, read_write> global_2: type_26;
fn function_() {
var phi_105_: u32;
var phi_107_: u32;
var phi_119_: u32;
var phi_122_: u32;
var phi_124_: u32;
var phi_126_: u32;
var phi_140_: u32;
var phi_148_: u32;
var phi_155_: u32;
var phi_120_: u32;
var phi_123_: u32;
var phi_125_: u32;
var phi_127_: u32;
var phi_108_: u32;
let _e8 = global;
let _e10 = arrayLength((&global_2.member));
let _e13 = global_1.member.member_2;
let _e21 = (_e8.y + _e13.member_1);
if ((_e8.x + _e13.member) < _e13.member_2) {
if (_e21 < _e13.member_3) {
let _e26 = global_1.member.member;
let _e33 = global_1.member.member_12.member_18.member.member;
let _e39 = global_1.member.member_12.member_18.member.member_1;
let _e40 = (_e26.member_2 == 0u);
if _e40 {
phi_105_ = (_e21 * _e33);
} else {
phi_105_ = _e21;
}
let _e45 = phi_105_;
phi_107_ = 0u;
loop {
let _e47 = phi_107_;
let _e48 = (_e47 < 6u);
if _e48 {
phi_119_ = 0u;
phi_122_ = 0u;
phi_124_ = ((_e45 * 6u) + _e47);
phi_126_ = 0u;
loop {
let _e52 = phi_119_;
let _e54 = phi_122_;
let _e56 = phi_124_;
let _e58 = phi_126_;
let _e59 = (_e54 < select(_e39, _e33, _e40));
if _e59 {
let _e60 = (_e56 < _e10);
if _e60 {
let _e63 = atomicAdd((&global_2.member[_e56]), 0u);
phi_140_ = _e63;
} else {
phi_140_ = 0u;
}
let _e65 = phi_140_;
let _e66 = (_e56 + 1u);
let _e67 = (_e66 < _e10);
if _e67 {
let _e70 = atomicAdd((&global_2.member[_e66]), 0u);
phi_148_ = _e70;
} else {
phi_148_ = 0u;
}
let _e72 = phi_148_;
if _e60 {
let _e75 = atomicAdd((&global_2.member[_e56]), _e58);
phi_155_ = _e75;
} else {
phi_155_ = 0u;
}
let _e77 = phi_155_;
let _e81 = (_e52 + select(0u, 1u, ((_e77 + _e58) < _e58)));
if (_e81 == 0u) {
} else {
if _e67 {
let _e85 = atomicAdd((&global_2.member[_e66]), _e81);
}
}
let _e86 = (_e58 + _e65);
phi_120_ = ((_e52 + _e72) + select(0u, 1u, (_e86 < _e58)));
phi_123_ = (_e54 + 1u);
phi_125_ = (_e56 + (select(_e33, 1u, _e40) * 6u));
phi_127_ = _e86;
} else {
phi_120_ = u32();
phi_123_ = u32();
phi_125_ = u32();
phi_127_ = u32();
}
let _e95 = phi_120_;
let _e97 = phi_123_;
let _e99 = phi_125_;
let _e101 = phi_127_;
continue;
continuing {
phi_119_ = _e95;
phi_122_ = _e97;
phi_124_ = _e99;
phi_126_ = _e101;
break if !(_e59);
}
}
phi_108_ = (_e47 + 2u);
} else {
phi_108_ = u32();
}
let _e105 = phi_108_;
continue;
continuing {
phi_107_ = _e105;
break if !(_e48);
}
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
