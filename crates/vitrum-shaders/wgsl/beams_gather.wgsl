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
struct type_17 {
member: u32,
member_1: u32,
}
struct type_18 {
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
struct type_19 {
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
struct type_20 {
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
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_23 {
member: type_2,
member_1: type_17,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_21,
member_19: type_22,
}
struct type_24 {
member: type_23,
}
struct type_25 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_24;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_13;
@group(0) @binding(3)
var<storage> global_4: type_13;
@group(0) @binding(4)
var<storage> global_5: type_13;
@group(0) @binding(5)
var<storage, read_write> global_6: type_13;
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
var local_23: type_17;
var local_24: u32;
var local_25: u32;
var local_26: u32;
var local_27: u32;
var local_28: u32;
var local_29: u32;
var local_30: u32;
var local_31: u32;
var local_32: type_17;
var local_33: u32;
var local_34: type_25;
var local_35: i32;
var local_36: i32;
var phi_1958_: vec3<f32>;
var phi_1961_: vec3<f32>;
var phi_1963_: u32;
var phi_1983_: u32;
var phi_1984_: u32;
var phi_1996_: u32;
var phi_1997_: u32;
var local_37: u32;
var local_38: u32;
var phi_2014_: u32;
var phi_2015_: u32;
var phi_2027_: u32;
var phi_2028_: u32;
var local_39: u32;
var local_40: u32;
var local_41: u32;
var phi_2053_: u32;
var phi_2054_: u32;
var local_42: u32;
var local_43: u32;
var phi_2071_: u32;
var phi_2072_: u32;
var local_44: u32;
var local_45: u32;
var phi_2094_: u32;
var phi_2095_: u32;
var phi_2107_: u32;
var phi_2108_: u32;
var local_46: u32;
var local_47: u32;
var local_48: u32;
var phi_2144_: u32;
var local_49: u32;
var phi_2158_: vec3<f32>;
var phi_2161_: vec3<f32>;
var phi_2163_: type_17;
var phi_3017_: bool;
var phi_3027_: u32;
var phi_3051_: u32;
var phi_3072_: u32;
var phi_3075_: u32;
var phi_3112_: u32;
var phi_3183_: u32;
var phi_3254_: u32;
var phi_3325_: u32;
var phi_3396_: u32;
var phi_3467_: u32;
var phi_3527_: u32;
var phi_3073_: u32;
var phi_3076_: u32;
var phi_3804_: u32;
var phi_3806_: vec3<f32>;
var phi_3809_: vec3<f32>;
var phi_3811_: u32;
var phi_3840_: u32;
var phi_3886_: i32;
var phi_4733_: u32;
var phi_4736_: f32;
var phi_4871_: i32;
var phi_4884_: i32;
var phi_4898_: i32;
var phi_5214_: i32;
var phi_5227_: i32;
var phi_5241_: i32;
var phi_4734_: u32;
var phi_4737_: f32;
var phi_5446_: f32;
var phi_5459_: u32;
var phi_5462_: f32;
var phi_5597_: i32;
var phi_5610_: i32;
var phi_5624_: i32;
var phi_5940_: i32;
var phi_5953_: i32;
var phi_5967_: i32;
var phi_5460_: u32;
var phi_5463_: f32;
var phi_6172_: f32;
var phi_6294_: i32;
var phi_6307_: i32;
var phi_6321_: i32;
var phi_6521_: f32;
var phi_6864_: f32;
var phi_6983_: vec3<f32>;
var phi_7022_: vec3<f32>;
var phi_7023_: vec3<f32>;
var phi_3807_: vec3<f32>;
var phi_3810_: vec3<f32>;
var phi_3812_: u32;
var phi_7033_: type_17;
var phi_7034_: type_17;
var phi_7055_: vec3<f32>;
var phi_7056_: vec3<f32>;
var phi_7057_: type_17;
var phi_2159_: vec3<f32>;
var phi_2162_: vec3<f32>;
var phi_2164_: type_17;
var phi_1959_: vec3<f32>;
var phi_1962_: vec3<f32>;
var phi_1964_: u32;
var local_50: vec3<f32>;
var local_51: vec3<f32>;
var local_52: vec3<f32>;
var local_53: vec3<f32>;
var local_54: vec3<f32>;
var local_55: vec3<f32>;
var phi_7111_: array<f32, 22>;
var local_56: u32;
var local_57: f32;
var local_58: f32;
var local_59: vec3<f32>;
var local_60: vec3<f32>;
var local_61: type_17;
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
phi_7111_ = array<f32, 22>(_e177, _e187, _e198, _e209, _e220, _e231, _e242, _e253, _e264, _e275, _e286, _e297, _e308, _e319, _e330, _e341, _e352, _e363, _e374, _e385, _e396, _e407);
} else {
let _e898 = (((_e536 * _e536) + (_e547 * _e547)) + (_e558 * _e558));
let _e906 = (((_e569 * _e569) + (_e580 * _e580)) + (_e591 * _e591));
let _e911 = (0.5f * (sqrt(select(0f, _e898, (_e898 > 0f))) + sqrt(select(0f, _e906, (_e906 > 0f)))));
let _e916 = (((_e602 * _e602) + (_e613 * _e613)) + (_e624 * _e624));
let _e924 = (((_e635 * _e635) + (_e646 * _e646)) + (_e657 * _e657));
let _e929 = (0.5f * (sqrt(select(0f, _e916, (_e916 > 0f))) + sqrt(select(0f, _e924, (_e924 > 0f)))));
let _e933 = global_1.member.member_11.member;
phi_1958_ = vec3<f32>(0f, 0f, 0f);
phi_1961_ = vec3<f32>(0f, 0f, 0f);
phi_1963_ = 0u;
loop {
let _e937 = phi_1958_;
let _e939 = phi_1961_;
let _e941 = phi_1963_;
local_50 = _e939;
local_51 = _e939;
local_52 = _e939;
local_53 = _e937;
local_54 = _e937;
local_55 = _e937;
let _e945 = global_1.member.member_12.member_9;
let _e946 = (_e941 <= _e945);
if _e946 {
let _e950 = global_1.member.member_12.member_6;
phi_1983_ = 0u;
loop {
let _e954 = phi_1983_;
local_49 = _e954;
let _e958 = ((1u << bitcast<u32>((_e954 & 31u))) < _e933);
if _e958 {
phi_1984_ = (_e954 + 1u);
} else {
phi_1984_ = u32();
}
let _e961 = phi_1984_;
continue;
continuing {
phi_1983_ = _e961;
break if !(_e958);
}
}
phi_1996_ = 0u;
loop {
let _e964 = phi_1996_;
local_37 = _e964;
local_38 = _e964;
let _e968 = ((1u << bitcast<u32>((_e964 & 31u))) < _e933);
if _e968 {
phi_1997_ = (_e964 + 1u);
} else {
phi_1997_ = u32();
}
let _e971 = phi_1997_;
continue;
continuing {
phi_1996_ = _e971;
break if !(_e968);
}
}
let _e974 = local_37;
let _e977 = local_38;
phi_2014_ = 0u;
loop {
let _e980 = phi_2014_;
local_41 = _e980;
let _e984 = ((1u << bitcast<u32>((_e980 & 31u))) < _e933);
if _e984 {
phi_2015_ = (_e980 + 1u);
} else {
phi_2015_ = u32();
}
let _e987 = phi_2015_;
continue;
continuing {
phi_2014_ = _e987;
break if !(_e984);
}
}
phi_2027_ = 0u;
loop {
let _e990 = phi_2027_;
local_39 = _e990;
local_40 = _e990;
let _e994 = ((1u << bitcast<u32>((_e990 & 31u))) < _e933);
if _e994 {
phi_2028_ = (_e990 + 1u);
} else {
phi_2028_ = u32();
}
let _e997 = phi_2028_;
continue;
continuing {
phi_2027_ = _e997;
break if !(_e994);
}
}
let _e1000 = local_39;
let _e1003 = local_40;
let _e1006 = local_41;
let _e1015 = global_1.member.member_12.member_8;
phi_2053_ = 0u;
loop {
let _e1018 = phi_2053_;
local_42 = _e1018;
local_43 = _e1018;
let _e1022 = ((1u << bitcast<u32>((_e1018 & 31u))) < _e933);
if _e1022 {
phi_2054_ = (_e1018 + 1u);
} else {
phi_2054_ = u32();
}
let _e1025 = phi_2054_;
continue;
continuing {
phi_2053_ = _e1025;
break if !(_e1022);
}
}
let _e1028 = local_42;
let _e1031 = local_43;
phi_2071_ = 0u;
loop {
let _e1034 = phi_2071_;
local_44 = _e1034;
local_45 = _e1034;
let _e1038 = ((1u << bitcast<u32>((_e1034 & 31u))) < _e933);
if _e1038 {
phi_2072_ = (_e1034 + 1u);
} else {
phi_2072_ = u32();
}
let _e1041 = phi_2072_;
continue;
continuing {
phi_2071_ = _e1041;
break if !(_e1038);
}
}
let _e1044 = local_44;
let _e1050 = local_45;
phi_2094_ = 0u;
loop {
let _e1060 = phi_2094_;
local_48 = _e1060;
let _e1064 = ((1u << bitcast<u32>((_e1060 & 31u))) < _e933);
if _e1064 {
phi_2095_ = (_e1060 + 1u);
} else {
phi_2095_ = u32();
}
let _e1067 = phi_2095_;
continue;
continuing {
phi_2094_ = _e1067;
break if !(_e1064);
}
}
phi_2107_ = 0u;
loop {
let _e1070 = phi_2107_;
local_46 = _e1070;
local_47 = _e1070;
let _e1074 = ((1u << bitcast<u32>((_e1070 & 31u))) < _e933);
if _e1074 {
phi_2108_ = (_e1070 + 1u);
} else {
phi_2108_ = u32();
}
let _e1077 = phi_2108_;
continue;
continuing {
phi_2107_ = _e1077;
break if !(_e1074);
}
}
let _e1080 = local_46;
let _e1083 = local_47;
let _e1086 = local_48;
let _e1092 = (((((1u << bitcast<u32>(((2u * _e1044) & 31u))) - (1u << bitcast<u32>(((2u * (_e1050 - select(6u, _e1031, (_e1028 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1086 - select(6u, _e1083, (_e1080 < 6u)))) & 31u))));
let _e1093 = (_e1092 / 64u);
if ((_e1092 % 64u) > 0u) {
phi_2144_ = (_e1093 + 1u);
} else {
phi_2144_ = _e1093;
}
let _e1098 = phi_2144_;
let _e1101 = local_49;
local_34 = type_25(_e1101, select(6u, _e977, (_e974 < 6u)), (1u << bitcast<u32>(((2u * (_e1006 - select(6u, _e1003, (_e1000 < 6u)))) & 31u))), (_e941 * _e1015), (_e1098 * 64u));
let _e1103 = (_e941 == 0u);
let _e1105 = local_34.member_1;
phi_2158_ = _e937;
phi_2161_ = _e939;
phi_2163_ = type_17(_e1105, 0u);
loop {
let _e1108 = phi_2158_;
let _e1110 = phi_2161_;
let _e1112 = phi_2163_;
local_62 = _e1108;
local_63 = _e1110;
let _e1115 = local_34.member_1;
let _e1118 = local_34.member_2;
let _e1120 = ((_e1112.member < _e1115) || (_e1112.member_1 < _e1118));
if _e1120 {
local_32.member = _e1112.member;
local_32.member_1 = _e1112.member_1;
let _e1123 = local_32.member;
let _e1124 = local_32.member_1;
let _e1126 = local_34.member;
let _e1141 = local_34.member_3;
local_33 = (_e1141 + (((((1u << bitcast<u32>(((2u * _e1126) & 31u))) - (1u << bitcast<u32>(((2u * (_e1126 - _e1123)) & 31u)))) / 3u) * 4u) + _e1124));
let _e1143 = local_33;
let _e1144 = bitcast<i32>(_e1143);
let _e1146 = (bitcast<i32>(_e149) - 1i);
let _e1148 = select(_e1146, _e1144, (_e1144 < _e1146));
let _e1153 = global_4.member[bitcast<u32>(select(0i, _e1148, (_e1148 > 0i)))];
let _e1154 = local_33;
let _e1156 = local_34.member_4;
let _e1158 = bitcast<i32>((_e1154 + _e1156));
let _e1160 = select(_e1146, _e1158, (_e1158 < _e1146));
let _e1165 = global_4.member[bitcast<u32>(select(0i, _e1160, (_e1160 > 0i)))];
let _e1166 = local_33;
let _e1167 = local_34.member_4;
let _e1170 = bitcast<i32>((_e1166 + (2u * _e1167)));
let _e1172 = select(_e1146, _e1170, (_e1170 < _e1146));
let _e1177 = global_4.member[bitcast<u32>(select(0i, _e1172, (_e1172 > 0i)))];
let _e1178 = local_32.member;
let _e1179 = local_32.member_1;
let _e1180 = local_34.member;
let _e1194 = local_34.member_3;
let _e1195 = local_34.member_4;
local_31 = ((_e1194 + (3u * _e1195)) + (((((1u << bitcast<u32>(((2u * _e1180) & 31u))) - (1u << bitcast<u32>(((2u * (_e1180 - _e1178)) & 31u)))) / 3u) * 4u) + _e1179));
let _e1199 = local_31;
let _e1200 = bitcast<i32>(_e1199);
let _e1202 = select(_e1146, _e1200, (_e1200 < _e1146));
let _e1207 = global_4.member[bitcast<u32>(select(0i, _e1202, (_e1202 > 0i)))];
let _e1208 = local_31;
let _e1209 = local_34.member_4;
let _e1211 = bitcast<i32>((_e1208 + _e1209));
let _e1213 = select(_e1146, _e1211, (_e1211 < _e1146));
let _e1218 = global_4.member[bitcast<u32>(select(0i, _e1213, (_e1213 > 0i)))];
let _e1219 = local_31;
let _e1220 = local_34.member_4;
let _e1223 = bitcast<i32>((_e1219 + (2u * _e1220)));
let _e1225 = select(_e1146, _e1223, (_e1223 < _e1146));
let _e1230 = global_4.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1231 = local_32.member;
let _e1232 = local_32.member_1;
let _e1233 = local_34.member;
let _e1247 = local_34.member_3;
let _e1248 = local_34.member_4;
local_30 = ((_e1247 + (6u * _e1248)) + (((((1u << bitcast<u32>(((2u * _e1233) & 31u))) - (1u << bitcast<u32>(((2u * (_e1233 - _e1231)) & 31u)))) / 3u) * 4u) + _e1232));
let _e1252 = local_30;
let _e1253 = bitcast<i32>(_e1252);
let _e1255 = select(_e1146, _e1253, (_e1253 < _e1146));
let _e1260 = global_4.member[bitcast<u32>(select(0i, _e1255, (_e1255 > 0i)))];
let _e1261 = local_30;
let _e1262 = local_34.member_4;
let _e1264 = bitcast<i32>((_e1261 + _e1262));
let _e1266 = select(_e1146, _e1264, (_e1264 < _e1146));
let _e1271 = global_4.member[bitcast<u32>(select(0i, _e1266, (_e1266 > 0i)))];
let _e1272 = local_30;
let _e1273 = local_34.member_4;
let _e1276 = bitcast<i32>((_e1272 + (2u * _e1273)));
let _e1278 = select(_e1146, _e1276, (_e1276 < _e1146));
let _e1283 = global_4.member[bitcast<u32>(select(0i, _e1278, (_e1278 > 0i)))];
let _e1284 = local_32.member;
let _e1285 = local_32.member_1;
let _e1286 = local_34.member;
let _e1300 = local_34.member_3;
let _e1301 = local_34.member_4;
local_29 = ((_e1300 + (9u * _e1301)) + (((((1u << bitcast<u32>(((2u * _e1286) & 31u))) - (1u << bitcast<u32>(((2u * (_e1286 - _e1284)) & 31u)))) / 3u) * 4u) + _e1285));
let _e1305 = local_29;
let _e1306 = bitcast<i32>(_e1305);
let _e1308 = select(_e1146, _e1306, (_e1306 < _e1146));
let _e1313 = global_4.member[bitcast<u32>(select(0i, _e1308, (_e1308 > 0i)))];
let _e1314 = local_29;
let _e1315 = local_34.member_4;
let _e1317 = bitcast<i32>((_e1314 + _e1315));
let _e1319 = select(_e1146, _e1317, (_e1317 < _e1146));
let _e1324 = global_4.member[bitcast<u32>(select(0i, _e1319, (_e1319 > 0i)))];
let _e1325 = local_29;
let _e1326 = local_34.member_4;
let _e1329 = bitcast<i32>((_e1325 + (2u * _e1326)));
let _e1331 = select(_e1146, _e1329, (_e1329 < _e1146));
let _e1336 = global_4.member[bitcast<u32>(select(0i, _e1331, (_e1331 > 0i)))];
let _e1337 = local_32.member;
let _e1338 = local_32.member_1;
let _e1339 = local_34.member;
let _e1353 = local_34.member_3;
let _e1354 = local_34.member_4;
local_28 = ((_e1353 + (12u * _e1354)) + (((((1u << bitcast<u32>(((2u * _e1339) & 31u))) - (1u << bitcast<u32>(((2u * (_e1339 - _e1337)) & 31u)))) / 3u) * 4u) + _e1338));
let _e1358 = local_28;
let _e1359 = bitcast<i32>(_e1358);
let _e1361 = select(_e1146, _e1359, (_e1359 < _e1146));
let _e1366 = global_4.member[bitcast<u32>(select(0i, _e1361, (_e1361 > 0i)))];
let _e1367 = local_28;
let _e1368 = local_34.member_4;
let _e1370 = bitcast<i32>((_e1367 + _e1368));
let _e1372 = select(_e1146, _e1370, (_e1370 < _e1146));
let _e1377 = global_4.member[bitcast<u32>(select(0i, _e1372, (_e1372 > 0i)))];
let _e1378 = local_28;
let _e1379 = local_34.member_4;
let _e1382 = bitcast<i32>((_e1378 + (2u * _e1379)));
let _e1384 = select(_e1146, _e1382, (_e1382 < _e1146));
let _e1389 = global_4.member[bitcast<u32>(select(0i, _e1384, (_e1384 > 0i)))];
let _e1390 = local_32.member;
let _e1391 = local_32.member_1;
let _e1392 = local_34.member;
let _e1406 = local_34.member_3;
let _e1407 = local_34.member_4;
local_27 = ((_e1406 + (15u * _e1407)) + (((((1u << bitcast<u32>(((2u * _e1392) & 31u))) - (1u << bitcast<u32>(((2u * (_e1392 - _e1390)) & 31u)))) / 3u) * 4u) + _e1391));
let _e1411 = local_27;
let _e1412 = bitcast<i32>(_e1411);
let _e1414 = select(_e1146, _e1412, (_e1412 < _e1146));
let _e1419 = global_4.member[bitcast<u32>(select(0i, _e1414, (_e1414 > 0i)))];
let _e1420 = local_27;
let _e1421 = local_34.member_4;
let _e1423 = bitcast<i32>((_e1420 + _e1421));
let _e1425 = select(_e1146, _e1423, (_e1423 < _e1146));
let _e1430 = global_4.member[bitcast<u32>(select(0i, _e1425, (_e1425 > 0i)))];
let _e1431 = local_27;
let _e1432 = local_34.member_4;
let _e1435 = bitcast<i32>((_e1431 + (2u * _e1432)));
let _e1437 = select(_e1146, _e1435, (_e1435 < _e1146));
let _e1442 = global_4.member[bitcast<u32>(select(0i, _e1437, (_e1437 > 0i)))];
let _e1446 = ((_e1207 - _e1153) * 0.5f);
let _e1447 = ((_e1218 - _e1165) * 0.5f);
let _e1448 = ((_e1230 - _e1177) * 0.5f);
let _e1452 = ((_e1153 + _e1446) - _e802);
let _e1453 = ((_e1165 + _e1447) - _e803);
let _e1454 = ((_e1177 + _e1448) - _e804);
let _e1459 = (((_e1452 * _e1452) + (_e1453 * _e1453)) + (_e1454 * _e1454));
let _e1467 = (((_e1446 * _e1446) + (_e1447 * _e1447)) + (_e1448 * _e1448));
let _e1473 = (_e911 + (_e929 * (sqrt(select(0f, _e1459, (_e1459 > 0f))) + sqrt(select(0f, _e1467, (_e1467 > 0f))))));
let _e1481 = (((_e1153 - _e1473) - _e802) * _e816);
let _e1483 = (((_e1207 + _e1473) - _e802) * _e816);
let _e1485 = (((_e1165 - _e1473) - _e803) * _e824);
let _e1487 = (((_e1218 + _e1473) - _e803) * _e824);
let _e1489 = (((_e1177 - _e1473) - _e804) * _e832);
let _e1491 = (((_e1230 + _e1473) - _e804) * _e832);
let _e1493 = select(_e1483, _e1481, (_e1481 < _e1483));
let _e1495 = select(_e1487, _e1485, (_e1485 < _e1487));
let _e1497 = select(_e1495, _e1493, (_e1493 > _e1495));
let _e1499 = select(_e1491, _e1489, (_e1489 < _e1491));
let _e1501 = select(_e1499, _e1497, (_e1497 > _e1499));
let _e1503 = select(_e1483, _e1481, (_e1481 > _e1483));
let _e1505 = select(_e1487, _e1485, (_e1485 > _e1487));
let _e1507 = select(_e1505, _e1503, (_e1503 < _e1505));
let _e1509 = select(_e1491, _e1489, (_e1489 > _e1491));
let _e1511 = select(_e1509, _e1507, (_e1507 < _e1509));
if ((_e1153 <= _e1207) && (select(_e884, _e1501, (_e1501 > _e884)) <= select(_e885, _e1511, (_e1511 < _e885)))) {
let _e1519 = (_e1260 - _e802);
let _e1520 = (_e1271 - _e803);
let _e1521 = (_e1283 - _e804);
let _e1524 = ((_e1377 * _e525) - (_e1389 * _e514));
let _e1527 = ((_e1389 * _e503) - (_e1366 * _e525));
let _e1530 = ((_e1366 * _e514) - (_e1377 * _e503));
let _e1578 = (((_e1313 * _e1313) + (_e1324 * _e1324)) + (_e1336 * _e1336));
let _e1581 = sqrt(select(0f, _e1578, (_e1578 > 0f)));
let _e1586 = (((_e1419 * _e1419) + (_e1430 * _e1430)) + (_e1442 * _e1442));
let _e1596 = (((_e1519 * _e1519) + (_e1520 * _e1520)) + (_e1521 * _e1521));
phi_3017_ = (bitcast<f32>((bitcast<u32>((((_e1519 * _e1524) + (_e1520 * _e1527)) + (_e1521 * _e1530))) & 2147483647u)) <= ((((((bitcast<f32>((bitcast<u32>(_e1524) & 2147483647u)) * _e1313) + (bitcast<f32>((bitcast<u32>(_e1527) & 2147483647u)) * _e1324)) + (bitcast<f32>((bitcast<u32>(_e1530) & 2147483647u)) * _e1336)) + (((bitcast<f32>((bitcast<u32>(((_e514 * _e1521) - (_e525 * _e1520))) & 2147483647u)) * _e1419) + (bitcast<f32>((bitcast<u32>(((_e525 * _e1519) - (_e503 * _e1521))) & 2147483647u)) * _e1430)) + (bitcast<f32>((bitcast<u32>(((_e503 * _e1520) - (_e514 * _e1519))) & 2147483647u)) * _e1442))) + (_e1581 * sqrt(select(0f, _e1586, (_e1586 > 0f))))) + (_e911 + (_e929 * (sqrt(select(0f, _e1596, (_e1596 > 0f))) + _e1581)))));
} else {
phi_3017_ = false;
}
let _e1609 = phi_3017_;
let _e1610 = local_34.member_1;
if (_e1610 < 2u) {
let _e1612 = local_34.member_1;
phi_3027_ = _e1612;
} else {
phi_3027_ = 2u;
}
let _e1614 = phi_3027_;
if (_e1609 && (_e1112.member > _e1614)) {
phi_7055_ = _e1108;
phi_7056_ = _e1110;
phi_7057_ = type_17((_e1112.member - 1u), (_e1112.member_1 << bitcast<u32>(2i)));
} else {
if _e1609 {
let _e1617 = local_34.member_1;
if (_e1617 < 2u) {
let _e1619 = local_34.member_1;
phi_3051_ = _e1619;
} else {
phi_3051_ = 2u;
}
let _e1621 = phi_3051_;
let _e1627 = local_34.member_3;
let _e1628 = local_34.member_4;
let _e1631 = local_34.member_4;
phi_3072_ = 0u;
phi_3075_ = 0u;
loop {
let _e1637 = phi_3072_;
let _e1639 = phi_3075_;
local_56 = _e1639;
let _e1640 = (_e1637 < select(0u, 16u, ((((_e1112.member_1 << bitcast<u32>(((2u * _e1621) & 31u))) + 16u) <= _e1631) && ((_e1627 + (24u * _e1628)) <= _e149))));
if _e1640 {
local_23.member = _e1112.member;
local_23.member_1 = _e1112.member_1;
local_24 = _e1637;
let _e1643 = local_23.member_1;
let _e1644 = local_24;
local_25 = _e1644;
let _e1645 = local_34.member_3;
let _e1646 = local_34.member_1;
if (_e1646 < 2u) {
let _e1648 = local_34.member_1;
phi_3112_ = _e1648;
} else {
phi_3112_ = 2u;
}
let _e1650 = phi_3112_;
local_26 = (_e1645 + (_e1643 << bitcast<u32>(((2u * _e1650) & 31u))));
let _e1656 = local_26;
let _e1658 = local_25;
let _e1663 = global_4.member[bitcast<u32>((bitcast<i32>(_e1656) + bitcast<i32>(_e1658)))];
let _e1664 = local_26;
let _e1665 = local_34.member_4;
let _e1668 = local_25;
let _e1673 = global_4.member[bitcast<u32>((bitcast<i32>((_e1664 + _e1665)) + bitcast<i32>(_e1668)))];
let _e1674 = local_26;
let _e1675 = local_34.member_4;
let _e1679 = local_25;
let _e1684 = global_4.member[bitcast<u32>((bitcast<i32>((_e1674 + (2u * _e1675))) + bitcast<i32>(_e1679)))];
let _e1685 = local_23.member_1;
let _e1686 = local_24;
local_21 = _e1686;
let _e1687 = local_34.member_3;
let _e1688 = local_34.member_4;
let _e1691 = local_34.member_1;
if (_e1691 < 2u) {
let _e1693 = local_34.member_1;
phi_3183_ = _e1693;
} else {
phi_3183_ = 2u;
}
let _e1695 = phi_3183_;
local_22 = ((_e1687 + (3u * _e1688)) + (_e1685 << bitcast<u32>(((2u * _e1695) & 31u))));
let _e1701 = local_22;
let _e1703 = local_21;
let _e1708 = global_4.member[bitcast<u32>((bitcast<i32>(_e1701) + bitcast<i32>(_e1703)))];
let _e1709 = local_22;
let _e1710 = local_34.member_4;
let _e1713 = local_21;
let _e1718 = global_4.member[bitcast<u32>((bitcast<i32>((_e1709 + _e1710)) + bitcast<i32>(_e1713)))];
let _e1719 = local_22;
let _e1720 = local_34.member_4;
let _e1724 = local_21;
let _e1729 = global_4.member[bitcast<u32>((bitcast<i32>((_e1719 + (2u * _e1720))) + bitcast<i32>(_e1724)))];
let _e1730 = local_23.member_1;
let _e1731 = local_24;
local_19 = _e1731;
let _e1732 = local_34.member_3;
let _e1733 = local_34.member_4;
let _e1736 = local_34.member_1;
if (_e1736 < 2u) {
let _e1738 = local_34.member_1;
phi_3254_ = _e1738;
} else {
phi_3254_ = 2u;
}
let _e1740 = phi_3254_;
local_20 = ((_e1732 + (6u * _e1733)) + (_e1730 << bitcast<u32>(((2u * _e1740) & 31u))));
let _e1746 = local_20;
let _e1748 = local_19;
let _e1753 = global_4.member[bitcast<u32>((bitcast<i32>(_e1746) + bitcast<i32>(_e1748)))];
let _e1754 = local_20;
let _e1755 = local_34.member_4;
let _e1758 = local_19;
let _e1763 = global_4.member[bitcast<u32>((bitcast<i32>((_e1754 + _e1755)) + bitcast<i32>(_e1758)))];
let _e1764 = local_20;
let _e1765 = local_34.member_4;
let _e1769 = local_19;
let _e1774 = global_4.member[bitcast<u32>((bitcast<i32>((_e1764 + (2u * _e1765))) + bitcast<i32>(_e1769)))];
let _e1775 = local_23.member_1;
let _e1776 = local_24;
local_17 = _e1776;
let _e1777 = local_34.member_3;
let _e1778 = local_34.member_4;
let _e1781 = local_34.member_1;
if (_e1781 < 2u) {
let _e1783 = local_34.member_1;
phi_3325_ = _e1783;
} else {
phi_3325_ = 2u;
}
let _e1785 = phi_3325_;
local_18 = ((_e1777 + (9u * _e1778)) + (_e1775 << bitcast<u32>(((2u * _e1785) & 31u))));
let _e1791 = local_18;
let _e1793 = local_17;
let _e1798 = global_4.member[bitcast<u32>((bitcast<i32>(_e1791) + bitcast<i32>(_e1793)))];
let _e1799 = local_18;
let _e1800 = local_34.member_4;
let _e1803 = local_17;
let _e1808 = global_4.member[bitcast<u32>((bitcast<i32>((_e1799 + _e1800)) + bitcast<i32>(_e1803)))];
let _e1809 = local_18;
let _e1810 = local_34.member_4;
let _e1814 = local_17;
let _e1819 = global_4.member[bitcast<u32>((bitcast<i32>((_e1809 + (2u * _e1810))) + bitcast<i32>(_e1814)))];
let _e1820 = local_23.member_1;
let _e1821 = local_24;
local_15 = _e1821;
let _e1822 = local_34.member_3;
let _e1823 = local_34.member_4;
let _e1826 = local_34.member_1;
if (_e1826 < 2u) {
let _e1828 = local_34.member_1;
phi_3396_ = _e1828;
} else {
phi_3396_ = 2u;
}
let _e1830 = phi_3396_;
local_16 = ((_e1822 + (12u * _e1823)) + (_e1820 << bitcast<u32>(((2u * _e1830) & 31u))));
let _e1836 = local_16;
let _e1838 = local_15;
let _e1843 = global_4.member[bitcast<u32>((bitcast<i32>(_e1836) + bitcast<i32>(_e1838)))];
let _e1844 = local_16;
let _e1845 = local_34.member_4;
let _e1848 = local_15;
let _e1853 = global_4.member[bitcast<u32>((bitcast<i32>((_e1844 + _e1845)) + bitcast<i32>(_e1848)))];
let _e1854 = local_16;
let _e1855 = local_34.member_4;
let _e1859 = local_15;
let _e1864 = global_4.member[bitcast<u32>((bitcast<i32>((_e1854 + (2u * _e1855))) + bitcast<i32>(_e1859)))];
let _e1865 = local_23.member_1;
let _e1866 = local_24;
local_13 = _e1866;
let _e1867 = local_34.member_3;
let _e1868 = local_34.member_4;
let _e1871 = local_34.member_1;
if (_e1871 < 2u) {
let _e1873 = local_34.member_1;
phi_3467_ = _e1873;
} else {
phi_3467_ = 2u;
}
let _e1875 = phi_3467_;
local_14 = ((_e1867 + (15u * _e1868)) + (_e1865 << bitcast<u32>(((2u * _e1875) & 31u))));
let _e1881 = local_14;
let _e1883 = local_13;
let _e1888 = global_4.member[bitcast<u32>((bitcast<i32>(_e1881) + bitcast<i32>(_e1883)))];
let _e1889 = local_14;
let _e1890 = local_34.member_4;
let _e1893 = local_13;
let _e1898 = global_4.member[bitcast<u32>((bitcast<i32>((_e1889 + _e1890)) + bitcast<i32>(_e1893)))];
let _e1899 = local_14;
let _e1900 = local_34.member_4;
let _e1904 = local_13;
let _e1909 = global_4.member[bitcast<u32>((bitcast<i32>((_e1899 + (2u * _e1900))) + bitcast<i32>(_e1904)))];
let _e1910 = local_34.member_1;
if (_e1910 < 2u) {
let _e1912 = local_34.member_1;
phi_3527_ = _e1912;
} else {
phi_3527_ = 2u;
}
let _e1914 = phi_3527_;
let _e1916 = ((2u * _e1914) & 31u);
let _e1919 = ((_e1112.member_1 << bitcast<u32>(_e1916)) + _e1637);
let _e1920 = (_e1919 & 1431655765u);
let _e1924 = ((_e1920 | (_e1920 >> bitcast<u32>(1i))) & 858993459u);
let _e1928 = ((_e1924 | (_e1924 >> bitcast<u32>(2i))) & 252645135u);
let _e1932 = ((_e1928 | (_e1928 >> bitcast<u32>(4i))) & 16711935u);
let _e1939 = ((_e1919 >> bitcast<u32>(1i)) & 1431655765u);
let _e1943 = ((_e1939 | (_e1939 >> bitcast<u32>(1i))) & 858993459u);
let _e1947 = ((_e1943 | (_e1943 >> bitcast<u32>(2i))) & 252645135u);
let _e1951 = ((_e1947 | (_e1947 >> bitcast<u32>(4i))) & 16711935u);
let _e1966 = ((_e1708 - _e1663) * 0.5f);
let _e1967 = ((_e1718 - _e1673) * 0.5f);
let _e1968 = ((_e1729 - _e1684) * 0.5f);
let _e1972 = ((_e1663 + _e1966) - _e802);
let _e1973 = ((_e1673 + _e1967) - _e803);
let _e1974 = ((_e1684 + _e1968) - _e804);
let _e1979 = (((_e1972 * _e1972) + (_e1973 * _e1973)) + (_e1974 * _e1974));
let _e1987 = (((_e1966 * _e1966) + (_e1967 * _e1967)) + (_e1968 * _e1968));
let _e1993 = (_e911 + (_e929 * (sqrt(select(0f, _e1979, (_e1979 > 0f))) + sqrt(select(0f, _e1987, (_e1987 > 0f))))));
let _e2001 = (((_e1663 - _e1993) - _e802) * _e816);
let _e2003 = (((_e1708 + _e1993) - _e802) * _e816);
let _e2005 = (((_e1673 - _e1993) - _e803) * _e824);
let _e2007 = (((_e1718 + _e1993) - _e803) * _e824);
let _e2009 = (((_e1684 - _e1993) - _e804) * _e832);
let _e2011 = (((_e1729 + _e1993) - _e804) * _e832);
let _e2013 = select(_e2003, _e2001, (_e2001 < _e2003));
let _e2015 = select(_e2007, _e2005, (_e2005 < _e2007));
let _e2017 = select(_e2015, _e2013, (_e2013 > _e2015));
let _e2019 = select(_e2011, _e2009, (_e2009 < _e2011));
let _e2021 = select(_e2019, _e2017, (_e2017 > _e2019));
let _e2023 = select(_e2003, _e2001, (_e2001 > _e2003));
let _e2025 = select(_e2007, _e2005, (_e2005 > _e2007));
let _e2027 = select(_e2025, _e2023, (_e2023 < _e2025));
let _e2029 = select(_e2011, _e2009, (_e2009 > _e2011));
let _e2031 = select(_e2029, _e2027, (_e2027 < _e2029));
let _e2040 = (_e1753 - _e802);
let _e2041 = (_e1763 - _e803);
let _e2042 = (_e1774 - _e804);
let _e2045 = ((_e1853 * _e525) - (_e1864 * _e514));
let _e2048 = ((_e1864 * _e503) - (_e1843 * _e525));
let _e2051 = ((_e1843 * _e514) - (_e1853 * _e503));
let _e2099 = (((_e1798 * _e1798) + (_e1808 * _e1808)) + (_e1819 * _e1819));
let _e2102 = sqrt(select(0f, _e2099, (_e2099 > 0f)));
let _e2107 = (((_e1888 * _e1888) + (_e1898 * _e1898)) + (_e1909 * _e1909));
let _e2117 = (((_e2040 * _e2040) + (_e2041 * _e2041)) + (_e2042 * _e2042));
phi_3073_ = (_e1637 + 1u);
phi_3076_ = (_e1639 | (select(0u, 1u, (((((_e1637 < (1u << bitcast<u32>(_e1916))) && (((_e1932 | (_e1932 >> bitcast<u32>(8i))) & 65535u) < _e933)) && (((_e1951 | (_e1951 >> bitcast<u32>(8i))) & 65535u) < _e933)) && ((_e1663 <= _e1708) && (select(_e884, _e2021, (_e2021 > _e884)) <= select(_e885, _e2031, (_e2031 < _e885))))) && (bitcast<f32>((bitcast<u32>((((_e2040 * _e2045) + (_e2041 * _e2048)) + (_e2042 * _e2051))) & 2147483647u)) <= ((((((bitcast<f32>((bitcast<u32>(_e2045) & 2147483647u)) * _e1798) + (bitcast<f32>((bitcast<u32>(_e2048) & 2147483647u)) * _e1808)) + (bitcast<f32>((bitcast<u32>(_e2051) & 2147483647u)) * _e1819)) + (((bitcast<f32>((bitcast<u32>(((_e514 * _e2042) - (_e525 * _e2041))) & 2147483647u)) * _e1888) + (bitcast<f32>((bitcast<u32>(((_e525 * _e2040) - (_e503 * _e2042))) & 2147483647u)) * _e1898)) + (bitcast<f32>((bitcast<u32>(((_e503 * _e2041) - (_e514 * _e2040))) & 2147483647u)) * _e1909))) + (_e2102 * sqrt(select(0f, _e2107, (_e2107 > 0f))))) + (_e911 + (_e929 * (sqrt(select(0f, _e2117, (_e2117 > 0f))) + _e2102))))))) << bitcast<u32>((_e1637 & 31u))));
} else {
phi_3073_ = u32();
phi_3076_ = u32();
}
let _e2137 = phi_3073_;
let _e2139 = phi_3076_;
continue;
continuing {
phi_3072_ = _e2137;
phi_3075_ = _e2139;
break if !(_e1640);
}
}
let _e4459 = local_56;
phi_3804_ = _e4459;
} else {
phi_3804_ = 0u;
}
let _e2142 = phi_3804_;
phi_3806_ = _e1108;
phi_3809_ = _e1110;
phi_3811_ = 0u;
loop {
let _e2144 = phi_3806_;
let _e2146 = phi_3809_;
let _e2148 = phi_3811_;
local_59 = _e2144;
local_60 = _e2146;
let _e2151 = (_e2142 >> bitcast<u32>((_e2148 & 31u)));
let _e2152 = (_e2151 == 0u);
if _e2152 {
phi_3807_ = vec3<f32>();
phi_3810_ = vec3<f32>();
phi_3812_ = u32();
} else {
if ((_e2151 & 1u) == 0u) {
phi_7022_ = _e2144;
phi_7023_ = _e2146;
} else {
let _e2155 = local_34.member_1;
if (_e2155 < 2u) {
let _e2157 = local_34.member_1;
phi_3840_ = _e2157;
} else {
phi_3840_ = 2u;
}
let _e2159 = phi_3840_;
let _e2161 = ((2u * _e2159) & 31u);
let _e2164 = ((_e1112.member_1 << bitcast<u32>(_e2161)) + _e2148);
let _e2165 = (_e2164 & 1431655765u);
let _e2169 = ((_e2165 | (_e2165 >> bitcast<u32>(1i))) & 858993459u);
let _e2173 = ((_e2169 | (_e2169 >> bitcast<u32>(2i))) & 252645135u);
let _e2177 = ((_e2173 | (_e2173 >> bitcast<u32>(4i))) & 16711935u);
let _e2181 = ((_e2177 | (_e2177 >> bitcast<u32>(8i))) & 65535u);
let _e2184 = ((_e2164 >> bitcast<u32>(1i)) & 1431655765u);
let _e2188 = ((_e2184 | (_e2184 >> bitcast<u32>(1i))) & 858993459u);
let _e2192 = ((_e2188 | (_e2188 >> bitcast<u32>(2i))) & 252645135u);
let _e2196 = ((_e2192 | (_e2192 >> bitcast<u32>(4i))) & 16711935u);
let _e2200 = ((_e2196 | (_e2196 >> bitcast<u32>(8i))) & 65535u);
if (((_e2148 < (1u << bitcast<u32>(_e2161))) && (_e2181 < _e933)) && (_e2200 < _e933)) {
phi_3886_ = bitcast<i32>(((_e2200 * _e933) + _e2181));
} else {
phi_3886_ = 0i;
}
let _e2212 = phi_3886_;
local_10 = bitcast<i32>((_e941 * _e950));
local_11 = _e2212;
local_12 = bitcast<i32>((_e933 * _e933));
let _e2213 = local_10;
let _e2214 = local_11;
let _e2215 = (_e2213 + _e2214);
let _e2217 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e2219 = select(_e2217, _e2215, (_e2215 < _e2217));
let _e2224 = global_3.member[bitcast<u32>(select(0i, _e2219, (_e2219 > 0i)))];
let _e2225 = local_10;
let _e2226 = local_12;
let _e2228 = local_11;
let _e2229 = ((_e2225 + _e2226) + _e2228);
let _e2231 = select(_e2217, _e2229, (_e2229 < _e2217));
let _e2236 = global_3.member[bitcast<u32>(select(0i, _e2231, (_e2231 > 0i)))];
let _e2237 = local_10;
let _e2238 = local_12;
let _e2241 = local_11;
let _e2242 = ((_e2237 + (2i * _e2238)) + _e2241);
let _e2244 = select(_e2217, _e2242, (_e2242 < _e2217));
let _e2249 = global_3.member[bitcast<u32>(select(0i, _e2244, (_e2244 > 0i)))];
let _e2250 = local_10;
let _e2251 = local_12;
let _e2254 = local_11;
let _e2255 = ((_e2250 + (3i * _e2251)) + _e2254);
let _e2257 = select(_e2217, _e2255, (_e2255 < _e2217));
let _e2262 = global_3.member[bitcast<u32>(select(0i, _e2257, (_e2257 > 0i)))];
let _e2263 = local_10;
let _e2264 = local_12;
let _e2267 = local_11;
let _e2268 = ((_e2263 + (4i * _e2264)) + _e2267);
let _e2270 = select(_e2217, _e2268, (_e2268 < _e2217));
let _e2275 = global_3.member[bitcast<u32>(select(0i, _e2270, (_e2270 > 0i)))];
let _e2276 = local_10;
let _e2277 = local_12;
let _e2280 = local_11;
let _e2281 = ((_e2276 + (5i * _e2277)) + _e2280);
let _e2283 = select(_e2217, _e2281, (_e2281 < _e2217));
let _e2288 = global_3.member[bitcast<u32>(select(0i, _e2283, (_e2283 > 0i)))];
let _e2289 = local_10;
let _e2290 = local_12;
let _e2293 = local_11;
let _e2294 = ((_e2289 + (6i * _e2290)) + _e2293);
let _e2296 = select(_e2217, _e2294, (_e2294 < _e2217));
let _e2301 = global_3.member[bitcast<u32>(select(0i, _e2296, (_e2296 > 0i)))];
let _e2302 = local_10;
let _e2303 = local_12;
let _e2306 = local_11;
let _e2307 = ((_e2302 + (7i * _e2303)) + _e2306);
let _e2309 = select(_e2217, _e2307, (_e2307 < _e2217));
let _e2314 = global_3.member[bitcast<u32>(select(0i, _e2309, (_e2309 > 0i)))];
let _e2315 = local_10;
let _e2316 = local_12;
let _e2319 = local_11;
let _e2320 = ((_e2315 + (8i * _e2316)) + _e2319);
let _e2322 = select(_e2217, _e2320, (_e2320 < _e2217));
let _e2327 = global_3.member[bitcast<u32>(select(0i, _e2322, (_e2322 > 0i)))];
let _e2328 = local_10;
let _e2329 = local_12;
let _e2332 = local_11;
let _e2333 = ((_e2328 + (9i * _e2329)) + _e2332);
let _e2335 = select(_e2217, _e2333, (_e2333 < _e2217));
let _e2340 = global_3.member[bitcast<u32>(select(0i, _e2335, (_e2335 > 0i)))];
let _e2341 = local_10;
let _e2342 = local_12;
let _e2345 = local_11;
let _e2346 = ((_e2341 + (10i * _e2342)) + _e2345);
let _e2348 = select(_e2217, _e2346, (_e2346 < _e2217));
let _e2353 = global_3.member[bitcast<u32>(select(0i, _e2348, (_e2348 > 0i)))];
let _e2354 = local_10;
let _e2355 = local_12;
let _e2358 = local_11;
let _e2359 = ((_e2354 + (11i * _e2355)) + _e2358);
let _e2361 = select(_e2217, _e2359, (_e2359 < _e2217));
let _e2366 = global_3.member[bitcast<u32>(select(0i, _e2361, (_e2361 > 0i)))];
let _e2367 = local_10;
let _e2368 = local_12;
let _e2371 = local_11;
let _e2372 = ((_e2367 + (12i * _e2368)) + _e2371);
let _e2374 = select(_e2217, _e2372, (_e2372 < _e2217));
let _e2379 = global_3.member[bitcast<u32>(select(0i, _e2374, (_e2374 > 0i)))];
let _e2380 = local_10;
let _e2381 = local_12;
let _e2384 = local_11;
let _e2385 = ((_e2380 + (13i * _e2381)) + _e2384);
let _e2387 = select(_e2217, _e2385, (_e2385 < _e2217));
let _e2392 = global_3.member[bitcast<u32>(select(0i, _e2387, (_e2387 > 0i)))];
let _e2393 = local_10;
let _e2394 = local_12;
let _e2397 = local_11;
let _e2398 = ((_e2393 + (14i * _e2394)) + _e2397);
let _e2400 = select(_e2217, _e2398, (_e2398 < _e2217));
let _e2405 = global_3.member[bitcast<u32>(select(0i, _e2400, (_e2400 > 0i)))];
let _e2406 = local_10;
let _e2407 = local_12;
let _e2410 = local_11;
let _e2411 = ((_e2406 + (15i * _e2407)) + _e2410);
let _e2413 = select(_e2217, _e2411, (_e2411 < _e2217));
let _e2418 = global_3.member[bitcast<u32>(select(0i, _e2413, (_e2413 > 0i)))];
let _e2419 = local_10;
let _e2420 = local_12;
let _e2423 = local_11;
let _e2424 = ((_e2419 + (16i * _e2420)) + _e2423);
let _e2426 = select(_e2217, _e2424, (_e2424 < _e2217));
let _e2431 = global_3.member[bitcast<u32>(select(0i, _e2426, (_e2426 > 0i)))];
let _e2432 = local_10;
let _e2433 = local_12;
let _e2436 = local_11;
let _e2437 = ((_e2432 + (17i * _e2433)) + _e2436);
let _e2439 = select(_e2217, _e2437, (_e2437 < _e2217));
let _e2444 = global_3.member[bitcast<u32>(select(0i, _e2439, (_e2439 > 0i)))];
let _e2445 = local_10;
let _e2446 = local_12;
let _e2449 = local_11;
let _e2450 = ((_e2445 + (18i * _e2446)) + _e2449);
let _e2452 = select(_e2217, _e2450, (_e2450 < _e2217));
let _e2457 = global_3.member[bitcast<u32>(select(0i, _e2452, (_e2452 > 0i)))];
let _e2458 = local_10;
let _e2459 = local_12;
let _e2462 = local_11;
let _e2463 = ((_e2458 + (19i * _e2459)) + _e2462);
let _e2465 = select(_e2217, _e2463, (_e2463 < _e2217));
let _e2470 = global_3.member[bitcast<u32>(select(0i, _e2465, (_e2465 > 0i)))];
let _e2471 = local_10;
let _e2472 = local_12;
let _e2475 = local_11;
let _e2476 = ((_e2471 + (20i * _e2472)) + _e2475);
let _e2478 = select(_e2217, _e2476, (_e2476 < _e2217));
let _e2483 = global_3.member[bitcast<u32>(select(0i, _e2478, (_e2478 > 0i)))];
let _e2484 = local_10;
let _e2485 = local_12;
let _e2488 = local_11;
let _e2489 = ((_e2484 + (23i * _e2485)) + _e2488);
let _e2491 = select(_e2217, _e2489, (_e2489 < _e2217));
let _e2496 = global_3.member[bitcast<u32>(select(0i, _e2491, (_e2491 > 0i)))];
let _e2497 = (_e2224 - _e802);
let _e2498 = (_e2236 - _e803);
let _e2499 = (_e2249 - _e804);
let _e2502 = ((_e2498 * _e2288) - (_e2499 * _e2275));
let _e2505 = ((_e2499 * _e2262) - (_e2497 * _e2288));
let _e2508 = ((_e2497 * _e2275) - (_e2498 * _e2262));
let _e2513 = (((_e503 * _e2502) + (_e514 * _e2505)) + (_e525 * _e2508));
let _e2542 = bitcast<f32>((bitcast<u32>((((_e503 * (((_e2314 * _e2288) - (_e2327 * _e2275)) + ((_e2498 * _e2405) - (_e2499 * _e2392)))) + (_e514 * (((_e2327 * _e2262) - (_e2301 * _e2288)) + ((_e2499 * _e2379) - (_e2497 * _e2405))))) + (_e525 * (((_e2301 * _e2275) - (_e2314 * _e2262)) + ((_e2497 * _e2392) - (_e2498 * _e2379)))))) & 2147483647u));
let _e2571 = bitcast<f32>((bitcast<u32>((((_e503 * (((_e2353 * _e2288) - (_e2366 * _e2275)) + ((_e2498 * _e2444) - (_e2499 * _e2431)))) + (_e514 * (((_e2366 * _e2262) - (_e2340 * _e2288)) + ((_e2499 * _e2418) - (_e2497 * _e2444))))) + (_e525 * (((_e2340 * _e2275) - (_e2353 * _e2262)) + ((_e2497 * _e2431) - (_e2498 * _e2418)))))) & 2147483647u));
let _e2594 = bitcast<f32>((bitcast<u32>(((((_e602 * _e2502) + (_e613 * _e2505)) + (_e624 * _e2508)) - (((_e503 * ((_e547 * _e2288) - (_e558 * _e2275))) + (_e514 * ((_e558 * _e2262) - (_e536 * _e2288)))) + (_e525 * ((_e536 * _e2275) - (_e547 * _e2262)))))) & 2147483647u));
let _e2617 = bitcast<f32>((bitcast<u32>(((((_e635 * _e2502) + (_e646 * _e2505)) + (_e657 * _e2508)) - (((_e503 * ((_e580 * _e2288) - (_e591 * _e2275))) + (_e514 * ((_e591 * _e2262) - (_e569 * _e2288)))) + (_e525 * ((_e569 * _e2275) - (_e580 * _e2262)))))) & 2147483647u));
let _e2619 = select(_e2617, _e2594, (_e2594 > _e2617));
let _e2621 = select(1e-12f, _e2619, (_e2619 > 1e-12f));
let _e2626 = (((_e2497 * _e503) + (_e2498 * _e514)) + (_e2499 * _e525));
let _e2631 = (((_e2497 * _e2262) + (_e2498 * _e2275)) + (_e2499 * _e2288));
let _e2636 = (((_e503 * _e2262) + (_e514 * _e2275)) + (_e525 * _e2288));
let _e2639 = ((_e514 * _e2288) - (_e525 * _e2275));
let _e2642 = ((_e525 * _e2262) - (_e503 * _e2288));
let _e2645 = ((_e503 * _e2275) - (_e514 * _e2262));
let _e2650 = (((_e2639 * _e2639) + (_e2642 * _e2642)) + (_e2645 * _e2645));
let _e2653 = (1f / select(1e-9f, _e2650, (_e2650 > 1e-9f)));
let _e2656 = ((_e2626 - (_e2636 * _e2631)) * _e2653);
let _e2659 = (((_e2636 * _e2626) - _e2631) * _e2653);
if ((bitcast<f32>((bitcast<u32>(_e2513) & 2147483647u)) <= (0.5f * ((_e2542 + _e2571) + _e2621))) && ((((_e2659 >= 0f) && (_e2659 < _e2496)) && (_e2656 > _e884)) && (_e2656 < _e885))) {
let _e2675 = (_e2659 - 0f);
let _e2679 = global_1.member.member_13.member_6;
let _e2680 = (_e2679 == 0u);
if _e2680 {
phi_5446_ = _e2675;
} else {
let _e2682 = (_e2675 / f32(_e2679));
phi_4733_ = 0u;
phi_4736_ = 0f;
loop {
let _e2684 = phi_4733_;
let _e2686 = phi_4736_;
local_57 = _e2686;
let _e2689 = ((_e2684 < _e2679) && (_e2675 > 0f));
if _e2689 {
let _e2692 = (0f + (_e2682 * f32(_e2684)));
let _e2693 = (_e2692 + _e2682);
let _e2695 = (0.5f * (_e2692 + _e2693));
let _e2696 = (_e2693 - _e2692);
let _e2697 = (0.28867513f * _e2696);
let _e2698 = (_e2695 - _e2697);
let _e2708 = global_1.member.member_13.member_7;
let _e2709 = bitcast<i32>(_e2708);
let _e2713 = global_1.member.member_13.member_8;
let _e2714 = bitcast<i32>(_e2713);
let _e2718 = global_1.member.member_13.member_9;
let _e2719 = bitcast<i32>(_e2718);
let _e2720 = f32(_e2709);
let _e2722 = (_e843.member - _e836.member);
let _e2725 = (((((_e2224 + (_e2262 * _e2698)) - _e836.member) / _e2722) * _e2720) - 0.5f);
let _e2726 = (_e2720 - 1f);
let _e2728 = select(0f, _e2725, (_e2725 > 0f));
let _e2730 = select(_e2726, _e2728, (_e2728 < _e2726));
let _e2731 = f32(_e2714);
let _e2733 = (_e843.member_1 - _e836.member_1);
let _e2736 = (((((_e2236 + (_e2275 * _e2698)) - _e836.member_1) / _e2733) * _e2731) - 0.5f);
let _e2737 = (_e2731 - 1f);
let _e2739 = select(0f, _e2736, (_e2736 > 0f));
let _e2741 = select(_e2737, _e2739, (_e2739 < _e2737));
let _e2742 = f32(_e2719);
let _e2744 = (_e843.member_2 - _e836.member_2);
let _e2747 = (((((_e2249 + (_e2288 * _e2698)) - _e836.member_2) / _e2744) * _e2742) - 0.5f);
let _e2748 = (_e2742 - 1f);
let _e2750 = select(0f, _e2747, (_e2747 > 0f));
let _e2752 = select(_e2748, _e2750, (_e2750 < _e2748));
let _e2754 = select(0f, _e2730, (_e2730 > 0f));
let _e2756 = select(1e6f, _e2754, (_e2754 < 1e6f));
let _e2763 = select(0i, select(select(i32(_e2756), i32(-2147483648), (_e2756 < -2147483600f)), 2147483647i, (_e2756 > 2147483500f)), (_e2756 == _e2756));
let _e2767 = (_e2763 - select(0i, 1i, (_e2756 < f32(_e2763))));
let _e2769 = select(0f, _e2741, (_e2741 > 0f));
let _e2771 = select(1e6f, _e2769, (_e2769 < 1e6f));
let _e2778 = select(0i, select(select(i32(_e2771), i32(-2147483648), (_e2771 < -2147483600f)), 2147483647i, (_e2771 > 2147483500f)), (_e2771 == _e2771));
let _e2782 = (_e2778 - select(0i, 1i, (_e2771 < f32(_e2778))));
let _e2784 = select(0f, _e2752, (_e2752 > 0f));
let _e2786 = select(1e6f, _e2784, (_e2784 < 1e6f));
let _e2793 = select(0i, select(select(i32(_e2786), i32(-2147483648), (_e2786 < -2147483600f)), 2147483647i, (_e2786 > 2147483500f)), (_e2786 == _e2786));
let _e2797 = (_e2793 - select(0i, 1i, (_e2786 < f32(_e2793))));
let _e2801 = (_e2741 - f32(_e2782));
let _e2803 = (_e2752 - f32(_e2797));
local_8 = (_e2730 - f32(_e2767));
let _e2804 = (_e2767 + 1i);
let _e2806 = select(_e2804, 0i, (_e2804 < 0i));
if (_e2806 >= _e2709) {
phi_4871_ = (_e2709 - 1i);
} else {
phi_4871_ = _e2806;
}
let _e2810 = phi_4871_;
local_9 = (_e2810 - _e2767);
let _e2812 = (_e2782 + 1i);
let _e2814 = select(_e2812, 0i, (_e2812 < 0i));
if (_e2814 >= _e2714) {
phi_4884_ = (_e2714 - 1i);
} else {
phi_4884_ = _e2814;
}
let _e2818 = phi_4884_;
let _e2820 = ((_e2818 - _e2782) * _e2709);
let _e2821 = (_e2797 + 1i);
let _e2823 = select(_e2821, 0i, (_e2821 < 0i));
if (_e2823 >= _e2719) {
phi_4898_ = (_e2719 - 1i);
} else {
phi_4898_ = _e2823;
}
let _e2827 = phi_4898_;
let _e2834 = global_1.member.member_13.member_10;
let _e2835 = bitcast<i32>(_e2834);
let _e2840 = ((_e2835 + (((_e2797 * _e2714) + _e2782) * _e2709)) + _e2767);
let _e2842 = (bitcast<i32>(_e152) - 1i);
let _e2844 = select(_e2842, _e2840, (_e2840 < _e2842));
let _e2849 = global_5.member[bitcast<u32>(select(0i, _e2844, (_e2844 > 0i)))];
let _e2850 = local_8;
let _e2853 = local_9;
let _e2854 = (_e2840 + _e2853);
let _e2856 = select(_e2842, _e2854, (_e2854 < _e2842));
let _e2861 = global_5.member[bitcast<u32>(select(0i, _e2856, (_e2856 > 0i)))];
let _e2862 = local_8;
let _e2865 = (1f - _e2801);
let _e2867 = (_e2840 + _e2820);
let _e2869 = select(_e2842, _e2867, (_e2867 < _e2842));
let _e2874 = global_5.member[bitcast<u32>(select(0i, _e2869, (_e2869 > 0i)))];
let _e2875 = local_8;
let _e2878 = local_9;
let _e2879 = (_e2867 + _e2878);
let _e2881 = select(_e2842, _e2879, (_e2879 < _e2842));
let _e2886 = global_5.member[bitcast<u32>(select(0i, _e2881, (_e2881 > 0i)))];
let _e2887 = local_8;
let _e2892 = (_e2840 + (((_e2827 - _e2797) * _e2709) * _e2714));
let _e2894 = select(_e2842, _e2892, (_e2892 < _e2842));
let _e2899 = global_5.member[bitcast<u32>(select(0i, _e2894, (_e2894 > 0i)))];
let _e2900 = local_8;
let _e2903 = local_9;
let _e2904 = (_e2892 + _e2903);
let _e2906 = select(_e2842, _e2904, (_e2904 < _e2842));
let _e2911 = global_5.member[bitcast<u32>(select(0i, _e2906, (_e2906 > 0i)))];
let _e2912 = local_8;
let _e2916 = (_e2892 + _e2820);
let _e2918 = select(_e2842, _e2916, (_e2916 < _e2842));
let _e2923 = global_5.member[bitcast<u32>(select(0i, _e2918, (_e2918 > 0i)))];
let _e2924 = local_8;
let _e2927 = local_9;
let _e2928 = (_e2916 + _e2927);
let _e2930 = select(_e2842, _e2928, (_e2928 < _e2842));
let _e2935 = global_5.member[bitcast<u32>(select(0i, _e2930, (_e2930 > 0i)))];
let _e2936 = local_8;
let _e2945 = (_e2695 + _e2697);
let _e2955 = (((((_e2224 + (_e2262 * _e2945)) - _e836.member) / _e2722) * _e2720) - 0.5f);
let _e2957 = select(0f, _e2955, (_e2955 > 0f));
let _e2959 = select(_e2726, _e2957, (_e2957 < _e2726));
let _e2963 = (((((_e2236 + (_e2275 * _e2945)) - _e836.member_1) / _e2733) * _e2731) - 0.5f);
let _e2965 = select(0f, _e2963, (_e2963 > 0f));
let _e2967 = select(_e2737, _e2965, (_e2965 < _e2737));
let _e2971 = (((((_e2249 + (_e2288 * _e2945)) - _e836.member_2) / _e2744) * _e2742) - 0.5f);
let _e2973 = select(0f, _e2971, (_e2971 > 0f));
let _e2975 = select(_e2748, _e2973, (_e2973 < _e2748));
let _e2977 = select(0f, _e2959, (_e2959 > 0f));
let _e2979 = select(1e6f, _e2977, (_e2977 < 1e6f));
let _e2986 = select(0i, select(select(i32(_e2979), i32(-2147483648), (_e2979 < -2147483600f)), 2147483647i, (_e2979 > 2147483500f)), (_e2979 == _e2979));
let _e2990 = (_e2986 - select(0i, 1i, (_e2979 < f32(_e2986))));
let _e2992 = select(0f, _e2967, (_e2967 > 0f));
let _e2994 = select(1e6f, _e2992, (_e2992 < 1e6f));
let _e3001 = select(0i, select(select(i32(_e2994), i32(-2147483648), (_e2994 < -2147483600f)), 2147483647i, (_e2994 > 2147483500f)), (_e2994 == _e2994));
let _e3005 = (_e3001 - select(0i, 1i, (_e2994 < f32(_e3001))));
let _e3007 = select(0f, _e2975, (_e2975 > 0f));
let _e3009 = select(1e6f, _e3007, (_e3007 < 1e6f));
let _e3016 = select(0i, select(select(i32(_e3009), i32(-2147483648), (_e3009 < -2147483600f)), 2147483647i, (_e3009 > 2147483500f)), (_e3009 == _e3009));
let _e3020 = (_e3016 - select(0i, 1i, (_e3009 < f32(_e3016))));
let _e3024 = (_e2967 - f32(_e3005));
let _e3026 = (_e2975 - f32(_e3020));
local_6 = (_e2959 - f32(_e2990));
let _e3027 = (_e2990 + 1i);
let _e3029 = select(_e3027, 0i, (_e3027 < 0i));
if (_e3029 >= _e2709) {
phi_5214_ = (_e2709 - 1i);
} else {
phi_5214_ = _e3029;
}
let _e3033 = phi_5214_;
local_7 = (_e3033 - _e2990);
let _e3035 = (_e3005 + 1i);
let _e3037 = select(_e3035, 0i, (_e3035 < 0i));
if (_e3037 >= _e2714) {
phi_5227_ = (_e2714 - 1i);
} else {
phi_5227_ = _e3037;
}
let _e3041 = phi_5227_;
let _e3043 = ((_e3041 - _e3005) * _e2709);
let _e3044 = (_e3020 + 1i);
let _e3046 = select(_e3044, 0i, (_e3044 < 0i));
if (_e3046 >= _e2719) {
phi_5241_ = (_e2719 - 1i);
} else {
phi_5241_ = _e3046;
}
let _e3050 = phi_5241_;
let _e3058 = ((_e2835 + (((_e3020 * _e2714) + _e3005) * _e2709)) + _e2990);
let _e3060 = select(_e2842, _e3058, (_e3058 < _e2842));
let _e3065 = global_5.member[bitcast<u32>(select(0i, _e3060, (_e3060 > 0i)))];
let _e3066 = local_6;
let _e3069 = local_7;
let _e3070 = (_e3058 + _e3069);
let _e3072 = select(_e2842, _e3070, (_e3070 < _e2842));
let _e3077 = global_5.member[bitcast<u32>(select(0i, _e3072, (_e3072 > 0i)))];
let _e3078 = local_6;
let _e3081 = (1f - _e3024);
let _e3083 = (_e3058 + _e3043);
let _e3085 = select(_e2842, _e3083, (_e3083 < _e2842));
let _e3090 = global_5.member[bitcast<u32>(select(0i, _e3085, (_e3085 > 0i)))];
let _e3091 = local_6;
let _e3094 = local_7;
let _e3095 = (_e3083 + _e3094);
let _e3097 = select(_e2842, _e3095, (_e3095 < _e2842));
let _e3102 = global_5.member[bitcast<u32>(select(0i, _e3097, (_e3097 > 0i)))];
let _e3103 = local_6;
let _e3108 = (_e3058 + (((_e3050 - _e3020) * _e2709) * _e2714));
let _e3110 = select(_e2842, _e3108, (_e3108 < _e2842));
let _e3115 = global_5.member[bitcast<u32>(select(0i, _e3110, (_e3110 > 0i)))];
let _e3116 = local_6;
let _e3119 = local_7;
let _e3120 = (_e3108 + _e3119);
let _e3122 = select(_e2842, _e3120, (_e3120 < _e2842));
let _e3127 = global_5.member[bitcast<u32>(select(0i, _e3122, (_e3122 > 0i)))];
let _e3128 = local_6;
let _e3132 = (_e3108 + _e3043);
let _e3134 = select(_e2842, _e3132, (_e3132 < _e2842));
let _e3139 = global_5.member[bitcast<u32>(select(0i, _e3134, (_e3134 > 0i)))];
let _e3140 = local_6;
let _e3143 = local_7;
let _e3144 = (_e3132 + _e3143);
let _e3146 = select(_e2842, _e3144, (_e3144 < _e2842));
let _e3151 = global_5.member[bitcast<u32>(select(0i, _e3146, (_e3146 > 0i)))];
let _e3152 = local_6;
phi_4734_ = (_e2684 + 1u);
phi_4737_ = (_e2686 + ((0.5f * (((((((_e2849 * (1f - _e2850)) + (_e2861 * _e2862)) * _e2865) + (((_e2874 * (1f - _e2875)) + (_e2886 * _e2887)) * _e2801)) * (1f - _e2803)) + (((((_e2899 * (1f - _e2900)) + (_e2911 * _e2912)) * _e2865) + (((_e2923 * (1f - _e2924)) + (_e2935 * _e2936)) * _e2801)) * _e2803)) + ((((((_e3065 * (1f - _e3066)) + (_e3077 * _e3078)) * _e3081) + (((_e3090 * (1f - _e3091)) + (_e3102 * _e3103)) * _e3024)) * (1f - _e3026)) + (((((_e3115 * (1f - _e3116)) + (_e3127 * _e3128)) * _e3081) + (((_e3139 * (1f - _e3140)) + (_e3151 * _e3152)) * _e3024)) * _e3026)))) * _e2696));
} else {
phi_4734_ = u32();
phi_4737_ = f32();
}
let _e3167 = phi_4734_;
let _e3169 = phi_4737_;
continue;
continuing {
phi_4733_ = _e3167;
phi_4736_ = _e3169;
break if !(_e2689);
}
}
let _e4477 = local_57;
phi_5446_ = _e4477;
}
let _e3172 = phi_5446_;
let _e3173 = (_e2656 - _e884);
if _e2680 {
phi_6172_ = _e3173;
} else {
let _e3175 = (_e3173 / f32(_e2679));
phi_5459_ = 0u;
phi_5462_ = 0f;
loop {
let _e3177 = phi_5459_;
let _e3179 = phi_5462_;
local_58 = _e3179;
let _e3182 = ((_e3177 < _e2679) && (_e3173 > 0f));
if _e3182 {
let _e3185 = (_e884 + (_e3175 * f32(_e3177)));
let _e3186 = (_e3185 + _e3175);
let _e3188 = (0.5f * (_e3185 + _e3186));
let _e3189 = (_e3186 - _e3185);
let _e3190 = (0.28867513f * _e3189);
let _e3191 = (_e3188 - _e3190);
let _e3201 = global_1.member.member_13.member_7;
let _e3202 = bitcast<i32>(_e3201);
let _e3206 = global_1.member.member_13.member_8;
let _e3207 = bitcast<i32>(_e3206);
let _e3211 = global_1.member.member_13.member_9;
let _e3212 = bitcast<i32>(_e3211);
let _e3213 = f32(_e3202);
let _e3215 = (_e843.member - _e836.member);
let _e3218 = (((((_e802 + (_e503 * _e3191)) - _e836.member) / _e3215) * _e3213) - 0.5f);
let _e3219 = (_e3213 - 1f);
let _e3221 = select(0f, _e3218, (_e3218 > 0f));
let _e3223 = select(_e3219, _e3221, (_e3221 < _e3219));
let _e3224 = f32(_e3207);
let _e3226 = (_e843.member_1 - _e836.member_1);
let _e3229 = (((((_e803 + (_e514 * _e3191)) - _e836.member_1) / _e3226) * _e3224) - 0.5f);
let _e3230 = (_e3224 - 1f);
let _e3232 = select(0f, _e3229, (_e3229 > 0f));
let _e3234 = select(_e3230, _e3232, (_e3232 < _e3230));
let _e3235 = f32(_e3212);
let _e3237 = (_e843.member_2 - _e836.member_2);
let _e3240 = (((((_e804 + (_e525 * _e3191)) - _e836.member_2) / _e3237) * _e3235) - 0.5f);
let _e3241 = (_e3235 - 1f);
let _e3243 = select(0f, _e3240, (_e3240 > 0f));
let _e3245 = select(_e3241, _e3243, (_e3243 < _e3241));
let _e3247 = select(0f, _e3223, (_e3223 > 0f));
let _e3249 = select(1e6f, _e3247, (_e3247 < 1e6f));
let _e3256 = select(0i, select(select(i32(_e3249), i32(-2147483648), (_e3249 < -2147483600f)), 2147483647i, (_e3249 > 2147483500f)), (_e3249 == _e3249));
let _e3260 = (_e3256 - select(0i, 1i, (_e3249 < f32(_e3256))));
let _e3262 = select(0f, _e3234, (_e3234 > 0f));
let _e3264 = select(1e6f, _e3262, (_e3262 < 1e6f));
let _e3271 = select(0i, select(select(i32(_e3264), i32(-2147483648), (_e3264 < -2147483600f)), 2147483647i, (_e3264 > 2147483500f)), (_e3264 == _e3264));
let _e3275 = (_e3271 - select(0i, 1i, (_e3264 < f32(_e3271))));
let _e3277 = select(0f, _e3245, (_e3245 > 0f));
let _e3279 = select(1e6f, _e3277, (_e3277 < 1e6f));
let _e3286 = select(0i, select(select(i32(_e3279), i32(-2147483648), (_e3279 < -2147483600f)), 2147483647i, (_e3279 > 2147483500f)), (_e3279 == _e3279));
let _e3290 = (_e3286 - select(0i, 1i, (_e3279 < f32(_e3286))));
let _e3294 = (_e3234 - f32(_e3275));
let _e3296 = (_e3245 - f32(_e3290));
local_4 = (_e3223 - f32(_e3260));
let _e3297 = (_e3260 + 1i);
let _e3299 = select(_e3297, 0i, (_e3297 < 0i));
if (_e3299 >= _e3202) {
phi_5597_ = (_e3202 - 1i);
} else {
phi_5597_ = _e3299;
}
let _e3303 = phi_5597_;
local_5 = (_e3303 - _e3260);
let _e3305 = (_e3275 + 1i);
let _e3307 = select(_e3305, 0i, (_e3305 < 0i));
if (_e3307 >= _e3207) {
phi_5610_ = (_e3207 - 1i);
} else {
phi_5610_ = _e3307;
}
let _e3311 = phi_5610_;
let _e3313 = ((_e3311 - _e3275) * _e3202);
let _e3314 = (_e3290 + 1i);
let _e3316 = select(_e3314, 0i, (_e3314 < 0i));
if (_e3316 >= _e3212) {
phi_5624_ = (_e3212 - 1i);
} else {
phi_5624_ = _e3316;
}
let _e3320 = phi_5624_;
let _e3327 = global_1.member.member_13.member_10;
let _e3328 = bitcast<i32>(_e3327);
let _e3333 = ((_e3328 + (((_e3290 * _e3207) + _e3275) * _e3202)) + _e3260);
let _e3335 = (bitcast<i32>(_e152) - 1i);
let _e3337 = select(_e3335, _e3333, (_e3333 < _e3335));
let _e3342 = global_5.member[bitcast<u32>(select(0i, _e3337, (_e3337 > 0i)))];
let _e3343 = local_4;
let _e3346 = local_5;
let _e3347 = (_e3333 + _e3346);
let _e3349 = select(_e3335, _e3347, (_e3347 < _e3335));
let _e3354 = global_5.member[bitcast<u32>(select(0i, _e3349, (_e3349 > 0i)))];
let _e3355 = local_4;
let _e3358 = (1f - _e3294);
let _e3360 = (_e3333 + _e3313);
let _e3362 = select(_e3335, _e3360, (_e3360 < _e3335));
let _e3367 = global_5.member[bitcast<u32>(select(0i, _e3362, (_e3362 > 0i)))];
let _e3368 = local_4;
let _e3371 = local_5;
let _e3372 = (_e3360 + _e3371);
let _e3374 = select(_e3335, _e3372, (_e3372 < _e3335));
let _e3379 = global_5.member[bitcast<u32>(select(0i, _e3374, (_e3374 > 0i)))];
let _e3380 = local_4;
let _e3385 = (_e3333 + (((_e3320 - _e3290) * _e3202) * _e3207));
let _e3387 = select(_e3335, _e3385, (_e3385 < _e3335));
let _e3392 = global_5.member[bitcast<u32>(select(0i, _e3387, (_e3387 > 0i)))];
let _e3393 = local_4;
let _e3396 = local_5;
let _e3397 = (_e3385 + _e3396);
let _e3399 = select(_e3335, _e3397, (_e3397 < _e3335));
let _e3404 = global_5.member[bitcast<u32>(select(0i, _e3399, (_e3399 > 0i)))];
let _e3405 = local_4;
let _e3409 = (_e3385 + _e3313);
let _e3411 = select(_e3335, _e3409, (_e3409 < _e3335));
let _e3416 = global_5.member[bitcast<u32>(select(0i, _e3411, (_e3411 > 0i)))];
let _e3417 = local_4;
let _e3420 = local_5;
let _e3421 = (_e3409 + _e3420);
let _e3423 = select(_e3335, _e3421, (_e3421 < _e3335));
let _e3428 = global_5.member[bitcast<u32>(select(0i, _e3423, (_e3423 > 0i)))];
let _e3429 = local_4;
let _e3438 = (_e3188 + _e3190);
let _e3448 = (((((_e802 + (_e503 * _e3438)) - _e836.member) / _e3215) * _e3213) - 0.5f);
let _e3450 = select(0f, _e3448, (_e3448 > 0f));
let _e3452 = select(_e3219, _e3450, (_e3450 < _e3219));
let _e3456 = (((((_e803 + (_e514 * _e3438)) - _e836.member_1) / _e3226) * _e3224) - 0.5f);
let _e3458 = select(0f, _e3456, (_e3456 > 0f));
let _e3460 = select(_e3230, _e3458, (_e3458 < _e3230));
let _e3464 = (((((_e804 + (_e525 * _e3438)) - _e836.member_2) / _e3237) * _e3235) - 0.5f);
let _e3466 = select(0f, _e3464, (_e3464 > 0f));
let _e3468 = select(_e3241, _e3466, (_e3466 < _e3241));
let _e3470 = select(0f, _e3452, (_e3452 > 0f));
let _e3472 = select(1e6f, _e3470, (_e3470 < 1e6f));
let _e3479 = select(0i, select(select(i32(_e3472), i32(-2147483648), (_e3472 < -2147483600f)), 2147483647i, (_e3472 > 2147483500f)), (_e3472 == _e3472));
let _e3483 = (_e3479 - select(0i, 1i, (_e3472 < f32(_e3479))));
let _e3485 = select(0f, _e3460, (_e3460 > 0f));
let _e3487 = select(1e6f, _e3485, (_e3485 < 1e6f));
let _e3494 = select(0i, select(select(i32(_e3487), i32(-2147483648), (_e3487 < -2147483600f)), 2147483647i, (_e3487 > 2147483500f)), (_e3487 == _e3487));
let _e3498 = (_e3494 - select(0i, 1i, (_e3487 < f32(_e3494))));
let _e3500 = select(0f, _e3468, (_e3468 > 0f));
let _e3502 = select(1e6f, _e3500, (_e3500 < 1e6f));
let _e3509 = select(0i, select(select(i32(_e3502), i32(-2147483648), (_e3502 < -2147483600f)), 2147483647i, (_e3502 > 2147483500f)), (_e3502 == _e3502));
let _e3513 = (_e3509 - select(0i, 1i, (_e3502 < f32(_e3509))));
let _e3517 = (_e3460 - f32(_e3498));
let _e3519 = (_e3468 - f32(_e3513));
local_2 = (_e3452 - f32(_e3483));
let _e3520 = (_e3483 + 1i);
let _e3522 = select(_e3520, 0i, (_e3520 < 0i));
if (_e3522 >= _e3202) {
phi_5940_ = (_e3202 - 1i);
} else {
phi_5940_ = _e3522;
}
let _e3526 = phi_5940_;
local_3 = (_e3526 - _e3483);
let _e3528 = (_e3498 + 1i);
let _e3530 = select(_e3528, 0i, (_e3528 < 0i));
if (_e3530 >= _e3207) {
phi_5953_ = (_e3207 - 1i);
} else {
phi_5953_ = _e3530;
}
let _e3534 = phi_5953_;
let _e3536 = ((_e3534 - _e3498) * _e3202);
let _e3537 = (_e3513 + 1i);
let _e3539 = select(_e3537, 0i, (_e3537 < 0i));
if (_e3539 >= _e3212) {
phi_5967_ = (_e3212 - 1i);
} else {
phi_5967_ = _e3539;
}
let _e3543 = phi_5967_;
let _e3551 = ((_e3328 + (((_e3513 * _e3207) + _e3498) * _e3202)) + _e3483);
let _e3553 = select(_e3335, _e3551, (_e3551 < _e3335));
let _e3558 = global_5.member[bitcast<u32>(select(0i, _e3553, (_e3553 > 0i)))];
let _e3559 = local_2;
let _e3562 = local_3;
let _e3563 = (_e3551 + _e3562);
let _e3565 = select(_e3335, _e3563, (_e3563 < _e3335));
let _e3570 = global_5.member[bitcast<u32>(select(0i, _e3565, (_e3565 > 0i)))];
let _e3571 = local_2;
let _e3574 = (1f - _e3517);
let _e3576 = (_e3551 + _e3536);
let _e3578 = select(_e3335, _e3576, (_e3576 < _e3335));
let _e3583 = global_5.member[bitcast<u32>(select(0i, _e3578, (_e3578 > 0i)))];
let _e3584 = local_2;
let _e3587 = local_3;
let _e3588 = (_e3576 + _e3587);
let _e3590 = select(_e3335, _e3588, (_e3588 < _e3335));
let _e3595 = global_5.member[bitcast<u32>(select(0i, _e3590, (_e3590 > 0i)))];
let _e3596 = local_2;
let _e3601 = (_e3551 + (((_e3543 - _e3513) * _e3202) * _e3207));
let _e3603 = select(_e3335, _e3601, (_e3601 < _e3335));
let _e3608 = global_5.member[bitcast<u32>(select(0i, _e3603, (_e3603 > 0i)))];
let _e3609 = local_2;
let _e3612 = local_3;
let _e3613 = (_e3601 + _e3612);
let _e3615 = select(_e3335, _e3613, (_e3613 < _e3335));
let _e3620 = global_5.member[bitcast<u32>(select(0i, _e3615, (_e3615 > 0i)))];
let _e3621 = local_2;
let _e3625 = (_e3601 + _e3536);
let _e3627 = select(_e3335, _e3625, (_e3625 < _e3335));
let _e3632 = global_5.member[bitcast<u32>(select(0i, _e3627, (_e3627 > 0i)))];
let _e3633 = local_2;
let _e3636 = local_3;
let _e3637 = (_e3625 + _e3636);
let _e3639 = select(_e3335, _e3637, (_e3637 < _e3335));
let _e3644 = global_5.member[bitcast<u32>(select(0i, _e3639, (_e3639 > 0i)))];
let _e3645 = local_2;
phi_5460_ = (_e3177 + 1u);
phi_5463_ = (_e3179 + ((0.5f * (((((((_e3342 * (1f - _e3343)) + (_e3354 * _e3355)) * _e3358) + (((_e3367 * (1f - _e3368)) + (_e3379 * _e3380)) * _e3294)) * (1f - _e3296)) + (((((_e3392 * (1f - _e3393)) + (_e3404 * _e3405)) * _e3358) + (((_e3416 * (1f - _e3417)) + (_e3428 * _e3429)) * _e3294)) * _e3296)) + ((((((_e3558 * (1f - _e3559)) + (_e3570 * _e3571)) * _e3574) + (((_e3583 * (1f - _e3584)) + (_e3595 * _e3596)) * _e3517)) * (1f - _e3519)) + (((((_e3608 * (1f - _e3609)) + (_e3620 * _e3621)) * _e3574) + (((_e3632 * (1f - _e3633)) + (_e3644 * _e3645)) * _e3517)) * _e3519)))) * _e3189));
} else {
phi_5460_ = u32();
phi_5463_ = f32();
}
let _e3660 = phi_5460_;
let _e3662 = phi_5463_;
continue;
continuing {
phi_5459_ = _e3660;
phi_5462_ = _e3662;
break if !(_e3182);
}
}
let _e4490 = local_58;
phi_6172_ = _e4490;
}
let _e3665 = phi_6172_;
if _e2680 {
phi_6521_ = 1f;
} else {
let _e3675 = global_1.member.member_13.member_7;
let _e3676 = bitcast<i32>(_e3675);
let _e3680 = global_1.member.member_13.member_8;
let _e3681 = bitcast<i32>(_e3680);
let _e3685 = global_1.member.member_13.member_9;
let _e3686 = bitcast<i32>(_e3685);
let _e3687 = f32(_e3676);
let _e3692 = (((((_e802 + (_e503 * _e2656)) - _e836.member) / (_e843.member - _e836.member)) * _e3687) - 0.5f);
let _e3693 = (_e3687 - 1f);
let _e3695 = select(0f, _e3692, (_e3692 > 0f));
let _e3697 = select(_e3693, _e3695, (_e3695 < _e3693));
let _e3698 = f32(_e3681);
let _e3703 = (((((_e803 + (_e514 * _e2656)) - _e836.member_1) / (_e843.member_1 - _e836.member_1)) * _e3698) - 0.5f);
let _e3704 = (_e3698 - 1f);
let _e3706 = select(0f, _e3703, (_e3703 > 0f));
let _e3708 = select(_e3704, _e3706, (_e3706 < _e3704));
let _e3709 = f32(_e3686);
let _e3714 = (((((_e804 + (_e525 * _e2656)) - _e836.member_2) / (_e843.member_2 - _e836.member_2)) * _e3709) - 0.5f);
let _e3715 = (_e3709 - 1f);
let _e3717 = select(0f, _e3714, (_e3714 > 0f));
let _e3719 = select(_e3715, _e3717, (_e3717 < _e3715));
let _e3721 = select(0f, _e3697, (_e3697 > 0f));
let _e3723 = select(1e6f, _e3721, (_e3721 < 1e6f));
let _e3730 = select(0i, select(select(i32(_e3723), i32(-2147483648), (_e3723 < -2147483600f)), 2147483647i, (_e3723 > 2147483500f)), (_e3723 == _e3723));
let _e3734 = (_e3730 - select(0i, 1i, (_e3723 < f32(_e3730))));
let _e3736 = select(0f, _e3708, (_e3708 > 0f));
let _e3738 = select(1e6f, _e3736, (_e3736 < 1e6f));
let _e3745 = select(0i, select(select(i32(_e3738), i32(-2147483648), (_e3738 < -2147483600f)), 2147483647i, (_e3738 > 2147483500f)), (_e3738 == _e3738));
let _e3749 = (_e3745 - select(0i, 1i, (_e3738 < f32(_e3745))));
let _e3751 = select(0f, _e3719, (_e3719 > 0f));
let _e3753 = select(1e6f, _e3751, (_e3751 < 1e6f));
let _e3760 = select(0i, select(select(i32(_e3753), i32(-2147483648), (_e3753 < -2147483600f)), 2147483647i, (_e3753 > 2147483500f)), (_e3753 == _e3753));
let _e3764 = (_e3760 - select(0i, 1i, (_e3753 < f32(_e3760))));
let _e3768 = (_e3708 - f32(_e3749));
let _e3770 = (_e3719 - f32(_e3764));
local = (_e3697 - f32(_e3734));
let _e3771 = (_e3734 + 1i);
let _e3773 = select(_e3771, 0i, (_e3771 < 0i));
if (_e3773 >= _e3676) {
phi_6294_ = (_e3676 - 1i);
} else {
phi_6294_ = _e3773;
}
let _e3777 = phi_6294_;
local_1 = (_e3777 - _e3734);
let _e3779 = (_e3749 + 1i);
let _e3781 = select(_e3779, 0i, (_e3779 < 0i));
if (_e3781 >= _e3681) {
phi_6307_ = (_e3681 - 1i);
} else {
phi_6307_ = _e3781;
}
let _e3785 = phi_6307_;
let _e3787 = ((_e3785 - _e3749) * _e3676);
let _e3788 = (_e3764 + 1i);
let _e3790 = select(_e3788, 0i, (_e3788 < 0i));
if (_e3790 >= _e3686) {
phi_6321_ = (_e3686 - 1i);
} else {
phi_6321_ = _e3790;
}
let _e3794 = phi_6321_;
let _e3801 = global_1.member.member_13.member_10;
let _e3807 = ((bitcast<i32>(_e3801) + (((_e3764 * _e3681) + _e3749) * _e3676)) + _e3734);
let _e3809 = (bitcast<i32>(_e152) - 1i);
let _e3811 = select(_e3809, _e3807, (_e3807 < _e3809));
let _e3816 = global_5.member[bitcast<u32>(select(0i, _e3811, (_e3811 > 0i)))];
let _e3817 = local;
let _e3820 = local_1;
let _e3821 = (_e3807 + _e3820);
let _e3823 = select(_e3809, _e3821, (_e3821 < _e3809));
let _e3828 = global_5.member[bitcast<u32>(select(0i, _e3823, (_e3823 > 0i)))];
let _e3829 = local;
let _e3832 = (1f - _e3768);
let _e3834 = (_e3807 + _e3787);
let _e3836 = select(_e3809, _e3834, (_e3834 < _e3809));
let _e3841 = global_5.member[bitcast<u32>(select(0i, _e3836, (_e3836 > 0i)))];
let _e3842 = local;
let _e3845 = local_1;
let _e3846 = (_e3834 + _e3845);
let _e3848 = select(_e3809, _e3846, (_e3846 < _e3809));
let _e3853 = global_5.member[bitcast<u32>(select(0i, _e3848, (_e3848 > 0i)))];
let _e3854 = local;
let _e3859 = (_e3807 + (((_e3794 - _e3764) * _e3676) * _e3681));
let _e3861 = select(_e3809, _e3859, (_e3859 < _e3809));
let _e3866 = global_5.member[bitcast<u32>(select(0i, _e3861, (_e3861 > 0i)))];
let _e3867 = local;
let _e3870 = local_1;
let _e3871 = (_e3859 + _e3870);
let _e3873 = select(_e3809, _e3871, (_e3871 < _e3809));
let _e3878 = global_5.member[bitcast<u32>(select(0i, _e3873, (_e3873 > 0i)))];
let _e3879 = local;
let _e3883 = (_e3859 + _e3787);
let _e3885 = select(_e3809, _e3883, (_e3883 < _e3809));
let _e3890 = global_5.member[bitcast<u32>(select(0i, _e3885, (_e3885 > 0i)))];
let _e3891 = local;
let _e3894 = local_1;
let _e3895 = (_e3883 + _e3894);
let _e3897 = select(_e3809, _e3895, (_e3895 < _e3809));
let _e3902 = global_5.member[bitcast<u32>(select(0i, _e3897, (_e3897 > 0i)))];
let _e3903 = local;
phi_6521_ = ((((((_e3816 * (1f - _e3817)) + (_e3828 * _e3829)) * _e3832) + (((_e3841 * (1f - _e3842)) + (_e3853 * _e3854)) * _e3768)) * (1f - _e3770)) + (((((_e3866 * (1f - _e3867)) + (_e3878 * _e3879)) * _e3832) + (((_e3890 * (1f - _e3891)) + (_e3902 * _e3903)) * _e3768)) * _e3770));
}
let _e3913 = phi_6521_;
let _e3914 = (_e3172 + _e3665);
let _e3918 = global_1.member.member_13.member;
let _e3923 = -((_e3918.member * _e3914));
let _e3925 = select(-87f, _e3923, (_e3923 > -87f));
let _e3927 = select(88f, _e3925, (_e3925 < 88f));
let _e3929 = ((_e3927 * 1.442695f) + 0.5f);
let _e3931 = select(-127f, _e3929, (_e3929 > -127f));
let _e3933 = select(128f, _e3931, (_e3931 < 128f));
let _e3940 = select(0i, select(select(i32(_e3933), i32(-2147483648), (_e3933 < -2147483600f)), 2147483647i, (_e3933 > 2147483500f)), (_e3933 == _e3933));
let _e3944 = (_e3940 - select(0i, 1i, (_e3933 < f32(_e3940))));
let _e3945 = f32(_e3944);
let _e3949 = ((_e3927 - (_e3945 * 0.6933594f)) - (_e3945 * -2.1219444e-4f));
let _e3971 = -((_e3918.member_1 * _e3914));
let _e3973 = select(-87f, _e3971, (_e3971 > -87f));
let _e3975 = select(88f, _e3973, (_e3973 < 88f));
let _e3977 = ((_e3975 * 1.442695f) + 0.5f);
let _e3979 = select(-127f, _e3977, (_e3977 > -127f));
let _e3981 = select(128f, _e3979, (_e3979 < 128f));
let _e3988 = select(0i, select(select(i32(_e3981), i32(-2147483648), (_e3981 < -2147483600f)), 2147483647i, (_e3981 > 2147483500f)), (_e3981 == _e3981));
let _e3992 = (_e3988 - select(0i, 1i, (_e3981 < f32(_e3988))));
let _e3993 = f32(_e3992);
let _e3997 = ((_e3975 - (_e3993 * 0.6933594f)) - (_e3993 * -2.1219444e-4f));
let _e4019 = -((_e3918.member_2 * _e3914));
let _e4021 = select(-87f, _e4019, (_e4019 > -87f));
let _e4023 = select(88f, _e4021, (_e4021 < 88f));
let _e4025 = ((_e4023 * 1.442695f) + 0.5f);
let _e4027 = select(-127f, _e4025, (_e4025 > -127f));
let _e4029 = select(128f, _e4027, (_e4027 < 128f));
let _e4036 = select(0i, select(select(i32(_e4029), i32(-2147483648), (_e4029 < -2147483600f)), 2147483647i, (_e4029 > 2147483500f)), (_e4029 == _e4029));
let _e4040 = (_e4036 - select(0i, 1i, (_e4029 < f32(_e4036))));
let _e4041 = f32(_e4040);
let _e4045 = ((_e4023 - (_e4041 * 0.6933594f)) - (_e4041 * -2.1219444e-4f));
let _e4066 = -(_e2636);
let _e4070 = global_1.member.member_13.member_2;
let _e4071 = (_e4070 * _e4070);
let _e4075 = ((1f + _e4071) - ((2f * _e4070) * _e4066));
let _e4077 = select(1e-9f, _e4075, (_e4075 > 1e-9f));
let _e4090 = global_1.member.member_13.member_3;
if (_e4090 == 2u) {
let _e4095 = (0.5f - (0.5f * _e4066));
let _e4097 = select(0f, _e4095, (_e4095 > 0f));
let _e4101 = (sqrt(select(0f, _e4097, (_e4097 > 0f))) * 255f);
let _e4102 = (255f - 1f);
let _e4104 = select(0f, _e4101, (_e4101 > 0f));
let _e4106 = select(_e4102, _e4104, (_e4104 < _e4102));
let _e4113 = select(0i, select(select(i32(_e4106), i32(-2147483648), (_e4106 < -2147483600f)), 2147483647i, (_e4106 > 2147483500f)), (_e4106 == _e4106));
let _e4117 = (_e4113 - select(0i, 1i, (_e4106 < f32(_e4113))));
let _e4121 = global_1.member.member_13.member_11;
let _e4122 = bitcast<i32>(_e4121);
let _e4123 = (_e4122 + _e4117);
let _e4125 = (bitcast<i32>(_e152) - 1i);
let _e4127 = select(_e4125, _e4123, (_e4123 < _e4125));
let _e4132 = global_5.member[bitcast<u32>(select(0i, _e4127, (_e4127 > 0i)))];
let _e4134 = (_e4122 + (_e4117 + 1i));
let _e4136 = select(_e4125, _e4134, (_e4134 < _e4125));
let _e4141 = global_5.member[bitcast<u32>(select(0i, _e4136, (_e4136 > 0i)))];
phi_6864_ = (_e4132 + ((_e4141 - _e4132) * (_e4101 - f32(_e4117))));
} else {
phi_6864_ = select(((1f - _e4071) / (_e4077 * sqrt(select(0f, _e4077, (_e4077 > 0f))))), (0.75f * (1f + (_e4066 * _e4066))), (_e4090 == 1u));
}
let _e4148 = phi_6864_;
let _e4151 = (1e-4f * _e2621);
let _e4153 = select(_e2571, _e2542, (_e2542 > _e2571));
let _e4155 = select(_e4151, _e4153, (_e4153 > _e4151));
let _e4157 = select(_e2571, _e2542, (_e2542 < _e2571));
let _e4159 = select(_e4151, _e4157, (_e4157 > _e4151));
let _e4161 = (0.5f * (_e4155 + _e4159));
let _e4162 = (0.5f / _e4159);
let _e4163 = (1f / _e4155);
let _e4165 = (0.5f * _e2621);
let _e4166 = (_e2513 + _e4165);
let _e4167 = -(_e4166);
let _e4170 = (_e4161 - select(_e4167, _e4166, (_e4166 > _e4167)));
let _e4172 = select(0f, _e4170, (_e4170 > 0f));
let _e4174 = select(_e4159, _e4172, (_e4172 < _e4159));
let _e4177 = (_e4170 - _e4159);
let _e4181 = (((_e4174 * (_e4174 * _e4162)) + select(0f, _e4177, (_e4177 > 0f))) * _e4163);
let _e4185 = (_e2513 - _e4165);
let _e4186 = -(_e4185);
let _e4189 = (_e4161 - select(_e4186, _e4185, (_e4185 > _e4186)));
let _e4191 = select(0f, _e4189, (_e4189 > 0f));
let _e4193 = select(_e4159, _e4191, (_e4191 < _e4159));
let _e4196 = (_e4189 - _e4159);
let _e4200 = (((_e4193 * (_e4193 * _e4162)) + select(0f, _e4196, (_e4196 > 0f))) * _e4163);
let _e4207 = (((_e4148 * (0.25f / 3.1415927f)) * ((select(_e4181, (1f - _e4181), (_e4166 >= 0f)) - select(_e4200, (1f - _e4200), (_e4185 >= 0f))) * (1f / _e2621))) * _e3913);
let _e4214 = global_1.member.member_13.member_1;
phi_6983_ = vec3<f32>((((_e2457 * ((1f + (_e3949 * (1f + (_e3949 * (0.5f + (_e3949 * (0.16666667f + (_e3949 * (0.041666668f + (_e3949 * (0.008333334f + (_e3949 * (0.001388889f + (_e3949 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3944 + 127i)) << bitcast<u32>(23i))))) * _e4214.member) * _e4207), (((_e2470 * ((1f + (_e3997 * (1f + (_e3997 * (0.5f + (_e3997 * (0.16666667f + (_e3997 * (0.041666668f + (_e3997 * (0.008333334f + (_e3997 * (0.001388889f + (_e3997 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3992 + 127i)) << bitcast<u32>(23i))))) * _e4214.member_1) * _e4207), (((_e2483 * ((1f + (_e4045 * (1f + (_e4045 * (0.5f + (_e4045 * (0.16666667f + (_e4045 * (0.041666668f + (_e4045 * (0.008333334f + (_e4045 * (0.001388889f + (_e4045 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4040 + 127i)) << bitcast<u32>(23i))))) * _e4214.member_2) * _e4207));
} else {
phi_6983_ = vec3<f32>(0f, 0f, 0f);
}
let _e4226 = phi_6983_;
let _e4227 = select(1f, 0f, _e1103);
let _e4241 = select(0f, 1f, _e1103);
phi_7022_ = vec3<f32>((_e2144.x + (_e4226.x * _e4241)), (_e2144.y + (_e4226.y * _e4241)), (_e2144.z + (_e4226.z * _e4241)));
phi_7023_ = vec3<f32>((_e2146.x + (_e4226.x * _e4227)), (_e2146.y + (_e4226.y * _e4227)), (_e2146.z + (_e4226.z * _e4227)));
}
let _e4253 = phi_7022_;
let _e4255 = phi_7023_;
phi_3807_ = _e4253;
phi_3810_ = _e4255;
phi_3812_ = (_e2148 + 1u);
}
let _e4258 = phi_3807_;
let _e4260 = phi_3810_;
let _e4262 = phi_3812_;
continue;
continuing {
phi_3806_ = _e4258;
phi_3809_ = _e4260;
phi_3811_ = _e4262;
break if !(select(true, false, _e2152));
}
}
let _e4265 = local_34.member_1;
phi_7033_ = type_17(_e1112.member, (_e1112.member_1 + 1u));
loop {
let _e4269 = phi_7033_;
local_61 = _e4269;
let _e4275 = (((_e4269.member_1 & 3u) == 0u) && (_e4269.member < _e4265));
if _e4275 {
phi_7034_ = type_17((_e4269.member + 1u), (_e4269.member_1 >> bitcast<u32>(2i)));
} else {
phi_7034_ = type_17();
}
let _e4281 = phi_7034_;
continue;
continuing {
phi_7033_ = _e4281;
break if !(_e4275);
}
}
let _e4506 = local_59;
phi_7055_ = _e4506;
let _e4509 = local_60;
phi_7056_ = _e4509;
let _e4512 = local_61;
phi_7057_ = _e4512;
}
let _e4288 = phi_7055_;
let _e4290 = phi_7056_;
let _e4292 = phi_7057_;
phi_2159_ = _e4288;
phi_2162_ = _e4290;
phi_2164_ = _e4292;
} else {
phi_2159_ = vec3<f32>();
phi_2162_ = vec3<f32>();
phi_2164_ = type_17();
}
let _e4294 = phi_2159_;
let _e4296 = phi_2162_;
let _e4298 = phi_2164_;
continue;
continuing {
phi_2158_ = _e4294;
phi_2161_ = _e4296;
phi_2163_ = _e4298;
break if !(_e1120);
}
}
let _e4518 = local_62;
phi_1959_ = _e4518;
let _e4521 = local_63;
phi_1962_ = _e4521;
phi_1964_ = (_e941 + 1u);
} else {
phi_1959_ = vec3<f32>();
phi_1962_ = vec3<f32>();
phi_1964_ = u32();
}
let _e4302 = phi_1959_;
let _e4304 = phi_1962_;
let _e4306 = phi_1964_;
continue;
continuing {
phi_1958_ = _e4302;
phi_1961_ = _e4304;
phi_1963_ = _e4306;
break if !(_e946);
}
}
let _e4309 = local_50;
let _e4313 = local_51;
let _e4317 = local_52;
let _e4324 = local_53;
let _e4328 = local_54;
let _e4332 = local_55;
phi_7111_ = array<f32, 22>(_e177, _e187, _e198, _e209, _e220, _e231, _e242, _e253, _e264, (_e275 + (_e4309.x * _e806)), (_e286 + (_e4313.y * _e807)), (_e297 + (_e4317.z * _e808)), (_e308 + (_e4324.x * _e806)), (_e319 + (_e4328.y * _e807)), (_e330 + (_e4332.z * _e808)), _e341, _e352, _e363, _e374, _e385, _e396, _e407);
}
let _e4340 = phi_7111_;
global_6.member[_e166] = _e4340[0];
global_6.member[_e178] = _e4340[1];
global_6.member[_e189] = _e4340[2];
global_6.member[_e200] = _e4340[3];
global_6.member[_e211] = _e4340[4];
global_6.member[_e222] = _e4340[5];
global_6.member[_e233] = _e4340[6];
global_6.member[_e244] = _e4340[7];
global_6.member[_e255] = _e4340[8];
global_6.member[_e266] = _e4340[9];
global_6.member[_e277] = _e4340[10];
global_6.member[_e288] = _e4340[11];
global_6.member[_e299] = _e4340[12];
global_6.member[_e310] = _e4340[13];
global_6.member[_e321] = _e4340[14];
global_6.member[_e332] = _e4340[15];
global_6.member[_e343] = _e4340[16];
global_6.member[_e354] = _e4340[17];
global_6.member[_e365] = _e4340[18];
global_6.member[_e376] = _e4340[19];
global_6.member[_e387] = _e4340[20];
global_6.member[_e398] = _e4340[21];
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
