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
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_13 {
member: array<f32>,
}
struct type_15 {
member: u32,
member_1: u32,
}
struct type_16 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_17 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
}
struct type_18 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
}
struct type_19 {
member: f32,
member_1: u32,
}
struct type_20 {
member: type_2,
member_1: type_15,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_16,
member_12: type_17,
member_13: type_18,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_19,
}
struct type_21 {
member: type_20,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_21;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage, read_write> global_3: type_13;
fn function_() {
var phi_97_: u32;
var phi_113_: u32;
var phi_116_: u32;
var phi_114_: u32;
var phi_117_: u32;
var local: u32;
var phi_144_: u32;
var phi_147_: u32;
var local_1: u32;
var local_2: u32;
var phi_145_: u32;
var phi_148_: u32;
var local_3: u32;
var local_4: u32;
var local_5: u32;
var phi_179_: i32;
var phi_182_: f32;
var phi_184_: type_5;
var phi_199_: i32;
var phi_202_: f32;
var phi_204_: type_5;
var phi_200_: i32;
var phi_203_: f32;
var phi_205_: type_5;
var phi_180_: i32;
var phi_183_: f32;
var phi_185_: type_5;
var local_6: f32;
var local_7: f32;
var local_8: type_5;
var local_9: type_5;
var local_10: type_5;
var local_11: f32;
var local_12: type_5;
let _e17 = global;
let _e22 = global_1.member.member;
if (_e17.x < _e22.member) {
if (_e17.y < _e22.member_1) {
let _e29 = (_e22.member * _e22.member_1);
let _e31 = ((_e17.y * _e22.member) + _e17.x);
phi_97_ = 1u;
loop {
let _e33 = phi_97_;
let _e37 = global_1.member.member_18.member_1;
let _e42 = global_1.member.member_1.member_1;
let _e43 = (_e33 + 1u);
phi_113_ = 1u;
phi_116_ = 0u;
local_1 = _e33;
local_2 = _e42;
local_4 = _e33;
local_5 = _e42;
loop {
let _e45 = phi_113_;
let _e47 = phi_116_;
local = _e47;
let _e48 = (_e45 < _e43);
if _e48 {
let _e49 = (_e45 & 31u);
phi_114_ = (_e45 + 1u);
phi_117_ = (_e47 + (((_e42 + (1u << bitcast<u32>(_e49))) - 1u) >> bitcast<u32>(_e49)));
} else {
phi_114_ = u32();
phi_117_ = u32();
}
let _e59 = phi_114_;
let _e61 = phi_117_;
continue;
continuing {
phi_113_ = _e59;
phi_116_ = _e61;
break if !(_e48);
}
}
let _e64 = local;
let _e66 = ((_e33 < _e37) && (_e17.y >= _e64));
continue;
continuing {
phi_97_ = select(u32(), _e43, _e66);
break if !(_e66);
}
}
phi_144_ = 1u;
phi_147_ = 0u;
loop {
let _e70 = phi_144_;
let _e72 = phi_147_;
local_3 = _e72;
let _e74 = local_1;
let _e75 = (_e70 < _e74);
if _e75 {
let _e76 = (_e70 & 31u);
let _e80 = local_2;
phi_145_ = (_e70 + 1u);
phi_148_ = (_e72 + (((_e80 + (1u << bitcast<u32>(_e76))) - 1u) >> bitcast<u32>(_e76)));
} else {
phi_145_ = u32();
phi_148_ = u32();
}
let _e88 = phi_145_;
let _e90 = phi_148_;
continue;
continuing {
phi_144_ = _e88;
phi_147_ = _e90;
break if !(_e75);
}
}
let _e93 = local_3;
let _e95 = bitcast<i32>((_e17.y - _e93));
let _e97 = local_4;
let _e100 = (1i << bitcast<u32>((_e97 & 31u)));
let _e104 = global_1.member.member_1.member;
let _e105 = bitcast<i32>(_e104);
let _e107 = local_5;
let _e108 = bitcast<i32>(_e107);
phi_179_ = (_e95 * _e100);
phi_182_ = 0f;
phi_184_ = type_5(1e30f, 0f, 0f);
loop {
let _e112 = phi_179_;
let _e114 = phi_182_;
let _e116 = phi_184_;
local_6 = _e114;
local_7 = _e114;
local_8 = _e116;
local_9 = _e116;
local_10 = _e116;
let _e121 = ((_e112 < ((_e95 + 1i) * _e100)) && (_e112 < _e108));
if _e121 {
let _e122 = bitcast<i32>(_e17.x);
phi_199_ = (_e122 * _e100);
phi_202_ = _e114;
phi_204_ = _e116;
loop {
let _e125 = phi_199_;
let _e127 = phi_202_;
let _e129 = phi_204_;
local_11 = _e127;
local_12 = _e129;
let _e134 = ((_e125 < ((_e122 + 1i) * _e100)) && (_e125 < _e105));
if _e134 {
let _e135 = (_e112 * _e105);
let _e136 = (_e135 + _e125);
let _e138 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e140 = select(_e138, _e136, (_e136 < _e138));
let _e146 = global_2.member[bitcast<u32>(select(0i, _e140, (_e140 > 0i)))];
let _e154 = (((_e105 * _e108) + _e135) + _e125);
let _e156 = select(_e138, _e154, (_e154 < _e138));
let _e162 = global_2.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
phi_200_ = (_e125 + 1i);
phi_203_ = (_e127 + 1f);
phi_205_ = type_5(select(_e146, _e129.member, (_e129.member < _e146)), select(_e146, _e129.member_1, (_e129.member_1 > _e146)), (_e129.member_2 + _e162));
} else {
phi_200_ = i32();
phi_203_ = f32();
phi_205_ = type_5();
}
let _e169 = phi_200_;
let _e171 = phi_203_;
let _e173 = phi_205_;
continue;
continuing {
phi_199_ = _e169;
phi_202_ = _e171;
phi_204_ = _e173;
break if !(_e134);
}
}
phi_180_ = (_e112 + 1i);
let _e236 = local_11;
phi_183_ = _e236;
let _e239 = local_12;
phi_185_ = _e239;
} else {
phi_180_ = i32();
phi_183_ = f32();
phi_185_ = type_5();
}
let _e177 = phi_180_;
let _e179 = phi_183_;
let _e181 = phi_185_;
continue;
continuing {
phi_179_ = _e177;
phi_182_ = _e179;
phi_184_ = _e181;
break if !(_e121);
}
}
let _e184 = local_6;
let _e187 = local_7;
let _e191 = local_8;
let _e195 = local_9;
let _e198 = local_10;
global_3.member[_e31] = _e195.member;
global_3.member[(_e29 + _e31)] = _e198.member_1;
global_3.member[((2u * _e29) + _e31)] = (_e191.member_2 * (1f / select(1f, _e187, (_e184 > 1f))));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
