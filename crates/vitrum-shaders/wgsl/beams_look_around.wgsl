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
struct type_12 {
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
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_17 {
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
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_19 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_20 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_21 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_22 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_17,
member_12: type_18,
member_13: type_19,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_20,
member_19: type_21,
}
struct type_23 {
member: type_22,
}
struct type_24 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(2)
var<storage, read_write> global_2: type_15;
@group(0) @binding(1)
var<storage> global_3: type_15;
fn function_() {
var phi_105_: u32;
var phi_141_: u32;
var phi_142_: u32;
var phi_143_: u32;
var local: u32;
var local_1: u32;
var local_2: u32;
var local_3: u32;
var local_4: u32;
var local_5: u32;
var phi_177_: u32;
var phi_178_: u32;
var phi_179_: u32;
var local_6: u32;
var phi_204_: i32;
var phi_207_: type_24;
var phi_218_: i32;
var phi_221_: type_24;
var local_7: u32;
var local_8: u32;
var local_9: u32;
var local_10: u32;
var local_11: u32;
var phi_283_: u32;
var phi_284_: u32;
var phi_285_: u32;
var phi_366_: type_24;
var phi_219_: i32;
var phi_222_: type_24;
var phi_205_: i32;
var phi_208_: type_24;
var local_12: u32;
var local_13: u32;
var local_14: u32;
var local_15: u32;
var local_16: u32;
var phi_412_: u32;
var phi_413_: u32;
var phi_414_: u32;
var local_17: type_24;
var local_18: type_24;
var local_19: type_24;
var local_20: u32;
var local_21: u32;
var local_22: type_24;
var local_23: u32;
let _e18 = global;
let _e20 = arrayLength((&global_3.member));
let _e23 = global_1.member.member;
if (_e18.x < _e23.member) {
if (_e18.y < _e23.member_1) {
let _e30 = (_e23.member * _e23.member_1);
let _e32 = ((_e18.y * _e23.member) + _e18.x);
phi_105_ = 1u;
loop {
let _e34 = phi_105_;
local = _e34;
local_1 = _e34;
local_2 = _e34;
local_3 = _e34;
local_6 = _e34;
local_7 = _e34;
local_8 = _e34;
local_9 = _e34;
local_12 = _e34;
local_13 = _e34;
local_14 = _e34;
let _e38 = global_1.member.member_18.member_1;
let _e40 = (_e34 + 1u);
let _e44 = global_1.member.member_18.member_6;
let _e48 = global_1.member.member_18.member_7;
let _e52 = global_1.member.member_18.member_8;
local_4 = _e48;
local_5 = _e52;
local_20 = _e44;
local_10 = _e48;
local_11 = _e52;
local_21 = _e44;
local_15 = _e48;
local_16 = _e52;
local_23 = _e44;
if (_e40 == 0u) {
phi_143_ = 0u;
} else {
if (_e40 == 1u) {
phi_142_ = 0u;
} else {
if (_e40 == 2u) {
phi_141_ = _e44;
} else {
phi_141_ = select(_e52, _e48, (_e40 == 3u));
}
let _e59 = phi_141_;
phi_142_ = _e59;
}
let _e61 = phi_142_;
phi_143_ = _e61;
}
let _e63 = phi_143_;
let _e65 = ((_e34 < _e38) && (_e18.y >= _e63));
continue;
continuing {
phi_105_ = select(u32(), _e40, _e65);
break if !(_e65);
}
}
let _e68 = bitcast<i32>(_e18.x);
let _e70 = local;
let _e71 = (_e70 == 0u);
if _e71 {
phi_179_ = 0u;
} else {
let _e73 = local_1;
if (_e73 == 1u) {
phi_178_ = 0u;
} else {
let _e76 = local_2;
if (_e76 == 2u) {
let _e319 = local_20;
phi_177_ = _e319;
} else {
let _e79 = local_3;
let _e82 = local_4;
let _e84 = local_5;
phi_177_ = select(_e84, _e82, (_e79 == 3u));
}
let _e87 = phi_177_;
phi_178_ = _e87;
}
let _e89 = phi_178_;
phi_179_ = _e89;
}
let _e91 = phi_179_;
let _e93 = bitcast<i32>((_e18.y - _e91));
let _e97 = global_1.member.member_1.member;
let _e101 = global_1.member.member_1.member_1;
let _e103 = local_6;
let _e104 = (_e103 & 31u);
let _e106 = (1u << bitcast<u32>(_e104));
phi_204_ = (_e93 - 2i);
phi_207_ = type_24(1e30f, 0f, 1e30f, 0f);
loop {
let _e119 = phi_204_;
let _e121 = phi_207_;
local_17 = _e121;
local_18 = _e121;
local_19 = _e121;
let _e123 = (_e119 <= (_e93 + 2i));
if _e123 {
phi_218_ = (_e68 - 2i);
phi_221_ = _e121;
loop {
let _e126 = phi_218_;
let _e128 = phi_221_;
local_22 = _e128;
let _e130 = (_e126 <= (_e68 + 2i));
if _e130 {
if ((((_e126 >= 0i) && (_e126 < bitcast<i32>((((_e97 + _e106) - 1u) >> bitcast<u32>(_e104))))) && (_e119 >= 0i)) && (_e119 < bitcast<i32>((((_e101 + _e106) - 1u) >> bitcast<u32>(_e104))))) {
let _e141 = bitcast<i32>(((_e97 + 1u) >> bitcast<u32>(1u)));
let _e145 = global_1.member.member_18.member_9;
if _e71 {
phi_285_ = 0u;
} else {
let _e149 = local_7;
if (_e149 == 1u) {
phi_284_ = 0u;
} else {
let _e152 = local_8;
if (_e152 == 2u) {
let _e334 = local_21;
phi_283_ = _e334;
} else {
let _e155 = local_9;
let _e158 = local_10;
let _e160 = local_11;
phi_283_ = select(_e160, _e158, (_e155 == 3u));
}
let _e163 = phi_283_;
phi_284_ = _e163;
}
let _e165 = phi_284_;
phi_285_ = _e165;
}
let _e167 = phi_285_;
let _e171 = (((bitcast<i32>(_e167) + _e119) * _e141) + _e126);
let _e173 = (bitcast<i32>(_e20) - 1i);
let _e175 = select(_e173, _e171, (_e171 < _e173));
let _e181 = global_3.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e182 = ((_e141 * bitcast<i32>(_e145)) + _e171);
let _e184 = select(_e173, _e182, (_e182 < _e173));
let _e190 = global_3.member[bitcast<u32>(select(0i, _e184, (_e184 > 0i)))];
let _e201 = ((((_e126 >= (_e68 - 1i)) && (_e126 <= (_e68 + 1i))) && (_e119 >= (_e93 - 1i))) && (_e119 <= (_e93 + 1i)));
let _e208 = type_24(_e128.member, _e128.member_1, select(_e181, _e128.member_2, (_e128.member_2 < _e181)), _e128.member_3);
let _e210 = select(1e30f, _e181, _e201);
let _e216 = type_24(select(_e210, _e128.member, (_e128.member < _e210)), _e208.member_1, _e208.member_2, _e208.member_3);
let _e218 = select(0f, _e190, _e201);
phi_366_ = type_24(_e216.member, select(_e218, _e128.member_1, (_e128.member_1 > _e218)), _e216.member_2, _e216.member_3);
} else {
phi_366_ = _e128;
}
let _e226 = phi_366_;
phi_219_ = (_e126 + 1i);
phi_222_ = _e226;
} else {
phi_219_ = i32();
phi_222_ = type_24();
}
let _e229 = phi_219_;
let _e231 = phi_222_;
continue;
continuing {
phi_218_ = _e229;
phi_221_ = _e231;
break if !(_e130);
}
}
phi_205_ = (_e119 + 1i);
let _e343 = local_22;
phi_208_ = _e343;
} else {
phi_205_ = i32();
phi_208_ = type_24();
}
let _e235 = phi_205_;
let _e237 = phi_208_;
continue;
continuing {
phi_204_ = _e235;
phi_207_ = _e237;
break if !(_e123);
}
}
let _e242 = bitcast<i32>(((_e97 + 1u) >> bitcast<u32>(1u)));
let _e246 = global_1.member.member_18.member_9;
if _e71 {
phi_414_ = 0u;
} else {
let _e250 = local_12;
if (_e250 == 1u) {
phi_413_ = 0u;
} else {
let _e253 = local_13;
if (_e253 == 2u) {
let _e351 = local_23;
phi_412_ = _e351;
} else {
let _e256 = local_14;
let _e259 = local_15;
let _e261 = local_16;
phi_412_ = select(_e261, _e259, (_e256 == 3u));
}
let _e264 = phi_412_;
phi_413_ = _e264;
}
let _e266 = phi_413_;
phi_414_ = _e266;
}
let _e268 = phi_414_;
let _e274 = ((2i * (_e242 * bitcast<i32>(_e246))) + (((bitcast<i32>(_e268) + _e93) * _e242) + _e68));
let _e276 = (bitcast<i32>(_e20) - 1i);
let _e278 = select(_e276, _e274, (_e274 < _e276));
let _e284 = global_3.member[bitcast<u32>(select(0i, _e278, (_e278 > 0i)))];
let _e286 = local_17;
let _e289 = local_18;
let _e292 = local_19;
global_2.member[_e32] = _e286.member;
global_2.member[(_e30 + _e32)] = _e289.member_1;
global_2.member[((2u * _e30) + _e32)] = _e292.member_2;
global_2.member[((3u * _e30) + _e32)] = _e284;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
