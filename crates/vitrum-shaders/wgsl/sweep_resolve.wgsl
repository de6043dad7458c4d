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
struct type_14 {
member: u32,
member_1: u32,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_19 {
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
struct type_20 {
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
struct type_21 {
member: type_5,
member_1: type_5,
}
struct type_22 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_23 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_24 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
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
member_17: type_14,
member_18: type_22,
member_19: type_5,
member_20: type_23,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_14,
member_4: type_14,
member_5: u32,
member_6: u32,
member_7: type_18,
member_8: type_19,
member_9: type_19,
member_10: type_20,
member_11: type_21,
member_12: type_24,
member_13: type_18,
member_14: type_4,
member_15: type_9,
member_16: type_25,
member_17: type_25,
member_18: type_25,
member_19: type_25,
member_20: type_5,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_27 {
member: type_26,
}
struct type_28 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_11;
@group(0) @binding(0)
var<storage> global_2: type_27;
@group(0) @binding(1)
var<storage> global_3: type_11;
@group(0) @binding(2)
var<storage> global_4: type_11;
@group(0) @binding(3)
var<storage> global_5: type_16;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: u32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: i32;
var local_17: i32;
var local_18: i32;
var local_19: u32;
var local_20: i32;
var local_21: i32;
var local_22: u32;
var local_23: u32;
var local_24: i32;
var local_25: i32;
var phi_271_: u32;
var phi_1202_: u32;
var phi_1539_: f32;
var phi_1595_: f32;
var phi_1600_: vec3<f32>;
var phi_1703_: f32;
var phi_1787_: f32;
var phi_1859_: type_28;
var phi_1860_: type_28;
var phi_2180_: i32;
var phi_2200_: i32;
var phi_2206_: i32;
var phi_2216_: i32;
var phi_2236_: i32;
var phi_2242_: i32;
var phi_2289_: u32;
var phi_2440_: u32;
var phi_2667_: u32;
var phi_2818_: u32;
var phi_3049_: vec3<f32>;
var phi_3651_: i32;
var phi_3654_: i32;
var phi_3656_: i32;
var phi_3658_: i32;
var phi_3673_: i32;
var phi_3679_: i32;
var phi_3652_: i32;
var phi_3655_: i32;
var phi_3657_: i32;
var phi_3659_: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var phi_3754_: i32;
var local_29: i32;
var local_30: i32;
var phi_3760_: i32;
var local_31: i32;
var phi_3767_: i32;
var local_32: i32;
var local_33: i32;
var phi_3773_: i32;
var local_34: i32;
var local_35: i32;
var phi_3784_: i32;
var local_36: i32;
var local_37: i32;
var phi_3796_: i32;
var local_38: i32;
var local_39: i32;
var local_40: i32;
var local_41: i32;
var phi_4032_: i32;
var phi_4035_: i32;
var phi_4037_: i32;
var phi_4039_: i32;
var phi_4054_: i32;
var phi_4060_: i32;
var phi_4033_: i32;
var phi_4036_: i32;
var phi_4038_: i32;
var phi_4040_: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var phi_4135_: i32;
var local_45: i32;
var local_46: i32;
var phi_4141_: i32;
var local_47: i32;
var phi_4148_: i32;
var local_48: i32;
var local_49: i32;
var phi_4154_: i32;
var local_50: i32;
var local_51: i32;
var phi_4165_: i32;
var local_52: i32;
var local_53: i32;
var phi_4177_: i32;
var local_54: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var phi_4432_: vec3<f32>;
var phi_4433_: vec3<f32>;
var phi_4434_: vec3<f32>;
var phi_4611_: i32;
var phi_4631_: i32;
var phi_4637_: i32;
var phi_4647_: i32;
var phi_4667_: i32;
var phi_4673_: i32;
var phi_4720_: u32;
var phi_4871_: u32;
var phi_5098_: u32;
var phi_5249_: u32;
var phi_5514_: vec3<f32>;
var phi_6116_: i32;
var phi_6119_: i32;
var phi_6121_: i32;
var phi_6123_: i32;
var phi_6138_: i32;
var phi_6144_: i32;
var phi_6117_: i32;
var phi_6120_: i32;
var phi_6122_: i32;
var phi_6124_: i32;
var local_58: i32;
var local_59: i32;
var local_60: i32;
var phi_6219_: i32;
var local_61: i32;
var local_62: i32;
var phi_6225_: i32;
var local_63: i32;
var phi_6232_: i32;
var local_64: i32;
var local_65: i32;
var phi_6238_: i32;
var local_66: i32;
var local_67: i32;
var phi_6249_: i32;
var local_68: i32;
var local_69: i32;
var phi_6261_: i32;
var local_70: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var phi_6497_: i32;
var phi_6500_: i32;
var phi_6502_: i32;
var phi_6504_: i32;
var phi_6519_: i32;
var phi_6525_: i32;
var phi_6498_: i32;
var phi_6501_: i32;
var phi_6503_: i32;
var phi_6505_: i32;
var local_74: i32;
var local_75: i32;
var local_76: i32;
var phi_6600_: i32;
var local_77: i32;
var local_78: i32;
var phi_6606_: i32;
var local_79: i32;
var phi_6613_: i32;
var local_80: i32;
var local_81: i32;
var phi_6619_: i32;
var local_82: i32;
var local_83: i32;
var phi_6630_: i32;
var local_84: i32;
var local_85: i32;
var phi_6642_: i32;
var local_86: i32;
var local_87: i32;
var local_88: i32;
var local_89: i32;
var phi_6897_: vec3<f32>;
var phi_6898_: vec3<f32>;
var phi_6899_: vec3<f32>;
var phi_6910_: vec3<f32>;
switch bitcast<i32>(0u) {
default: {
let _e119 = global;
let _e125 = arrayLength((&global_4.member));
let _e130 = global_2.member.member_2;
let _e133 = global_2.member.member;
let _e141 = (_e119.x + _e130.member);
let _e143 = (_e119.y + _e130.member_1);
if (_e141 < _e130.member_2) {
if (_e143 < _e130.member_3) {
let _e146 = (_e133.member * _e133.member_1);
let _e148 = ((_e143 * _e133.member) + _e141);
local_22 = _e141;
local_23 = _e143;
let _e153 = global_2.member.member_3.member;
let _e157 = global_2.member.member_3.member_1;
let _e158 = local_22;
let _e159 = local_23;
let _e160 = (_e158 % 16u);
let _e161 = (_e159 % 4u);
if ((_e158 < (_e153 - (_e153 % 16u))) && (_e159 < (_e157 - (_e157 % 4u)))) {
phi_271_ = ((((_e159 - _e161) + (_e160 / 4u)) * _e153) + (((_e158 - _e160) + (_e161 * 4u)) + (_e160 % 4u)));
} else {
phi_271_ = ((_e159 * _e153) + _e158);
}
let _e182 = phi_271_;
local_24 = bitcast<i32>(_e182);
let _e185 = bitcast<i32>((_e153 * _e157));
local_25 = _e185;
let _e186 = local_25;
let _e188 = local_24;
let _e189 = ((7i * _e186) + _e188);
let _e191 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e193 = select(_e191, _e189, (_e189 < _e191));
let _e198 = global_3.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e199 = local_25;
let _e201 = local_24;
let _e202 = ((9i * _e199) + _e201);
let _e204 = select(_e191, _e202, (_e202 < _e191));
let _e209 = global_3.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e210 = local_25;
let _e212 = local_24;
let _e213 = ((10i * _e210) + _e212);
let _e215 = select(_e191, _e213, (_e213 < _e191));
let _e220 = global_3.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e221 = local_25;
let _e223 = local_24;
let _e224 = ((11i * _e221) + _e223);
let _e226 = select(_e191, _e224, (_e224 < _e191));
let _e231 = global_3.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e232 = local_25;
let _e234 = local_24;
let _e235 = ((12i * _e232) + _e234);
let _e237 = select(_e191, _e235, (_e235 < _e191));
let _e242 = global_3.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e243 = local_25;
let _e245 = local_24;
let _e246 = ((8i * _e243) + _e245);
let _e248 = select(_e191, _e246, (_e246 < _e191));
let _e253 = global_3.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e254 = local_25;
let _e256 = local_24;
let _e257 = ((13i * _e254) + _e256);
let _e259 = select(_e191, _e257, (_e257 < _e191));
let _e264 = global_3.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e265 = local_25;
let _e267 = local_24;
let _e268 = ((14i * _e265) + _e267);
let _e270 = select(_e191, _e268, (_e268 < _e191));
let _e275 = global_3.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e276 = local_25;
let _e278 = local_24;
let _e279 = ((15i * _e276) + _e278);
let _e281 = select(_e191, _e279, (_e279 < _e191));
let _e286 = global_3.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e287 = local_25;
let _e289 = local_24;
let _e290 = ((3i * _e287) + _e289);
let _e292 = select(_e191, _e290, (_e290 < _e191));
let _e297 = global_3.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e298 = local_25;
let _e300 = local_24;
let _e301 = ((4i * _e298) + _e300);
let _e303 = select(_e191, _e301, (_e301 < _e191));
let _e308 = global_3.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e309 = local_25;
let _e311 = local_24;
let _e312 = ((5i * _e309) + _e311);
let _e314 = select(_e191, _e312, (_e312 < _e191));
let _e319 = global_3.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e324 = (((_e297 * _e297) + (_e308 * _e308)) + (_e319 * _e319));
let _e327 = sqrt(select(0f, _e324, (_e324 > 0f)));
let _e330 = (1f / select(1e-20f, _e327, (_e327 > 1e-20f)));
let _e331 = (_e297 * _e330);
let _e332 = (_e308 * _e330);
let _e333 = (_e319 * _e330);
let _e334 = (_e198 == 0f);
let _e335 = local_24;
let _e337 = select(_e191, _e335, (_e335 < _e191));
let _e342 = global_3.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e343 = local_25;
let _e344 = local_24;
let _e345 = (_e343 + _e344);
let _e347 = select(_e191, _e345, (_e345 < _e191));
let _e352 = global_3.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e353 = local_25;
let _e355 = local_24;
let _e356 = ((2i * _e353) + _e355);
let _e358 = select(_e191, _e356, (_e356 < _e191));
let _e363 = global_3.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e367 = global_2.member.member_7.member_1;
let _e370 = select(0f, ((_e367 - _e363) / _e319), _e334);
let _e374 = (_e342 + (_e297 * _e370));
let _e375 = (_e352 + (_e308 * _e370));
let _e376 = (_e363 + (_e319 * _e370));
let _e381 = global_2.member.member_15.member.member;
let _e392 = ((((_e381.member.member * _e374) + (_e381.member.member_1 * _e375)) + (_e381.member.member_2 * _e376)) + _e381.member_1);
let _e398 = -((((_e381.member.member * _e331) + (_e381.member.member_1 * _e332)) + (_e381.member.member_2 * _e333)));
let _e400 = (_e398 > 1e-9f);
let _e404 = ((_e392 / select(1e-9f, _e398, _e400)) - 0f);
let _e407 = select(1e30f, select(0f, _e404, (_e404 > 0f)), ((_e392 > 0f) && _e400));
let _e412 = global_2.member.member_15.member_1.member;
let _e423 = ((((_e412.member.member * _e374) + (_e412.member.member_1 * _e375)) + (_e412.member.member_2 * _e376)) + _e412.member_1);
let _e429 = -((((_e412.member.member * _e331) + (_e412.member.member_1 * _e332)) + (_e412.member.member_2 * _e333)));
let _e431 = (_e429 > 1e-9f);
let _e435 = ((_e423 / select(1e-9f, _e429, _e431)) - 0f);
let _e438 = select(1e30f, select(0f, _e435, (_e435 > 0f)), ((_e423 > 0f) && _e431));
let _e442 = (_e438 < _e407);
let _e444 = select(select(-2i, -3i, _e442), -1i, ((_e407 >= 1e30f) && (_e438 >= 1e30f)));
let _e445 = select(_e407, _e438, _e442);
let _e446 = (_e444 == -3i);
let _e452 = global_2.member.member_15.member_1.member.member;
let _e457 = global_2.member.member_15.member_1.member_1;
let _e463 = global_2.member.member_15.member.member.member;
let _e468 = global_2.member.member_15.member.member_1;
let _e488 = select(_e445, 0f, (_e444 == -1i));
let _e492 = (_e374 + (_e331 * _e488));
let _e493 = (_e375 + (_e332 * _e488));
let _e494 = (_e376 + (_e333 * _e488));
let _e498 = global_2.member.member_12.member;
let _e509 = ((((_e498.member.member * _e492) + (_e498.member.member_1 * _e493)) + (_e498.member.member_2 * _e494)) + _e498.member_1);
let _e513 = global_2.member.member_12.member_1;
let _e524 = ((((_e513.member.member * _e492) + (_e513.member.member_1 * _e493)) + (_e513.member.member_2 * _e494)) + _e513.member_1);
let _e528 = global_2.member.member_12.member_2;
let _e539 = ((((_e528.member.member * _e492) + (_e528.member.member_1 * _e493)) + (_e528.member.member_2 * _e494)) + _e528.member_1);
let _e543 = global_2.member.member_12.member_3;
let _e544 = (_e543 != 0u);
let _e548 = global_2.member.member_12.member_19;
let _e552 = (_e509 - _e548.member);
let _e553 = (_e524 - _e548.member_1);
let _e554 = (_e539 - _e548.member_2);
let _e559 = (((_e552 * _e552) + (_e553 * _e553)) + (_e554 * _e554));
let _e562 = sqrt(select(0f, _e559, (_e559 > 0f)));
let _e565 = (1f / select(1e-20f, _e562, (_e562 > 1e-20f)));
let _e569 = select(0f, (_e552 * _e565), _e544);
let _e570 = select(0f, (_e553 * _e565), _e544);
let _e571 = select(1f, (_e554 * _e565), _e544);
let _e576 = global_2.member.member_12.member.member;
let _e587 = global_2.member.member_12.member_1.member;
let _e601 = global_2.member.member_12.member_2.member;
let _e610 = (vec3<f32>(((_e576.member * _e569) + (_e587.member * _e570)), ((_e576.member_1 * _e569) + (_e587.member_1 * _e570)), ((_e576.member_2 * _e569) + (_e587.member_2 * _e570))) + vec3<f32>((_e601.member * _e571), (_e601.member_1 * _e571), (_e601.member_2 * _e571)));
let _e613 = global_2.member.member_1;
if ((_e613 & 256u) != 0u) {
let _e621 = global_2.member.member_12.member_18.member.member;
let _e622 = bitcast<i32>(_e621);
let _e628 = global_2.member.member_12.member_18.member.member_1;
let _e629 = bitcast<i32>(_e628);
let _e634 = global_2.member.member_12.member_19.member_2;
let _e636 = select(1f, (_e539 - _e634), _e544);
let _e639 = (1f / select(1e-12f, _e636, (_e636 > 1e-12f)));
let _e644 = global_2.member.member_12.member_5;
let _e649 = global_2.member.member_12.member_8;
let _e650 = (((_e509 * _e639) - _e644) * _e649);
let _e655 = global_2.member.member_12.member_6;
let _e657 = (((_e524 * _e639) - _e655) * _e649);
let _e662 = global_2.member.member_12.member_4.member;
let _e664 = f32(bitcast<i32>(_e662));
let _e666 = select(0f, _e650, (_e650 > 0f));
let _e673 = global_2.member.member_12.member_18.member_1;
let _e676 = ((_e650 - _e664) * _e673);
let _e681 = global_2.member.member_12.member_18.member_2;
let _e683 = select(0f, _e676, (_e676 > 0f));
let _e685 = (_e681 + _e683);
let _e690 = (-(_e650) * _e673);
let _e692 = select(0f, _e690, (_e690 > 0f));
let _e694 = (_e681 + _e692);
let _e701 = (((_e681 + (select(_e664, _e666, (_e666 < _e664)) * _e673)) + (((_e683 * _e681) / select(1e-12f, _e685, (_e685 > 1e-12f))) - ((_e692 * _e681) / select(1e-12f, _e694, (_e694 > 1e-12f))))) - 0.5f);
let _e706 = global_2.member.member_12.member_4.member_1;
let _e708 = f32(bitcast<i32>(_e706));
let _e710 = select(0f, _e657, (_e657 > 0f));
let _e715 = ((_e657 - _e708) * _e673);
let _e717 = select(0f, _e715, (_e715 > 0f));
let _e719 = (_e681 + _e717);
let _e724 = (-(_e657) * _e673);
let _e726 = select(0f, _e724, (_e724 > 0f));
let _e728 = (_e681 + _e726);
let _e735 = (((_e681 + (select(_e708, _e710, (_e710 < _e708)) * _e673)) + (((_e717 * _e681) / select(1e-12f, _e719, (_e719 > 1e-12f))) - ((_e726 * _e681) / select(1e-12f, _e728, (_e728 > 1e-12f))))) - 0.5f);
let _e737 = f32((_e622 - 2i));
let _e739 = select(0f, _e701, (_e701 > 0f));
let _e741 = select(_e737, _e739, (_e739 < _e737));
let _e748 = select(0i, select(select(i32(_e741), i32(-2147483648), (_e741 < -2147483600f)), 2147483647i, (_e741 > 2147483500f)), (_e741 == _e741));
let _e752 = (_e748 - select(0i, 1i, (_e741 < f32(_e748))));
let _e754 = f32((_e629 - 2i));
let _e756 = select(0f, _e735, (_e735 > 0f));
let _e758 = select(_e754, _e756, (_e756 < _e754));
let _e765 = select(0i, select(select(i32(_e758), i32(-2147483648), (_e758 < -2147483600f)), 2147483647i, (_e758 > 2147483500f)), (_e758 == _e758));
let _e769 = (_e765 - select(0i, 1i, (_e758 < f32(_e765))));
let _e771 = (_e701 - f32(_e752));
let _e773 = select(0f, _e771, (_e771 > 0f));
let _e775 = select(1f, _e773, (_e773 < 1f));
let _e777 = (_e735 - f32(_e769));
let _e779 = select(0f, _e777, (_e777 > 0f));
let _e781 = select(1f, _e779, (_e779 < 1f));
if _e446 {
let _e786 = global_2.member.member_12.member_18.member_4;
phi_1202_ = _e786;
} else {
let _e791 = global_2.member.member_12.member_18.member_3;
phi_1202_ = _e791;
}
let _e793 = phi_1202_;
let _e797 = ((bitcast<i32>(_e793) + (_e769 * _e622)) + _e752);
let _e798 = (_e622 * _e629);
let _e800 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e802 = select(_e800, _e797, (_e797 < _e800));
let _e808 = global_5.member[bitcast<u32>(select(0i, _e802, (_e802 > 0i)))];
let _e809 = bitcast<f32>(_e808);
let _e810 = (_e797 + 1i);
let _e812 = select(_e800, _e810, (_e810 < _e800));
let _e818 = global_5.member[bitcast<u32>(select(0i, _e812, (_e812 > 0i)))];
let _e822 = (_e809 + ((bitcast<f32>(_e818) - _e809) * _e775));
let _e823 = (_e797 + _e622);
let _e825 = select(_e800, _e823, (_e823 < _e800));
let _e831 = global_5.member[bitcast<u32>(select(0i, _e825, (_e825 > 0i)))];
let _e832 = bitcast<f32>(_e831);
let _e833 = (_e823 + 1i);
let _e835 = select(_e800, _e833, (_e833 < _e800));
let _e841 = global_5.member[bitcast<u32>(select(0i, _e835, (_e835 > 0i)))];
let _e848 = (_e822 + (((_e832 + ((bitcast<f32>(_e841) - _e832) * _e775)) - _e822) * _e781));
let _e849 = (_e797 + _e798);
let _e851 = select(_e800, _e849, (_e849 < _e800));
let _e857 = global_5.member[bitcast<u32>(select(0i, _e851, (_e851 > 0i)))];
let _e858 = bitcast<f32>(_e857);
let _e859 = (_e849 + 1i);
let _e861 = select(_e800, _e859, (_e859 < _e800));
let _e867 = global_5.member[bitcast<u32>(select(0i, _e861, (_e861 > 0i)))];
let _e871 = (_e858 + ((bitcast<f32>(_e867) - _e858) * _e775));
let _e872 = (_e849 + _e622);
let _e874 = select(_e800, _e872, (_e872 < _e800));
let _e880 = global_5.member[bitcast<u32>(select(0i, _e874, (_e874 > 0i)))];
let _e881 = bitcast<f32>(_e880);
let _e882 = (_e872 + 1i);
let _e884 = select(_e800, _e882, (_e882 < _e800));
let _e890 = global_5.member[bitcast<u32>(select(0i, _e884, (_e884 > 0i)))];
let _e897 = (_e871 + (((_e881 + ((bitcast<f32>(_e890) - _e881) * _e775)) - _e871) * _e781));
let _e899 = (_e797 + (2i * _e798));
let _e901 = select(_e800, _e899, (_e899 < _e800));
let _e907 = global_5.member[bitcast<u32>(select(0i, _e901, (_e901 > 0i)))];
let _e908 = bitcast<f32>(_e907);
let _e909 = (_e899 + 1i);
let _e911 = select(_e800, _e909, (_e909 < _e800));
let _e917 = global_5.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e921 = (_e908 + ((bitcast<f32>(_e917) - _e908) * _e775));
let _e922 = (_e899 + _e622);
let _e924 = select(_e800, _e922, (_e922 < _e800));
let _e930 = global_5.member[bitcast<u32>(select(0i, _e924, (_e924 > 0i)))];
let _e931 = bitcast<f32>(_e930);
let _e932 = (_e922 + 1i);
let _e934 = select(_e800, _e932, (_e932 < _e800));
let _e940 = global_5.member[bitcast<u32>(select(0i, _e934, (_e934 > 0i)))];
let _e947 = (_e921 + (((_e931 + ((bitcast<f32>(_e940) - _e931) * _e775)) - _e921) * _e781));
let _e949 = (_e543 == 0u);
if _e949 {
phi_1600_ = vec3<f32>(_e848, _e897, _e947);
} else {
if _e949 {
phi_1539_ = 1f;
} else {
let _e954 = global_2.member.member_12.member_20.member;
let _e962 = (((_e954.member * _e552) + (_e954.member_1 * _e553)) + (_e954.member_2 * _e554));
let _e966 = (_e552 - (_e954.member * _e962));
let _e967 = (_e553 - (_e954.member_1 * _e962));
let _e968 = (_e554 - (_e954.member_2 * _e962));
let _e973 = (((_e966 * _e966) + (_e967 * _e967)) + (_e968 * _e968));
let _e984 = global_2.member.member_12.member_20.member_1;
let _e990 = global_2.member.member_12.member_20.member_2;
let _e991 = ((_e984 - (sqrt(select(0f, _e973, (_e973 > 0f))) / select(1e-20f, _e962, (_e962 > 1e-20f)))) * _e990);
let _e993 = select(0f, _e991, (_e991 > 0f));
let _e995 = select(1f, _e993, (_e993 < 1f));
phi_1539_ = select(1f, select(0f, ((_e995 * _e995) * (3f - (2f * _e995))), (_e962 > 0f)), (_e990 > 0f));
}
let _e1005 = phi_1539_;
let _e1007 = select(0f, 1f, (_e554 > 0f));
let _e1011 = ((_e848 * _e1007) + _e1005);
let _e1012 = ((_e897 * _e1007) + _e1005);
let _e1013 = ((_e947 * _e1007) + _e1005);
if _e949 {
phi_1595_ = 1f;
} else {
phi_1595_ = (1f / select(1e-12f, _e559, (_e559 > 1e-12f)));
}
let _e1024 = phi_1595_;
phi_1600_ = vec3<f32>((select(0f, _e1011, (_e1011 > 0f)) * _e1024), (select(0f, _e1012, (_e1012 > 0f)) * _e1024), (select(0f, _e1013, (_e1013 > 0f)) * _e1024));
}
let _e1030 = phi_1600_;
let _e1034 = global_2.member.member_11.member_1;
phi_1860_ = type_28((vec3<f32>(_e1034.member, _e1034.member_1, _e1034.member_2) * _e1030), _e610);
} else {
let _e1041 = (_e543 == 0u);
if _e1041 {
let _e1045 = global_2.member.member_11.member_1;
let _e1053 = global_2.member.member_11.member;
phi_1859_ = type_28(vec3<f32>(_e1045.member, _e1045.member_1, _e1045.member_2), vec3<f32>(_e1053.member, _e1053.member_1, _e1053.member_2));
} else {
let _e1062 = global_2.member.member_11.member_1;
if _e1041 {
phi_1703_ = 1f;
} else {
phi_1703_ = (1f / select(1e-12f, _e559, (_e559 > 1e-12f)));
}
let _e1070 = phi_1703_;
if _e1041 {
phi_1787_ = 1f;
} else {
let _e1075 = global_2.member.member_12.member_20.member;
let _e1083 = (((_e1075.member * _e552) + (_e1075.member_1 * _e553)) + (_e1075.member_2 * _e554));
let _e1087 = (_e552 - (_e1075.member * _e1083));
let _e1088 = (_e553 - (_e1075.member_1 * _e1083));
let _e1089 = (_e554 - (_e1075.member_2 * _e1083));
let _e1094 = (((_e1087 * _e1087) + (_e1088 * _e1088)) + (_e1089 * _e1089));
let _e1105 = global_2.member.member_12.member_20.member_1;
let _e1111 = global_2.member.member_12.member_20.member_2;
let _e1112 = ((_e1105 - (sqrt(select(0f, _e1094, (_e1094 > 0f))) / select(1e-20f, _e1083, (_e1083 > 1e-20f)))) * _e1111);
let _e1114 = select(0f, _e1112, (_e1112 > 0f));
let _e1116 = select(1f, _e1114, (_e1114 < 1f));
phi_1787_ = select(1f, select(0f, ((_e1116 * _e1116) * (3f - (2f * _e1116))), (_e1083 > 0f)), (_e1111 > 0f));
}
let _e1126 = phi_1787_;
let _e1127 = (_e1070 * _e1126);
phi_1859_ = type_28(vec3<f32>((_e1062.member * _e1127), (_e1062.member_1 * _e1127), (_e1062.member_2 * _e1127)), _e610);
}
let _e1134 = phi_1859_;
phi_1860_ = _e1134;
}
let _e1136 = phi_1860_;
let _e1145 = (((_e1136.member_1.x * _e1136.member_1.x) + (_e1136.member_1.y * _e1136.member_1.y)) + (_e1136.member_1.z * _e1136.member_1.z));
let _e1148 = sqrt(select(0f, _e1145, (_e1145 > 0f)));
let _e1154 = (1e-6f * _e1148);
let _e1158 = select((_e1148 / select(_e1154, _e1136.member_1.z, (_e1136.member_1.z > _e1154))), 1f, ((_e613 & 8u) != 0u));
let _e1167 = global_2.member.member_20;
let _e1179 = (-((((select(_e463.member, _e452.member, _e446) * _e1136.member_1.x) + (select(_e463.member_1, _e452.member_1, _e446) * _e1136.member_1.y)) + (select(_e463.member_2, _e452.member_2, _e446) * _e1136.member_1.z))) / select(1e-20f, _e1148, (_e1148 > 1e-20f)));
let _e1184 = bitcast<f32>((bitcast<u32>(select(0f, _e1179, (_e1179 > 0f))) & 2147483647u));
let _e1197 = ((_e334 || (_e198 == 3f)) && (_e444 != -1i));
let _e1202 = select(0f, (1f - _e242), _e1197);
let _e1203 = local_25;
let _e1205 = local_24;
let _e1206 = ((19i * _e1203) + _e1205);
let _e1208 = select(_e191, _e1206, (_e1206 < _e191));
let _e1213 = global_3.member[bitcast<u32>(select(0i, _e1208, (_e1208 > 0i)))];
let _e1214 = (1f - _e1213);
let _e1218 = (_e1202 * _e1214);
let _e1225 = (_e242 + _e1202);
let _e1231 = ((1f - _e1225) * _e1214);
let _e1232 = local_24;
local_20 = _e1232;
local_21 = _e185;
let _e1233 = local_21;
let _e1235 = local_20;
let _e1236 = ((3i * _e1233) + _e1235);
let _e1238 = select(_e191, _e1236, (_e1236 < _e191));
let _e1243 = global_3.member[bitcast<u32>(select(0i, _e1238, (_e1238 > 0i)))];
let _e1244 = local_21;
let _e1246 = local_20;
let _e1247 = ((4i * _e1244) + _e1246);
let _e1249 = select(_e191, _e1247, (_e1247 < _e191));
let _e1254 = global_3.member[bitcast<u32>(select(0i, _e1249, (_e1249 > 0i)))];
let _e1255 = local_21;
let _e1257 = local_20;
let _e1258 = ((5i * _e1255) + _e1257);
let _e1260 = select(_e191, _e1258, (_e1258 < _e191));
let _e1265 = global_3.member[bitcast<u32>(select(0i, _e1260, (_e1260 > 0i)))];
let _e1269 = global_2.member.member_23.member_4;
let _e1277 = (((_e1269.member * _e1243) + (_e1269.member_1 * _e1254)) + (_e1269.member_2 * _e1265));
let _e1281 = global_2.member.member_23.member_5;
let _e1289 = (((_e1281.member * _e1243) + (_e1281.member_1 * _e1254)) + (_e1281.member_2 * _e1265));
let _e1293 = global_2.member.member_23.member_6;
let _e1301 = (((_e1293.member * _e1243) + (_e1293.member_1 * _e1254)) + (_e1293.member_2 * _e1265));
let _e1306 = (((_e1277 * _e1277) + (_e1289 * _e1289)) + (_e1301 * _e1301));
let _e1309 = sqrt(select(0f, _e1306, (_e1306 > 0f)));
let _e1312 = (1f / select(1e-20f, _e1309, (_e1309 > 1e-20f)));
let _e1313 = (_e1277 * _e1312);
let _e1314 = (_e1289 * _e1312);
let _e1315 = (_e1301 * _e1312);
let _e1316 = local_22;
let _e1317 = bitcast<i32>(_e1316);
let _e1318 = local_23;
let _e1319 = bitcast<i32>(_e1318);
local_19 = 3u;
let _e1322 = global_2.member.member_3.member;
let _e1323 = bitcast<i32>(_e1322);
let _e1326 = global_2.member.member_3.member_1;
let _e1327 = bitcast<i32>(_e1326);
let _e1329 = global_2.member.member_5;
let _e1330 = (_e1329 == 0u);
if _e1330 {
phi_2180_ = _e1323;
} else {
phi_2180_ = bitcast<i32>(_e1329);
}
let _e1333 = phi_2180_;
if (_e1333 == 0i) {
break;
}
if ((_e1333 == -1i) && (_e1317 == i32(-2147483648))) {
break;
}
let _e1339 = (_e1317 - (_e1317 % _e1333));
let _e1341 = ((_e1339 + _e1333) - 1i);
if (_e1317 > _e1339) {
phi_2200_ = (_e1317 - 1i);
} else {
phi_2200_ = _e1339;
}
let _e1345 = phi_2200_;
if (_e1317 < _e1341) {
phi_2206_ = (_e1317 + 1i);
} else {
phi_2206_ = _e1341;
}
let _e1349 = phi_2206_;
if _e1330 {
phi_2216_ = _e1327;
} else {
phi_2216_ = bitcast<i32>(_e1329);
}
let _e1352 = phi_2216_;
if (_e1352 == 0i) {
break;
}
if ((_e1352 == -1i) && (_e1319 == i32(-2147483648))) {
break;
}
let _e1358 = (_e1319 - (_e1319 % _e1352));
let _e1360 = ((_e1358 + _e1352) - 1i);
if (_e1319 > _e1358) {
phi_2236_ = (_e1319 - 1i);
} else {
phi_2236_ = _e1358;
}
let _e1364 = phi_2236_;
if (_e1319 < _e1360) {
phi_2242_ = (_e1319 + 1i);
} else {
phi_2242_ = _e1360;
}
let _e1368 = phi_2242_;
let _e1370 = bitcast<u32>(_e1345);
let _e1371 = bitcast<u32>(_e1319);
let _e1372 = (_e1370 % 16u);
let _e1373 = (_e1371 % 4u);
let _e1375 = (_e1322 - (_e1322 % 16u));
let _e1378 = (_e1326 - (_e1326 % 4u));
let _e1379 = (_e1371 < _e1378);
if ((_e1370 < _e1375) && _e1379) {
phi_2289_ = ((((_e1371 - _e1373) + (_e1372 / 4u)) * _e1322) + (((_e1370 - _e1372) + (_e1373 * 4u)) + (_e1372 % 4u)));
} else {
phi_2289_ = ((_e1371 * _e1322) + _e1370);
}
let _e1394 = phi_2289_;
let _e1396 = local_19;
local_17 = bitcast<i32>(_e1394);
let _e1398 = bitcast<i32>((_e1322 * _e1326));
local_18 = _e1398;
let _e1400 = local_18;
let _e1402 = local_17;
let _e1403 = ((bitcast<i32>(_e1396) * _e1400) + _e1402);
let _e1405 = select(_e191, _e1403, (_e1403 < _e191));
let _e1410 = global_3.member[bitcast<u32>(select(0i, _e1405, (_e1405 > 0i)))];
let _e1413 = local_18;
let _e1415 = local_17;
let _e1416 = ((bitcast<i32>((_e1396 + 1u)) * _e1413) + _e1415);
let _e1418 = select(_e191, _e1416, (_e1416 < _e191));
let _e1423 = global_3.member[bitcast<u32>(select(0i, _e1418, (_e1418 > 0i)))];
let _e1426 = local_18;
let _e1428 = local_17;
let _e1429 = ((bitcast<i32>((_e1396 + 2u)) * _e1426) + _e1428);
let _e1431 = select(_e191, _e1429, (_e1429 < _e191));
let _e1436 = global_3.member[bitcast<u32>(select(0i, _e1431, (_e1431 > 0i)))];
let _e1439 = global_2.member.member_23.member_4;
let _e1447 = (((_e1439.member * _e1410) + (_e1439.member_1 * _e1423)) + (_e1439.member_2 * _e1436));
let _e1450 = global_2.member.member_23.member_5;
let _e1458 = (((_e1450.member * _e1410) + (_e1450.member_1 * _e1423)) + (_e1450.member_2 * _e1436));
let _e1461 = global_2.member.member_23.member_6;
let _e1469 = (((_e1461.member * _e1410) + (_e1461.member_1 * _e1423)) + (_e1461.member_2 * _e1436));
let _e1470 = bitcast<u32>(_e1349);
let _e1471 = (_e1470 % 16u);
if ((_e1470 < _e1375) && _e1379) {
phi_2440_ = ((((_e1371 - _e1373) + (_e1471 / 4u)) * _e1322) + (((_e1470 - _e1471) + (_e1373 * 4u)) + (_e1471 % 4u)));
} else {
phi_2440_ = ((_e1371 * _e1322) + _e1470);
}
let _e1487 = phi_2440_;
let _e1489 = local_19;
local_15 = bitcast<i32>(_e1487);
local_16 = _e1398;
let _e1491 = local_16;
let _e1493 = local_15;
let _e1494 = ((bitcast<i32>(_e1489) * _e1491) + _e1493);
let _e1496 = select(_e191, _e1494, (_e1494 < _e191));
let _e1501 = global_3.member[bitcast<u32>(select(0i, _e1496, (_e1496 > 0i)))];
let _e1504 = local_16;
let _e1506 = local_15;
let _e1507 = ((bitcast<i32>((_e1489 + 1u)) * _e1504) + _e1506);
let _e1509 = select(_e191, _e1507, (_e1507 < _e191));
let _e1514 = global_3.member[bitcast<u32>(select(0i, _e1509, (_e1509 > 0i)))];
let _e1517 = local_16;
let _e1519 = local_15;
let _e1520 = ((bitcast<i32>((_e1489 + 2u)) * _e1517) + _e1519);
let _e1522 = select(_e191, _e1520, (_e1520 < _e191));
let _e1527 = global_3.member[bitcast<u32>(select(0i, _e1522, (_e1522 > 0i)))];
let _e1532 = (((_e1439.member * _e1501) + (_e1439.member_1 * _e1514)) + (_e1439.member_2 * _e1527));
let _e1537 = (((_e1450.member * _e1501) + (_e1450.member_1 * _e1514)) + (_e1450.member_2 * _e1527));
let _e1542 = (((_e1461.member * _e1501) + (_e1461.member_1 * _e1514)) + (_e1461.member_2 * _e1527));
let _e1547 = (((_e1447 * _e1447) + (_e1458 * _e1458)) + (_e1469 * _e1469));
let _e1550 = sqrt(select(0f, _e1547, (_e1547 > 0f)));
let _e1555 = (((_e1532 * _e1532) + (_e1537 * _e1537)) + (_e1542 * _e1542));
let _e1558 = sqrt(select(0f, _e1555, (_e1555 > 0f)));
let _e1559 = (_e1558 > 1e-9f);
let _e1561 = (1f / select(1e-9f, _e1558, _e1559));
let _e1565 = (_e1550 > 1e-9f);
let _e1567 = (1f / select(1e-9f, _e1550, _e1565));
let _e1571 = ((_e1532 * _e1561) - (_e1447 * _e1567));
let _e1572 = ((_e1537 * _e1561) - (_e1458 * _e1567));
let _e1573 = ((_e1542 * _e1561) - (_e1469 * _e1567));
let _e1578 = (((_e1571 * _e1571) + (_e1572 * _e1572)) + (_e1573 * _e1573));
let _e1583 = f32((_e1349 - _e1345));
let _e1587 = select(0f, (sqrt(select(0f, _e1578, (_e1578 > 0f))) / select(1f, _e1583, (_e1583 > 1f))), (_e1565 && _e1559));
let _e1589 = bitcast<u32>(_e1317);
let _e1590 = bitcast<u32>(_e1364);
let _e1591 = (_e1589 % 16u);
let _e1592 = (_e1590 % 4u);
let _e1593 = (_e1589 < _e1375);
if (_e1593 && (_e1590 < _e1378)) {
phi_2667_ = ((((_e1590 - _e1592) + (_e1591 / 4u)) * _e1322) + (((_e1589 - _e1591) + (_e1592 * 4u)) + (_e1591 % 4u)));
} else {
phi_2667_ = ((_e1590 * _e1322) + _e1589);
}
let _e1609 = phi_2667_;
let _e1611 = local_19;
local_13 = bitcast<i32>(_e1609);
local_14 = _e1398;
let _e1613 = local_14;
let _e1615 = local_13;
let _e1616 = ((bitcast<i32>(_e1611) * _e1613) + _e1615);
let _e1618 = select(_e191, _e1616, (_e1616 < _e191));
let _e1623 = global_3.member[bitcast<u32>(select(0i, _e1618, (_e1618 > 0i)))];
let _e1626 = local_14;
let _e1628 = local_13;
let _e1629 = ((bitcast<i32>((_e1611 + 1u)) * _e1626) + _e1628);
let _e1631 = select(_e191, _e1629, (_e1629 < _e191));
let _e1636 = global_3.member[bitcast<u32>(select(0i, _e1631, (_e1631 > 0i)))];
let _e1639 = local_14;
let _e1641 = local_13;
let _e1642 = ((bitcast<i32>((_e1611 + 2u)) * _e1639) + _e1641);
let _e1644 = select(_e191, _e1642, (_e1642 < _e191));
let _e1649 = global_3.member[bitcast<u32>(select(0i, _e1644, (_e1644 > 0i)))];
let _e1654 = (((_e1439.member * _e1623) + (_e1439.member_1 * _e1636)) + (_e1439.member_2 * _e1649));
let _e1659 = (((_e1450.member * _e1623) + (_e1450.member_1 * _e1636)) + (_e1450.member_2 * _e1649));
let _e1664 = (((_e1461.member * _e1623) + (_e1461.member_1 * _e1636)) + (_e1461.member_2 * _e1649));
let _e1665 = bitcast<u32>(_e1368);
let _e1666 = (_e1665 % 4u);
if (_e1593 && (_e1665 < _e1378)) {
phi_2818_ = ((((_e1665 - _e1666) + (_e1591 / 4u)) * _e1322) + (((_e1589 - _e1591) + (_e1666 * 4u)) + (_e1591 % 4u)));
} else {
phi_2818_ = ((_e1665 * _e1322) + _e1589);
}
let _e1682 = phi_2818_;
let _e1684 = local_19;
local_11 = bitcast<i32>(_e1682);
local_12 = _e1398;
let _e1686 = local_12;
let _e1688 = local_11;
let _e1689 = ((bitcast<i32>(_e1684) * _e1686) + _e1688);
let _e1691 = select(_e191, _e1689, (_e1689 < _e191));
let _e1696 = global_3.member[bitcast<u32>(select(0i, _e1691, (_e1691 > 0i)))];
let _e1699 = local_12;
let _e1701 = local_11;
let _e1702 = ((bitcast<i32>((_e1684 + 1u)) * _e1699) + _e1701);
let _e1704 = select(_e191, _e1702, (_e1702 < _e191));
let _e1709 = global_3.member[bitcast<u32>(select(0i, _e1704, (_e1704 > 0i)))];
let _e1712 = local_12;
let _e1714 = local_11;
let _e1715 = ((bitcast<i32>((_e1684 + 2u)) * _e1712) + _e1714);
let _e1717 = select(_e191, _e1715, (_e1715 < _e191));
let _e1722 = global_3.member[bitcast<u32>(select(0i, _e1717, (_e1717 > 0i)))];
let _e1727 = (((_e1439.member * _e1696) + (_e1439.member_1 * _e1709)) + (_e1439.member_2 * _e1722));
let _e1732 = (((_e1450.member * _e1696) + (_e1450.member_1 * _e1709)) + (_e1450.member_2 * _e1722));
let _e1737 = (((_e1461.member * _e1696) + (_e1461.member_1 * _e1709)) + (_e1461.member_2 * _e1722));
let _e1742 = (((_e1654 * _e1654) + (_e1659 * _e1659)) + (_e1664 * _e1664));
let _e1745 = sqrt(select(0f, _e1742, (_e1742 > 0f)));
let _e1750 = (((_e1727 * _e1727) + (_e1732 * _e1732)) + (_e1737 * _e1737));
let _e1753 = sqrt(select(0f, _e1750, (_e1750 > 0f)));
let _e1754 = (_e1753 > 1e-9f);
let _e1756 = (1f / select(1e-9f, _e1753, _e1754));
let _e1760 = (_e1745 > 1e-9f);
let _e1762 = (1f / select(1e-9f, _e1745, _e1760));
let _e1766 = ((_e1727 * _e1756) - (_e1654 * _e1762));
let _e1767 = ((_e1732 * _e1756) - (_e1659 * _e1762));
let _e1768 = ((_e1737 * _e1756) - (_e1664 * _e1762));
let _e1773 = (((_e1766 * _e1766) + (_e1767 * _e1767)) + (_e1768 * _e1768));
let _e1778 = f32((_e1368 - _e1364));
let _e1782 = select(0f, (sqrt(select(0f, _e1773, (_e1773 > 0f))) / select(1f, _e1778, (_e1778 > 1f))), (_e1760 && _e1754));
let _e1784 = select(_e1782, _e1587, (_e1587 > _e1782));
let _e1788 = global_2.member.member_23.member;
let _e1792 = global_2.member.member_23.member_7;
let _e1796 = vec3<f32>(_e1792.member, _e1792.member_1, _e1792.member_2);
let _e1800 = global_2.member.member_23.member_8;
let _e1804 = (_e1788 == 0u);
if _e1804 {
phi_4434_ = _e1796;
} else {
if (_e1788 == 1u) {
let _e1807 = select(-1f, _e1315, (_e1315 > -1f));
let _e1809 = select(1f, _e1807, (_e1807 < 1f));
if (_e1809 > 0f) {
phi_3049_ = _e1796;
} else {
let _e1814 = global_2.member.member_23.member_9;
phi_3049_ = vec3<f32>(_e1814.member, _e1814.member_1, _e1814.member_2);
}
let _e1820 = phi_3049_;
let _e1829 = bitcast<f32>((bitcast<u32>(_e1809) & 2147483647u));
let _e1832 = sqrt(select(0f, _e1829, (_e1829 > 0f)));
phi_4433_ = vec3<f32>((_e1800.member + ((_e1820.x - _e1800.member) * _e1832)), (_e1800.member_1 + ((_e1820.y - _e1800.member_1) * _e1832)), (_e1800.member_2 + ((_e1820.z - _e1800.member_2) * _e1832)));
} else {
if (_e1788 == 2u) {
let _e1844 = global_2.member.member_23.member_10;
let _e1845 = (_e1784 / _e1844);
let _e1847 = select(1e-4f, _e1845, (_e1845 > 1e-4f));
let _e1850 = bitcast<f32>((bitcast<u32>(_e1313) & 2147483647u));
let _e1853 = bitcast<f32>((bitcast<u32>(_e1314) & 2147483647u));
let _e1857 = select(_e1853, _e1850, (_e1850 > _e1853));
let _e1860 = (select(_e1853, _e1850, (_e1850 < _e1853)) / select(1.1754944e-38f, _e1857, (_e1857 > 1.1754944e-38f)));
let _e1861 = (_e1860 > 0.41421357f);
let _e1865 = select(_e1860, ((_e1860 - 1f) / (_e1860 + 1f)), _e1861);
let _e1866 = (_e1865 * _e1865);
let _e1881 = (select(0f, 0.7853982f, _e1861) + (_e1865 + ((_e1865 * _e1866) * (-0.33333334f + (_e1866 * (0.2f + (_e1866 * (-0.14285713f + (_e1866 * (0.11111111f + (_e1866 * (-0.09090909f + (_e1866 * 0.0585f)))))))))))));
let _e1884 = select(_e1881, (1.5707964f - _e1881), (_e1853 > _e1850));
let _e1887 = select(_e1884, (3.1415927f - _e1884), (_e1313 < 0f));
let _e1893 = (1f - (_e1315 * _e1315));
let _e1896 = sqrt(select(0f, _e1893, (_e1893 > 0f)));
let _e1899 = (_e1847 / select(1e-3f, _e1896, (_e1896 > 1e-3f)));
let _e1900 = ((select(_e1887, -(_e1887), (_e1314 < 0f)) / _e1844) * 0.5f);
let _e1902 = select(-8e6f, _e1900, (_e1900 > -8e6f));
let _e1904 = select(8e6f, _e1902, (_e1902 < 8e6f));
let _e1911 = select(0i, select(select(i32(_e1904), i32(-2147483648), (_e1904 < -2147483600f)), 2147483647i, (_e1904 > 2147483500f)), (_e1904 == _e1904));
let _e1918 = ((_e1900 - f32((_e1911 - select(0i, 1i, (_e1904 < f32(_e1911)))))) * 2f);
let _e1926 = ((select(select((_e1918 - 2f), (1f - _e1918), (_e1918 < 1.5f)), _e1918, (_e1918 < 0.5f)) * 2f) / _e1899);
let _e1928 = select(-1f, _e1926, (_e1926 > -1f));
let _e1931 = (2f - _e1899);
let _e1933 = select(0f, _e1931, (_e1931 > 0f));
let _e1938 = select(-1f, _e1315, (_e1315 > -1f));
let _e1940 = select(1f, _e1938, (_e1938 < 1f));
let _e1943 = ((1f - _e1940) * (1f + _e1940));
let _e1946 = sqrt(select(0f, _e1943, (_e1943 > 0f)));
let _e1949 = bitcast<f32>((bitcast<u32>(_e1946) & 2147483647u));
let _e1952 = bitcast<f32>((bitcast<u32>(_e1940) & 2147483647u));
let _e1956 = select(_e1952, _e1949, (_e1949 > _e1952));
let _e1959 = (select(_e1952, _e1949, (_e1949 < _e1952)) / select(1.1754944e-38f, _e1956, (_e1956 > 1.1754944e-38f)));
let _e1960 = (_e1959 > 0.41421357f);
let _e1964 = select(_e1959, ((_e1959 - 1f) / (_e1959 + 1f)), _e1960);
let _e1965 = (_e1964 * _e1964);
let _e1980 = (select(0f, 0.7853982f, _e1960) + (_e1964 + ((_e1964 * _e1965) * (-0.33333334f + (_e1965 * (0.2f + (_e1965 * (-0.14285713f + (_e1965 * (0.11111111f + (_e1965 * (-0.09090909f + (_e1965 * 0.0585f)))))))))))));
let _e1983 = select(_e1980, (1.5707964f - _e1980), (_e1952 > _e1949));
let _e1986 = select(_e1983, (3.1415927f - _e1983), (_e1946 < 0f));
let _e1991 = ((select(_e1986, -(_e1986), (_e1940 < 0f)) / _e1844) * 0.5f);
let _e1993 = select(-8e6f, _e1991, (_e1991 > -8e6f));
let _e1995 = select(8e6f, _e1993, (_e1993 < 8e6f));
let _e2002 = select(0i, select(select(i32(_e1995), i32(-2147483648), (_e1995 < -2147483600f)), 2147483647i, (_e1995 > 2147483500f)), (_e1995 == _e1995));
let _e2009 = ((_e1991 - f32((_e2002 - select(0i, 1i, (_e1995 < f32(_e2002)))))) * 2f);
let _e2017 = ((select(select((_e2009 - 2f), (1f - _e2009), (_e2009 < 1.5f)), _e2009, (_e2009 < 0.5f)) * 2f) / _e1847);
let _e2019 = select(-1f, _e2017, (_e2017 > -1f));
let _e2022 = (2f - _e1847);
let _e2024 = select(0f, _e2022, (_e2022 > 0f));
let _e2030 = (0.5f + ((0.5f * (select(1f, _e1928, (_e1928 < 1f)) * select(1f, _e1933, (_e1933 < 1f)))) * (select(1f, _e2019, (_e2019 < 1f)) * select(1f, _e2024, (_e2024 < 1f)))));
phi_4432_ = vec3<f32>((_e1792.member + ((_e1800.member - _e1792.member) * _e2030)), (_e1792.member_1 + ((_e1800.member_1 - _e1792.member_1) * _e2030)), (_e1792.member_2 + ((_e1800.member_2 - _e1792.member_2) * _e2030)));
} else {
let _e2044 = global_2.member.member_23.member_1;
let _e2045 = bitcast<i32>(_e2044);
let _e2050 = global_2.member.member_23.member_3;
let _e2052 = f32(bitcast<i32>(_e2050));
let _e2054 = (2f * 3.1415927f);
let _e2055 = ((_e1784 * f32(_e2045)) / _e2054);
let _e2057 = select(1e-6f, _e2055, (_e2055 > 1e-6f));
let _e2060 = bitcast<u32>(select(1.1754944e-38f, _e2057, (_e2057 > 1.1754944e-38f)));
let _e2061 = (_e2060 & 8388607u);
let _e2063 = select(0u, 1u, (_e2061 > 3474675u));
let _e2074 = bitcast<f32>((_e2061 | ((127u - _e2063) << bitcast<u32>(23i))));
let _e2077 = ((_e2074 - 1f) / (_e2074 + 1f));
let _e2078 = (_e2077 * _e2077);
let _e2093 = (f32(((bitcast<i32>((_e2060 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e2063))) + (((2f * _e2077) + ((_e2077 * _e2078) * (0.6666667f + (_e2078 * (0.4f + (_e2078 * (0.2857143f + (_e2078 * (0.22222222f + (_e2078 * 0.18181819f)))))))))) * 1.442695f));
let _e2094 = (_e2052 - 1f);
let _e2096 = select(0f, _e2093, (_e2093 > 0f));
let _e2098 = select(_e2094, _e2096, (_e2096 < _e2094));
let _e2099 = (_e2052 - 2f);
let _e2101 = select(0f, _e2099, (_e2099 > 0f));
let _e2103 = select(0f, _e2098, (_e2098 > 0f));
let _e2105 = select(_e2101, _e2103, (_e2103 < _e2101));
let _e2112 = select(0i, select(select(i32(_e2105), i32(-2147483648), (_e2105 < -2147483600f)), 2147483647i, (_e2105 > 2147483500f)), (_e2105 == _e2105));
let _e2116 = (_e2112 - select(0i, 1i, (_e2105 < f32(_e2112))));
let _e2119 = bitcast<f32>((bitcast<u32>(_e1314) & 2147483647u));
let _e2122 = bitcast<f32>((bitcast<u32>(_e1313) & 2147483647u));
let _e2126 = select(_e2122, _e2119, (_e2119 > _e2122));
let _e2129 = (select(_e2122, _e2119, (_e2119 < _e2122)) / select(1.1754944e-38f, _e2126, (_e2126 > 1.1754944e-38f)));
let _e2130 = (_e2129 > 0.41421357f);
let _e2134 = select(_e2129, ((_e2129 - 1f) / (_e2129 + 1f)), _e2130);
let _e2135 = (_e2134 * _e2134);
let _e2150 = (select(0f, 0.7853982f, _e2130) + (_e2134 + ((_e2134 * _e2135) * (-0.33333334f + (_e2135 * (0.2f + (_e2135 * (-0.14285713f + (_e2135 * (0.11111111f + (_e2135 * (-0.09090909f + (_e2135 * 0.0585f)))))))))))));
let _e2153 = select(_e2150, (1.5707964f - _e2150), (_e2122 > _e2119));
let _e2156 = select(_e2153, (3.1415927f - _e2153), (_e1314 < 0f));
let _e2161 = (0.5f - (select(_e2156, -(_e2156), (_e1313 < 0f)) / _e2054));
let _e2163 = select(-1f, _e1315, (_e1315 > -1f));
let _e2165 = select(1f, _e2163, (_e2163 < 1f));
let _e2168 = ((1f - _e2165) * (1f + _e2165));
let _e2171 = sqrt(select(0f, _e2168, (_e2168 > 0f)));
let _e2174 = bitcast<f32>((bitcast<u32>(_e2171) & 2147483647u));
let _e2177 = bitcast<f32>((bitcast<u32>(_e2165) & 2147483647u));
let _e2181 = select(_e2177, _e2174, (_e2174 > _e2177));
let _e2184 = (select(_e2177, _e2174, (_e2174 < _e2177)) / select(1.1754944e-38f, _e2181, (_e2181 > 1.1754944e-38f)));
let _e2185 = (_e2184 > 0.41421357f);
let _e2189 = select(_e2184, ((_e2184 - 1f) / (_e2184 + 1f)), _e2185);
let _e2190 = (_e2189 * _e2189);
let _e2205 = (select(0f, 0.7853982f, _e2185) + (_e2189 + ((_e2189 * _e2190) * (-0.33333334f + (_e2190 * (0.2f + (_e2190 * (-0.14285713f + (_e2190 * (0.11111111f + (_e2190 * (-0.09090909f + (_e2190 * 0.0585f)))))))))))));
let _e2208 = select(_e2205, (1.5707964f - _e2205), (_e2177 > _e2174));
let _e2211 = select(_e2208, (3.1415927f - _e2208), (_e2171 < 0f));
let _e2216 = (0.5f - (select(_e2211, -(_e2211), (_e2165 < 0f)) / 3.1415927f));
let _e2220 = global_2.member.member_23.member_2;
let _e2221 = bitcast<i32>(_e2220);
phi_3651_ = 0i;
phi_3654_ = 0i;
phi_3656_ = _e2221;
phi_3658_ = _e2045;
loop {
let _e2223 = phi_3651_;
let _e2225 = phi_3654_;
let _e2227 = phi_3656_;
let _e2229 = phi_3658_;
local_26 = _e2229;
local_27 = _e2227;
local_28 = _e2229;
local_29 = _e2229;
local_30 = _e2229;
local_31 = _e2229;
local_32 = _e2229;
local_33 = _e2229;
local_34 = _e2227;
local_35 = _e2227;
local_36 = _e2227;
local_37 = _e2227;
local_38 = _e2229;
local_39 = _e2225;
local_40 = _e2229;
local_41 = _e2225;
let _e2230 = (_e2223 < _e2116);
if _e2230 {
if (_e2229 > 1i) {
phi_3673_ = (_e2229 >> bitcast<u32>(1i));
} else {
phi_3673_ = 1i;
}
let _e2237 = phi_3673_;
if (_e2227 > 1i) {
phi_3679_ = (_e2227 >> bitcast<u32>(1i));
} else {
phi_3679_ = 1i;
}
let _e2242 = phi_3679_;
phi_3652_ = (_e2223 + 1i);
phi_3655_ = (_e2225 + (_e2229 * _e2227));
phi_3657_ = _e2242;
phi_3659_ = _e2237;
} else {
phi_3652_ = i32();
phi_3655_ = i32();
phi_3657_ = i32();
phi_3659_ = i32();
}
let _e2245 = phi_3652_;
let _e2247 = phi_3655_;
let _e2249 = phi_3657_;
let _e2251 = phi_3659_;
continue;
continuing {
phi_3651_ = _e2245;
phi_3654_ = _e2247;
phi_3656_ = _e2249;
phi_3658_ = _e2251;
break if !(_e2230);
}
}
let _e2254 = local_26;
let _e2255 = f32(_e2254);
let _e2257 = ((_e2161 * _e2255) - 0.5f);
let _e2259 = local_27;
let _e2260 = f32(_e2259);
let _e2262 = ((_e2216 * _e2260) - 0.5f);
let _e2264 = select(-1f, _e2257, (_e2257 > -1f));
let _e2266 = select(_e2255, _e2264, (_e2264 < _e2255));
let _e2273 = select(0i, select(select(i32(_e2266), i32(-2147483648), (_e2266 < -2147483600f)), 2147483647i, (_e2266 > 2147483500f)), (_e2266 == _e2266));
let _e2277 = (_e2273 - select(0i, 1i, (_e2266 < f32(_e2273))));
let _e2279 = select(-1f, _e2262, (_e2262 > -1f));
let _e2281 = select(_e2260, _e2279, (_e2279 < _e2260));
let _e2288 = select(0i, select(select(i32(_e2281), i32(-2147483648), (_e2281 < -2147483600f)), 2147483647i, (_e2281 > 2147483500f)), (_e2281 == _e2281));
let _e2292 = (_e2288 - select(0i, 1i, (_e2281 < f32(_e2288))));
let _e2294 = (_e2257 - f32(_e2277));
let _e2296 = (_e2262 - f32(_e2292));
let _e2298 = select(0f, _e2296, (_e2296 > 0f));
let _e2300 = select(1f, _e2298, (_e2298 < 1f));
if (_e2277 < 0i) {
let _e2303 = local_28;
phi_3754_ = (_e2277 + _e2303);
} else {
phi_3754_ = _e2277;
}
let _e2306 = phi_3754_;
let _e2308 = local_29;
if (_e2306 >= _e2308) {
let _e2311 = local_30;
phi_3760_ = (_e2306 - _e2311);
} else {
phi_3760_ = _e2306;
}
let _e2314 = phi_3760_;
let _e2315 = (_e2277 + 1i);
if (_e2315 < 0i) {
let _e2318 = local_31;
phi_3767_ = (_e2315 + _e2318);
} else {
phi_3767_ = _e2315;
}
let _e2321 = phi_3767_;
let _e2323 = local_32;
if (_e2321 >= _e2323) {
let _e2326 = local_33;
phi_3773_ = (_e2321 - _e2326);
} else {
phi_3773_ = _e2321;
}
let _e2329 = phi_3773_;
let _e2331 = select(_e2292, 0i, (_e2292 < 0i));
let _e2333 = local_34;
if (_e2331 >= _e2333) {
let _e2336 = local_35;
phi_3784_ = (_e2336 - 1i);
} else {
phi_3784_ = _e2331;
}
let _e2339 = phi_3784_;
let _e2340 = (_e2292 + 1i);
let _e2342 = select(_e2340, 0i, (_e2340 < 0i));
let _e2344 = local_36;
if (_e2342 >= _e2344) {
let _e2347 = local_37;
phi_3796_ = (_e2347 - 1i);
} else {
phi_3796_ = _e2342;
}
let _e2350 = phi_3796_;
let _e2352 = local_38;
let _e2355 = local_39;
let _e2356 = (_e2355 + (_e2339 * _e2352));
let _e2358 = local_40;
let _e2361 = local_41;
let _e2362 = (_e2361 + (_e2350 * _e2358));
let _e2364 = (3i * (_e2356 + _e2314));
let _e2366 = (bitcast<i32>(_e125) - 1i);
let _e2368 = select(_e2366, _e2364, (_e2364 < _e2366));
let _e2374 = global_4.member[bitcast<u32>(select(0i, _e2368, (_e2368 > 0i)))];
let _e2375 = (_e2364 + 1i);
let _e2377 = select(_e2366, _e2375, (_e2375 < _e2366));
let _e2383 = global_4.member[bitcast<u32>(select(0i, _e2377, (_e2377 > 0i)))];
let _e2384 = (_e2364 + 2i);
let _e2386 = select(_e2366, _e2384, (_e2384 < _e2366));
let _e2392 = global_4.member[bitcast<u32>(select(0i, _e2386, (_e2386 > 0i)))];
let _e2394 = (3i * (_e2356 + _e2329));
let _e2396 = select(_e2366, _e2394, (_e2394 < _e2366));
let _e2402 = global_4.member[bitcast<u32>(select(0i, _e2396, (_e2396 > 0i)))];
let _e2403 = (_e2394 + 1i);
let _e2405 = select(_e2366, _e2403, (_e2403 < _e2366));
let _e2411 = global_4.member[bitcast<u32>(select(0i, _e2405, (_e2405 > 0i)))];
let _e2412 = (_e2394 + 2i);
let _e2414 = select(_e2366, _e2412, (_e2412 < _e2366));
let _e2420 = global_4.member[bitcast<u32>(select(0i, _e2414, (_e2414 > 0i)))];
let _e2422 = (3i * (_e2362 + _e2314));
let _e2424 = select(_e2366, _e2422, (_e2422 < _e2366));
let _e2430 = global_4.member[bitcast<u32>(select(0i, _e2424, (_e2424 > 0i)))];
let _e2431 = (_e2422 + 1i);
let _e2433 = select(_e2366, _e2431, (_e2431 < _e2366));
let _e2439 = global_4.member[bitcast<u32>(select(0i, _e2433, (_e2433 > 0i)))];
let _e2440 = (_e2422 + 2i);
let _e2442 = select(_e2366, _e2440, (_e2440 < _e2366));
let _e2448 = global_4.member[bitcast<u32>(select(0i, _e2442, (_e2442 > 0i)))];
let _e2450 = (3i * (_e2362 + _e2329));
let _e2452 = select(_e2366, _e2450, (_e2450 < _e2366));
let _e2458 = global_4.member[bitcast<u32>(select(0i, _e2452, (_e2452 > 0i)))];
let _e2459 = (_e2450 + 1i);
let _e2461 = select(_e2366, _e2459, (_e2459 < _e2366));
let _e2467 = global_4.member[bitcast<u32>(select(0i, _e2461, (_e2461 > 0i)))];
let _e2468 = (_e2450 + 2i);
let _e2470 = select(_e2366, _e2468, (_e2468 < _e2366));
let _e2476 = global_4.member[bitcast<u32>(select(0i, _e2470, (_e2470 > 0i)))];
let _e2483 = (_e2374 + ((_e2402 - _e2374) * _e2294));
let _e2484 = (_e2383 + ((_e2411 - _e2383) * _e2294));
let _e2485 = (_e2392 + ((_e2420 - _e2392) * _e2294));
let _e2501 = (_e2483 + (((_e2430 + ((_e2458 - _e2430) * _e2294)) - _e2483) * _e2300));
let _e2502 = (_e2484 + (((_e2439 + ((_e2467 - _e2439) * _e2294)) - _e2484) * _e2300));
let _e2503 = (_e2485 + (((_e2448 + ((_e2476 - _e2448) * _e2294)) - _e2485) * _e2300));
phi_4032_ = 0i;
phi_4035_ = 0i;
phi_4037_ = _e2221;
phi_4039_ = _e2045;
loop {
let _e2506 = phi_4032_;
let _e2508 = phi_4035_;
let _e2510 = phi_4037_;
let _e2512 = phi_4039_;
local_42 = _e2512;
local_43 = _e2510;
local_44 = _e2512;
local_45 = _e2512;
local_46 = _e2512;
local_47 = _e2512;
local_48 = _e2512;
local_49 = _e2512;
local_50 = _e2510;
local_51 = _e2510;
local_52 = _e2510;
local_53 = _e2510;
local_54 = _e2512;
local_55 = _e2508;
local_56 = _e2512;
local_57 = _e2508;
let _e2513 = (_e2506 < (_e2116 + 1i));
if _e2513 {
if (_e2512 > 1i) {
phi_4054_ = (_e2512 >> bitcast<u32>(1i));
} else {
phi_4054_ = 1i;
}
let _e2520 = phi_4054_;
if (_e2510 > 1i) {
phi_4060_ = (_e2510 >> bitcast<u32>(1i));
} else {
phi_4060_ = 1i;
}
let _e2525 = phi_4060_;
phi_4033_ = (_e2506 + 1i);
phi_4036_ = (_e2508 + (_e2512 * _e2510));
phi_4038_ = _e2525;
phi_4040_ = _e2520;
} else {
phi_4033_ = i32();
phi_4036_ = i32();
phi_4038_ = i32();
phi_4040_ = i32();
}
let _e2528 = phi_4033_;
let _e2530 = phi_4036_;
let _e2532 = phi_4038_;
let _e2534 = phi_4040_;
continue;
continuing {
phi_4032_ = _e2528;
phi_4035_ = _e2530;
phi_4037_ = _e2532;
phi_4039_ = _e2534;
break if !(_e2513);
}
}
let _e2537 = local_42;
let _e2538 = f32(_e2537);
let _e2540 = ((_e2161 * _e2538) - 0.5f);
let _e2542 = local_43;
let _e2543 = f32(_e2542);
let _e2545 = ((_e2216 * _e2543) - 0.5f);
let _e2547 = select(-1f, _e2540, (_e2540 > -1f));
let _e2549 = select(_e2538, _e2547, (_e2547 < _e2538));
let _e2556 = select(0i, select(select(i32(_e2549), i32(-2147483648), (_e2549 < -2147483600f)), 2147483647i, (_e2549 > 2147483500f)), (_e2549 == _e2549));
let _e2560 = (_e2556 - select(0i, 1i, (_e2549 < f32(_e2556))));
let _e2562 = select(-1f, _e2545, (_e2545 > -1f));
let _e2564 = select(_e2543, _e2562, (_e2562 < _e2543));
let _e2571 = select(0i, select(select(i32(_e2564), i32(-2147483648), (_e2564 < -2147483600f)), 2147483647i, (_e2564 > 2147483500f)), (_e2564 == _e2564));
let _e2575 = (_e2571 - select(0i, 1i, (_e2564 < f32(_e2571))));
let _e2577 = (_e2540 - f32(_e2560));
let _e2579 = (_e2545 - f32(_e2575));
let _e2581 = select(0f, _e2579, (_e2579 > 0f));
let _e2583 = select(1f, _e2581, (_e2581 < 1f));
if (_e2560 < 0i) {
let _e2586 = local_44;
phi_4135_ = (_e2560 + _e2586);
} else {
phi_4135_ = _e2560;
}
let _e2589 = phi_4135_;
let _e2591 = local_45;
if (_e2589 >= _e2591) {
let _e2594 = local_46;
phi_4141_ = (_e2589 - _e2594);
} else {
phi_4141_ = _e2589;
}
let _e2597 = phi_4141_;
let _e2598 = (_e2560 + 1i);
if (_e2598 < 0i) {
let _e2601 = local_47;
phi_4148_ = (_e2598 + _e2601);
} else {
phi_4148_ = _e2598;
}
let _e2604 = phi_4148_;
let _e2606 = local_48;
if (_e2604 >= _e2606) {
let _e2609 = local_49;
phi_4154_ = (_e2604 - _e2609);
} else {
phi_4154_ = _e2604;
}
let _e2612 = phi_4154_;
let _e2614 = select(_e2575, 0i, (_e2575 < 0i));
let _e2616 = local_50;
if (_e2614 >= _e2616) {
let _e2619 = local_51;
phi_4165_ = (_e2619 - 1i);
} else {
phi_4165_ = _e2614;
}
let _e2622 = phi_4165_;
let _e2623 = (_e2575 + 1i);
let _e2625 = select(_e2623, 0i, (_e2623 < 0i));
let _e2627 = local_52;
if (_e2625 >= _e2627) {
let _e2630 = local_53;
phi_4177_ = (_e2630 - 1i);
} else {
phi_4177_ = _e2625;
}
let _e2633 = phi_4177_;
let _e2635 = local_54;
let _e2638 = local_55;
let _e2639 = (_e2638 + (_e2622 * _e2635));
let _e2641 = local_56;
let _e2644 = local_57;
let _e2645 = (_e2644 + (_e2633 * _e2641));
let _e2647 = (3i * (_e2639 + _e2597));
let _e2649 = select(_e2366, _e2647, (_e2647 < _e2366));
let _e2655 = global_4.member[bitcast<u32>(select(0i, _e2649, (_e2649 > 0i)))];
let _e2656 = (_e2647 + 1i);
let _e2658 = select(_e2366, _e2656, (_e2656 < _e2366));
let _e2664 = global_4.member[bitcast<u32>(select(0i, _e2658, (_e2658 > 0i)))];
let _e2665 = (_e2647 + 2i);
let _e2667 = select(_e2366, _e2665, (_e2665 < _e2366));
let _e2673 = global_4.member[bitcast<u32>(select(0i, _e2667, (_e2667 > 0i)))];
let _e2675 = (3i * (_e2639 + _e2612));
let _e2677 = select(_e2366, _e2675, (_e2675 < _e2366));
let _e2683 = global_4.member[bitcast<u32>(select(0i, _e2677, (_e2677 > 0i)))];
let _e2684 = (_e2675 + 1i);
let _e2686 = select(_e2366, _e2684, (_e2684 < _e2366));
let _e2692 = global_4.member[bitcast<u32>(select(0i, _e2686, (_e2686 > 0i)))];
let _e2693 = (_e2675 + 2i);
let _e2695 = select(_e2366, _e2693, (_e2693 < _e2366));
let _e2701 = global_4.member[bitcast<u32>(select(0i, _e2695, (_e2695 > 0i)))];
let _e2703 = (3i * (_e2645 + _e2597));
let _e2705 = select(_e2366, _e2703, (_e2703 < _e2366));
let _e2711 = global_4.member[bitcast<u32>(select(0i, _e2705, (_e2705 > 0i)))];
let _e2712 = (_e2703 + 1i);
let _e2714 = select(_e2366, _e2712, (_e2712 < _e2366));
let _e2720 = global_4.member[bitcast<u32>(select(0i, _e2714, (_e2714 > 0i)))];
let _e2721 = (_e2703 + 2i);
let _e2723 = select(_e2366, _e2721, (_e2721 < _e2366));
let _e2729 = global_4.member[bitcast<u32>(select(0i, _e2723, (_e2723 > 0i)))];
let _e2731 = (3i * (_e2645 + _e2612));
let _e2733 = select(_e2366, _e2731, (_e2731 < _e2366));
let _e2739 = global_4.member[bitcast<u32>(select(0i, _e2733, (_e2733 > 0i)))];
let _e2740 = (_e2731 + 1i);
let _e2742 = select(_e2366, _e2740, (_e2740 < _e2366));
let _e2748 = global_4.member[bitcast<u32>(select(0i, _e2742, (_e2742 > 0i)))];
let _e2749 = (_e2731 + 2i);
let _e2751 = select(_e2366, _e2749, (_e2749 < _e2366));
let _e2757 = global_4.member[bitcast<u32>(select(0i, _e2751, (_e2751 > 0i)))];
let _e2764 = (_e2655 + ((_e2683 - _e2655) * _e2577));
let _e2765 = (_e2664 + ((_e2692 - _e2664) * _e2577));
let _e2766 = (_e2673 + ((_e2701 - _e2673) * _e2577));
let _e2789 = (_e2098 - f32(_e2116));
let _e2791 = select(0f, _e2789, (_e2789 > 0f));
let _e2793 = select(1f, _e2791, (_e2791 < 1f));
let _e2803 = global_2.member.member_23.member_11;
phi_4432_ = vec3<f32>(((_e2501 + (((_e2764 + (((_e2711 + ((_e2739 - _e2711) * _e2577)) - _e2764) * _e2583)) - _e2501) * _e2793)) * _e2803), ((_e2502 + (((_e2765 + (((_e2720 + ((_e2748 - _e2720) * _e2577)) - _e2765) * _e2583)) - _e2502) * _e2793)) * _e2803), ((_e2503 + (((_e2766 + (((_e2729 + ((_e2757 - _e2729) * _e2577)) - _e2766) * _e2583)) - _e2503) * _e2793)) * _e2803));
}
let _e2809 = phi_4432_;
phi_4433_ = _e2809;
}
let _e2811 = phi_4433_;
phi_4434_ = _e2811;
}
let _e2813 = phi_4434_;
let _e2817 = global_2.member.member_23.member_12;
let _e2824 = (_e1231 * _e2817);
let _e2828 = ((_e209 + ((_e264 * (select(_e468.member, _e457.member, _e446) * (((_e1136.member.x * _e1158) * _e1184) + _e1167.member))) * _e1218)) + ((_e264 * _e2813.x) * _e2824));
let _e2829 = ((_e220 + ((_e275 * (select(_e468.member_1, _e457.member_1, _e446) * (((_e1136.member.y * _e1158) * _e1184) + _e1167.member_1))) * _e1218)) + ((_e275 * _e2813.y) * _e2824));
let _e2830 = ((_e231 + ((_e286 * (select(_e468.member_2, _e457.member_2, _e446) * (((_e1136.member.z * _e1158) * _e1184) + _e1167.member_2))) * _e1218)) + ((_e286 * _e2813.z) * _e2824));
if ((((_e133.member_2 == 1u) || (_e133.member_2 == 5u)) || (_e133.member_2 == 6u)) || ((_e133.member_2 == 2u) || (_e133.member_2 == 7u))) {
let _e2841 = local_24;
local_9 = _e2841;
local_10 = _e185;
let _e2842 = local_10;
let _e2844 = local_9;
let _e2845 = ((20i * _e2842) + _e2844);
let _e2847 = select(_e191, _e2845, (_e2845 < _e191));
let _e2852 = global_3.member[bitcast<u32>(select(0i, _e2847, (_e2847 > 0i)))];
let _e2853 = local_10;
let _e2855 = local_9;
let _e2856 = ((21i * _e2853) + _e2855);
let _e2858 = select(_e191, _e2856, (_e2856 < _e191));
let _e2863 = global_3.member[bitcast<u32>(select(0i, _e2858, (_e2858 > 0i)))];
let _e2864 = local_10;
let _e2866 = local_9;
let _e2867 = ((22i * _e2864) + _e2866);
let _e2869 = select(_e191, _e2867, (_e2867 < _e191));
let _e2874 = global_3.member[bitcast<u32>(select(0i, _e2869, (_e2869 > 0i)))];
let _e2879 = (((_e1269.member * _e2852) + (_e1269.member_1 * _e2863)) + (_e1269.member_2 * _e2874));
let _e2884 = (((_e1281.member * _e2852) + (_e1281.member_1 * _e2863)) + (_e1281.member_2 * _e2874));
let _e2889 = (((_e1293.member * _e2852) + (_e1293.member_1 * _e2863)) + (_e1293.member_2 * _e2874));
let _e2894 = (((_e2879 * _e2879) + (_e2884 * _e2884)) + (_e2889 * _e2889));
let _e2897 = sqrt(select(0f, _e2894, (_e2894 > 0f)));
let _e2898 = local_22;
let _e2899 = bitcast<i32>(_e2898);
let _e2900 = local_23;
let _e2901 = bitcast<i32>(_e2900);
local_8 = 20u;
if _e1330 {
phi_4611_ = _e1323;
} else {
phi_4611_ = bitcast<i32>(_e1329);
}
let _e2904 = phi_4611_;
if (_e2904 == 0i) {
break;
}
if ((_e2904 == -1i) && (_e2899 == i32(-2147483648))) {
break;
}
let _e2910 = (_e2899 - (_e2899 % _e2904));
let _e2912 = ((_e2910 + _e2904) - 1i);
if (_e2899 > _e2910) {
phi_4631_ = (_e2899 - 1i);
} else {
phi_4631_ = _e2910;
}
let _e2916 = phi_4631_;
if (_e2899 < _e2912) {
phi_4637_ = (_e2899 + 1i);
} else {
phi_4637_ = _e2912;
}
let _e2920 = phi_4637_;
if _e1330 {
phi_4647_ = _e1327;
} else {
phi_4647_ = bitcast<i32>(_e1329);
}
let _e2923 = phi_4647_;
if (_e2923 == 0i) {
break;
}
if ((_e2923 == -1i) && (_e2901 == i32(-2147483648))) {
break;
}
let _e2929 = (_e2901 - (_e2901 % _e2923));
let _e2931 = ((_e2929 + _e2923) - 1i);
if (_e2901 > _e2929) {
phi_4667_ = (_e2901 - 1i);
} else {
phi_4667_ = _e2929;
}
let _e2935 = phi_4667_;
if (_e2901 < _e2931) {
phi_4673_ = (_e2901 + 1i);
} else {
phi_4673_ = _e2931;
}
let _e2939 = phi_4673_;
let _e2941 = bitcast<u32>(_e2916);
let _e2942 = bitcast<u32>(_e2901);
let _e2943 = (_e2941 % 16u);
let _e2944 = (_e2942 % 4u);
let _e2946 = (_e2942 < _e1378);
if ((_e2941 < _e1375) && _e2946) {
phi_4720_ = ((((_e2942 - _e2944) + (_e2943 / 4u)) * _e1322) + (((_e2941 - _e2943) + (_e2944 * 4u)) + (_e2943 % 4u)));
} else {
phi_4720_ = ((_e2942 * _e1322) + _e2941);
}
let _e2961 = phi_4720_;
let _e2963 = local_8;
local_6 = bitcast<i32>(_e2961);
local_7 = _e1398;
let _e2965 = local_7;
let _e2967 = local_6;
let _e2968 = ((bitcast<i32>(_e2963) * _e2965) + _e2967);
let _e2970 = select(_e191, _e2968, (_e2968 < _e191));
let _e2975 = global_3.member[bitcast<u32>(select(0i, _e2970, (_e2970 > 0i)))];
let _e2978 = local_7;
let _e2980 = local_6;
let _e2981 = ((bitcast<i32>((_e2963 + 1u)) * _e2978) + _e2980);
let _e2983 = select(_e191, _e2981, (_e2981 < _e191));
let _e2988 = global_3.member[bitcast<u32>(select(0i, _e2983, (_e2983 > 0i)))];
let _e2991 = local_7;
let _e2993 = local_6;
let _e2994 = ((bitcast<i32>((_e2963 + 2u)) * _e2991) + _e2993);
let _e2996 = select(_e191, _e2994, (_e2994 < _e191));
let _e3001 = global_3.member[bitcast<u32>(select(0i, _e2996, (_e2996 > 0i)))];
let _e3006 = (((_e1439.member * _e2975) + (_e1439.member_1 * _e2988)) + (_e1439.member_2 * _e3001));
let _e3011 = (((_e1450.member * _e2975) + (_e1450.member_1 * _e2988)) + (_e1450.member_2 * _e3001));
let _e3016 = (((_e1461.member * _e2975) + (_e1461.member_1 * _e2988)) + (_e1461.member_2 * _e3001));
let _e3017 = bitcast<u32>(_e2920);
let _e3018 = (_e3017 % 16u);
if ((_e3017 < _e1375) && _e2946) {
phi_4871_ = ((((_e2942 - _e2944) + (_e3018 / 4u)) * _e1322) + (((_e3017 - _e3018) + (_e2944 * 4u)) + (_e3018 % 4u)));
} else {
phi_4871_ = ((_e2942 * _e1322) + _e3017);
}
let _e3034 = phi_4871_;
let _e3036 = local_8;
local_4 = bitcast<i32>(_e3034);
local_5 = _e1398;
let _e3038 = local_5;
let _e3040 = local_4;
let _e3041 = ((bitcast<i32>(_e3036) * _e3038) + _e3040);
let _e3043 = select(_e191, _e3041, (_e3041 < _e191));
let _e3048 = global_3.member[bitcast<u32>(select(0i, _e3043, (_e3043 > 0i)))];
let _e3051 = local_5;
let _e3053 = local_4;
let _e3054 = ((bitcast<i32>((_e3036 + 1u)) * _e3051) + _e3053);
let _e3056 = select(_e191, _e3054, (_e3054 < _e191));
let _e3061 = global_3.member[bitcast<u32>(select(0i, _e3056, (_e3056 > 0i)))];
let _e3064 = local_5;
let _e3066 = local_4;
let _e3067 = ((bitcast<i32>((_e3036 + 2u)) * _e3064) + _e3066);
let _e3069 = select(_e191, _e3067, (_e3067 < _e191));
let _e3074 = global_3.member[bitcast<u32>(select(0i, _e3069, (_e3069 > 0i)))];
let _e3079 = (((_e1439.member * _e3048) + (_e1439.member_1 * _e3061)) + (_e1439.member_2 * _e3074));
let _e3084 = (((_e1450.member * _e3048) + (_e1450.member_1 * _e3061)) + (_e1450.member_2 * _e3074));
let _e3089 = (((_e1461.member * _e3048) + (_e1461.member_1 * _e3061)) + (_e1461.member_2 * _e3074));
let _e3094 = (((_e3006 * _e3006) + (_e3011 * _e3011)) + (_e3016 * _e3016));
let _e3097 = sqrt(select(0f, _e3094, (_e3094 > 0f)));
let _e3102 = (((_e3079 * _e3079) + (_e3084 * _e3084)) + (_e3089 * _e3089));
let _e3105 = sqrt(select(0f, _e3102, (_e3102 > 0f)));
let _e3106 = (_e3105 > 1e-9f);
let _e3108 = (1f / select(1e-9f, _e3105, _e3106));
let _e3112 = (_e3097 > 1e-9f);
let _e3114 = (1f / select(1e-9f, _e3097, _e3112));
let _e3118 = ((_e3079 * _e3108) - (_e3006 * _e3114));
let _e3119 = ((_e3084 * _e3108) - (_e3011 * _e3114));
let _e3120 = ((_e3089 * _e3108) - (_e3016 * _e3114));
let _e3125 = (((_e3118 * _e3118) + (_e3119 * _e3119)) + (_e3120 * _e3120));
let _e3130 = f32((_e2920 - _e2916));
let _e3134 = select(0f, (sqrt(select(0f, _e3125, (_e3125 > 0f))) / select(1f, _e3130, (_e3130 > 1f))), (_e3112 && _e3106));
let _e3136 = bitcast<u32>(_e2899);
let _e3137 = bitcast<u32>(_e2935);
let _e3138 = (_e3136 % 16u);
let _e3139 = (_e3137 % 4u);
let _e3140 = (_e3136 < _e1375);
if (_e3140 && (_e3137 < _e1378)) {
phi_5098_ = ((((_e3137 - _e3139) + (_e3138 / 4u)) * _e1322) + (((_e3136 - _e3138) + (_e3139 * 4u)) + (_e3138 % 4u)));
} else {
phi_5098_ = ((_e3137 * _e1322) + _e3136);
}
let _e3156 = phi_5098_;
let _e3158 = local_8;
local_2 = bitcast<i32>(_e3156);
local_3 = _e1398;
let _e3160 = local_3;
let _e3162 = local_2;
let _e3163 = ((bitcast<i32>(_e3158) * _e3160) + _e3162);
let _e3165 = select(_e191, _e3163, (_e3163 < _e191));
let _e3170 = global_3.member[bitcast<u32>(select(0i, _e3165, (_e3165 > 0i)))];
let _e3173 = local_3;
let _e3175 = local_2;
let _e3176 = ((bitcast<i32>((_e3158 + 1u)) * _e3173) + _e3175);
let _e3178 = select(_e191, _e3176, (_e3176 < _e191));
let _e3183 = global_3.member[bitcast<u32>(select(0i, _e3178, (_e3178 > 0i)))];
let _e3186 = local_3;
let _e3188 = local_2;
let _e3189 = ((bitcast<i32>((_e3158 + 2u)) * _e3186) + _e3188);
let _e3191 = select(_e191, _e3189, (_e3189 < _e191));
let _e3196 = global_3.member[bitcast<u32>(select(0i, _e3191, (_e3191 > 0i)))];
let _e3201 = (((_e1439.member * _e3170) + (_e1439.member_1 * _e3183)) + (_e1439.member_2 * _e3196));
let _e3206 = (((_e1450.member * _e3170) + (_e1450.member_1 * _e3183)) + (_e1450.member_2 * _e3196));
let _e3211 = (((_e1461.member * _e3170) + (_e1461.member_1 * _e3183)) + (_e1461.member_2 * _e3196));
let _e3212 = bitcast<u32>(_e2939);
let _e3213 = (_e3212 % 4u);
if (_e3140 && (_e3212 < _e1378)) {
phi_5249_ = ((((_e3212 - _e3213) + (_e3138 / 4u)) * _e1322) + (((_e3136 - _e3138) + (_e3213 * 4u)) + (_e3138 % 4u)));
} else {
phi_5249_ = ((_e3212 * _e1322) + _e3136);
}
let _e3229 = phi_5249_;
let _e3231 = local_8;
local = bitcast<i32>(_e3229);
local_1 = _e1398;
let _e3233 = local_1;
let _e3235 = local;
let _e3236 = ((bitcast<i32>(_e3231) * _e3233) + _e3235);
let _e3238 = select(_e191, _e3236, (_e3236 < _e191));
let _e3243 = global_3.member[bitcast<u32>(select(0i, _e3238, (_e3238 > 0i)))];
let _e3246 = local_1;
let _e3248 = local;
let _e3249 = ((bitcast<i32>((_e3231 + 1u)) * _e3246) + _e3248);
let _e3251 = select(_e191, _e3249, (_e3249 < _e191));
let _e3256 = global_3.member[bitcast<u32>(select(0i, _e3251, (_e3251 > 0i)))];
let _e3259 = local_1;
let _e3261 = local;
let _e3262 = ((bitcast<i32>((_e3231 + 2u)) * _e3259) + _e3261);
let _e3264 = select(_e191, _e3262, (_e3262 < _e191));
let _e3269 = global_3.member[bitcast<u32>(select(0i, _e3264, (_e3264 > 0i)))];
let _e3274 = (((_e1439.member * _e3243) + (_e1439.member_1 * _e3256)) + (_e1439.member_2 * _e3269));
let _e3279 = (((_e1450.member * _e3243) + (_e1450.member_1 * _e3256)) + (_e1450.member_2 * _e3269));
let _e3284 = (((_e1461.member * _e3243) + (_e1461.member_1 * _e3256)) + (_e1461.member_2 * _e3269));
let _e3289 = (((_e3201 * _e3201) + (_e3206 * _e3206)) + (_e3211 * _e3211));
let _e3292 = sqrt(select(0f, _e3289, (_e3289 > 0f)));
let _e3297 = (((_e3274 * _e3274) + (_e3279 * _e3279)) + (_e3284 * _e3284));
let _e3300 = sqrt(select(0f, _e3297, (_e3297 > 0f)));
let _e3301 = (_e3300 > 1e-9f);
let _e3303 = (1f / select(1e-9f, _e3300, _e3301));
let _e3307 = (_e3292 > 1e-9f);
let _e3309 = (1f / select(1e-9f, _e3292, _e3307));
let _e3313 = ((_e3274 * _e3303) - (_e3201 * _e3309));
let _e3314 = ((_e3279 * _e3303) - (_e3206 * _e3309));
let _e3315 = ((_e3284 * _e3303) - (_e3211 * _e3309));
let _e3320 = (((_e3313 * _e3313) + (_e3314 * _e3314)) + (_e3315 * _e3315));
let _e3325 = f32((_e2939 - _e2935));
let _e3329 = select(0f, (sqrt(select(0f, _e3320, (_e3320 > 0f))) / select(1f, _e3325, (_e3325 > 1f))), (_e3307 && _e3301));
let _e3331 = select(_e3329, _e3134, (_e3134 > _e3329));
let _e3334 = global_2.member.member_21;
let _e3336 = (2f * (_e3334 * _e3334));
let _e3338 = select(_e3336, _e3331, (_e3331 > _e3336));
let _e3339 = (_e2897 > 0f);
let _e3342 = (1f / select(1e-20f, _e2897, (_e2897 > 1e-20f)));
let _e3346 = select(0f, (_e2879 * _e3342), _e3339);
let _e3347 = select(0f, (_e2884 * _e3342), _e3339);
let _e3348 = select(1f, (_e2889 * _e3342), _e3339);
if _e1804 {
phi_6899_ = _e1796;
} else {
if (_e1788 == 1u) {
let _e3351 = select(-1f, _e3348, (_e3348 > -1f));
let _e3353 = select(1f, _e3351, (_e3351 < 1f));
if (_e3353 > 0f) {
phi_5514_ = _e1796;
} else {
let _e3358 = global_2.member.member_23.member_9;
phi_5514_ = vec3<f32>(_e3358.member, _e3358.member_1, _e3358.member_2);
}
let _e3364 = phi_5514_;
let _e3373 = bitcast<f32>((bitcast<u32>(_e3353) & 2147483647u));
let _e3376 = sqrt(select(0f, _e3373, (_e3373 > 0f)));
phi_6898_ = vec3<f32>((_e1800.member + ((_e3364.x - _e1800.member) * _e3376)), (_e1800.member_1 + ((_e3364.y - _e1800.member_1) * _e3376)), (_e1800.member_2 + ((_e3364.z - _e1800.member_2) * _e3376)));
} else {
if (_e1788 == 2u) {
let _e3388 = global_2.member.member_23.member_10;
let _e3389 = (_e3338 / _e3388);
let _e3391 = select(1e-4f, _e3389, (_e3389 > 1e-4f));
let _e3394 = bitcast<f32>((bitcast<u32>(_e3346) & 2147483647u));
let _e3397 = bitcast<f32>((bitcast<u32>(_e3347) & 2147483647u));
let _e3401 = select(_e3397, _e3394, (_e3394 > _e3397));
let _e3404 = (select(_e3397, _e3394, (_e3394 < _e3397)) / select(1.1754944e-38f, _e3401, (_e3401 > 1.1754944e-38f)));
let _e3405 = (_e3404 > 0.41421357f);
let _e3409 = select(_e3404, ((_e3404 - 1f) / (_e3404 + 1f)), _e3405);
let _e3410 = (_e3409 * _e3409);
let _e3425 = (select(0f, 0.7853982f, _e3405) + (_e3409 + ((_e3409 * _e3410) * (-0.33333334f + (_e3410 * (0.2f + (_e3410 * (-0.14285713f + (_e3410 * (0.11111111f + (_e3410 * (-0.09090909f + (_e3410 * 0.0585f)))))))))))));
let _e3428 = select(_e3425, (1.5707964f - _e3425), (_e3397 > _e3394));
let _e3431 = select(_e3428, (3.1415927f - _e3428), (_e3346 < 0f));
let _e3437 = (1f - (_e3348 * _e3348));
let _e3440 = sqrt(select(0f, _e3437, (_e3437 > 0f)));
let _e3443 = (_e3391 / select(1e-3f, _e3440, (_e3440 > 1e-3f)));
let _e3444 = ((select(_e3431, -(_e3431), (_e3347 < 0f)) / _e3388) * 0.5f);
let _e3446 = select(-8e6f, _e3444, (_e3444 > -8e6f));
let _e3448 = select(8e6f, _e3446, (_e3446 < 8e6f));
let _e3455 = select(0i, select(select(i32(_e3448), i32(-2147483648), (_e3448 < -2147483600f)), 2147483647i, (_e3448 > 2147483500f)), (_e3448 == _e3448));
let _e3462 = ((_e3444 - f32((_e3455 - select(0i, 1i, (_e3448 < f32(_e3455)))))) * 2f);
let _e3470 = ((select(select((_e3462 - 2f), (1f - _e3462), (_e3462 < 1.5f)), _e3462, (_e3462 < 0.5f)) * 2f) / _e3443);
let _e3472 = select(-1f, _e3470, (_e3470 > -1f));
let _e3475 = (2f - _e3443);
let _e3477 = select(0f, _e3475, (_e3475 > 0f));
let _e3482 = select(-1f, _e3348, (_e3348 > -1f));
let _e3484 = select(1f, _e3482, (_e3482 < 1f));
let _e3487 = ((1f - _e3484) * (1f + _e3484));
let _e3490 = sqrt(select(0f, _e3487, (_e3487 > 0f)));
let _e3493 = bitcast<f32>((bitcast<u32>(_e3490) & 2147483647u));
let _e3496 = bitcast<f32>((bitcast<u32>(_e3484) & 2147483647u));
let _e3500 = select(_e3496, _e3493, (_e3493 > _e3496));
let _e3503 = (select(_e3496, _e3493, (_e3493 < _e3496)) / select(1.1754944e-38f, _e3500, (_e3500 > 1.1754944e-38f)));
let _e3504 = (_e3503 > 0.41421357f);
let _e3508 = select(_e3503, ((_e3503 - 1f) / (_e3503 + 1f)), _e3504);
let _e3509 = (_e3508 * _e3508);
let _e3524 = (select(0f, 0.7853982f, _e3504) + (_e3508 + ((_e3508 * _e3509) * (-0.33333334f + (_e3509 * (0.2f + (_e3509 * (-0.14285713f + (_e3509 * (0.11111111f + (_e3509 * (-0.09090909f + (_e3509 * 0.0585f)))))))))))));
let _e3527 = select(_e3524, (1.5707964f - _e3524), (_e3496 > _e3493));
let _e3530 = select(_e3527, (3.1415927f - _e3527), (_e3490 < 0f));
let _e3535 = ((select(_e3530, -(_e3530), (_e3484 < 0f)) / _e3388) * 0.5f);
let _e3537 = select(-8e6f, _e3535, (_e3535 > -8e6f));
let _e3539 = select(8e6f, _e3537, (_e3537 < 8e6f));
let _e3546 = select(0i, select(select(i32(_e3539), i32(-2147483648), (_e3539 < -2147483600f)), 2147483647i, (_e3539 > 2147483500f)), (_e3539 == _e3539));
let _e3553 = ((_e3535 - f32((_e3546 - select(0i, 1i, (_e3539 < f32(_e3546)))))) * 2f);
let _e3561 = ((select(select((_e3553 - 2f), (1f - _e3553), (_e3553 < 1.5f)), _e3553, (_e3553 < 0.5f)) * 2f) / _e3391);
let _e3563 = select(-1f, _e3561, (_e3561 > -1f));
let _e3566 = (2f - _e3391);
let _e3568 = select(0f, _e3566, (_e3566 > 0f));
let _e3574 = (0.5f + ((0.5f * (select(1f, _e3472, (_e3472 < 1f)) * select(1f, _e3477, (_e3477 < 1f)))) * (select(1f, _e3563, (_e3563 < 1f)) * select(1f, _e3568, (_e3568 < 1f)))));
phi_6897_ = vec3<f32>((_e1792.member + ((_e1800.member - _e1792.member) * _e3574)), (_e1792.member_1 + ((_e1800.member_1 - _e1792.member_1) * _e3574)), (_e1792.member_2 + ((_e1800.member_2 - _e1792.member_2) * _e3574)));
} else {
let _e3588 = global_2.member.member_23.member_1;
let _e3589 = bitcast<i32>(_e3588);
let _e3594 = global_2.member.member_23.member_3;
let _e3596 = f32(bitcast<i32>(_e3594));
let _e3598 = (2f * 3.1415927f);
let _e3599 = ((_e3338 * f32(_e3589)) / _e3598);
let _e3601 = select(1e-6f, _e3599, (_e3599 > 1e-6f));
let _e3604 = bitcast<u32>(select(1.1754944e-38f, _e3601, (_e3601 > 1.1754944e-38f)));
let _e3605 = (_e3604 & 8388607u);
let _e3607 = select(0u, 1u, (_e3605 > 3474675u));
let _e3618 = bitcast<f32>((_e3605 | ((127u - _e3607) << bitcast<u32>(23i))));
let _e3621 = ((_e3618 - 1f) / (_e3618 + 1f));
let _e3622 = (_e3621 * _e3621);
let _e3637 = (f32(((bitcast<i32>((_e3604 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e3607))) + (((2f * _e3621) + ((_e3621 * _e3622) * (0.6666667f + (_e3622 * (0.4f + (_e3622 * (0.2857143f + (_e3622 * (0.22222222f + (_e3622 * 0.18181819f)))))))))) * 1.442695f));
let _e3638 = (_e3596 - 1f);
let _e3640 = select(0f, _e3637, (_e3637 > 0f));
let _e3642 = select(_e3638, _e3640, (_e3640 < _e3638));
let _e3643 = (_e3596 - 2f);
let _e3645 = select(0f, _e3643, (_e3643 > 0f));
let _e3647 = select(0f, _e3642, (_e3642 > 0f));
let _e3649 = select(_e3645, _e3647, (_e3647 < _e3645));
let _e3656 = select(0i, select(select(i32(_e3649), i32(-2147483648), (_e3649 < -2147483600f)), 2147483647i, (_e3649 > 2147483500f)), (_e3649 == _e3649));
let _e3660 = (_e3656 - select(0i, 1i, (_e3649 < f32(_e3656))));
let _e3663 = bitcast<f32>((bitcast<u32>(_e3347) & 2147483647u));
let _e3666 = bitcast<f32>((bitcast<u32>(_e3346) & 2147483647u));
let _e3670 = select(_e3666, _e3663, (_e3663 > _e3666));
let _e3673 = (select(_e3666, _e3663, (_e3663 < _e3666)) / select(1.1754944e-38f, _e3670, (_e3670 > 1.1754944e-38f)));
let _e3674 = (_e3673 > 0.41421357f);
let _e3678 = select(_e3673, ((_e3673 - 1f) / (_e3673 + 1f)), _e3674);
let _e3679 = (_e3678 * _e3678);
let _e3694 = (select(0f, 0.7853982f, _e3674) + (_e3678 + ((_e3678 * _e3679) * (-0.33333334f + (_e3679 * (0.2f + (_e3679 * (-0.14285713f + (_e3679 * (0.11111111f + (_e3679 * (-0.09090909f + (_e3679 * 0.0585f)))))))))))));
let _e3697 = select(_e3694, (1.5707964f - _e3694), (_e3666 > _e3663));
let _e3700 = select(_e3697, (3.1415927f - _e3697), (_e3347 < 0f));
let _e3705 = (0.5f - (select(_e3700, -(_e3700), (_e3346 < 0f)) / _e3598));
let _e3707 = select(-1f, _e3348, (_e3348 > -1f));
let _e3709 = select(1f, _e3707, (_e3707 < 1f));
let _e3712 = ((1f - _e3709) * (1f + _e3709));
let _e3715 = sqrt(select(0f, _e3712, (_e3712 > 0f)));
let _e3718 = bitcast<f32>((bitcast<u32>(_e3715) & 2147483647u));
let _e3721 = bitcast<f32>((bitcast<u32>(_e3709) & 2147483647u));
let _e3725 = select(_e3721, _e3718, (_e3718 > _e3721));
let _e3728 = (select(_e3721, _e3718, (_e3718 < _e3721)) / select(1.1754944e-38f, _e3725, (_e3725 > 1.1754944e-38f)));
let _e3729 = (_e3728 > 0.41421357f);
let _e3733 = select(_e3728, ((_e3728 - 1f) / (_e3728 + 1f)), _e3729);
let _e3734 = (_e3733 * _e3733);
let _e3749 = (select(0f, 0.7853982f, _e3729) + (_e3733 + ((_e3733 * _e3734) * (-0.33333334f + (_e3734 * (0.2f + (_e3734 * (-0.14285713f + (_e3734 * (0.11111111f + (_e3734 * (-0.09090909f + (_e3734 * 0.0585f)))))))))))));
let _e3752 = select(_e3749, (1.5707964f - _e3749), (_e3721 > _e3718));
let _e3755 = select(_e3752, (3.1415927f - _e3752), (_e3715 < 0f));
let _e3760 = (0.5f - (select(_e3755, -(_e3755), (_e3709 < 0f)) / 3.1415927f));
let _e3764 = global_2.member.member_23.member_2;
let _e3765 = bitcast<i32>(_e3764);
phi_6116_ = 0i;
phi_6119_ = 0i;
phi_6121_ = _e3765;
phi_6123_ = _e3589;
loop {
let _e3767 = phi_6116_;
let _e3769 = phi_6119_;
let _e3771 = phi_6121_;
let _e3773 = phi_6123_;
local_58 = _e3773;
local_59 = _e3771;
local_60 = _e3773;
local_61 = _e3773;
local_62 = _e3773;
local_63 = _e3773;
local_64 = _e3773;
local_65 = _e3773;
local_66 = _e3771;
local_67 = _e3771;
local_68 = _e3771;
local_69 = _e3771;
local_70 = _e3773;
local_71 = _e3769;
local_72 = _e3773;
local_73 = _e3769;
let _e3774 = (_e3767 < _e3660);
if _e3774 {
if (_e3773 > 1i) {
phi_6138_ = (_e3773 >> bitcast<u32>(1i));
} else {
phi_6138_ = 1i;
}
let _e3781 = phi_6138_;
if (_e3771 > 1i) {
phi_6144_ = (_e3771 >> bitcast<u32>(1i));
} else {
phi_6144_ = 1i;
}
let _e3786 = phi_6144_;
phi_6117_ = (_e3767 + 1i);
phi_6120_ = (_e3769 + (_e3773 * _e3771));
phi_6122_ = _e3786;
phi_6124_ = _e3781;
} else {
phi_6117_ = i32();
phi_6120_ = i32();
phi_6122_ = i32();
phi_6124_ = i32();
}
let _e3789 = phi_6117_;
let _e3791 = phi_6120_;
let _e3793 = phi_6122_;
let _e3795 = phi_6124_;
continue;
continuing {
phi_6116_ = _e3789;
phi_6119_ = _e3791;
phi_6121_ = _e3793;
phi_6123_ = _e3795;
break if !(_e3774);
}
}
let _e3798 = local_58;
let _e3799 = f32(_e3798);
let _e3801 = ((_e3705 * _e3799) - 0.5f);
let _e3803 = local_59;
let _e3804 = f32(_e3803);
let _e3806 = ((_e3760 * _e3804) - 0.5f);
let _e3808 = select(-1f, _e3801, (_e3801 > -1f));
let _e3810 = select(_e3799, _e3808, (_e3808 < _e3799));
let _e3817 = select(0i, select(select(i32(_e3810), i32(-2147483648), (_e3810 < -2147483600f)), 2147483647i, (_e3810 > 2147483500f)), (_e3810 == _e3810));
let _e3821 = (_e3817 - select(0i, 1i, (_e3810 < f32(_e3817))));
let _e3823 = select(-1f, _e3806, (_e3806 > -1f));
let _e3825 = select(_e3804, _e3823, (_e3823 < _e3804));
let _e3832 = select(0i, select(select(i32(_e3825), i32(-2147483648), (_e3825 < -2147483600f)), 2147483647i, (_e3825 > 2147483500f)), (_e3825 == _e3825));
let _e3836 = (_e3832 - select(0i, 1i, (_e3825 < f32(_e3832))));
let _e3838 = (_e3801 - f32(_e3821));
let _e3840 = (_e3806 - f32(_e3836));
let _e3842 = select(0f, _e3840, (_e3840 > 0f));
let _e3844 = select(1f, _e3842, (_e3842 < 1f));
if (_e3821 < 0i) {
let _e3847 = local_60;
phi_6219_ = (_e3821 + _e3847);
} else {
phi_6219_ = _e3821;
}
let _e3850 = phi_6219_;
let _e3852 = local_61;
if (_e3850 >= _e3852) {
let _e3855 = local_62;
phi_6225_ = (_e3850 - _e3855);
} else {
phi_6225_ = _e3850;
}
let _e3858 = phi_6225_;
let _e3859 = (_e3821 + 1i);
if (_e3859 < 0i) {
let _e3862 = local_63;
phi_6232_ = (_e3859 + _e3862);
} else {
phi_6232_ = _e3859;
}
let _e3865 = phi_6232_;
let _e3867 = local_64;
if (_e3865 >= _e3867) {
let _e3870 = local_65;
phi_6238_ = (_e3865 - _e3870);
} else {
phi_6238_ = _e3865;
}
let _e3873 = phi_6238_;
let _e3875 = select(_e3836, 0i, (_e3836 < 0i));
let _e3877 = local_66;
if (_e3875 >= _e3877) {
let _e3880 = local_67;
phi_6249_ = (_e3880 - 1i);
} else {
phi_6249_ = _e3875;
}
let _e3883 = phi_6249_;
let _e3884 = (_e3836 + 1i);
let _e3886 = select(_e3884, 0i, (_e3884 < 0i));
let _e3888 = local_68;
if (_e3886 >= _e3888) {
let _e3891 = local_69;
phi_6261_ = (_e3891 - 1i);
} else {
phi_6261_ = _e3886;
}
let _e3894 = phi_6261_;
let _e3896 = local_70;
let _e3899 = local_71;
let _e3900 = (_e3899 + (_e3883 * _e3896));
let _e3902 = local_72;
let _e3905 = local_73;
let _e3906 = (_e3905 + (_e3894 * _e3902));
let _e3908 = (3i * (_e3900 + _e3858));
let _e3910 = (bitcast<i32>(_e125) - 1i);
let _e3912 = select(_e3910, _e3908, (_e3908 < _e3910));
let _e3918 = global_4.member[bitcast<u32>(select(0i, _e3912, (_e3912 > 0i)))];
let _e3919 = (_e3908 + 1i);
let _e3921 = select(_e3910, _e3919, (_e3919 < _e3910));
let _e3927 = global_4.member[bitcast<u32>(select(0i, _e3921, (_e3921 > 0i)))];
let _e3928 = (_e3908 + 2i);
let _e3930 = select(_e3910, _e3928, (_e3928 < _e3910));
let _e3936 = global_4.member[bitcast<u32>(select(0i, _e3930, (_e3930 > 0i)))];
let _e3938 = (3i * (_e3900 + _e3873));
let _e3940 = select(_e3910, _e3938, (_e3938 < _e3910));
let _e3946 = global_4.member[bitcast<u32>(select(0i, _e3940, (_e3940 > 0i)))];
let _e3947 = (_e3938 + 1i);
let _e3949 = select(_e3910, _e3947, (_e3947 < _e3910));
let _e3955 = global_4.member[bitcast<u32>(select(0i, _e3949, (_e3949 > 0i)))];
let _e3956 = (_e3938 + 2i);
let _e3958 = select(_e3910, _e3956, (_e3956 < _e3910));
let _e3964 = global_4.member[bitcast<u32>(select(0i, _e3958, (_e3958 > 0i)))];
let _e3966 = (3i * (_e3906 + _e3858));
let _e3968 = select(_e3910, _e3966, (_e3966 < _e3910));
let _e3974 = global_4.member[bitcast<u32>(select(0i, _e3968, (_e3968 > 0i)))];
let _e3975 = (_e3966 + 1i);
let _e3977 = select(_e3910, _e3975, (_e3975 < _e3910));
let _e3983 = global_4.member[bitcast<u32>(select(0i, _e3977, (_e3977 > 0i)))];
let _e3984 = (_e3966 + 2i);
let _e3986 = select(_e3910, _e3984, (_e3984 < _e3910));
let _e3992 = global_4.member[bitcast<u32>(select(0i, _e3986, (_e3986 > 0i)))];
let _e3994 = (3i * (_e3906 + _e3873));
let _e3996 = select(_e3910, _e3994, (_e3994 < _e3910));
let _e4002 = global_4.member[bitcast<u32>(select(0i, _e3996, (_e3996 > 0i)))];
let _e4003 = (_e3994 + 1i);
let _e4005 = select(_e3910, _e4003, (_e4003 < _e3910));
let _e4011 = global_4.member[bitcast<u32>(select(0i, _e4005, (_e4005 > 0i)))];
let _e4012 = (_e3994 + 2i);
let _e4014 = select(_e3910, _e4012, (_e4012 < _e3910));
let _e4020 = global_4.member[bitcast<u32>(select(0i, _e4014, (_e4014 > 0i)))];
let _e4027 = (_e3918 + ((_e3946 - _e3918) * _e3838));
let _e4028 = (_e3927 + ((_e3955 - _e3927) * _e3838));
let _e4029 = (_e3936 + ((_e3964 - _e3936) * _e3838));
let _e4045 = (_e4027 + (((_e3974 + ((_e4002 - _e3974) * _e3838)) - _e4027) * _e3844));
let _e4046 = (_e4028 + (((_e3983 + ((_e4011 - _e3983) * _e3838)) - _e4028) * _e3844));
let _e4047 = (_e4029 + (((_e3992 + ((_e4020 - _e3992) * _e3838)) - _e4029) * _e3844));
phi_6497_ = 0i;
phi_6500_ = 0i;
phi_6502_ = _e3765;
phi_6504_ = _e3589;
loop {
let _e4050 = phi_6497_;
let _e4052 = phi_6500_;
let _e4054 = phi_6502_;
let _e4056 = phi_6504_;
local_74 = _e4056;
local_75 = _e4054;
local_76 = _e4056;
local_77 = _e4056;
local_78 = _e4056;
local_79 = _e4056;
local_80 = _e4056;
local_81 = _e4056;
local_82 = _e4054;
local_83 = _e4054;
local_84 = _e4054;
local_85 = _e4054;
local_86 = _e4056;
local_87 = _e4052;
local_88 = _e4056;
local_89 = _e4052;
let _e4057 = (_e4050 < (_e3660 + 1i));
if _e4057 {
if (_e4056 > 1i) {
phi_6519_ = (_e4056 >> bitcast<u32>(1i));
} else {
phi_6519_ = 1i;
}
let _e4064 = phi_6519_;
if (_e4054 > 1i) {
phi_6525_ = (_e4054 >> bitcast<u32>(1i));
} else {
phi_6525_ = 1i;
}
let _e4069 = phi_6525_;
phi_6498_ = (_e4050 + 1i);
phi_6501_ = (_e4052 + (_e4056 * _e4054));
phi_6503_ = _e4069;
phi_6505_ = _e4064;
} else {
phi_6498_ = i32();
phi_6501_ = i32();
phi_6503_ = i32();
phi_6505_ = i32();
}
let _e4072 = phi_6498_;
let _e4074 = phi_6501_;
let _e4076 = phi_6503_;
let _e4078 = phi_6505_;
continue;
continuing {
phi_6497_ = _e4072;
phi_6500_ = _e4074;
phi_6502_ = _e4076;
phi_6504_ = _e4078;
break if !(_e4057);
}
}
let _e4081 = local_74;
let _e4082 = f32(_e4081);
let _e4084 = ((_e3705 * _e4082) - 0.5f);
let _e4086 = local_75;
let _e4087 = f32(_e4086);
let _e4089 = ((_e3760 * _e4087) - 0.5f);
let _e4091 = select(-1f, _e4084, (_e4084 > -1f));
let _e4093 = select(_e4082, _e4091, (_e4091 < _e4082));
let _e4100 = select(0i, select(select(i32(_e4093), i32(-2147483648), (_e4093 < -2147483600f)), 2147483647i, (_e4093 > 2147483500f)), (_e4093 == _e4093));
let _e4104 = (_e4100 - select(0i, 1i, (_e4093 < f32(_e4100))));
let _e4106 = select(-1f, _e4089, (_e4089 > -1f));
let _e4108 = select(_e4087, _e4106, (_e4106 < _e4087));
let _e4115 = select(0i, select(select(i32(_e4108), i32(-2147483648), (_e4108 < -2147483600f)), 2147483647i, (_e4108 > 2147483500f)), (_e4108 == _e4108));
let _e4119 = (_e4115 - select(0i, 1i, (_e4108 < f32(_e4115))));
let _e4121 = (_e4084 - f32(_e4104));
let _e4123 = (_e4089 - f32(_e4119));
let _e4125 = select(0f, _e4123, (_e4123 > 0f));
let _e4127 = select(1f, _e4125, (_e4125 < 1f));
if (_e4104 < 0i) {
let _e4130 = local_76;
phi_6600_ = (_e4104 + _e4130);
} else {
phi_6600_ = _e4104;
}
let _e4133 = phi_6600_;
let _e4135 = local_77;
if (_e4133 >= _e4135) {
let _e4138 = local_78;
phi_6606_ = (_e4133 - _e4138);
} else {
phi_6606_ = _e4133;
}
let _e4141 = phi_6606_;
let _e4142 = (_e4104 + 1i);
if (_e4142 < 0i) {
let _e4145 = local_79;
phi_6613_ = (_e4142 + _e4145);
} else {
phi_6613_ = _e4142;
}
let _e4148 = phi_6613_;
let _e4150 = local_80;
if (_e4148 >= _e4150) {
let _e4153 = local_81;
phi_6619_ = (_e4148 - _e4153);
} else {
phi_6619_ = _e4148;
}
let _e4156 = phi_6619_;
let _e4158 = select(_e4119, 0i, (_e4119 < 0i));
let _e4160 = local_82;
if (_e4158 >= _e4160) {
let _e4163 = local_83;
phi_6630_ = (_e4163 - 1i);
} else {
phi_6630_ = _e4158;
}
let _e4166 = phi_6630_;
let _e4167 = (_e4119 + 1i);
let _e4169 = select(_e4167, 0i, (_e4167 < 0i));
let _e4171 = local_84;
if (_e4169 >= _e4171) {
let _e4174 = local_85;
phi_6642_ = (_e4174 - 1i);
} else {
phi_6642_ = _e4169;
}
let _e4177 = phi_6642_;
let _e4179 = local_86;
let _e4182 = local_87;
let _e4183 = (_e4182 + (_e4166 * _e4179));
let _e4185 = local_88;
let _e4188 = local_89;
let _e4189 = (_e4188 + (_e4177 * _e4185));
let _e4191 = (3i * (_e4183 + _e4141));
let _e4193 = select(_e3910, _e4191, (_e4191 < _e3910));
let _e4199 = global_4.member[bitcast<u32>(select(0i, _e4193, (_e4193 > 0i)))];
let _e4200 = (_e4191 + 1i);
let _e4202 = select(_e3910, _e4200, (_e4200 < _e3910));
let _e4208 = global_4.member[bitcast<u32>(select(0i, _e4202, (_e4202 > 0i)))];
let _e4209 = (_e4191 + 2i);
let _e4211 = select(_e3910, _e4209, (_e4209 < _e3910));
let _e4217 = global_4.member[bitcast<u32>(select(0i, _e4211, (_e4211 > 0i)))];
let _e4219 = (3i * (_e4183 + _e4156));
let _e4221 = select(_e3910, _e4219, (_e4219 < _e3910));
let _e4227 = global_4.member[bitcast<u32>(select(0i, _e4221, (_e4221 > 0i)))];
let _e4228 = (_e4219 + 1i);
let _e4230 = select(_e3910, _e4228, (_e4228 < _e3910));
let _e4236 = global_4.member[bitcast<u32>(select(0i, _e4230, (_e4230 > 0i)))];
let _e4237 = (_e4219 + 2i);
let _e4239 = select(_e3910, _e4237, (_e4237 < _e3910));
let _e4245 = global_4.member[bitcast<u32>(select(0i, _e4239, (_e4239 > 0i)))];
let _e4247 = (3i * (_e4189 + _e4141));
let _e4249 = select(_e3910, _e4247, (_e4247 < _e3910));
let _e4255 = global_4.member[bitcast<u32>(select(0i, _e4249, (_e4249 > 0i)))];
let _e4256 = (_e4247 + 1i);
let _e4258 = select(_e3910, _e4256, (_e4256 < _e3910));
let _e4264 = global_4.member[bitcast<u32>(select(0i, _e4258, (_e4258 > 0i)))];
let _e4265 = (_e4247 + 2i);
let _e4267 = select(_e3910, _e4265, (_e4265 < _e3910));
let _e4273 = global_4.member[bitcast<u32>(select(0i, _e4267, (_e4267 > 0i)))];
let _e4275 = (3i * (_e4189 + _e4156));
let _e4277 = select(_e3910, _e4275, (_e4275 < _e3910));
let _e4283 = global_4.member[bitcast<u32>(select(0i, _e4277, (_e4277 > 0i)))];
let _e4284 = (_e4275 + 1i);
let _e4286 = select(_e3910, _e4284, (_e4284 < _e3910));
let _e4292 = global_4.member[bitcast<u32>(select(0i, _e4286, (_e4286 > 0i)))];
let _e4293 = (_e4275 + 2i);
let _e4295 = select(_e3910, _e4293, (_e4293 < _e3910));
let _e4301 = global_4.member[bitcast<u32>(select(0i, _e4295, (_e4295 > 0i)))];
let _e4308 = (_e4199 + ((_e4227 - _e4199) * _e4121));
let _e4309 = (_e4208 + ((_e4236 - _e4208) * _e4121));
let _e4310 = (_e4217 + ((_e4245 - _e4217) * _e4121));
let _e4333 = (_e3642 - f32(_e3660));
let _e4335 = select(0f, _e4333, (_e4333 > 0f));
let _e4337 = select(1f, _e4335, (_e4335 < 1f));
let _e4347 = global_2.member.member_23.member_11;
phi_6897_ = vec3<f32>(((_e4045 + (((_e4308 + (((_e4255 + ((_e4283 - _e4255) * _e4121)) - _e4308) * _e4127)) - _e4045) * _e4337)) * _e4347), ((_e4046 + (((_e4309 + (((_e4264 + ((_e4292 - _e4264) * _e4121)) - _e4309) * _e4127)) - _e4046) * _e4337)) * _e4347), ((_e4047 + (((_e4310 + (((_e4273 + ((_e4301 - _e4273) * _e4121)) - _e4310) * _e4127)) - _e4047) * _e4337)) * _e4347));
}
let _e4353 = phi_6897_;
phi_6898_ = _e4353;
}
let _e4355 = phi_6898_;
phi_6899_ = _e4355;
}
let _e4357 = phi_6899_;
phi_6910_ = vec3<f32>((_e2828 + (_e4357.x * _e2897)), (_e2829 + (_e4357.y * _e2897)), (_e2830 + (_e4357.z * _e2897)));
} else {
phi_6910_ = vec3<f32>(_e2828, _e2829, _e2830);
}
let _e4369 = phi_6910_;
let _e4375 = (1f - ((_e1231 * ((_e264 + _e275) + _e286)) * (1f / 3f)));
global_1.member[_e148] = _e4369.x;
global_1.member[(_e146 + _e148)] = _e4369.y;
global_1.member[((2u * _e146) + _e148)] = _e4369.z;
global_1.member[((3u * _e146) + _e148)] = (_e4375 + ((1f - _e4375) * _e2817));
global_1.member[((4u * _e146) + _e148)] = _e1225;
global_1.member[((5u * _e146) + _e148)] = _e264;
global_1.member[((6u * _e146) + _e148)] = _e275;
global_1.member[((7u * _e146) + _e148)] = _e286;
global_1.member[((8u * _e146) + _e148)] = ((_e253 + (_e1202 * (_e376 + (_e333 * _e445)))) / select(1e-12f, _e1225, (_e1225 > 1e-12f)));
global_1.member[((9u * _e146) + _e148)] = _e331;
global_1.member[((10u * _e146) + _e148)] = _e332;
global_1.member[((11u * _e146) + _e148)] = -(_e333);
global_1.member[((12u * _e146) + _e148)] = select(_e374, _e492, _e1197);
global_1.member[((13u * _e146) + _e148)] = select(_e375, _e493, _e1197);
global_1.member[((14u * _e146) + _e148)] = -(select(_e376, _e494, _e1197));
global_1.member[((15u * _e146) + _e148)] = select(select(_e198, 2f, (_e198 == 4f)), 1f, _e1197);
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
