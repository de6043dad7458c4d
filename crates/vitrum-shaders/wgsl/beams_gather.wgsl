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
struct type_19 {
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
struct type_20 {
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
struct type_21 {
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
struct type_22 {
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
struct type_23 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_24 {
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
member_11: type_19,
member_12: type_20,
member_13: type_21,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_22,
member_19: type_23,
}
struct type_25 {
member: type_24,
}
struct type_26 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(2)
var<storage> global_3: type_15;
@group(0) @binding(3)
var<storage> global_4: type_15;
@group(0) @binding(4)
var<storage> global_5: type_15;
@group(0) @binding(5)
var<storage, read_write> global_6: type_15;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: f32;
var local_5: i32;
var local_6: f32;
var local_7: i32;
var local_8: f32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: u32;
var local_14: u32;
var local_15: u32;
var local_16: u32;
var local_17: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var local_21: u32;
var local_22: u32;
var local_23: type_13;
var local_24: u32;
var local_25: u32;
var local_26: u32;
var local_27: u32;
var local_28: u32;
var local_29: u32;
var local_30: u32;
var local_31: u32;
var local_32: type_13;
var local_33: u32;
var local_34: type_26;
var local_35: i32;
var local_36: i32;
var phi_2007_: vec3<f32>;
var phi_2010_: vec3<f32>;
var phi_2012_: u32;
var phi_2032_: u32;
var phi_2033_: u32;
var phi_2045_: u32;
var phi_2046_: u32;
var local_37: u32;
var local_38: u32;
var phi_2063_: u32;
var phi_2064_: u32;
var phi_2076_: u32;
var phi_2077_: u32;
var local_39: u32;
var local_40: u32;
var local_41: u32;
var phi_2102_: u32;
var phi_2103_: u32;
var local_42: u32;
var local_43: u32;
var phi_2120_: u32;
var phi_2121_: u32;
var local_44: u32;
var local_45: u32;
var phi_2143_: u32;
var phi_2144_: u32;
var phi_2156_: u32;
var phi_2157_: u32;
var local_46: u32;
var local_47: u32;
var local_48: u32;
var phi_2193_: u32;
var local_49: u32;
var phi_2207_: vec3<f32>;
var phi_2210_: vec3<f32>;
var phi_2212_: type_13;
var phi_3089_: bool;
var phi_3099_: u32;
var phi_3123_: u32;
var phi_3144_: u32;
var phi_3147_: u32;
var phi_3184_: u32;
var phi_3255_: u32;
var phi_3326_: u32;
var phi_3397_: u32;
var phi_3468_: u32;
var phi_3539_: u32;
var phi_3599_: u32;
var phi_3145_: u32;
var phi_3148_: u32;
var phi_3899_: u32;
var phi_3901_: vec3<f32>;
var phi_3904_: vec3<f32>;
var phi_3906_: u32;
var phi_3935_: u32;
var phi_3981_: i32;
var phi_4828_: u32;
var phi_4831_: f32;
var phi_4966_: i32;
var phi_4979_: i32;
var phi_4993_: i32;
var phi_5309_: i32;
var phi_5322_: i32;
var phi_5336_: i32;
var phi_4829_: u32;
var phi_4832_: f32;
var phi_5541_: f32;
var phi_5554_: u32;
var phi_5557_: f32;
var phi_5692_: i32;
var phi_5705_: i32;
var phi_5719_: i32;
var phi_6035_: i32;
var phi_6048_: i32;
var phi_6062_: i32;
var phi_5555_: u32;
var phi_5558_: f32;
var phi_6267_: f32;
var phi_6389_: i32;
var phi_6402_: i32;
var phi_6416_: i32;
var phi_6616_: f32;
var phi_6959_: f32;
var phi_7078_: vec3<f32>;
var phi_7117_: vec3<f32>;
var phi_7118_: vec3<f32>;
var phi_3902_: vec3<f32>;
var phi_3905_: vec3<f32>;
var phi_3907_: u32;
var phi_7128_: type_13;
var phi_7129_: type_13;
var phi_7150_: vec3<f32>;
var phi_7151_: vec3<f32>;
var phi_7152_: type_13;
var phi_2208_: vec3<f32>;
var phi_2211_: vec3<f32>;
var phi_2213_: type_13;
var phi_2008_: vec3<f32>;
var phi_2011_: vec3<f32>;
var phi_2013_: u32;
var local_50: vec3<f32>;
var local_51: vec3<f32>;
var local_52: vec3<f32>;
var local_53: vec3<f32>;
var local_54: vec3<f32>;
var local_55: vec3<f32>;
var phi_7206_: array<f32, 22>;
var local_56: u32;
var local_57: f32;
var local_58: f32;
var local_59: vec3<f32>;
var local_60: vec3<f32>;
var local_61: type_13;
var local_62: vec3<f32>;
var local_63: vec3<f32>;
let _e140 = global;
let _e149 = arrayLength((&global_4.member));
let _e152 = arrayLength((&global_5.member));
let _e157 = global_1.member.member;
if (_e140.x < _e157.member) {
if (_e140.y < _e157.member_1) {
let _e164 = (_e157.member * _e157.member_1);
let _e166 = ((_e140.y * _e157.member) + _e140.x);
let _e167 = bitcast<i32>(_e166);
let _e169 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e171 = select(_e169, _e167, (_e167 < _e169));
let _e177 = global_6.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e178 = (_e164 + _e166);
let _e179 = bitcast<i32>(_e178);
let _e181 = select(_e169, _e179, (_e179 < _e169));
let _e187 = global_6.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e189 = ((2u * _e164) + _e166);
let _e190 = bitcast<i32>(_e189);
let _e192 = select(_e169, _e190, (_e190 < _e169));
let _e198 = global_6.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e200 = ((3u * _e164) + _e166);
let _e201 = bitcast<i32>(_e200);
let _e203 = select(_e169, _e201, (_e201 < _e169));
let _e209 = global_6.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e211 = ((4u * _e164) + _e166);
let _e212 = bitcast<i32>(_e211);
let _e214 = select(_e169, _e212, (_e212 < _e169));
let _e220 = global_6.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e222 = ((5u * _e164) + _e166);
let _e223 = bitcast<i32>(_e222);
let _e225 = select(_e169, _e223, (_e223 < _e169));
let _e231 = global_6.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e233 = ((6u * _e164) + _e166);
let _e234 = bitcast<i32>(_e233);
let _e236 = select(_e169, _e234, (_e234 < _e169));
let _e242 = global_6.member[bitcast<u32>(select(0i, _e236, (_e236 > 0i)))];
let _e244 = ((7u * _e164) + _e166);
let _e245 = bitcast<i32>(_e244);
let _e247 = select(_e169, _e245, (_e245 < _e169));
let _e253 = global_6.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e255 = ((8u * _e164) + _e166);
let _e256 = bitcast<i32>(_e255);
let _e258 = select(_e169, _e256, (_e256 < _e169));
let _e264 = global_6.member[bitcast<u32>(select(0i, _e258, (_e258 > 0i)))];
let _e266 = ((9u * _e164) + _e166);
let _e267 = bitcast<i32>(_e266);
let _e269 = select(_e169, _e267, (_e267 < _e169));
let _e275 = global_6.member[bitcast<u32>(select(0i, _e269, (_e269 > 0i)))];
let _e277 = ((10u * _e164) + _e166);
let _e278 = bitcast<i32>(_e277);
let _e280 = select(_e169, _e278, (_e278 < _e169));
let _e286 = global_6.member[bitcast<u32>(select(0i, _e280, (_e280 > 0i)))];
let _e288 = ((11u * _e164) + _e166);
let _e289 = bitcast<i32>(_e288);
let _e291 = select(_e169, _e289, (_e289 < _e169));
let _e297 = global_6.member[bitcast<u32>(select(0i, _e291, (_e291 > 0i)))];
let _e299 = ((12u * _e164) + _e166);
let _e300 = bitcast<i32>(_e299);
let _e302 = select(_e169, _e300, (_e300 < _e169));
let _e308 = global_6.member[bitcast<u32>(select(0i, _e302, (_e302 > 0i)))];
let _e310 = ((13u * _e164) + _e166);
let _e311 = bitcast<i32>(_e310);
let _e313 = select(_e169, _e311, (_e311 < _e169));
let _e319 = global_6.member[bitcast<u32>(select(0i, _e313, (_e313 > 0i)))];
let _e321 = ((14u * _e164) + _e166);
let _e322 = bitcast<i32>(_e321);
let _e324 = select(_e169, _e322, (_e322 < _e169));
let _e330 = global_6.member[bitcast<u32>(select(0i, _e324, (_e324 > 0i)))];
let _e332 = ((15u * _e164) + _e166);
let _e333 = bitcast<i32>(_e332);
let _e335 = select(_e169, _e333, (_e333 < _e169));
let _e341 = global_6.member[bitcast<u32>(select(0i, _e335, (_e335 > 0i)))];
let _e343 = ((16u * _e164) + _e166);
let _e344 = bitcast<i32>(_e343);
let _e346 = select(_e169, _e344, (_e344 < _e169));
let _e352 = global_6.member[bitcast<u32>(select(0i, _e346, (_e346 > 0i)))];
let _e354 = ((17u * _e164) + _e166);
let _e355 = bitcast<i32>(_e354);
let _e357 = select(_e169, _e355, (_e355 < _e169));
let _e363 = global_6.member[bitcast<u32>(select(0i, _e357, (_e357 > 0i)))];
let _e365 = ((18u * _e164) + _e166);
let _e366 = bitcast<i32>(_e365);
let _e368 = select(_e169, _e366, (_e366 < _e169));
let _e374 = global_6.member[bitcast<u32>(select(0i, _e368, (_e368 > 0i)))];
let _e376 = ((19u * _e164) + _e166);
let _e377 = bitcast<i32>(_e376);
let _e379 = select(_e169, _e377, (_e377 < _e169));
let _e385 = global_6.member[bitcast<u32>(select(0i, _e379, (_e379 > 0i)))];
let _e387 = ((20u * _e164) + _e166);
let _e388 = bitcast<i32>(_e387);
let _e390 = select(_e169, _e388, (_e388 < _e169));
let _e396 = global_6.member[bitcast<u32>(select(0i, _e390, (_e390 > 0i)))];
let _e398 = ((21u * _e164) + _e166);
let _e399 = bitcast<i32>(_e398);
let _e401 = select(_e169, _e399, (_e399 < _e169));
let _e407 = global_6.member[bitcast<u32>(select(0i, _e401, (_e401 > 0i)))];
let _e412 = global_1.member.member.member;
let _e416 = global_1.member.member.member_1;
let _e417 = (_e412 * _e416);
local_35 = bitcast<i32>(_e417);
let _e420 = ((_e140.y * _e412) + _e140.x);
let _e421 = bitcast<i32>(_e420);
local_36 = _e421;
let _e422 = local_35;
let _e424 = local_36;
let _e425 = ((29i * _e422) + _e424);
let _e427 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e429 = select(_e427, _e425, (_e425 < _e427));
let _e434 = global_2.member[bitcast<u32>(select(0i, _e429, (_e429 > 0i)))];
let _e436 = local_35;
let _e438 = local_36;
let _e439 = ((36i * _e436) + _e438);
let _e441 = select(_e427, _e439, (_e439 < _e427));
let _e446 = global_2.member[bitcast<u32>(select(0i, _e441, (_e441 > 0i)))];
let _e457 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e434 == 2f) && (select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < -2147483600f)), 2147483647i, (_e446 > 2147483500f)), (_e446 == _e446)) == (bitcast<i32>(_e457) + 1i)))) > 1u) {
let _e465 = select(_e427, _e421, (_e421 < _e427));
let _e471 = global_2.member[bitcast<u32>(select(0i, _e465, (_e465 > 0i)))];
let _e473 = bitcast<i32>((_e417 + _e420));
let _e475 = select(_e427, _e473, (_e473 < _e427));
let _e481 = global_2.member[bitcast<u32>(select(0i, _e475, (_e475 > 0i)))];
let _e484 = bitcast<i32>(((2u * _e417) + _e420));
let _e486 = select(_e427, _e484, (_e484 < _e427));
let _e492 = global_2.member[bitcast<u32>(select(0i, _e486, (_e486 > 0i)))];
let _e495 = bitcast<i32>(((3u * _e417) + _e420));
let _e497 = select(_e427, _e495, (_e495 < _e427));
let _e503 = global_2.member[bitcast<u32>(select(0i, _e497, (_e497 > 0i)))];
let _e506 = bitcast<i32>(((4u * _e417) + _e420));
let _e508 = select(_e427, _e506, (_e506 < _e427));
let _e514 = global_2.member[bitcast<u32>(select(0i, _e508, (_e508 > 0i)))];
let _e517 = bitcast<i32>(((5u * _e417) + _e420));
let _e519 = select(_e427, _e517, (_e517 < _e427));
let _e525 = global_2.member[bitcast<u32>(select(0i, _e519, (_e519 > 0i)))];
let _e528 = bitcast<i32>(((6u * _e417) + _e420));
let _e530 = select(_e427, _e528, (_e528 < _e427));
let _e536 = global_2.member[bitcast<u32>(select(0i, _e530, (_e530 > 0i)))];
let _e539 = bitcast<i32>(((7u * _e417) + _e420));
let _e541 = select(_e427, _e539, (_e539 < _e427));
let _e547 = global_2.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
let _e550 = bitcast<i32>(((8u * _e417) + _e420));
let _e552 = select(_e427, _e550, (_e550 < _e427));
let _e558 = global_2.member[bitcast<u32>(select(0i, _e552, (_e552 > 0i)))];
let _e561 = bitcast<i32>(((9u * _e417) + _e420));
let _e563 = select(_e427, _e561, (_e561 < _e427));
let _e569 = global_2.member[bitcast<u32>(select(0i, _e563, (_e563 > 0i)))];
let _e572 = bitcast<i32>(((10u * _e417) + _e420));
let _e574 = select(_e427, _e572, (_e572 < _e427));
let _e580 = global_2.member[bitcast<u32>(select(0i, _e574, (_e574 > 0i)))];
let _e583 = bitcast<i32>(((11u * _e417) + _e420));
let _e585 = select(_e427, _e583, (_e583 < _e427));
let _e591 = global_2.member[bitcast<u32>(select(0i, _e585, (_e585 > 0i)))];
let _e594 = bitcast<i32>(((12u * _e417) + _e420));
let _e596 = select(_e427, _e594, (_e594 < _e427));
let _e602 = global_2.member[bitcast<u32>(select(0i, _e596, (_e596 > 0i)))];
let _e605 = bitcast<i32>(((13u * _e417) + _e420));
let _e607 = select(_e427, _e605, (_e605 < _e427));
let _e613 = global_2.member[bitcast<u32>(select(0i, _e607, (_e607 > 0i)))];
let _e616 = bitcast<i32>(((14u * _e417) + _e420));
let _e618 = select(_e427, _e616, (_e616 < _e427));
let _e624 = global_2.member[bitcast<u32>(select(0i, _e618, (_e618 > 0i)))];
let _e627 = bitcast<i32>(((15u * _e417) + _e420));
let _e629 = select(_e427, _e627, (_e627 < _e427));
let _e635 = global_2.member[bitcast<u32>(select(0i, _e629, (_e629 > 0i)))];
let _e638 = bitcast<i32>(((16u * _e417) + _e420));
let _e640 = select(_e427, _e638, (_e638 < _e427));
let _e646 = global_2.member[bitcast<u32>(select(0i, _e640, (_e640 > 0i)))];
let _e649 = bitcast<i32>(((17u * _e417) + _e420));
let _e651 = select(_e427, _e649, (_e649 < _e427));
let _e657 = global_2.member[bitcast<u32>(select(0i, _e651, (_e651 > 0i)))];
let _e660 = bitcast<i32>(((18u * _e417) + _e420));
let _e662 = select(_e427, _e660, (_e660 < _e427));
let _e668 = global_2.member[bitcast<u32>(select(0i, _e662, (_e662 > 0i)))];
let _e671 = bitcast<i32>(((19u * _e417) + _e420));
let _e673 = select(_e427, _e671, (_e671 < _e427));
let _e679 = global_2.member[bitcast<u32>(select(0i, _e673, (_e673 > 0i)))];
let _e682 = bitcast<i32>(((20u * _e417) + _e420));
let _e684 = select(_e427, _e682, (_e682 < _e427));
let _e690 = global_2.member[bitcast<u32>(select(0i, _e684, (_e684 > 0i)))];
let _e693 = bitcast<i32>(((24u * _e417) + _e420));
let _e695 = select(_e427, _e693, (_e693 < _e427));
let _e701 = global_2.member[bitcast<u32>(select(0i, _e695, (_e695 > 0i)))];
let _e704 = bitcast<i32>(((30u * _e417) + _e420));
let _e706 = select(_e427, _e704, (_e704 < _e427));
let _e712 = global_2.member[bitcast<u32>(select(0i, _e706, (_e706 > 0i)))];
let _e720 = (select(0i, select(select(i32(_e712), i32(-2147483648), (_e712 < -2147483600f)), 2147483647i, (_e712 > 2147483500f)), (_e712 == _e712)) == 0i);
let _e728 = global_1.member.member_1.member;
let _e734 = global_1.member.member_1.member_1;
let _e744 = global_1.member.member_2.member;
let _e745 = (((((f32(bitcast<i32>(_e140.x)) + 0.5f) / f32(bitcast<i32>(_e728))) * 2f) - 1f) * _e744);
let _e753 = global_1.member.member_2.member_1;
let _e754 = ((1f - (((f32(bitcast<i32>(_e140.y)) + 0.5f) / f32(bitcast<i32>(_e734))) * 2f)) * _e753);
let _e757 = global_1.member.member_3;
let _e766 = global_1.member.member_4;
let _e779 = global_1.member.member_2.member_3;
let _e780 = (_e779 != 0u);
let _e783 = global_1.member.member_6;
let _e790 = select(_e783.member, (_e783.member + ((_e757.member * _e745) + (_e766.member * _e754))), _e780);
let _e791 = select(_e783.member_1, (_e783.member_1 + ((_e757.member_1 * _e745) + (_e766.member_1 * _e754))), _e780);
let _e792 = select(_e783.member_2, (_e783.member_2 + ((_e757.member_2 * _e745) + (_e766.member_2 * _e754))), _e780);
let _e802 = select(_e471, _e790, _e720);
let _e803 = select(_e481, _e791, _e720);
let _e804 = select(_e492, _e792, _e720);
let _e805 = (select(0f, ((((_e471 - _e790) * _e503) + ((_e481 - _e791) * _e514)) + ((_e492 - _e792) * _e525)), _e720) + _e701);
let _e806 = select(_e668, 1f, _e720);
let _e807 = select(_e679, 1f, _e720);
let _e808 = select(_e690, 1f, _e720);
let _e816 = (1f / select(_e503, select(1e-12f, -1e-12f, (_e503 < 0f)), (bitcast<f32>((bitcast<u32>(_e503) & 2147483647u)) < 1e-12f)));
let _e824 = (1f / select(_e514, select(1e-12f, -1e-12f, (_e514 < 0f)), (bitcast<f32>((bitcast<u32>(_e514) & 2147483647u)) < 1e-12f)));
let _e832 = (1f / select(_e525, select(1e-12f, -1e-12f, (_e525 < 0f)), (bitcast<f32>((bitcast<u32>(_e525) & 2147483647u)) < 1e-12f)));
let _e836 = global_1.member.member_13.member_4;
let _e843 = global_1.member.member_13.member_5;
let _e848 = ((_e836.member - _e802) * _e816);
let _e850 = ((_e843.member - _e802) * _e816);
let _e852 = ((_e836.member_1 - _e803) * _e824);
let _e854 = ((_e843.member_1 - _e803) * _e824);
let _e856 = ((_e836.member_2 - _e804) * _e832);
let _e858 = ((_e843.member_2 - _e804) * _e832);
let _e860 = select(_e850, _e848, (_e848 < _e850));
let _e862 = select(_e854, _e852, (_e852 < _e854));
let _e864 = select(_e862, _e860, (_e860 > _e862));
let _e866 = select(_e858, _e856, (_e856 < _e858));
let _e868 = select(_e866, _e864, (_e864 > _e866));
let _e870 = select(_e850, _e848, (_e848 > _e850));
let _e872 = select(_e854, _e852, (_e852 > _e854));
let _e874 = select(_e872, _e870, (_e870 < _e872));
let _e876 = select(_e858, _e856, (_e856 > _e858));
let _e878 = select(_e876, _e874, (_e874 < _e876));
let _e880 = select(0f, _e868, (_e868 > 0f));
let _e882 = select(_e805, _e878, (_e878 < _e805));
let _e883 = (_e882 > _e880);
let _e884 = select(0f, _e880, _e883);
let _e885 = select(0f, _e882, _e883);
if ((_e720 || (_e885 <= _e884)) || ((((_e806 + _e807) + _e808) * (1f / 3f)) < 0.01f)) {
phi_7206_ = array<f32, 22>(_e177, _e187, _e198, _e209, _e220, _e231, _e242, _e253, _e264, _e275, _e286, _e297, _e308, _e319, _e330, _e341, _e352, _e363, _e374, _e385, _e396, _e407);
} else {
let _e898 = (((_e602 * _e602) + (_e613 * _e613)) + (_e624 * _e624));
let _e906 = (((_e635 * _e635) + (_e646 * _e646)) + (_e657 * _e657));
let _e911 = (0.5f * (sqrt(select(0f, _e898, (_e898 > 0f))) + sqrt(select(0f, _e906, (_e906 > 0f)))));
let _e912 = (_e503 + _e911);
let _e920 = (1f / select(_e912, select(1e-12f, -1e-12f, (_e912 < 0f)), (bitcast<f32>((bitcast<u32>(_e912) & 2147483647u)) < 1e-12f)));
let _e921 = (_e514 + _e911);
let _e929 = (1f / select(_e921, select(1e-12f, -1e-12f, (_e921 < 0f)), (bitcast<f32>((bitcast<u32>(_e921) & 2147483647u)) < 1e-12f)));
let _e930 = (_e525 + _e911);
let _e938 = (1f / select(_e930, select(1e-12f, -1e-12f, (_e930 < 0f)), (bitcast<f32>((bitcast<u32>(_e930) & 2147483647u)) < 1e-12f)));
let _e939 = (_e503 - _e911);
let _e948 = (_e514 - _e911);
let _e957 = (_e525 - _e911);
let _e970 = (((_e536 * _e536) + (_e547 * _e547)) + (_e558 * _e558));
let _e978 = (((_e569 * _e569) + (_e580 * _e580)) + (_e591 * _e591));
let _e983 = (0.5f * (sqrt(select(0f, _e970, (_e970 > 0f))) + sqrt(select(0f, _e978, (_e978 > 0f)))));
let _e987 = global_1.member.member_11.member;
phi_2007_ = vec3<f32>(0f, 0f, 0f);
phi_2010_ = vec3<f32>(0f, 0f, 0f);
phi_2012_ = 0u;
loop {
let _e991 = phi_2007_;
let _e993 = phi_2010_;
let _e995 = phi_2012_;
local_50 = _e993;
local_51 = _e993;
local_52 = _e993;
local_53 = _e991;
local_54 = _e991;
local_55 = _e991;
let _e999 = global_1.member.member_12.member_9;
let _e1000 = (_e995 <= _e999);
if _e1000 {
let _e1004 = global_1.member.member_12.member_6;
phi_2032_ = 0u;
loop {
let _e1008 = phi_2032_;
local_49 = _e1008;
let _e1012 = ((1u << bitcast<u32>((_e1008 & 31u))) < _e987);
if _e1012 {
phi_2033_ = (_e1008 + 1u);
} else {
phi_2033_ = u32();
}
let _e1015 = phi_2033_;
continue;
continuing {
phi_2032_ = _e1015;
break if !(_e1012);
}
}
phi_2045_ = 0u;
loop {
let _e1018 = phi_2045_;
local_37 = _e1018;
local_38 = _e1018;
let _e1022 = ((1u << bitcast<u32>((_e1018 & 31u))) < _e987);
if _e1022 {
phi_2046_ = (_e1018 + 1u);
} else {
phi_2046_ = u32();
}
let _e1025 = phi_2046_;
continue;
continuing {
phi_2045_ = _e1025;
break if !(_e1022);
}
}
let _e1028 = local_37;
let _e1031 = local_38;
phi_2063_ = 0u;
loop {
let _e1034 = phi_2063_;
local_41 = _e1034;
let _e1038 = ((1u << bitcast<u32>((_e1034 & 31u))) < _e987);
if _e1038 {
phi_2064_ = (_e1034 + 1u);
} else {
phi_2064_ = u32();
}
let _e1041 = phi_2064_;
continue;
continuing {
phi_2063_ = _e1041;
break if !(_e1038);
}
}
phi_2076_ = 0u;
loop {
let _e1044 = phi_2076_;
local_39 = _e1044;
local_40 = _e1044;
let _e1048 = ((1u << bitcast<u32>((_e1044 & 31u))) < _e987);
if _e1048 {
phi_2077_ = (_e1044 + 1u);
} else {
phi_2077_ = u32();
}
let _e1051 = phi_2077_;
continue;
continuing {
phi_2076_ = _e1051;
break if !(_e1048);
}
}
let _e1054 = local_39;
let _e1057 = local_40;
let _e1060 = local_41;
let _e1069 = global_1.member.member_12.member_8;
phi_2102_ = 0u;
loop {
let _e1072 = phi_2102_;
local_42 = _e1072;
local_43 = _e1072;
let _e1076 = ((1u << bitcast<u32>((_e1072 & 31u))) < _e987);
if _e1076 {
phi_2103_ = (_e1072 + 1u);
} else {
phi_2103_ = u32();
}
let _e1079 = phi_2103_;
continue;
continuing {
phi_2102_ = _e1079;
break if !(_e1076);
}
}
let _e1082 = local_42;
let _e1085 = local_43;
phi_2120_ = 0u;
loop {
let _e1088 = phi_2120_;
local_44 = _e1088;
local_45 = _e1088;
let _e1092 = ((1u << bitcast<u32>((_e1088 & 31u))) < _e987);
if _e1092 {
phi_2121_ = (_e1088 + 1u);
} else {
phi_2121_ = u32();
}
let _e1095 = phi_2121_;
continue;
continuing {
phi_2120_ = _e1095;
break if !(_e1092);
}
}
let _e1098 = local_44;
let _e1104 = local_45;
phi_2143_ = 0u;
loop {
let _e1114 = phi_2143_;
local_48 = _e1114;
let _e1118 = ((1u << bitcast<u32>((_e1114 & 31u))) < _e987);
if _e1118 {
phi_2144_ = (_e1114 + 1u);
} else {
phi_2144_ = u32();
}
let _e1121 = phi_2144_;
continue;
continuing {
phi_2143_ = _e1121;
break if !(_e1118);
}
}
phi_2156_ = 0u;
loop {
let _e1124 = phi_2156_;
local_46 = _e1124;
local_47 = _e1124;
let _e1128 = ((1u << bitcast<u32>((_e1124 & 31u))) < _e987);
if _e1128 {
phi_2157_ = (_e1124 + 1u);
} else {
phi_2157_ = u32();
}
let _e1131 = phi_2157_;
continue;
continuing {
phi_2156_ = _e1131;
break if !(_e1128);
}
}
let _e1134 = local_46;
let _e1137 = local_47;
let _e1140 = local_48;
let _e1146 = (((((1u << bitcast<u32>(((2u * _e1098) & 31u))) - (1u << bitcast<u32>(((2u * (_e1104 - select(6u, _e1085, (_e1082 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1140 - select(6u, _e1137, (_e1134 < 6u)))) & 31u))));
let _e1147 = (_e1146 / 64u);
if ((_e1146 % 64u) > 0u) {
phi_2193_ = (_e1147 + 1u);
} else {
phi_2193_ = _e1147;
}
let _e1152 = phi_2193_;
let _e1155 = local_49;
local_34 = type_26(_e1155, select(6u, _e1031, (_e1028 < 6u)), (1u << bitcast<u32>(((2u * (_e1060 - select(6u, _e1057, (_e1054 < 6u)))) & 31u))), (_e995 * _e1069), (_e1152 * 64u));
let _e1157 = (_e995 == 0u);
let _e1159 = local_34.member_1;
phi_2207_ = _e991;
phi_2210_ = _e993;
phi_2212_ = type_13(_e1159, 0u);
loop {
let _e1162 = phi_2207_;
let _e1164 = phi_2210_;
let _e1166 = phi_2212_;
local_62 = _e1162;
local_63 = _e1164;
let _e1169 = local_34.member_1;
let _e1172 = local_34.member_2;
let _e1174 = ((_e1166.member < _e1169) || (_e1166.member_1 < _e1172));
if _e1174 {
local_32.member = _e1166.member;
local_32.member_1 = _e1166.member_1;
let _e1177 = local_32.member;
let _e1178 = local_32.member_1;
let _e1180 = local_34.member;
let _e1195 = local_34.member_3;
local_33 = (_e1195 + (((((1u << bitcast<u32>(((2u * _e1180) & 31u))) - (1u << bitcast<u32>(((2u * (_e1180 - _e1177)) & 31u)))) / 3u) * 4u) + _e1178));
let _e1197 = local_33;
let _e1198 = bitcast<i32>(_e1197);
let _e1200 = (bitcast<i32>(_e149) - 1i);
let _e1202 = select(_e1200, _e1198, (_e1198 < _e1200));
let _e1207 = global_4.member[bitcast<u32>(select(0i, _e1202, (_e1202 > 0i)))];
let _e1208 = local_33;
let _e1210 = local_34.member_4;
let _e1212 = bitcast<i32>((_e1208 + _e1210));
let _e1214 = select(_e1200, _e1212, (_e1212 < _e1200));
let _e1219 = global_4.member[bitcast<u32>(select(0i, _e1214, (_e1214 > 0i)))];
let _e1220 = local_33;
let _e1221 = local_34.member_4;
let _e1224 = bitcast<i32>((_e1220 + (2u * _e1221)));
let _e1226 = select(_e1200, _e1224, (_e1224 < _e1200));
let _e1231 = global_4.member[bitcast<u32>(select(0i, _e1226, (_e1226 > 0i)))];
let _e1232 = local_32.member;
let _e1233 = local_32.member_1;
let _e1234 = local_34.member;
let _e1248 = local_34.member_3;
let _e1249 = local_34.member_4;
local_31 = ((_e1248 + (3u * _e1249)) + (((((1u << bitcast<u32>(((2u * _e1234) & 31u))) - (1u << bitcast<u32>(((2u * (_e1234 - _e1232)) & 31u)))) / 3u) * 4u) + _e1233));
let _e1253 = local_31;
let _e1254 = bitcast<i32>(_e1253);
let _e1256 = select(_e1200, _e1254, (_e1254 < _e1200));
let _e1261 = global_4.member[bitcast<u32>(select(0i, _e1256, (_e1256 > 0i)))];
let _e1262 = local_31;
let _e1263 = local_34.member_4;
let _e1265 = bitcast<i32>((_e1262 + _e1263));
let _e1267 = select(_e1200, _e1265, (_e1265 < _e1200));
let _e1272 = global_4.member[bitcast<u32>(select(0i, _e1267, (_e1267 > 0i)))];
let _e1273 = local_31;
let _e1274 = local_34.member_4;
let _e1277 = bitcast<i32>((_e1273 + (2u * _e1274)));
let _e1279 = select(_e1200, _e1277, (_e1277 < _e1200));
let _e1284 = global_4.member[bitcast<u32>(select(0i, _e1279, (_e1279 > 0i)))];
let _e1285 = local_32.member;
let _e1286 = local_32.member_1;
let _e1287 = local_34.member;
let _e1301 = local_34.member_3;
let _e1302 = local_34.member_4;
local_30 = ((_e1301 + (6u * _e1302)) + (((((1u << bitcast<u32>(((2u * _e1287) & 31u))) - (1u << bitcast<u32>(((2u * (_e1287 - _e1285)) & 31u)))) / 3u) * 4u) + _e1286));
let _e1306 = local_30;
let _e1307 = bitcast<i32>(_e1306);
let _e1309 = select(_e1200, _e1307, (_e1307 < _e1200));
let _e1314 = global_4.member[bitcast<u32>(select(0i, _e1309, (_e1309 > 0i)))];
let _e1315 = local_30;
let _e1316 = local_34.member_4;
let _e1318 = bitcast<i32>((_e1315 + _e1316));
let _e1320 = select(_e1200, _e1318, (_e1318 < _e1200));
let _e1325 = global_4.member[bitcast<u32>(select(0i, _e1320, (_e1320 > 0i)))];
let _e1326 = local_30;
let _e1327 = local_34.member_4;
let _e1330 = bitcast<i32>((_e1326 + (2u * _e1327)));
let _e1332 = select(_e1200, _e1330, (_e1330 < _e1200));
let _e1337 = global_4.member[bitcast<u32>(select(0i, _e1332, (_e1332 > 0i)))];
let _e1338 = local_32.member;
let _e1339 = local_32.member_1;
let _e1340 = local_34.member;
let _e1354 = local_34.member_3;
let _e1355 = local_34.member_4;
local_29 = ((_e1354 + (9u * _e1355)) + (((((1u << bitcast<u32>(((2u * _e1340) & 31u))) - (1u << bitcast<u32>(((2u * (_e1340 - _e1338)) & 31u)))) / 3u) * 4u) + _e1339));
let _e1359 = local_29;
let _e1360 = bitcast<i32>(_e1359);
let _e1362 = select(_e1200, _e1360, (_e1360 < _e1200));
let _e1367 = global_4.member[bitcast<u32>(select(0i, _e1362, (_e1362 > 0i)))];
let _e1368 = local_29;
let _e1369 = local_34.member_4;
let _e1371 = bitcast<i32>((_e1368 + _e1369));
let _e1373 = select(_e1200, _e1371, (_e1371 < _e1200));
let _e1378 = global_4.member[bitcast<u32>(select(0i, _e1373, (_e1373 > 0i)))];
let _e1379 = local_29;
let _e1380 = local_34.member_4;
let _e1383 = bitcast<i32>((_e1379 + (2u * _e1380)));
let _e1385 = select(_e1200, _e1383, (_e1383 < _e1200));
let _e1390 = global_4.member[bitcast<u32>(select(0i, _e1385, (_e1385 > 0i)))];
let _e1391 = local_32.member;
let _e1392 = local_32.member_1;
let _e1393 = local_34.member;
let _e1407 = local_34.member_3;
let _e1408 = local_34.member_4;
local_28 = ((_e1407 + (12u * _e1408)) + (((((1u << bitcast<u32>(((2u * _e1393) & 31u))) - (1u << bitcast<u32>(((2u * (_e1393 - _e1391)) & 31u)))) / 3u) * 4u) + _e1392));
let _e1412 = local_28;
let _e1413 = bitcast<i32>(_e1412);
let _e1415 = select(_e1200, _e1413, (_e1413 < _e1200));
let _e1420 = global_4.member[bitcast<u32>(select(0i, _e1415, (_e1415 > 0i)))];
let _e1421 = local_28;
let _e1422 = local_34.member_4;
let _e1424 = bitcast<i32>((_e1421 + _e1422));
let _e1426 = select(_e1200, _e1424, (_e1424 < _e1200));
let _e1431 = global_4.member[bitcast<u32>(select(0i, _e1426, (_e1426 > 0i)))];
let _e1432 = local_28;
let _e1433 = local_34.member_4;
let _e1436 = bitcast<i32>((_e1432 + (2u * _e1433)));
let _e1438 = select(_e1200, _e1436, (_e1436 < _e1200));
let _e1443 = global_4.member[bitcast<u32>(select(0i, _e1438, (_e1438 > 0i)))];
let _e1444 = local_32.member;
let _e1445 = local_32.member_1;
let _e1446 = local_34.member;
let _e1460 = local_34.member_3;
let _e1461 = local_34.member_4;
local_27 = ((_e1460 + (15u * _e1461)) + (((((1u << bitcast<u32>(((2u * _e1446) & 31u))) - (1u << bitcast<u32>(((2u * (_e1446 - _e1444)) & 31u)))) / 3u) * 4u) + _e1445));
let _e1465 = local_27;
let _e1466 = bitcast<i32>(_e1465);
let _e1468 = select(_e1200, _e1466, (_e1466 < _e1200));
let _e1473 = global_4.member[bitcast<u32>(select(0i, _e1468, (_e1468 > 0i)))];
let _e1474 = local_27;
let _e1475 = local_34.member_4;
let _e1477 = bitcast<i32>((_e1474 + _e1475));
let _e1479 = select(_e1200, _e1477, (_e1477 < _e1200));
let _e1484 = global_4.member[bitcast<u32>(select(0i, _e1479, (_e1479 > 0i)))];
let _e1485 = local_27;
let _e1486 = local_34.member_4;
let _e1489 = bitcast<i32>((_e1485 + (2u * _e1486)));
let _e1491 = select(_e1200, _e1489, (_e1489 < _e1200));
let _e1496 = global_4.member[bitcast<u32>(select(0i, _e1491, (_e1491 > 0i)))];
let _e1509 = (((_e1207 - _e802) - _e983) * _e920);
let _e1510 = (_e920 > 0f);
let _e1513 = select(_e884, select(_e1509, _e884, (_e884 > _e1509)), _e1510);
let _e1516 = select(select(_e1509, _e885, (_e885 < _e1509)), _e885, _e1510);
let _e1517 = -((1f / select(_e939, select(1e-12f, -1e-12f, (_e939 < 0f)), (bitcast<f32>((bitcast<u32>(_e939) & 2147483647u)) < 1e-12f))));
let _e1519 = (-(((_e1261 - _e802) + _e983)) * _e1517);
let _e1520 = (_e1517 > 0f);
let _e1523 = select(_e1513, select(_e1519, _e1513, (_e1513 > _e1519)), _e1520);
let _e1526 = select(select(_e1519, _e1516, (_e1516 < _e1519)), _e1516, _e1520);
let _e1527 = (((_e1219 - _e803) - _e983) * _e929);
let _e1528 = (_e929 > 0f);
let _e1531 = select(_e1523, select(_e1527, _e1523, (_e1523 > _e1527)), _e1528);
let _e1534 = select(select(_e1527, _e1526, (_e1526 < _e1527)), _e1526, _e1528);
let _e1535 = -((1f / select(_e948, select(1e-12f, -1e-12f, (_e948 < 0f)), (bitcast<f32>((bitcast<u32>(_e948) & 2147483647u)) < 1e-12f))));
let _e1537 = (-(((_e1272 - _e803) + _e983)) * _e1535);
let _e1538 = (_e1535 > 0f);
let _e1541 = select(_e1531, select(_e1537, _e1531, (_e1531 > _e1537)), _e1538);
let _e1544 = select(select(_e1537, _e1534, (_e1534 < _e1537)), _e1534, _e1538);
let _e1545 = (((_e1231 - _e804) - _e983) * _e938);
let _e1546 = (_e938 > 0f);
let _e1549 = select(_e1541, select(_e1545, _e1541, (_e1541 > _e1545)), _e1546);
let _e1552 = select(select(_e1545, _e1544, (_e1544 < _e1545)), _e1544, _e1546);
let _e1553 = -((1f / select(_e957, select(1e-12f, -1e-12f, (_e957 < 0f)), (bitcast<f32>((bitcast<u32>(_e957) & 2147483647u)) < 1e-12f))));
let _e1555 = (-(((_e1284 - _e804) + _e983)) * _e1553);
let _e1556 = (_e1553 > 0f);
if ((_e1207 <= _e1261) && (select(_e1549, select(_e1555, _e1549, (_e1549 > _e1555)), _e1556) <= select(select(_e1555, _e1552, (_e1552 < _e1555)), _e1552, _e1556))) {
let _e1566 = (_e1314 - _e802);
let _e1567 = (_e1325 - _e803);
let _e1568 = (_e1337 - _e804);
let _e1571 = ((_e1431 * _e525) - (_e1443 * _e514));
let _e1574 = ((_e1443 * _e503) - (_e1420 * _e525));
let _e1577 = ((_e1420 * _e514) - (_e1431 * _e503));
let _e1625 = (((_e1367 * _e1367) + (_e1378 * _e1378)) + (_e1390 * _e1390));
let _e1628 = sqrt(select(0f, _e1625, (_e1625 > 0f)));
let _e1633 = (((_e1473 * _e1473) + (_e1484 * _e1484)) + (_e1496 * _e1496));
let _e1643 = (((_e1566 * _e1566) + (_e1567 * _e1567)) + (_e1568 * _e1568));
phi_3089_ = (bitcast<f32>((bitcast<u32>((((_e1566 * _e1571) + (_e1567 * _e1574)) + (_e1568 * _e1577))) & 2147483647u)) <= ((((((bitcast<f32>((bitcast<u32>(_e1571) & 2147483647u)) * _e1367) + (bitcast<f32>((bitcast<u32>(_e1574) & 2147483647u)) * _e1378)) + (bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u)) * _e1390)) + (((bitcast<f32>((bitcast<u32>(((_e514 * _e1568) - (_e525 * _e1567))) & 2147483647u)) * _e1473) + (bitcast<f32>((bitcast<u32>(((_e525 * _e1566) - (_e503 * _e1568))) & 2147483647u)) * _e1484)) + (bitcast<f32>((bitcast<u32>(((_e503 * _e1567) - (_e514 * _e1566))) & 2147483647u)) * _e1496))) + (_e1628 * sqrt(select(0f, _e1633, (_e1633 > 0f))))) + (_e983 + (_e911 * (sqrt(select(0f, _e1643, (_e1643 > 0f))) + _e1628)))));
} else {
phi_3089_ = false;
}
let _e1656 = phi_3089_;
let _e1657 = local_34.member_1;
if (_e1657 < 2u) {
let _e1659 = local_34.member_1;
phi_3099_ = _e1659;
} else {
phi_3099_ = 2u;
}
let _e1661 = phi_3099_;
if (_e1656 && (_e1166.member > _e1661)) {
phi_7150_ = _e1162;
phi_7151_ = _e1164;
phi_7152_ = type_13((_e1166.member - 1u), (_e1166.member_1 << bitcast<u32>(2i)));
} else {
if _e1656 {
let _e1664 = local_34.member_1;
if (_e1664 < 2u) {
let _e1666 = local_34.member_1;
phi_3123_ = _e1666;
} else {
phi_3123_ = 2u;
}
let _e1668 = phi_3123_;
let _e1674 = local_34.member_3;
let _e1675 = local_34.member_4;
let _e1678 = local_34.member_4;
phi_3144_ = 0u;
phi_3147_ = 0u;
loop {
let _e1684 = phi_3144_;
let _e1686 = phi_3147_;
local_56 = _e1686;
let _e1687 = (_e1684 < select(0u, 16u, ((((_e1166.member_1 << bitcast<u32>(((2u * _e1668) & 31u))) + 16u) <= _e1678) && ((_e1674 + (24u * _e1675)) <= _e149))));
if _e1687 {
local_23.member = _e1166.member;
local_23.member_1 = _e1166.member_1;
local_24 = _e1684;
let _e1690 = local_23.member_1;
let _e1691 = local_24;
local_25 = _e1691;
let _e1692 = local_34.member_3;
let _e1693 = local_34.member_1;
if (_e1693 < 2u) {
let _e1695 = local_34.member_1;
phi_3184_ = _e1695;
} else {
phi_3184_ = 2u;
}
let _e1697 = phi_3184_;
local_26 = (_e1692 + (_e1690 << bitcast<u32>(((2u * _e1697) & 31u))));
let _e1703 = local_26;
let _e1705 = local_25;
let _e1710 = global_4.member[bitcast<u32>((bitcast<i32>(_e1703) + bitcast<i32>(_e1705)))];
let _e1711 = local_26;
let _e1712 = local_34.member_4;
let _e1715 = local_25;
let _e1720 = global_4.member[bitcast<u32>((bitcast<i32>((_e1711 + _e1712)) + bitcast<i32>(_e1715)))];
let _e1721 = local_26;
let _e1722 = local_34.member_4;
let _e1726 = local_25;
let _e1731 = global_4.member[bitcast<u32>((bitcast<i32>((_e1721 + (2u * _e1722))) + bitcast<i32>(_e1726)))];
let _e1732 = local_23.member_1;
let _e1733 = local_24;
local_21 = _e1733;
let _e1734 = local_34.member_3;
let _e1735 = local_34.member_4;
let _e1738 = local_34.member_1;
if (_e1738 < 2u) {
let _e1740 = local_34.member_1;
phi_3255_ = _e1740;
} else {
phi_3255_ = 2u;
}
let _e1742 = phi_3255_;
local_22 = ((_e1734 + (3u * _e1735)) + (_e1732 << bitcast<u32>(((2u * _e1742) & 31u))));
let _e1748 = local_22;
let _e1750 = local_21;
let _e1755 = global_4.member[bitcast<u32>((bitcast<i32>(_e1748) + bitcast<i32>(_e1750)))];
let _e1756 = local_22;
let _e1757 = local_34.member_4;
let _e1760 = local_21;
let _e1765 = global_4.member[bitcast<u32>((bitcast<i32>((_e1756 + _e1757)) + bitcast<i32>(_e1760)))];
let _e1766 = local_22;
let _e1767 = local_34.member_4;
let _e1771 = local_21;
let _e1776 = global_4.member[bitcast<u32>((bitcast<i32>((_e1766 + (2u * _e1767))) + bitcast<i32>(_e1771)))];
let _e1777 = local_23.member_1;
let _e1778 = local_24;
local_19 = _e1778;
let _e1779 = local_34.member_3;
let _e1780 = local_34.member_4;
let _e1783 = local_34.member_1;
if (_e1783 < 2u) {
let _e1785 = local_34.member_1;
phi_3326_ = _e1785;
} else {
phi_3326_ = 2u;
}
let _e1787 = phi_3326_;
local_20 = ((_e1779 + (6u * _e1780)) + (_e1777 << bitcast<u32>(((2u * _e1787) & 31u))));
let _e1793 = local_20;
let _e1795 = local_19;
let _e1800 = global_4.member[bitcast<u32>((bitcast<i32>(_e1793) + bitcast<i32>(_e1795)))];
let _e1801 = local_20;
let _e1802 = local_34.member_4;
let _e1805 = local_19;
let _e1810 = global_4.member[bitcast<u32>((bitcast<i32>((_e1801 + _e1802)) + bitcast<i32>(_e1805)))];
let _e1811 = local_20;
let _e1812 = local_34.member_4;
let _e1816 = local_19;
let _e1821 = global_4.member[bitcast<u32>((bitcast<i32>((_e1811 + (2u * _e1812))) + bitcast<i32>(_e1816)))];
let _e1822 = local_23.member_1;
let _e1823 = local_24;
local_17 = _e1823;
let _e1824 = local_34.member_3;
let _e1825 = local_34.member_4;
let _e1828 = local_34.member_1;
if (_e1828 < 2u) {
let _e1830 = local_34.member_1;
phi_3397_ = _e1830;
} else {
phi_3397_ = 2u;
}
let _e1832 = phi_3397_;
local_18 = ((_e1824 + (9u * _e1825)) + (_e1822 << bitcast<u32>(((2u * _e1832) & 31u))));
let _e1838 = local_18;
let _e1840 = local_17;
let _e1845 = global_4.member[bitcast<u32>((bitcast<i32>(_e1838) + bitcast<i32>(_e1840)))];
let _e1846 = local_18;
let _e1847 = local_34.member_4;
let _e1850 = local_17;
let _e1855 = global_4.member[bitcast<u32>((bitcast<i32>((_e1846 + _e1847)) + bitcast<i32>(_e1850)))];
let _e1856 = local_18;
let _e1857 = local_34.member_4;
let _e1861 = local_17;
let _e1866 = global_4.member[bitcast<u32>((bitcast<i32>((_e1856 + (2u * _e1857))) + bitcast<i32>(_e1861)))];
let _e1867 = local_23.member_1;
let _e1868 = local_24;
local_15 = _e1868;
let _e1869 = local_34.member_3;
let _e1870 = local_34.member_4;
let _e1873 = local_34.member_1;
if (_e1873 < 2u) {
let _e1875 = local_34.member_1;
phi_3468_ = _e1875;
} else {
phi_3468_ = 2u;
}
let _e1877 = phi_3468_;
local_16 = ((_e1869 + (12u * _e1870)) + (_e1867 << bitcast<u32>(((2u * _e1877) & 31u))));
let _e1883 = local_16;
let _e1885 = local_15;
let _e1890 = global_4.member[bitcast<u32>((bitcast<i32>(_e1883) + bitcast<i32>(_e1885)))];
let _e1891 = local_16;
let _e1892 = local_34.member_4;
let _e1895 = local_15;
let _e1900 = global_4.member[bitcast<u32>((bitcast<i32>((_e1891 + _e1892)) + bitcast<i32>(_e1895)))];
let _e1901 = local_16;
let _e1902 = local_34.member_4;
let _e1906 = local_15;
let _e1911 = global_4.member[bitcast<u32>((bitcast<i32>((_e1901 + (2u * _e1902))) + bitcast<i32>(_e1906)))];
let _e1912 = local_23.member_1;
let _e1913 = local_24;
local_13 = _e1913;
let _e1914 = local_34.member_3;
let _e1915 = local_34.member_4;
let _e1918 = local_34.member_1;
if (_e1918 < 2u) {
let _e1920 = local_34.member_1;
phi_3539_ = _e1920;
} else {
phi_3539_ = 2u;
}
let _e1922 = phi_3539_;
local_14 = ((_e1914 + (15u * _e1915)) + (_e1912 << bitcast<u32>(((2u * _e1922) & 31u))));
let _e1928 = local_14;
let _e1930 = local_13;
let _e1935 = global_4.member[bitcast<u32>((bitcast<i32>(_e1928) + bitcast<i32>(_e1930)))];
let _e1936 = local_14;
let _e1937 = local_34.member_4;
let _e1940 = local_13;
let _e1945 = global_4.member[bitcast<u32>((bitcast<i32>((_e1936 + _e1937)) + bitcast<i32>(_e1940)))];
let _e1946 = local_14;
let _e1947 = local_34.member_4;
let _e1951 = local_13;
let _e1956 = global_4.member[bitcast<u32>((bitcast<i32>((_e1946 + (2u * _e1947))) + bitcast<i32>(_e1951)))];
let _e1957 = local_34.member_1;
if (_e1957 < 2u) {
let _e1959 = local_34.member_1;
phi_3599_ = _e1959;
} else {
phi_3599_ = 2u;
}
let _e1961 = phi_3599_;
let _e1963 = ((2u * _e1961) & 31u);
let _e1966 = ((_e1166.member_1 << bitcast<u32>(_e1963)) + _e1684);
let _e1967 = (_e1966 & 1431655765u);
let _e1971 = ((_e1967 | (_e1967 >> bitcast<u32>(1i))) & 858993459u);
let _e1975 = ((_e1971 | (_e1971 >> bitcast<u32>(2i))) & 252645135u);
let _e1979 = ((_e1975 | (_e1975 >> bitcast<u32>(4i))) & 16711935u);
let _e1986 = ((_e1966 >> bitcast<u32>(1i)) & 1431655765u);
let _e1990 = ((_e1986 | (_e1986 >> bitcast<u32>(1i))) & 858993459u);
let _e1994 = ((_e1990 | (_e1990 >> bitcast<u32>(2i))) & 252645135u);
let _e1998 = ((_e1994 | (_e1994 >> bitcast<u32>(4i))) & 16711935u);
let _e2022 = (((_e1710 - _e802) - _e983) * _e920);
let _e2025 = select(_e884, select(_e2022, _e884, (_e884 > _e2022)), _e1510);
let _e2028 = select(select(_e2022, _e885, (_e885 < _e2022)), _e885, _e1510);
let _e2030 = (-(((_e1755 - _e802) + _e983)) * _e1517);
let _e2033 = select(_e2025, select(_e2030, _e2025, (_e2025 > _e2030)), _e1520);
let _e2036 = select(select(_e2030, _e2028, (_e2028 < _e2030)), _e2028, _e1520);
let _e2037 = (((_e1720 - _e803) - _e983) * _e929);
let _e2040 = select(_e2033, select(_e2037, _e2033, (_e2033 > _e2037)), _e1528);
let _e2043 = select(select(_e2037, _e2036, (_e2036 < _e2037)), _e2036, _e1528);
let _e2045 = (-(((_e1765 - _e803) + _e983)) * _e1535);
let _e2048 = select(_e2040, select(_e2045, _e2040, (_e2040 > _e2045)), _e1538);
let _e2051 = select(select(_e2045, _e2043, (_e2043 < _e2045)), _e2043, _e1538);
let _e2052 = (((_e1731 - _e804) - _e983) * _e938);
let _e2055 = select(_e2048, select(_e2052, _e2048, (_e2048 > _e2052)), _e1546);
let _e2058 = select(select(_e2052, _e2051, (_e2051 < _e2052)), _e2051, _e1546);
let _e2060 = (-(((_e1776 - _e804) + _e983)) * _e1553);
let _e2071 = (_e1800 - _e802);
let _e2072 = (_e1810 - _e803);
let _e2073 = (_e1821 - _e804);
let _e2076 = ((_e1900 * _e525) - (_e1911 * _e514));
let _e2079 = ((_e1911 * _e503) - (_e1890 * _e525));
let _e2082 = ((_e1890 * _e514) - (_e1900 * _e503));
let _e2130 = (((_e1845 * _e1845) + (_e1855 * _e1855)) + (_e1866 * _e1866));
let _e2133 = sqrt(select(0f, _e2130, (_e2130 > 0f)));
let _e2138 = (((_e1935 * _e1935) + (_e1945 * _e1945)) + (_e1956 * _e1956));
let _e2148 = (((_e2071 * _e2071) + (_e2072 * _e2072)) + (_e2073 * _e2073));
phi_3145_ = (_e1684 + 1u);
phi_3148_ = (_e1686 | (select(0u, 1u, (((((_e1684 < (1u << bitcast<u32>(_e1963))) && (((_e1979 | (_e1979 >> bitcast<u32>(8i))) & 65535u) < _e987)) && (((_e1998 | (_e1998 >> bitcast<u32>(8i))) & 65535u) < _e987)) && ((_e1710 <= _e1755) && (select(_e2055, select(_e2060, _e2055, (_e2055 > _e2060)), _e1556) <= select(select(_e2060, _e2058, (_e2058 < _e2060)), _e2058, _e1556)))) && (bitcast<f32>((bitcast<u32>((((_e2071 * _e2076) + (_e2072 * _e2079)) + (_e2073 * _e2082))) & 2147483647u)) <= ((((((bitcast<f32>((bitcast<u32>(_e2076) & 2147483647u)) * _e1845) + (bitcast<f32>((bitcast<u32>(_e2079) & 2147483647u)) * _e1855)) + (bitcast<f32>((bitcast<u32>(_e2082) & 2147483647u)) * _e1866)) + (((bitcast<f32>((bitcast<u32>(((_e514 * _e2073) - (_e525 * _e2072))) & 2147483647u)) * _e1935) + (bitcast<f32>((bitcast<u32>(((_e525 * _e2071) - (_e503 * _e2073))) & 2147483647u)) * _e1945)) + (bitcast<f32>((bitcast<u32>(((_e503 * _e2072) - (_e514 * _e2071))) & 2147483647u)) * _e1956))) + (_e2133 * sqrt(select(0f, _e2138, (_e2138 > 0f))))) + (_e983 + (_e911 * (sqrt(select(0f, _e2148, (_e2148 > 0f))) + _e2133))))))) << bitcast<u32>((_e1684 & 31u))));
} else {
phi_3145_ = u32();
phi_3148_ = u32();
}
let _e2168 = phi_3145_;
let _e2170 = phi_3148_;
continue;
continuing {
phi_3144_ = _e2168;
phi_3147_ = _e2170;
break if !(_e1687);
}
}
let _e4490 = local_56;
phi_3899_ = _e4490;
} else {
phi_3899_ = 0u;
}
let _e2173 = phi_3899_;
phi_3901_ = _e1162;
phi_3904_ = _e1164;
phi_3906_ = 0u;
loop {
let _e2175 = phi_3901_;
let _e2177 = phi_3904_;
let _e2179 = phi_3906_;
local_59 = _e2175;
local_60 = _e2177;
let _e2182 = (_e2173 >> bitcast<u32>((_e2179 & 31u)));
let _e2183 = (_e2182 == 0u);
if _e2183 {
phi_3902_ = vec3<f32>();
phi_3905_ = vec3<f32>();
phi_3907_ = u32();
} else {
if ((_e2182 & 1u) == 0u) {
phi_7117_ = _e2175;
phi_7118_ = _e2177;
} else {
let _e2186 = local_34.member_1;
if (_e2186 < 2u) {
let _e2188 = local_34.member_1;
phi_3935_ = _e2188;
} else {
phi_3935_ = 2u;
}
let _e2190 = phi_3935_;
let _e2192 = ((2u * _e2190) & 31u);
let _e2195 = ((_e1166.member_1 << bitcast<u32>(_e2192)) + _e2179);
let _e2196 = (_e2195 & 1431655765u);
let _e2200 = ((_e2196 | (_e2196 >> bitcast<u32>(1i))) & 858993459u);
let _e2204 = ((_e2200 | (_e2200 >> bitcast<u32>(2i))) & 252645135u);
let _e2208 = ((_e2204 | (_e2204 >> bitcast<u32>(4i))) & 16711935u);
let _e2212 = ((_e2208 | (_e2208 >> bitcast<u32>(8i))) & 65535u);
let _e2215 = ((_e2195 >> bitcast<u32>(1i)) & 1431655765u);
let _e2219 = ((_e2215 | (_e2215 >> bitcast<u32>(1i))) & 858993459u);
let _e2223 = ((_e2219 | (_e2219 >> bitcast<u32>(2i))) & 252645135u);
let _e2227 = ((_e2223 | (_e2223 >> bitcast<u32>(4i))) & 16711935u);
let _e2231 = ((_e2227 | (_e2227 >> bitcast<u32>(8i))) & 65535u);
if (((_e2179 < (1u << bitcast<u32>(_e2192))) && (_e2212 < _e987)) && (_e2231 < _e987)) {
phi_3981_ = bitcast<i32>(((_e2231 * _e987) + _e2212));
} else {
phi_3981_ = 0i;
}
let _e2243 = phi_3981_;
local_10 = bitcast<i32>((_e995 * _e1004));
local_11 = _e2243;
local_12 = bitcast<i32>((_e987 * _e987));
let _e2244 = local_10;
let _e2245 = local_11;
let _e2246 = (_e2244 + _e2245);
let _e2248 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e2250 = select(_e2248, _e2246, (_e2246 < _e2248));
let _e2255 = global_3.member[bitcast<u32>(select(0i, _e2250, (_e2250 > 0i)))];
let _e2256 = local_10;
let _e2257 = local_12;
let _e2259 = local_11;
let _e2260 = ((_e2256 + _e2257) + _e2259);
let _e2262 = select(_e2248, _e2260, (_e2260 < _e2248));
let _e2267 = global_3.member[bitcast<u32>(select(0i, _e2262, (_e2262 > 0i)))];
let _e2268 = local_10;
let _e2269 = local_12;
let _e2272 = local_11;
let _e2273 = ((_e2268 + (2i * _e2269)) + _e2272);
let _e2275 = select(_e2248, _e2273, (_e2273 < _e2248));
let _e2280 = global_3.member[bitcast<u32>(select(0i, _e2275, (_e2275 > 0i)))];
let _e2281 = local_10;
let _e2282 = local_12;
let _e2285 = local_11;
let _e2286 = ((_e2281 + (3i * _e2282)) + _e2285);
let _e2288 = select(_e2248, _e2286, (_e2286 < _e2248));
let _e2293 = global_3.member[bitcast<u32>(select(0i, _e2288, (_e2288 > 0i)))];
let _e2294 = local_10;
let _e2295 = local_12;
let _e2298 = local_11;
let _e2299 = ((_e2294 + (4i * _e2295)) + _e2298);
let _e2301 = select(_e2248, _e2299, (_e2299 < _e2248));
let _e2306 = global_3.member[bitcast<u32>(select(0i, _e2301, (_e2301 > 0i)))];
let _e2307 = local_10;
let _e2308 = local_12;
let _e2311 = local_11;
let _e2312 = ((_e2307 + (5i * _e2308)) + _e2311);
let _e2314 = select(_e2248, _e2312, (_e2312 < _e2248));
let _e2319 = global_3.member[bitcast<u32>(select(0i, _e2314, (_e2314 > 0i)))];
let _e2320 = local_10;
let _e2321 = local_12;
let _e2324 = local_11;
let _e2325 = ((_e2320 + (6i * _e2321)) + _e2324);
let _e2327 = select(_e2248, _e2325, (_e2325 < _e2248));
let _e2332 = global_3.member[bitcast<u32>(select(0i, _e2327, (_e2327 > 0i)))];
let _e2333 = local_10;
let _e2334 = local_12;
let _e2337 = local_11;
let _e2338 = ((_e2333 + (7i * _e2334)) + _e2337);
let _e2340 = select(_e2248, _e2338, (_e2338 < _e2248));
let _e2345 = global_3.member[bitcast<u32>(select(0i, _e2340, (_e2340 > 0i)))];
let _e2346 = local_10;
let _e2347 = local_12;
let _e2350 = local_11;
let _e2351 = ((_e2346 + (8i * _e2347)) + _e2350);
let _e2353 = select(_e2248, _e2351, (_e2351 < _e2248));
let _e2358 = global_3.member[bitcast<u32>(select(0i, _e2353, (_e2353 > 0i)))];
let _e2359 = local_10;
let _e2360 = local_12;
let _e2363 = local_11;
let _e2364 = ((_e2359 + (9i * _e2360)) + _e2363);
let _e2366 = select(_e2248, _e2364, (_e2364 < _e2248));
let _e2371 = global_3.member[bitcast<u32>(select(0i, _e2366, (_e2366 > 0i)))];
let _e2372 = local_10;
let _e2373 = local_12;
let _e2376 = local_11;
let _e2377 = ((_e2372 + (10i * _e2373)) + _e2376);
let _e2379 = select(_e2248, _e2377, (_e2377 < _e2248));
let _e2384 = global_3.member[bitcast<u32>(select(0i, _e2379, (_e2379 > 0i)))];
let _e2385 = local_10;
let _e2386 = local_12;
let _e2389 = local_11;
let _e2390 = ((_e2385 + (11i * _e2386)) + _e2389);
let _e2392 = select(_e2248, _e2390, (_e2390 < _e2248));
let _e2397 = global_3.member[bitcast<u32>(select(0i, _e2392, (_e2392 > 0i)))];
let _e2398 = local_10;
let _e2399 = local_12;
let _e2402 = local_11;
let _e2403 = ((_e2398 + (12i * _e2399)) + _e2402);
let _e2405 = select(_e2248, _e2403, (_e2403 < _e2248));
let _e2410 = global_3.member[bitcast<u32>(select(0i, _e2405, (_e2405 > 0i)))];
let _e2411 = local_10;
let _e2412 = local_12;
let _e2415 = local_11;
let _e2416 = ((_e2411 + (13i * _e2412)) + _e2415);
let _e2418 = select(_e2248, _e2416, (_e2416 < _e2248));
let _e2423 = global_3.member[bitcast<u32>(select(0i, _e2418, (_e2418 > 0i)))];
let _e2424 = local_10;
let _e2425 = local_12;
let _e2428 = local_11;
let _e2429 = ((_e2424 + (14i * _e2425)) + _e2428);
let _e2431 = select(_e2248, _e2429, (_e2429 < _e2248));
let _e2436 = global_3.member[bitcast<u32>(select(0i, _e2431, (_e2431 > 0i)))];
let _e2437 = local_10;
let _e2438 = local_12;
let _e2441 = local_11;
let _e2442 = ((_e2437 + (15i * _e2438)) + _e2441);
let _e2444 = select(_e2248, _e2442, (_e2442 < _e2248));
let _e2449 = global_3.member[bitcast<u32>(select(0i, _e2444, (_e2444 > 0i)))];
let _e2450 = local_10;
let _e2451 = local_12;
let _e2454 = local_11;
let _e2455 = ((_e2450 + (16i * _e2451)) + _e2454);
let _e2457 = select(_e2248, _e2455, (_e2455 < _e2248));
let _e2462 = global_3.member[bitcast<u32>(select(0i, _e2457, (_e2457 > 0i)))];
let _e2463 = local_10;
let _e2464 = local_12;
let _e2467 = local_11;
let _e2468 = ((_e2463 + (17i * _e2464)) + _e2467);
let _e2470 = select(_e2248, _e2468, (_e2468 < _e2248));
let _e2475 = global_3.member[bitcast<u32>(select(0i, _e2470, (_e2470 > 0i)))];
let _e2476 = local_10;
let _e2477 = local_12;
let _e2480 = local_11;
let _e2481 = ((_e2476 + (18i * _e2477)) + _e2480);
let _e2483 = select(_e2248, _e2481, (_e2481 < _e2248));
let _e2488 = global_3.member[bitcast<u32>(select(0i, _e2483, (_e2483 > 0i)))];
let _e2489 = local_10;
let _e2490 = local_12;
let _e2493 = local_11;
let _e2494 = ((_e2489 + (19i * _e2490)) + _e2493);
let _e2496 = select(_e2248, _e2494, (_e2494 < _e2248));
let _e2501 = global_3.member[bitcast<u32>(select(0i, _e2496, (_e2496 > 0i)))];
let _e2502 = local_10;
let _e2503 = local_12;
let _e2506 = local_11;
let _e2507 = ((_e2502 + (20i * _e2503)) + _e2506);
let _e2509 = select(_e2248, _e2507, (_e2507 < _e2248));
let _e2514 = global_3.member[bitcast<u32>(select(0i, _e2509, (_e2509 > 0i)))];
let _e2515 = local_10;
let _e2516 = local_12;
let _e2519 = local_11;
let _e2520 = ((_e2515 + (23i * _e2516)) + _e2519);
let _e2522 = select(_e2248, _e2520, (_e2520 < _e2248));
let _e2527 = global_3.member[bitcast<u32>(select(0i, _e2522, (_e2522 > 0i)))];
let _e2528 = (_e2255 - _e802);
let _e2529 = (_e2267 - _e803);
let _e2530 = (_e2280 - _e804);
let _e2533 = ((_e2529 * _e2319) - (_e2530 * _e2306));
let _e2536 = ((_e2530 * _e2293) - (_e2528 * _e2319));
let _e2539 = ((_e2528 * _e2306) - (_e2529 * _e2293));
let _e2544 = (((_e503 * _e2533) + (_e514 * _e2536)) + (_e525 * _e2539));
let _e2573 = bitcast<f32>((bitcast<u32>((((_e503 * (((_e2345 * _e2319) - (_e2358 * _e2306)) + ((_e2529 * _e2436) - (_e2530 * _e2423)))) + (_e514 * (((_e2358 * _e2293) - (_e2332 * _e2319)) + ((_e2530 * _e2410) - (_e2528 * _e2436))))) + (_e525 * (((_e2332 * _e2306) - (_e2345 * _e2293)) + ((_e2528 * _e2423) - (_e2529 * _e2410)))))) & 2147483647u));
let _e2602 = bitcast<f32>((bitcast<u32>((((_e503 * (((_e2384 * _e2319) - (_e2397 * _e2306)) + ((_e2529 * _e2475) - (_e2530 * _e2462)))) + (_e514 * (((_e2397 * _e2293) - (_e2371 * _e2319)) + ((_e2530 * _e2449) - (_e2528 * _e2475))))) + (_e525 * (((_e2371 * _e2306) - (_e2384 * _e2293)) + ((_e2528 * _e2462) - (_e2529 * _e2449)))))) & 2147483647u));
let _e2625 = bitcast<f32>((bitcast<u32>(((((_e602 * _e2533) + (_e613 * _e2536)) + (_e624 * _e2539)) - (((_e503 * ((_e547 * _e2319) - (_e558 * _e2306))) + (_e514 * ((_e558 * _e2293) - (_e536 * _e2319)))) + (_e525 * ((_e536 * _e2306) - (_e547 * _e2293)))))) & 2147483647u));
let _e2648 = bitcast<f32>((bitcast<u32>(((((_e635 * _e2533) + (_e646 * _e2536)) + (_e657 * _e2539)) - (((_e503 * ((_e580 * _e2319) - (_e591 * _e2306))) + (_e514 * ((_e591 * _e2293) - (_e569 * _e2319)))) + (_e525 * ((_e569 * _e2306) - (_e580 * _e2293)))))) & 2147483647u));
let _e2650 = select(_e2648, _e2625, (_e2625 > _e2648));
let _e2652 = select(1e-12f, _e2650, (_e2650 > 1e-12f));
let _e2657 = (((_e2528 * _e503) + (_e2529 * _e514)) + (_e2530 * _e525));
let _e2662 = (((_e2528 * _e2293) + (_e2529 * _e2306)) + (_e2530 * _e2319));
let _e2667 = (((_e503 * _e2293) + (_e514 * _e2306)) + (_e525 * _e2319));
let _e2670 = ((_e514 * _e2319) - (_e525 * _e2306));
let _e2673 = ((_e525 * _e2293) - (_e503 * _e2319));
let _e2676 = ((_e503 * _e2306) - (_e514 * _e2293));
let _e2681 = (((_e2670 * _e2670) + (_e2673 * _e2673)) + (_e2676 * _e2676));
let _e2684 = (1f / select(1e-9f, _e2681, (_e2681 > 1e-9f)));
let _e2687 = ((_e2657 - (_e2667 * _e2662)) * _e2684);
let _e2690 = (((_e2667 * _e2657) - _e2662) * _e2684);
if ((bitcast<f32>((bitcast<u32>(_e2544) & 2147483647u)) <= (0.5f * ((_e2573 + _e2602) + _e2652))) && ((((_e2690 >= 0f) && (_e2690 < _e2527)) && (_e2687 > _e884)) && (_e2687 < _e885))) {
let _e2706 = (_e2690 - 0f);
let _e2710 = global_1.member.member_13.member_6;
let _e2711 = (_e2710 == 0u);
if _e2711 {
phi_5541_ = _e2706;
} else {
let _e2713 = (_e2706 / f32(_e2710));
phi_4828_ = 0u;
phi_4831_ = 0f;
loop {
let _e2715 = phi_4828_;
let _e2717 = phi_4831_;
local_57 = _e2717;
let _e2720 = ((_e2715 < _e2710) && (_e2706 > 0f));
if _e2720 {
let _e2723 = (0f + (_e2713 * f32(_e2715)));
let _e2724 = (_e2723 + _e2713);
let _e2726 = (0.5f * (_e2723 + _e2724));
let _e2727 = (_e2724 - _e2723);
let _e2728 = (0.28867513f * _e2727);
let _e2729 = (_e2726 - _e2728);
let _e2739 = global_1.member.member_13.member_7;
let _e2740 = bitcast<i32>(_e2739);
let _e2744 = global_1.member.member_13.member_8;
let _e2745 = bitcast<i32>(_e2744);
let _e2749 = global_1.member.member_13.member_9;
let _e2750 = bitcast<i32>(_e2749);
let _e2751 = f32(_e2740);
let _e2753 = (_e843.member - _e836.member);
let _e2756 = (((((_e2255 + (_e2293 * _e2729)) - _e836.member) / _e2753) * _e2751) - 0.5f);
let _e2757 = (_e2751 - 1f);
let _e2759 = select(0f, _e2756, (_e2756 > 0f));
let _e2761 = select(_e2757, _e2759, (_e2759 < _e2757));
let _e2762 = f32(_e2745);
let _e2764 = (_e843.member_1 - _e836.member_1);
let _e2767 = (((((_e2267 + (_e2306 * _e2729)) - _e836.member_1) / _e2764) * _e2762) - 0.5f);
let _e2768 = (_e2762 - 1f);
let _e2770 = select(0f, _e2767, (_e2767 > 0f));
let _e2772 = select(_e2768, _e2770, (_e2770 < _e2768));
let _e2773 = f32(_e2750);
let _e2775 = (_e843.member_2 - _e836.member_2);
let _e2778 = (((((_e2280 + (_e2319 * _e2729)) - _e836.member_2) / _e2775) * _e2773) - 0.5f);
let _e2779 = (_e2773 - 1f);
let _e2781 = select(0f, _e2778, (_e2778 > 0f));
let _e2783 = select(_e2779, _e2781, (_e2781 < _e2779));
let _e2785 = select(0f, _e2761, (_e2761 > 0f));
let _e2787 = select(1e6f, _e2785, (_e2785 < 1e6f));
let _e2794 = select(0i, select(select(i32(_e2787), i32(-2147483648), (_e2787 < -2147483600f)), 2147483647i, (_e2787 > 2147483500f)), (_e2787 == _e2787));
let _e2798 = (_e2794 - select(0i, 1i, (_e2787 < f32(_e2794))));
let _e2800 = select(0f, _e2772, (_e2772 > 0f));
let _e2802 = select(1e6f, _e2800, (_e2800 < 1e6f));
let _e2809 = select(0i, select(select(i32(_e2802), i32(-2147483648), (_e2802 < -2147483600f)), 2147483647i, (_e2802 > 2147483500f)), (_e2802 == _e2802));
let _e2813 = (_e2809 - select(0i, 1i, (_e2802 < f32(_e2809))));
let _e2815 = select(0f, _e2783, (_e2783 > 0f));
let _e2817 = select(1e6f, _e2815, (_e2815 < 1e6f));
let _e2824 = select(0i, select(select(i32(_e2817), i32(-2147483648), (_e2817 < -2147483600f)), 2147483647i, (_e2817 > 2147483500f)), (_e2817 == _e2817));
let _e2828 = (_e2824 - select(0i, 1i, (_e2817 < f32(_e2824))));
let _e2832 = (_e2772 - f32(_e2813));
let _e2834 = (_e2783 - f32(_e2828));
local_8 = (_e2761 - f32(_e2798));
let _e2835 = (_e2798 + 1i);
let _e2837 = select(_e2835, 0i, (_e2835 < 0i));
if (_e2837 >= _e2740) {
phi_4966_ = (_e2740 - 1i);
} else {
phi_4966_ = _e2837;
}
let _e2841 = phi_4966_;
local_9 = (_e2841 - _e2798);
let _e2843 = (_e2813 + 1i);
let _e2845 = select(_e2843, 0i, (_e2843 < 0i));
if (_e2845 >= _e2745) {
phi_4979_ = (_e2745 - 1i);
} else {
phi_4979_ = _e2845;
}
let _e2849 = phi_4979_;
let _e2851 = ((_e2849 - _e2813) * _e2740);
let _e2852 = (_e2828 + 1i);
let _e2854 = select(_e2852, 0i, (_e2852 < 0i));
if (_e2854 >= _e2750) {
phi_4993_ = (_e2750 - 1i);
} else {
phi_4993_ = _e2854;
}
let _e2858 = phi_4993_;
let _e2865 = global_1.member.member_13.member_10;
let _e2866 = bitcast<i32>(_e2865);
let _e2871 = ((_e2866 + (((_e2828 * _e2745) + _e2813) * _e2740)) + _e2798);
let _e2873 = (bitcast<i32>(_e152) - 1i);
let _e2875 = select(_e2873, _e2871, (_e2871 < _e2873));
let _e2880 = global_5.member[bitcast<u32>(select(0i, _e2875, (_e2875 > 0i)))];
let _e2881 = local_8;
let _e2884 = local_9;
let _e2885 = (_e2871 + _e2884);
let _e2887 = select(_e2873, _e2885, (_e2885 < _e2873));
let _e2892 = global_5.member[bitcast<u32>(select(0i, _e2887, (_e2887 > 0i)))];
let _e2893 = local_8;
let _e2896 = (1f - _e2832);
let _e2898 = (_e2871 + _e2851);
let _e2900 = select(_e2873, _e2898, (_e2898 < _e2873));
let _e2905 = global_5.member[bitcast<u32>(select(0i, _e2900, (_e2900 > 0i)))];
let _e2906 = local_8;
let _e2909 = local_9;
let _e2910 = (_e2898 + _e2909);
let _e2912 = select(_e2873, _e2910, (_e2910 < _e2873));
let _e2917 = global_5.member[bitcast<u32>(select(0i, _e2912, (_e2912 > 0i)))];
let _e2918 = local_8;
let _e2923 = (_e2871 + (((_e2858 - _e2828) * _e2740) * _e2745));
let _e2925 = select(_e2873, _e2923, (_e2923 < _e2873));
let _e2930 = global_5.member[bitcast<u32>(select(0i, _e2925, (_e2925 > 0i)))];
let _e2931 = local_8;
let _e2934 = local_9;
let _e2935 = (_e2923 + _e2934);
let _e2937 = select(_e2873, _e2935, (_e2935 < _e2873));
let _e2942 = global_5.member[bitcast<u32>(select(0i, _e2937, (_e2937 > 0i)))];
let _e2943 = local_8;
let _e2947 = (_e2923 + _e2851);
let _e2949 = select(_e2873, _e2947, (_e2947 < _e2873));
let _e2954 = global_5.member[bitcast<u32>(select(0i, _e2949, (_e2949 > 0i)))];
let _e2955 = local_8;
let _e2958 = local_9;
let _e2959 = (_e2947 + _e2958);
let _e2961 = select(_e2873, _e2959, (_e2959 < _e2873));
let _e2966 = global_5.member[bitcast<u32>(select(0i, _e2961, (_e2961 > 0i)))];
let _e2967 = local_8;
let _e2976 = (_e2726 + _e2728);
let _e2986 = (((((_e2255 + (_e2293 * _e2976)) - _e836.member) / _e2753) * _e2751) - 0.5f);
let _e2988 = select(0f, _e2986, (_e2986 > 0f));
let _e2990 = select(_e2757, _e2988, (_e2988 < _e2757));
let _e2994 = (((((_e2267 + (_e2306 * _e2976)) - _e836.member_1) / _e2764) * _e2762) - 0.5f);
let _e2996 = select(0f, _e2994, (_e2994 > 0f));
let _e2998 = select(_e2768, _e2996, (_e2996 < _e2768));
let _e3002 = (((((_e2280 + (_e2319 * _e2976)) - _e836.member_2) / _e2775) * _e2773) - 0.5f);
let _e3004 = select(0f, _e3002, (_e3002 > 0f));
let _e3006 = select(_e2779, _e3004, (_e3004 < _e2779));
let _e3008 = select(0f, _e2990, (_e2990 > 0f));
let _e3010 = select(1e6f, _e3008, (_e3008 < 1e6f));
let _e3017 = select(0i, select(select(i32(_e3010), i32(-2147483648), (_e3010 < -2147483600f)), 2147483647i, (_e3010 > 2147483500f)), (_e3010 == _e3010));
let _e3021 = (_e3017 - select(0i, 1i, (_e3010 < f32(_e3017))));
let _e3023 = select(0f, _e2998, (_e2998 > 0f));
let _e3025 = select(1e6f, _e3023, (_e3023 < 1e6f));
let _e3032 = select(0i, select(select(i32(_e3025), i32(-2147483648), (_e3025 < -2147483600f)), 2147483647i, (_e3025 > 2147483500f)), (_e3025 == _e3025));
let _e3036 = (_e3032 - select(0i, 1i, (_e3025 < f32(_e3032))));
let _e3038 = select(0f, _e3006, (_e3006 > 0f));
let _e3040 = select(1e6f, _e3038, (_e3038 < 1e6f));
let _e3047 = select(0i, select(select(i32(_e3040), i32(-2147483648), (_e3040 < -2147483600f)), 2147483647i, (_e3040 > 2147483500f)), (_e3040 == _e3040));
let _e3051 = (_e3047 - select(0i, 1i, (_e3040 < f32(_e3047))));
let _e3055 = (_e2998 - f32(_e3036));
let _e3057 = (_e3006 - f32(_e3051));
local_6 = (_e2990 - f32(_e3021));
let _e3058 = (_e3021 + 1i);
let _e3060 = select(_e3058, 0i, (_e3058 < 0i));
if (_e3060 >= _e2740) {
phi_5309_ = (_e2740 - 1i);
} else {
phi_5309_ = _e3060;
}
let _e3064 = phi_5309_;
local_7 = (_e3064 - _e3021);
let _e3066 = (_e3036 + 1i);
let _e3068 = select(_e3066, 0i, (_e3066 < 0i));
if (_e3068 >= _e2745) {
phi_5322_ = (_e2745 - 1i);
} else {
phi_5322_ = _e3068;
}
let _e3072 = phi_5322_;
let _e3074 = ((_e3072 - _e3036) * _e2740);
let _e3075 = (_e3051 + 1i);
let _e3077 = select(_e3075, 0i, (_e3075 < 0i));
if (_e3077 >= _e2750) {
phi_5336_ = (_e2750 - 1i);
} else {
phi_5336_ = _e3077;
}
let _e3081 = phi_5336_;
let _e3089 = ((_e2866 + (((_e3051 * _e2745) + _e3036) * _e2740)) + _e3021);
let _e3091 = select(_e2873, _e3089, (_e3089 < _e2873));
let _e3096 = global_5.member[bitcast<u32>(select(0i, _e3091, (_e3091 > 0i)))];
let _e3097 = local_6;
let _e3100 = local_7;
let _e3101 = (_e3089 + _e3100);
let _e3103 = select(_e2873, _e3101, (_e3101 < _e2873));
let _e3108 = global_5.member[bitcast<u32>(select(0i, _e3103, (_e3103 > 0i)))];
let _e3109 = local_6;
let _e3112 = (1f - _e3055);
let _e3114 = (_e3089 + _e3074);
let _e3116 = select(_e2873, _e3114, (_e3114 < _e2873));
let _e3121 = global_5.member[bitcast<u32>(select(0i, _e3116, (_e3116 > 0i)))];
let _e3122 = local_6;
let _e3125 = local_7;
let _e3126 = (_e3114 + _e3125);
let _e3128 = select(_e2873, _e3126, (_e3126 < _e2873));
let _e3133 = global_5.member[bitcast<u32>(select(0i, _e3128, (_e3128 > 0i)))];
let _e3134 = local_6;
let _e3139 = (_e3089 + (((_e3081 - _e3051) * _e2740) * _e2745));
let _e3141 = select(_e2873, _e3139, (_e3139 < _e2873));
let _e3146 = global_5.member[bitcast<u32>(select(0i, _e3141, (_e3141 > 0i)))];
let _e3147 = local_6;
let _e3150 = local_7;
let _e3151 = (_e3139 + _e3150);
let _e3153 = select(_e2873, _e3151, (_e3151 < _e2873));
let _e3158 = global_5.member[bitcast<u32>(select(0i, _e3153, (_e3153 > 0i)))];
let _e3159 = local_6;
let _e3163 = (_e3139 + _e3074);
let _e3165 = select(_e2873, _e3163, (_e3163 < _e2873));
let _e3170 = global_5.member[bitcast<u32>(select(0i, _e3165, (_e3165 > 0i)))];
let _e3171 = local_6;
let _e3174 = local_7;
let _e3175 = (_e3163 + _e3174);
let _e3177 = select(_e2873, _e3175, (_e3175 < _e2873));
let _e3182 = global_5.member[bitcast<u32>(select(0i, _e3177, (_e3177 > 0i)))];
let _e3183 = local_6;
phi_4829_ = (_e2715 + 1u);
phi_4832_ = (_e2717 + ((0.5f * (((((((_e2880 * (1f - _e2881)) + (_e2892 * _e2893)) * _e2896) + (((_e2905 * (1f - _e2906)) + (_e2917 * _e2918)) * _e2832)) * (1f - _e2834)) + (((((_e2930 * (1f - _e2931)) + (_e2942 * _e2943)) * _e2896) + (((_e2954 * (1f - _e2955)) + (_e2966 * _e2967)) * _e2832)) * _e2834)) + ((((((_e3096 * (1f - _e3097)) + (_e3108 * _e3109)) * _e3112) + (((_e3121 * (1f - _e3122)) + (_e3133 * _e3134)) * _e3055)) * (1f - _e3057)) + (((((_e3146 * (1f - _e3147)) + (_e3158 * _e3159)) * _e3112) + (((_e3170 * (1f - _e3171)) + (_e3182 * _e3183)) * _e3055)) * _e3057)))) * _e2727));
} else {
phi_4829_ = u32();
phi_4832_ = f32();
}
let _e3198 = phi_4829_;
let _e3200 = phi_4832_;
continue;
continuing {
phi_4828_ = _e3198;
phi_4831_ = _e3200;
break if !(_e2720);
}
}
let _e4508 = local_57;
phi_5541_ = _e4508;
}
let _e3203 = phi_5541_;
let _e3204 = (_e2687 - _e884);
if _e2711 {
phi_6267_ = _e3204;
} else {
let _e3206 = (_e3204 / f32(_e2710));
phi_5554_ = 0u;
phi_5557_ = 0f;
loop {
let _e3208 = phi_5554_;
let _e3210 = phi_5557_;
local_58 = _e3210;
let _e3213 = ((_e3208 < _e2710) && (_e3204 > 0f));
if _e3213 {
let _e3216 = (_e884 + (_e3206 * f32(_e3208)));
let _e3217 = (_e3216 + _e3206);
let _e3219 = (0.5f * (_e3216 + _e3217));
let _e3220 = (_e3217 - _e3216);
let _e3221 = (0.28867513f * _e3220);
let _e3222 = (_e3219 - _e3221);
let _e3232 = global_1.member.member_13.member_7;
let _e3233 = bitcast<i32>(_e3232);
let _e3237 = global_1.member.member_13.member_8;
let _e3238 = bitcast<i32>(_e3237);
let _e3242 = global_1.member.member_13.member_9;
let _e3243 = bitcast<i32>(_e3242);
let _e3244 = f32(_e3233);
let _e3246 = (_e843.member - _e836.member);
let _e3249 = (((((_e802 + (_e503 * _e3222)) - _e836.member) / _e3246) * _e3244) - 0.5f);
let _e3250 = (_e3244 - 1f);
let _e3252 = select(0f, _e3249, (_e3249 > 0f));
let _e3254 = select(_e3250, _e3252, (_e3252 < _e3250));
let _e3255 = f32(_e3238);
let _e3257 = (_e843.member_1 - _e836.member_1);
let _e3260 = (((((_e803 + (_e514 * _e3222)) - _e836.member_1) / _e3257) * _e3255) - 0.5f);
let _e3261 = (_e3255 - 1f);
let _e3263 = select(0f, _e3260, (_e3260 > 0f));
let _e3265 = select(_e3261, _e3263, (_e3263 < _e3261));
let _e3266 = f32(_e3243);
let _e3268 = (_e843.member_2 - _e836.member_2);
let _e3271 = (((((_e804 + (_e525 * _e3222)) - _e836.member_2) / _e3268) * _e3266) - 0.5f);
let _e3272 = (_e3266 - 1f);
let _e3274 = select(0f, _e3271, (_e3271 > 0f));
let _e3276 = select(_e3272, _e3274, (_e3274 < _e3272));
let _e3278 = select(0f, _e3254, (_e3254 > 0f));
let _e3280 = select(1e6f, _e3278, (_e3278 < 1e6f));
let _e3287 = select(0i, select(select(i32(_e3280), i32(-2147483648), (_e3280 < -2147483600f)), 2147483647i, (_e3280 > 2147483500f)), (_e3280 == _e3280));
let _e3291 = (_e3287 - select(0i, 1i, (_e3280 < f32(_e3287))));
let _e3293 = select(0f, _e3265, (_e3265 > 0f));
let _e3295 = select(1e6f, _e3293, (_e3293 < 1e6f));
let _e3302 = select(0i, select(select(i32(_e3295), i32(-2147483648), (_e3295 < -2147483600f)), 2147483647i, (_e3295 > 2147483500f)), (_e3295 == _e3295));
let _e3306 = (_e3302 - select(0i, 1i, (_e3295 < f32(_e3302))));
let _e3308 = select(0f, _e3276, (_e3276 > 0f));
let _e3310 = select(1e6f, _e3308, (_e3308 < 1e6f));
let _e3317 = select(0i, select(select(i32(_e3310), i32(-2147483648), (_e3310 < -2147483600f)), 2147483647i, (_e3310 > 2147483500f)), (_e3310 == _e3310));
let _e3321 = (_e3317 - select(0i, 1i, (_e3310 < f32(_e3317))));
let _e3325 = (_e3265 - f32(_e3306));
let _e3327 = (_e3276 - f32(_e3321));
local_4 = (_e3254 - f32(_e3291));
let _e3328 = (_e3291 + 1i);
let _e3330 = select(_e3328, 0i, (_e3328 < 0i));
if (_e3330 >= _e3233) {
phi_5692_ = (_e3233 - 1i);
} else {
phi_5692_ = _e3330;
}
let _e3334 = phi_5692_;
local_5 = (_e3334 - _e3291);
let _e3336 = (_e3306 + 1i);
let _e3338 = select(_e3336, 0i, (_e3336 < 0i));
if (_e3338 >= _e3238) {
phi_5705_ = (_e3238 - 1i);
} else {
phi_5705_ = _e3338;
}
let _e3342 = phi_5705_;
let _e3344 = ((_e3342 - _e3306) * _e3233);
let _e3345 = (_e3321 + 1i);
let _e3347 = select(_e3345, 0i, (_e3345 < 0i));
if (_e3347 >= _e3243) {
phi_5719_ = (_e3243 - 1i);
} else {
phi_5719_ = _e3347;
}
let _e3351 = phi_5719_;
let _e3358 = global_1.member.member_13.member_10;
let _e3359 = bitcast<i32>(_e3358);
let _e3364 = ((_e3359 + (((_e3321 * _e3238) + _e3306) * _e3233)) + _e3291);
let _e3366 = (bitcast<i32>(_e152) - 1i);
let _e3368 = select(_e3366, _e3364, (_e3364 < _e3366));
let _e3373 = global_5.member[bitcast<u32>(select(0i, _e3368, (_e3368 > 0i)))];
let _e3374 = local_4;
let _e3377 = local_5;
let _e3378 = (_e3364 + _e3377);
let _e3380 = select(_e3366, _e3378, (_e3378 < _e3366));
let _e3385 = global_5.member[bitcast<u32>(select(0i, _e3380, (_e3380 > 0i)))];
let _e3386 = local_4;
let _e3389 = (1f - _e3325);
let _e3391 = (_e3364 + _e3344);
let _e3393 = select(_e3366, _e3391, (_e3391 < _e3366));
let _e3398 = global_5.member[bitcast<u32>(select(0i, _e3393, (_e3393 > 0i)))];
let _e3399 = local_4;
let _e3402 = local_5;
let _e3403 = (_e3391 + _e3402);
let _e3405 = select(_e3366, _e3403, (_e3403 < _e3366));
let _e3410 = global_5.member[bitcast<u32>(select(0i, _e3405, (_e3405 > 0i)))];
let _e3411 = local_4;
let _e3416 = (_e3364 + (((_e3351 - _e3321) * _e3233) * _e3238));
let _e3418 = select(_e3366, _e3416, (_e3416 < _e3366));
let _e3423 = global_5.member[bitcast<u32>(select(0i, _e3418, (_e3418 > 0i)))];
let _e3424 = local_4;
let _e3427 = local_5;
let _e3428 = (_e3416 + _e3427);
let _e3430 = select(_e3366, _e3428, (_e3428 < _e3366));
let _e3435 = global_5.member[bitcast<u32>(select(0i, _e3430, (_e3430 > 0i)))];
let _e3436 = local_4;
let _e3440 = (_e3416 + _e3344);
let _e3442 = select(_e3366, _e3440, (_e3440 < _e3366));
let _e3447 = global_5.member[bitcast<u32>(select(0i, _e3442, (_e3442 > 0i)))];
let _e3448 = local_4;
let _e3451 = local_5;
let _e3452 = (_e3440 + _e3451);
let _e3454 = select(_e3366, _e3452, (_e3452 < _e3366));
let _e3459 = global_5.member[bitcast<u32>(select(0i, _e3454, (_e3454 > 0i)))];
let _e3460 = local_4;
let _e3469 = (_e3219 + _e3221);
let _e3479 = (((((_e802 + (_e503 * _e3469)) - _e836.member) / _e3246) * _e3244) - 0.5f);
let _e3481 = select(0f, _e3479, (_e3479 > 0f));
let _e3483 = select(_e3250, _e3481, (_e3481 < _e3250));
let _e3487 = (((((_e803 + (_e514 * _e3469)) - _e836.member_1) / _e3257) * _e3255) - 0.5f);
let _e3489 = select(0f, _e3487, (_e3487 > 0f));
let _e3491 = select(_e3261, _e3489, (_e3489 < _e3261));
let _e3495 = (((((_e804 + (_e525 * _e3469)) - _e836.member_2) / _e3268) * _e3266) - 0.5f);
let _e3497 = select(0f, _e3495, (_e3495 > 0f));
let _e3499 = select(_e3272, _e3497, (_e3497 < _e3272));
let _e3501 = select(0f, _e3483, (_e3483 > 0f));
let _e3503 = select(1e6f, _e3501, (_e3501 < 1e6f));
let _e3510 = select(0i, select(select(i32(_e3503), i32(-2147483648), (_e3503 < -2147483600f)), 2147483647i, (_e3503 > 2147483500f)), (_e3503 == _e3503));
let _e3514 = (_e3510 - select(0i, 1i, (_e3503 < f32(_e3510))));
let _e3516 = select(0f, _e3491, (_e3491 > 0f));
let _e3518 = select(1e6f, _e3516, (_e3516 < 1e6f));
let _e3525 = select(0i, select(select(i32(_e3518), i32(-2147483648), (_e3518 < -2147483600f)), 2147483647i, (_e3518 > 2147483500f)), (_e3518 == _e3518));
let _e3529 = (_e3525 - select(0i, 1i, (_e3518 < f32(_e3525))));
let _e3531 = select(0f, _e3499, (_e3499 > 0f));
let _e3533 = select(1e6f, _e3531, (_e3531 < 1e6f));
let _e3540 = select(0i, select(select(i32(_e3533), i32(-2147483648), (_e3533 < -2147483600f)), 2147483647i, (_e3533 > 2147483500f)), (_e3533 == _e3533));
let _e3544 = (_e3540 - select(0i, 1i, (_e3533 < f32(_e3540))));
let _e3548 = (_e3491 - f32(_e3529));
let _e3550 = (_e3499 - f32(_e3544));
local_2 = (_e3483 - f32(_e3514));
let _e3551 = (_e3514 + 1i);
let _e3553 = select(_e3551, 0i, (_e3551 < 0i));
if (_e3553 >= _e3233) {
phi_6035_ = (_e3233 - 1i);
} else {
phi_6035_ = _e3553;
}
let _e3557 = phi_6035_;
local_3 = (_e3557 - _e3514);
let _e3559 = (_e3529 + 1i);
let _e3561 = select(_e3559, 0i, (_e3559 < 0i));
if (_e3561 >= _e3238) {
phi_6048_ = (_e3238 - 1i);
} else {
phi_6048_ = _e3561;
}
let _e3565 = phi_6048_;
let _e3567 = ((_e3565 - _e3529) * _e3233);
let _e3568 = (_e3544 + 1i);
let _e3570 = select(_e3568, 0i, (_e3568 < 0i));
if (_e3570 >= _e3243) {
phi_6062_ = (_e3243 - 1i);
} else {
phi_6062_ = _e3570;
}
let _e3574 = phi_6062_;
let _e3582 = ((_e3359 + (((_e3544 * _e3238) + _e3529) * _e3233)) + _e3514);
let _e3584 = select(_e3366, _e3582, (_e3582 < _e3366));
let _e3589 = global_5.member[bitcast<u32>(select(0i, _e3584, (_e3584 > 0i)))];
let _e3590 = local_2;
let _e3593 = local_3;
let _e3594 = (_e3582 + _e3593);
let _e3596 = select(_e3366, _e3594, (_e3594 < _e3366));
let _e3601 = global_5.member[bitcast<u32>(select(0i, _e3596, (_e3596 > 0i)))];
let _e3602 = local_2;
let _e3605 = (1f - _e3548);
let _e3607 = (_e3582 + _e3567);
let _e3609 = select(_e3366, _e3607, (_e3607 < _e3366));
let _e3614 = global_5.member[bitcast<u32>(select(0i, _e3609, (_e3609 > 0i)))];
let _e3615 = local_2;
let _e3618 = local_3;
let _e3619 = (_e3607 + _e3618);
let _e3621 = select(_e3366, _e3619, (_e3619 < _e3366));
let _e3626 = global_5.member[bitcast<u32>(select(0i, _e3621, (_e3621 > 0i)))];
let _e3627 = local_2;
let _e3632 = (_e3582 + (((_e3574 - _e3544) * _e3233) * _e3238));
let _e3634 = select(_e3366, _e3632, (_e3632 < _e3366));
let _e3639 = global_5.member[bitcast<u32>(select(0i, _e3634, (_e3634 > 0i)))];
let _e3640 = local_2;
let _e3643 = local_3;
let _e3644 = (_e3632 + _e3643);
let _e3646 = select(_e3366, _e3644, (_e3644 < _e3366));
let _e3651 = global_5.member[bitcast<u32>(select(0i, _e3646, (_e3646 > 0i)))];
let _e3652 = local_2;
let _e3656 = (_e3632 + _e3567);
let _e3658 = select(_e3366, _e3656, (_e3656 < _e3366));
let _e3663 = global_5.member[bitcast<u32>(select(0i, _e3658, (_e3658 > 0i)))];
let _e3664 = local_2;
let _e3667 = local_3;
let _e3668 = (_e3656 + _e3667);
let _e3670 = select(_e3366, _e3668, (_e3668 < _e3366));
let _e3675 = global_5.member[bitcast<u32>(select(0i, _e3670, (_e3670 > 0i)))];
let _e3676 = local_2;
phi_5555_ = (_e3208 + 1u);
phi_5558_ = (_e3210 + ((0.5f * (((((((_e3373 * (1f - _e3374)) + (_e3385 * _e3386)) * _e3389) + (((_e3398 * (1f - _e3399)) + (_e3410 * _e3411)) * _e3325)) * (1f - _e3327)) + (((((_e3423 * (1f - _e3424)) + (_e3435 * _e3436)) * _e3389) + (((_e3447 * (1f - _e3448)) + (_e3459 * _e3460)) * _e3325)) * _e3327)) + ((((((_e3589 * (1f - _e3590)) + (_e3601 * _e3602)) * _e3605) + (((_e3614 * (1f - _e3615)) + (_e3626 * _e3627)) * _e3548)) * (1f - _e3550)) + (((((_e3639 * (1f - _e3640)) + (_e3651 * _e3652)) * _e3605) + (((_e3663 * (1f - _e3664)) + (_e3675 * _e3676)) * _e3548)) * _e3550)))) * _e3220));
} else {
phi_5555_ = u32();
phi_5558_ = f32();
}
let _e3691 = phi_5555_;
let _e3693 = phi_5558_;
continue;
continuing {
phi_5554_ = _e3691;
phi_5557_ = _e3693;
break if !(_e3213);
}
}
let _e4521 = local_58;
phi_6267_ = _e4521;
}
let _e3696 = phi_6267_;
if _e2711 {
phi_6616_ = 1f;
} else {
let _e3706 = global_1.member.member_13.member_7;
let _e3707 = bitcast<i32>(_e3706);
let _e3711 = global_1.member.member_13.member_8;
let _e3712 = bitcast<i32>(_e3711);
let _e3716 = global_1.member.member_13.member_9;
let _e3717 = bitcast<i32>(_e3716);
let _e3718 = f32(_e3707);
let _e3723 = (((((_e802 + (_e503 * _e2687)) - _e836.member) / (_e843.member - _e836.member)) * _e3718) - 0.5f);
let _e3724 = (_e3718 - 1f);
let _e3726 = select(0f, _e3723, (_e3723 > 0f));
let _e3728 = select(_e3724, _e3726, (_e3726 < _e3724));
let _e3729 = f32(_e3712);
let _e3734 = (((((_e803 + (_e514 * _e2687)) - _e836.member_1) / (_e843.member_1 - _e836.member_1)) * _e3729) - 0.5f);
let _e3735 = (_e3729 - 1f);
let _e3737 = select(0f, _e3734, (_e3734 > 0f));
let _e3739 = select(_e3735, _e3737, (_e3737 < _e3735));
let _e3740 = f32(_e3717);
let _e3745 = (((((_e804 + (_e525 * _e2687)) - _e836.member_2) / (_e843.member_2 - _e836.member_2)) * _e3740) - 0.5f);
let _e3746 = (_e3740 - 1f);
let _e3748 = select(0f, _e3745, (_e3745 > 0f));
let _e3750 = select(_e3746, _e3748, (_e3748 < _e3746));
let _e3752 = select(0f, _e3728, (_e3728 > 0f));
let _e3754 = select(1e6f, _e3752, (_e3752 < 1e6f));
let _e3761 = select(0i, select(select(i32(_e3754), i32(-2147483648), (_e3754 < -2147483600f)), 2147483647i, (_e3754 > 2147483500f)), (_e3754 == _e3754));
let _e3765 = (_e3761 - select(0i, 1i, (_e3754 < f32(_e3761))));
let _e3767 = select(0f, _e3739, (_e3739 > 0f));
let _e3769 = select(1e6f, _e3767, (_e3767 < 1e6f));
let _e3776 = select(0i, select(select(i32(_e3769), i32(-2147483648), (_e3769 < -2147483600f)), 2147483647i, (_e3769 > 2147483500f)), (_e3769 == _e3769));
let _e3780 = (_e3776 - select(0i, 1i, (_e3769 < f32(_e3776))));
let _e3782 = select(0f, _e3750, (_e3750 > 0f));
let _e3784 = select(1e6f, _e3782, (_e3782 < 1e6f));
let _e3791 = select(0i, select(select(i32(_e3784), i32(-2147483648), (_e3784 < -2147483600f)), 2147483647i, (_e3784 > 2147483500f)), (_e3784 == _e3784));
let _e3795 = (_e3791 - select(0i, 1i, (_e3784 < f32(_e3791))));
let _e3799 = (_e3739 - f32(_e3780));
let _e3801 = (_e3750 - f32(_e3795));
local = (_e3728 - f32(_e3765));
let _e3802 = (_e3765 + 1i);
let _e3804 = select(_e3802, 0i, (_e3802 < 0i));
if (_e3804 >= _e3707) {
phi_6389_ = (_e3707 - 1i);
} else {
phi_6389_ = _e3804;
}
let _e3808 = phi_6389_;
local_1 = (_e3808 - _e3765);
let _e3810 = (_e3780 + 1i);
let _e3812 = select(_e3810, 0i, (_e3810 < 0i));
if (_e3812 >= _e3712) {
phi_6402_ = (_e3712 - 1i);
} else {
phi_6402_ = _e3812;
}
let _e3816 = phi_6402_;
let _e3818 = ((_e3816 - _e3780) * _e3707);
let _e3819 = (_e3795 + 1i);
let _e3821 = select(_e3819, 0i, (_e3819 < 0i));
if (_e3821 >= _e3717) {
phi_6416_ = (_e3717 - 1i);
} else {
phi_6416_ = _e3821;
}
let _e3825 = phi_6416_;
let _e3832 = global_1.member.member_13.member_10;
let _e3838 = ((bitcast<i32>(_e3832) + (((_e3795 * _e3712) + _e3780) * _e3707)) + _e3765);
let _e3840 = (bitcast<i32>(_e152) - 1i);
let _e3842 = select(_e3840, _e3838, (_e3838 < _e3840));
let _e3847 = global_5.member[bitcast<u32>(select(0i, _e3842, (_e3842 > 0i)))];
let _e3848 = local;
let _e3851 = local_1;
let _e3852 = (_e3838 + _e3851);
let _e3854 = select(_e3840, _e3852, (_e3852 < _e3840));
let _e3859 = global_5.member[bitcast<u32>(select(0i, _e3854, (_e3854 > 0i)))];
let _e3860 = local;
let _e3863 = (1f - _e3799);
let _e3865 = (_e3838 + _e3818);
let _e3867 = select(_e3840, _e3865, (_e3865 < _e3840));
let _e3872 = global_5.member[bitcast<u32>(select(0i, _e3867, (_e3867 > 0i)))];
let _e3873 = local;
let _e3876 = local_1;
let _e3877 = (_e3865 + _e3876);
let _e3879 = select(_e3840, _e3877, (_e3877 < _e3840));
let _e3884 = global_5.member[bitcast<u32>(select(0i, _e3879, (_e3879 > 0i)))];
let _e3885 = local;
let _e3890 = (_e3838 + (((_e3825 - _e3795) * _e3707) * _e3712));
let _e3892 = select(_e3840, _e3890, (_e3890 < _e3840));
let _e3897 = global_5.member[bitcast<u32>(select(0i, _e3892, (_e3892 > 0i)))];
let _e3898 = local;
let _e3901 = local_1;
let _e3902 = (_e3890 + _e3901);
let _e3904 = select(_e3840, _e3902, (_e3902 < _e3840));
let _e3909 = global_5.member[bitcast<u32>(select(0i, _e3904, (_e3904 > 0i)))];
let _e3910 = local;
let _e3914 = (_e3890 + _e3818);
let _e3916 = select(_e3840, _e3914, (_e3914 < _e3840));
let _e3921 = global_5.member[bitcast<u32>(select(0i, _e3916, (_e3916 > 0i)))];
let _e3922 = local;
let _e3925 = local_1;
let _e3926 = (_e3914 + _e3925);
let _e3928 = select(_e3840, _e3926, (_e3926 < _e3840));
let _e3933 = global_5.member[bitcast<u32>(select(0i, _e3928, (_e3928 > 0i)))];
let _e3934 = local;
phi_6616_ = ((((((_e3847 * (1f - _e3848)) + (_e3859 * _e3860)) * _e3863) + (((_e3872 * (1f - _e3873)) + (_e3884 * _e3885)) * _e3799)) * (1f - _e3801)) + (((((_e3897 * (1f - _e3898)) + (_e3909 * _e3910)) * _e3863) + (((_e3921 * (1f - _e3922)) + (_e3933 * _e3934)) * _e3799)) * _e3801));
}
let _e3944 = phi_6616_;
let _e3945 = (_e3203 + _e3696);
let _e3949 = global_1.member.member_13.member;
let _e3954 = -((_e3949.member * _e3945));
let _e3956 = select(-87f, _e3954, (_e3954 > -87f));
let _e3958 = select(88f, _e3956, (_e3956 < 88f));
let _e3960 = ((_e3958 * 1.442695f) + 0.5f);
let _e3962 = select(-127f, _e3960, (_e3960 > -127f));
let _e3964 = select(128f, _e3962, (_e3962 < 128f));
let _e3971 = select(0i, select(select(i32(_e3964), i32(-2147483648), (_e3964 < -2147483600f)), 2147483647i, (_e3964 > 2147483500f)), (_e3964 == _e3964));
let _e3975 = (_e3971 - select(0i, 1i, (_e3964 < f32(_e3971))));
let _e3976 = f32(_e3975);
let _e3980 = ((_e3958 - (_e3976 * 0.6933594f)) - (_e3976 * -2.1219444e-4f));
let _e4002 = -((_e3949.member_1 * _e3945));
let _e4004 = select(-87f, _e4002, (_e4002 > -87f));
let _e4006 = select(88f, _e4004, (_e4004 < 88f));
let _e4008 = ((_e4006 * 1.442695f) + 0.5f);
let _e4010 = select(-127f, _e4008, (_e4008 > -127f));
let _e4012 = select(128f, _e4010, (_e4010 < 128f));
let _e4019 = select(0i, select(select(i32(_e4012), i32(-2147483648), (_e4012 < -2147483600f)), 2147483647i, (_e4012 > 2147483500f)), (_e4012 == _e4012));
let _e4023 = (_e4019 - select(0i, 1i, (_e4012 < f32(_e4019))));
let _e4024 = f32(_e4023);
let _e4028 = ((_e4006 - (_e4024 * 0.6933594f)) - (_e4024 * -2.1219444e-4f));
let _e4050 = -((_e3949.member_2 * _e3945));
let _e4052 = select(-87f, _e4050, (_e4050 > -87f));
let _e4054 = select(88f, _e4052, (_e4052 < 88f));
let _e4056 = ((_e4054 * 1.442695f) + 0.5f);
let _e4058 = select(-127f, _e4056, (_e4056 > -127f));
let _e4060 = select(128f, _e4058, (_e4058 < 128f));
let _e4067 = select(0i, select(select(i32(_e4060), i32(-2147483648), (_e4060 < -2147483600f)), 2147483647i, (_e4060 > 2147483500f)), (_e4060 == _e4060));
let _e4071 = (_e4067 - select(0i, 1i, (_e4060 < f32(_e4067))));
let _e4072 = f32(_e4071);
let _e4076 = ((_e4054 - (_e4072 * 0.6933594f)) - (_e4072 * -2.1219444e-4f));
let _e4097 = -(_e2667);
let _e4101 = global_1.member.member_13.member_2;
let _e4102 = (_e4101 * _e4101);
let _e4106 = ((1f + _e4102) - ((2f * _e4101) * _e4097));
let _e4108 = select(1e-9f, _e4106, (_e4106 > 1e-9f));
let _e4121 = global_1.member.member_13.member_3;
if (_e4121 == 2u) {
let _e4126 = (0.5f - (0.5f * _e4097));
let _e4128 = select(0f, _e4126, (_e4126 > 0f));
let _e4132 = (sqrt(select(0f, _e4128, (_e4128 > 0f))) * 255f);
let _e4133 = (255f - 1f);
let _e4135 = select(0f, _e4132, (_e4132 > 0f));
let _e4137 = select(_e4133, _e4135, (_e4135 < _e4133));
let _e4144 = select(0i, select(select(i32(_e4137), i32(-2147483648), (_e4137 < -2147483600f)), 2147483647i, (_e4137 > 2147483500f)), (_e4137 == _e4137));
let _e4148 = (_e4144 - select(0i, 1i, (_e4137 < f32(_e4144))));
let _e4152 = global_1.member.member_13.member_11;
let _e4153 = bitcast<i32>(_e4152);
let _e4154 = (_e4153 + _e4148);
let _e4156 = (bitcast<i32>(_e152) - 1i);
let _e4158 = select(_e4156, _e4154, (_e4154 < _e4156));
let _e4163 = global_5.member[bitcast<u32>(select(0i, _e4158, (_e4158 > 0i)))];
let _e4165 = (_e4153 + (_e4148 + 1i));
let _e4167 = select(_e4156, _e4165, (_e4165 < _e4156));
let _e4172 = global_5.member[bitcast<u32>(select(0i, _e4167, (_e4167 > 0i)))];
phi_6959_ = (_e4163 + ((_e4172 - _e4163) * (_e4132 - f32(_e4148))));
} else {
phi_6959_ = select(((1f - _e4102) / (_e4108 * sqrt(select(0f, _e4108, (_e4108 > 0f))))), (0.75f * (1f + (_e4097 * _e4097))), (_e4121 == 1u));
}
let _e4179 = phi_6959_;
let _e4182 = (1e-4f * _e2652);
let _e4184 = select(_e2602, _e2573, (_e2573 > _e2602));
let _e4186 = select(_e4182, _e4184, (_e4184 > _e4182));
let _e4188 = select(_e2602, _e2573, (_e2573 < _e2602));
let _e4190 = select(_e4182, _e4188, (_e4188 > _e4182));
let _e4192 = (0.5f * (_e4186 + _e4190));
let _e4193 = (0.5f / _e4190);
let _e4194 = (1f / _e4186);
let _e4196 = (0.5f * _e2652);
let _e4197 = (_e2544 + _e4196);
let _e4198 = -(_e4197);
let _e4201 = (_e4192 - select(_e4198, _e4197, (_e4197 > _e4198)));
let _e4203 = select(0f, _e4201, (_e4201 > 0f));
let _e4205 = select(_e4190, _e4203, (_e4203 < _e4190));
let _e4208 = (_e4201 - _e4190);
let _e4212 = (((_e4205 * (_e4205 * _e4193)) + select(0f, _e4208, (_e4208 > 0f))) * _e4194);
let _e4216 = (_e2544 - _e4196);
let _e4217 = -(_e4216);
let _e4220 = (_e4192 - select(_e4217, _e4216, (_e4216 > _e4217)));
let _e4222 = select(0f, _e4220, (_e4220 > 0f));
let _e4224 = select(_e4190, _e4222, (_e4222 < _e4190));
let _e4227 = (_e4220 - _e4190);
let _e4231 = (((_e4224 * (_e4224 * _e4193)) + select(0f, _e4227, (_e4227 > 0f))) * _e4194);
let _e4238 = (((_e4179 * (0.25f / 3.1415927f)) * ((select(_e4212, (1f - _e4212), (_e4197 >= 0f)) - select(_e4231, (1f - _e4231), (_e4216 >= 0f))) * (1f / _e2652))) * _e3944);
let _e4245 = global_1.member.member_13.member_1;
phi_7078_ = vec3<f32>((((_e2488 * ((1f + (_e3980 * (1f + (_e3980 * (0.5f + (_e3980 * (0.16666667f + (_e3980 * (0.041666668f + (_e3980 * (0.008333334f + (_e3980 * (0.001388889f + (_e3980 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3975 + 127i)) << bitcast<u32>(23i))))) * _e4245.member) * _e4238), (((_e2501 * ((1f + (_e4028 * (1f + (_e4028 * (0.5f + (_e4028 * (0.16666667f + (_e4028 * (0.041666668f + (_e4028 * (0.008333334f + (_e4028 * (0.001388889f + (_e4028 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4023 + 127i)) << bitcast<u32>(23i))))) * _e4245.member_1) * _e4238), (((_e2514 * ((1f + (_e4076 * (1f + (_e4076 * (0.5f + (_e4076 * (0.16666667f + (_e4076 * (0.041666668f + (_e4076 * (0.008333334f + (_e4076 * (0.001388889f + (_e4076 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4071 + 127i)) << bitcast<u32>(23i))))) * _e4245.member_2) * _e4238));
} else {
phi_7078_ = vec3<f32>(0f, 0f, 0f);
}
let _e4257 = phi_7078_;
let _e4258 = select(1f, 0f, _e1157);
let _e4272 = select(0f, 1f, _e1157);
phi_7117_ = vec3<f32>((_e2175.x + (_e4257.x * _e4272)), (_e2175.y + (_e4257.y * _e4272)), (_e2175.z + (_e4257.z * _e4272)));
phi_7118_ = vec3<f32>((_e2177.x + (_e4257.x * _e4258)), (_e2177.y + (_e4257.y * _e4258)), (_e2177.z + (_e4257.z * _e4258)));
}
let _e4284 = phi_7117_;
let _e4286 = phi_7118_;
phi_3902_ = _e4284;
phi_3905_ = _e4286;
phi_3907_ = (_e2179 + 1u);
}
let _e4289 = phi_3902_;
let _e4291 = phi_3905_;
let _e4293 = phi_3907_;
continue;
continuing {
phi_3901_ = _e4289;
phi_3904_ = _e4291;
phi_3906_ = _e4293;
break if !(select(true, false, _e2183));
}
}
let _e4296 = local_34.member_1;
phi_7128_ = type_13(_e1166.member, (_e1166.member_1 + 1u));
loop {
let _e4300 = phi_7128_;
local_61 = _e4300;
let _e4306 = (((_e4300.member_1 & 3u) == 0u) && (_e4300.member < _e4296));
if _e4306 {
phi_7129_ = type_13((_e4300.member + 1u), (_e4300.member_1 >> bitcast<u32>(2i)));
} else {
phi_7129_ = type_13();
}
let _e4312 = phi_7129_;
continue;
continuing {
phi_7128_ = _e4312;
break if !(_e4306);
}
}
let _e4537 = local_59;
phi_7150_ = _e4537;
let _e4540 = local_60;
phi_7151_ = _e4540;
let _e4543 = local_61;
phi_7152_ = _e4543;
}
let _e4319 = phi_7150_;
let _e4321 = phi_7151_;
let _e4323 = phi_7152_;
phi_2208_ = _e4319;
phi_2211_ = _e4321;
phi_2213_ = _e4323;
} else {
phi_2208_ = vec3<f32>();
phi_2211_ = vec3<f32>();
phi_2213_ = type_13();
}
let _e4325 = phi_2208_;
let _e4327 = phi_2211_;
let _e4329 = phi_2213_;
continue;
continuing {
phi_2207_ = _e4325;
phi_2210_ = _e4327;
phi_2212_ = _e4329;
break if !(_e1174);
}
}
let _e4549 = local_62;
phi_2008_ = _e4549;
let _e4552 = local_63;
phi_2011_ = _e4552;
phi_2013_ = (_e995 + 1u);
} else {
phi_2008_ = vec3<f32>();
phi_2011_ = vec3<f32>();
phi_2013_ = u32();
}
let _e4333 = phi_2008_;
let _e4335 = phi_2011_;
let _e4337 = phi_2013_;
continue;
continuing {
phi_2007_ = _e4333;
phi_2010_ = _e4335;
phi_2012_ = _e4337;
break if !(_e1000);
}
}
let _e4340 = local_50;
let _e4344 = local_51;
let _e4348 = local_52;
let _e4355 = local_53;
let _e4359 = local_54;
let _e4363 = local_55;
phi_7206_ = array<f32, 22>(_e177, _e187, _e198, _e209, _e220, _e231, _e242, _e253, _e264, (_e275 + (_e4340.x * _e806)), (_e286 + (_e4344.y * _e807)), (_e297 + (_e4348.z * _e808)), (_e308 + (_e4355.x * _e806)), (_e319 + (_e4359.y * _e807)), (_e330 + (_e4363.z * _e808)), _e341, _e352, _e363, _e374, _e385, _e396, _e407);
}
let _e4371 = phi_7206_;
global_6.member[_e166] = _e4371[0];
global_6.member[_e178] = _e4371[1];
global_6.member[_e189] = _e4371[2];
global_6.member[_e200] = _e4371[3];
global_6.member[_e211] = _e4371[4];
global_6.member[_e222] = _e4371[5];
global_6.member[_e233] = _e4371[6];
global_6.member[_e244] = _e4371[7];
global_6.member[_e255] = _e4371[8];
global_6.member[_e266] = _e4371[9];
global_6.member[_e277] = _e4371[10];
global_6.member[_e288] = _e4371[11];
global_6.member[_e299] = _e4371[12];
global_6.member[_e310] = _e4371[13];
global_6.member[_e321] = _e4371[14];
global_6.member[_e332] = _e4371[15];
global_6.member[_e343] = _e4371[16];
global_6.member[_e354] = _e4371[17];
global_6.member[_e365] = _e4371[18];
global_6.member[_e376] = _e4371[19];
global_6.member[_e387] = _e4371[20];
global_6.member[_e398] = _e4371[21];
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
