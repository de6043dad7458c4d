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
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: u32;
var local_17: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var local_21: type_17;
var local_22: u32;
var local_23: type_25;
var local_24: i32;
var local_25: i32;
var phi_1943_: vec3<f32>;
var phi_1946_: vec3<f32>;
var phi_1948_: u32;
var phi_1968_: u32;
var phi_1969_: u32;
var phi_1981_: u32;
var phi_1982_: u32;
var local_26: u32;
var local_27: u32;
var phi_1999_: u32;
var phi_2000_: u32;
var phi_2012_: u32;
var phi_2013_: u32;
var local_28: u32;
var local_29: u32;
var local_30: u32;
var phi_2038_: u32;
var phi_2039_: u32;
var local_31: u32;
var local_32: u32;
var phi_2056_: u32;
var phi_2057_: u32;
var local_33: u32;
var local_34: u32;
var phi_2079_: u32;
var phi_2080_: u32;
var phi_2092_: u32;
var phi_2093_: u32;
var local_35: u32;
var local_36: u32;
var local_37: u32;
var phi_2129_: u32;
var local_38: u32;
var phi_2143_: vec3<f32>;
var phi_2146_: vec3<f32>;
var phi_2148_: type_17;
var phi_2959_: bool;
var phi_2969_: u32;
var phi_2993_: u32;
var phi_2996_: u32;
var phi_3015_: u32;
var phi_3061_: i32;
var phi_2994_: u32;
var phi_2997_: u32;
var phi_3305_: u32;
var phi_3307_: vec3<f32>;
var phi_3310_: vec3<f32>;
var phi_3312_: u32;
var phi_3341_: u32;
var phi_3387_: i32;
var phi_4237_: u32;
var phi_4240_: f32;
var phi_4375_: i32;
var phi_4388_: i32;
var phi_4402_: i32;
var phi_4718_: i32;
var phi_4731_: i32;
var phi_4745_: i32;
var phi_4238_: u32;
var phi_4241_: f32;
var phi_4950_: f32;
var phi_4963_: u32;
var phi_4966_: f32;
var phi_5101_: i32;
var phi_5114_: i32;
var phi_5128_: i32;
var phi_5444_: i32;
var phi_5457_: i32;
var phi_5471_: i32;
var phi_4964_: u32;
var phi_4967_: f32;
var phi_5676_: f32;
var phi_5798_: i32;
var phi_5811_: i32;
var phi_5825_: i32;
var phi_6025_: f32;
var phi_6368_: f32;
var phi_6486_: vec3<f32>;
var phi_6488_: vec3<f32>;
var phi_6489_: bool;
var phi_6532_: vec3<f32>;
var phi_6533_: vec3<f32>;
var phi_3308_: vec3<f32>;
var phi_3311_: vec3<f32>;
var phi_3313_: u32;
var phi_6543_: type_17;
var phi_6544_: type_17;
var phi_6565_: vec3<f32>;
var phi_6566_: vec3<f32>;
var phi_6567_: type_17;
var phi_2144_: vec3<f32>;
var phi_2147_: vec3<f32>;
var phi_2149_: type_17;
var phi_1944_: vec3<f32>;
var phi_1947_: vec3<f32>;
var phi_1949_: u32;
var local_39: vec3<f32>;
var local_40: vec3<f32>;
var local_41: vec3<f32>;
var local_42: vec3<f32>;
var local_43: vec3<f32>;
var local_44: vec3<f32>;
var phi_6621_: array<f32, 22>;
var local_45: u32;
var local_46: f32;
var local_47: f32;
var local_48: vec3<f32>;
var local_49: vec3<f32>;
var local_50: type_17;
var local_51: vec3<f32>;
var local_52: vec3<f32>;
let _e131 = global;
let _e137 = arrayLength((&global_3.member));
let _e143 = arrayLength((&global_5.member));
let _e148 = global_1.member.member;
if (_e131.x < _e148.member) {
if (_e131.y < _e148.member_1) {
let _e155 = (_e148.member * _e148.member_1);
let _e157 = ((_e131.y * _e148.member) + _e131.x);
let _e158 = bitcast<i32>(_e157);
let _e160 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e162 = select(_e160, _e158, (_e158 < _e160));
let _e168 = global_6.member[bitcast<u32>(select(0i, _e162, (_e162 > 0i)))];
let _e169 = (_e155 + _e157);
let _e170 = bitcast<i32>(_e169);
let _e172 = select(_e160, _e170, (_e170 < _e160));
let _e178 = global_6.member[bitcast<u32>(select(0i, _e172, (_e172 > 0i)))];
let _e180 = ((2u * _e155) + _e157);
let _e181 = bitcast<i32>(_e180);
let _e183 = select(_e160, _e181, (_e181 < _e160));
let _e189 = global_6.member[bitcast<u32>(select(0i, _e183, (_e183 > 0i)))];
let _e191 = ((3u * _e155) + _e157);
let _e192 = bitcast<i32>(_e191);
let _e194 = select(_e160, _e192, (_e192 < _e160));
let _e200 = global_6.member[bitcast<u32>(select(0i, _e194, (_e194 > 0i)))];
let _e202 = ((4u * _e155) + _e157);
let _e203 = bitcast<i32>(_e202);
let _e205 = select(_e160, _e203, (_e203 < _e160));
let _e211 = global_6.member[bitcast<u32>(select(0i, _e205, (_e205 > 0i)))];
let _e213 = ((5u * _e155) + _e157);
let _e214 = bitcast<i32>(_e213);
let _e216 = select(_e160, _e214, (_e214 < _e160));
let _e222 = global_6.member[bitcast<u32>(select(0i, _e216, (_e216 > 0i)))];
let _e224 = ((6u * _e155) + _e157);
let _e225 = bitcast<i32>(_e224);
let _e227 = select(_e160, _e225, (_e225 < _e160));
let _e233 = global_6.member[bitcast<u32>(select(0i, _e227, (_e227 > 0i)))];
let _e235 = ((7u * _e155) + _e157);
let _e236 = bitcast<i32>(_e235);
let _e238 = select(_e160, _e236, (_e236 < _e160));
let _e244 = global_6.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e246 = ((8u * _e155) + _e157);
let _e247 = bitcast<i32>(_e246);
let _e249 = select(_e160, _e247, (_e247 < _e160));
let _e255 = global_6.member[bitcast<u32>(select(0i, _e249, (_e249 > 0i)))];
let _e257 = ((9u * _e155) + _e157);
let _e258 = bitcast<i32>(_e257);
let _e260 = select(_e160, _e258, (_e258 < _e160));
let _e266 = global_6.member[bitcast<u32>(select(0i, _e260, (_e260 > 0i)))];
let _e268 = ((10u * _e155) + _e157);
let _e269 = bitcast<i32>(_e268);
let _e271 = select(_e160, _e269, (_e269 < _e160));
let _e277 = global_6.member[bitcast<u32>(select(0i, _e271, (_e271 > 0i)))];
let _e279 = ((11u * _e155) + _e157);
let _e280 = bitcast<i32>(_e279);
let _e282 = select(_e160, _e280, (_e280 < _e160));
let _e288 = global_6.member[bitcast<u32>(select(0i, _e282, (_e282 > 0i)))];
let _e290 = ((12u * _e155) + _e157);
let _e291 = bitcast<i32>(_e290);
let _e293 = select(_e160, _e291, (_e291 < _e160));
let _e299 = global_6.member[bitcast<u32>(select(0i, _e293, (_e293 > 0i)))];
let _e301 = ((13u * _e155) + _e157);
let _e302 = bitcast<i32>(_e301);
let _e304 = select(_e160, _e302, (_e302 < _e160));
let _e310 = global_6.member[bitcast<u32>(select(0i, _e304, (_e304 > 0i)))];
let _e312 = ((14u * _e155) + _e157);
let _e313 = bitcast<i32>(_e312);
let _e315 = select(_e160, _e313, (_e313 < _e160));
let _e321 = global_6.member[bitcast<u32>(select(0i, _e315, (_e315 > 0i)))];
let _e323 = ((15u * _e155) + _e157);
let _e324 = bitcast<i32>(_e323);
let _e326 = select(_e160, _e324, (_e324 < _e160));
let _e332 = global_6.member[bitcast<u32>(select(0i, _e326, (_e326 > 0i)))];
let _e334 = ((16u * _e155) + _e157);
let _e335 = bitcast<i32>(_e334);
let _e337 = select(_e160, _e335, (_e335 < _e160));
let _e343 = global_6.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e345 = ((17u * _e155) + _e157);
let _e346 = bitcast<i32>(_e345);
let _e348 = select(_e160, _e346, (_e346 < _e160));
let _e354 = global_6.member[bitcast<u32>(select(0i, _e348, (_e348 > 0i)))];
let _e356 = ((18u * _e155) + _e157);
let _e357 = bitcast<i32>(_e356);
let _e359 = select(_e160, _e357, (_e357 < _e160));
let _e365 = global_6.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e367 = ((19u * _e155) + _e157);
let _e368 = bitcast<i32>(_e367);
let _e370 = select(_e160, _e368, (_e368 < _e160));
let _e376 = global_6.member[bitcast<u32>(select(0i, _e370, (_e370 > 0i)))];
let _e378 = ((20u * _e155) + _e157);
let _e379 = bitcast<i32>(_e378);
let _e381 = select(_e160, _e379, (_e379 < _e160));
let _e387 = global_6.member[bitcast<u32>(select(0i, _e381, (_e381 > 0i)))];
let _e389 = ((21u * _e155) + _e157);
let _e390 = bitcast<i32>(_e389);
let _e392 = select(_e160, _e390, (_e390 < _e160));
let _e398 = global_6.member[bitcast<u32>(select(0i, _e392, (_e392 > 0i)))];
let _e403 = global_1.member.member.member;
let _e407 = global_1.member.member.member_1;
let _e408 = (_e403 * _e407);
local_24 = bitcast<i32>(_e408);
let _e411 = ((_e131.y * _e403) + _e131.x);
let _e412 = bitcast<i32>(_e411);
local_25 = _e412;
let _e413 = local_24;
let _e415 = local_25;
let _e416 = ((29i * _e413) + _e415);
let _e418 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e420 = select(_e418, _e416, (_e416 < _e418));
let _e425 = global_2.member[bitcast<u32>(select(0i, _e420, (_e420 > 0i)))];
let _e427 = local_24;
let _e429 = local_25;
let _e430 = ((36i * _e427) + _e429);
let _e432 = select(_e418, _e430, (_e430 < _e418));
let _e437 = global_2.member[bitcast<u32>(select(0i, _e432, (_e432 > 0i)))];
let _e448 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e425 == 2f) && (select(0i, select(select(i32(_e437), i32(-2147483648), (_e437 < -2147483600f)), 2147483647i, (_e437 > 2147483500f)), (_e437 == _e437)) == (bitcast<i32>(_e448) + 1i)))) > 1u) {
let _e456 = select(_e418, _e412, (_e412 < _e418));
let _e462 = global_2.member[bitcast<u32>(select(0i, _e456, (_e456 > 0i)))];
let _e464 = bitcast<i32>((_e408 + _e411));
let _e466 = select(_e418, _e464, (_e464 < _e418));
let _e472 = global_2.member[bitcast<u32>(select(0i, _e466, (_e466 > 0i)))];
let _e475 = bitcast<i32>(((2u * _e408) + _e411));
let _e477 = select(_e418, _e475, (_e475 < _e418));
let _e483 = global_2.member[bitcast<u32>(select(0i, _e477, (_e477 > 0i)))];
let _e486 = bitcast<i32>(((3u * _e408) + _e411));
let _e488 = select(_e418, _e486, (_e486 < _e418));
let _e494 = global_2.member[bitcast<u32>(select(0i, _e488, (_e488 > 0i)))];
let _e497 = bitcast<i32>(((4u * _e408) + _e411));
let _e499 = select(_e418, _e497, (_e497 < _e418));
let _e505 = global_2.member[bitcast<u32>(select(0i, _e499, (_e499 > 0i)))];
let _e508 = bitcast<i32>(((5u * _e408) + _e411));
let _e510 = select(_e418, _e508, (_e508 < _e418));
let _e516 = global_2.member[bitcast<u32>(select(0i, _e510, (_e510 > 0i)))];
let _e519 = bitcast<i32>(((6u * _e408) + _e411));
let _e521 = select(_e418, _e519, (_e519 < _e418));
let _e527 = global_2.member[bitcast<u32>(select(0i, _e521, (_e521 > 0i)))];
let _e530 = bitcast<i32>(((7u * _e408) + _e411));
let _e532 = select(_e418, _e530, (_e530 < _e418));
let _e538 = global_2.member[bitcast<u32>(select(0i, _e532, (_e532 > 0i)))];
let _e541 = bitcast<i32>(((8u * _e408) + _e411));
let _e543 = select(_e418, _e541, (_e541 < _e418));
let _e549 = global_2.member[bitcast<u32>(select(0i, _e543, (_e543 > 0i)))];
let _e552 = bitcast<i32>(((9u * _e408) + _e411));
let _e554 = select(_e418, _e552, (_e552 < _e418));
let _e560 = global_2.member[bitcast<u32>(select(0i, _e554, (_e554 > 0i)))];
let _e563 = bitcast<i32>(((10u * _e408) + _e411));
let _e565 = select(_e418, _e563, (_e563 < _e418));
let _e571 = global_2.member[bitcast<u32>(select(0i, _e565, (_e565 > 0i)))];
let _e574 = bitcast<i32>(((11u * _e408) + _e411));
let _e576 = select(_e418, _e574, (_e574 < _e418));
let _e582 = global_2.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e585 = bitcast<i32>(((12u * _e408) + _e411));
let _e587 = select(_e418, _e585, (_e585 < _e418));
let _e593 = global_2.member[bitcast<u32>(select(0i, _e587, (_e587 > 0i)))];
let _e596 = bitcast<i32>(((13u * _e408) + _e411));
let _e598 = select(_e418, _e596, (_e596 < _e418));
let _e604 = global_2.member[bitcast<u32>(select(0i, _e598, (_e598 > 0i)))];
let _e607 = bitcast<i32>(((14u * _e408) + _e411));
let _e609 = select(_e418, _e607, (_e607 < _e418));
let _e615 = global_2.member[bitcast<u32>(select(0i, _e609, (_e609 > 0i)))];
let _e618 = bitcast<i32>(((15u * _e408) + _e411));
let _e620 = select(_e418, _e618, (_e618 < _e418));
let _e626 = global_2.member[bitcast<u32>(select(0i, _e620, (_e620 > 0i)))];
let _e629 = bitcast<i32>(((16u * _e408) + _e411));
let _e631 = select(_e418, _e629, (_e629 < _e418));
let _e637 = global_2.member[bitcast<u32>(select(0i, _e631, (_e631 > 0i)))];
let _e640 = bitcast<i32>(((17u * _e408) + _e411));
let _e642 = select(_e418, _e640, (_e640 < _e418));
let _e648 = global_2.member[bitcast<u32>(select(0i, _e642, (_e642 > 0i)))];
let _e651 = bitcast<i32>(((18u * _e408) + _e411));
let _e653 = select(_e418, _e651, (_e651 < _e418));
let _e659 = global_2.member[bitcast<u32>(select(0i, _e653, (_e653 > 0i)))];
let _e662 = bitcast<i32>(((19u * _e408) + _e411));
let _e664 = select(_e418, _e662, (_e662 < _e418));
let _e670 = global_2.member[bitcast<u32>(select(0i, _e664, (_e664 > 0i)))];
let _e673 = bitcast<i32>(((20u * _e408) + _e411));
let _e675 = select(_e418, _e673, (_e673 < _e418));
let _e681 = global_2.member[bitcast<u32>(select(0i, _e675, (_e675 > 0i)))];
let _e684 = bitcast<i32>(((24u * _e408) + _e411));
let _e686 = select(_e418, _e684, (_e684 < _e418));
let _e692 = global_2.member[bitcast<u32>(select(0i, _e686, (_e686 > 0i)))];
let _e695 = bitcast<i32>(((30u * _e408) + _e411));
let _e697 = select(_e418, _e695, (_e695 < _e418));
let _e703 = global_2.member[bitcast<u32>(select(0i, _e697, (_e697 > 0i)))];
let _e711 = (select(0i, select(select(i32(_e703), i32(-2147483648), (_e703 < -2147483600f)), 2147483647i, (_e703 > 2147483500f)), (_e703 == _e703)) == 0i);
let _e719 = global_1.member.member_1.member;
let _e725 = global_1.member.member_1.member_1;
let _e735 = global_1.member.member_2.member;
let _e736 = (((((f32(bitcast<i32>(_e131.x)) + 0.5f) / f32(bitcast<i32>(_e719))) * 2f) - 1f) * _e735);
let _e744 = global_1.member.member_2.member_1;
let _e745 = ((1f - (((f32(bitcast<i32>(_e131.y)) + 0.5f) / f32(bitcast<i32>(_e725))) * 2f)) * _e744);
let _e748 = global_1.member.member_3;
let _e757 = global_1.member.member_4;
let _e770 = global_1.member.member_2.member_3;
let _e771 = (_e770 != 0u);
let _e774 = global_1.member.member_6;
let _e781 = select(_e774.member, (_e774.member + ((_e748.member * _e736) + (_e757.member * _e745))), _e771);
let _e782 = select(_e774.member_1, (_e774.member_1 + ((_e748.member_1 * _e736) + (_e757.member_1 * _e745))), _e771);
let _e783 = select(_e774.member_2, (_e774.member_2 + ((_e748.member_2 * _e736) + (_e757.member_2 * _e745))), _e771);
let _e793 = select(_e462, _e781, _e711);
let _e794 = select(_e472, _e782, _e711);
let _e795 = select(_e483, _e783, _e711);
let _e796 = (select(0f, ((((_e462 - _e781) * _e494) + ((_e472 - _e782) * _e505)) + ((_e483 - _e783) * _e516)), _e711) + _e692);
let _e797 = select(_e659, 1f, _e711);
let _e798 = select(_e670, 1f, _e711);
let _e799 = select(_e681, 1f, _e711);
let _e807 = (1f / select(_e494, select(1e-12f, -1e-12f, (_e494 < 0f)), (bitcast<f32>((bitcast<u32>(_e494) & 2147483647u)) < 1e-12f)));
let _e815 = (1f / select(_e505, select(1e-12f, -1e-12f, (_e505 < 0f)), (bitcast<f32>((bitcast<u32>(_e505) & 2147483647u)) < 1e-12f)));
let _e823 = (1f / select(_e516, select(1e-12f, -1e-12f, (_e516 < 0f)), (bitcast<f32>((bitcast<u32>(_e516) & 2147483647u)) < 1e-12f)));
let _e827 = global_1.member.member_13.member_4;
let _e834 = global_1.member.member_13.member_5;
let _e839 = ((_e827.member - _e793) * _e807);
let _e841 = ((_e834.member - _e793) * _e807);
let _e843 = ((_e827.member_1 - _e794) * _e815);
let _e845 = ((_e834.member_1 - _e794) * _e815);
let _e847 = ((_e827.member_2 - _e795) * _e823);
let _e849 = ((_e834.member_2 - _e795) * _e823);
let _e851 = select(_e841, _e839, (_e839 < _e841));
let _e853 = select(_e845, _e843, (_e843 < _e845));
let _e855 = select(_e853, _e851, (_e851 > _e853));
let _e857 = select(_e849, _e847, (_e847 < _e849));
let _e859 = select(_e857, _e855, (_e855 > _e857));
let _e861 = select(_e841, _e839, (_e839 > _e841));
let _e863 = select(_e845, _e843, (_e843 > _e845));
let _e865 = select(_e863, _e861, (_e861 < _e863));
let _e867 = select(_e849, _e847, (_e847 > _e849));
let _e869 = select(_e867, _e865, (_e865 < _e867));
let _e871 = select(0f, _e859, (_e859 > 0f));
let _e873 = select(_e796, _e869, (_e869 < _e796));
let _e874 = (_e873 > _e871);
let _e875 = select(0f, _e871, _e874);
let _e876 = select(0f, _e873, _e874);
if ((_e711 || (_e876 <= _e875)) || ((((_e797 + _e798) + _e799) * (1f / 3f)) < 0.01f)) {
phi_6621_ = array<f32, 22>(_e168, _e178, _e189, _e200, _e211, _e222, _e233, _e244, _e255, _e266, _e277, _e288, _e299, _e310, _e321, _e332, _e343, _e354, _e365, _e376, _e387, _e398);
} else {
let _e889 = (((_e527 * _e527) + (_e538 * _e538)) + (_e549 * _e549));
let _e897 = (((_e560 * _e560) + (_e571 * _e571)) + (_e582 * _e582));
let _e902 = (0.5f * (sqrt(select(0f, _e889, (_e889 > 0f))) + sqrt(select(0f, _e897, (_e897 > 0f)))));
let _e907 = (((_e593 * _e593) + (_e604 * _e604)) + (_e615 * _e615));
let _e915 = (((_e626 * _e626) + (_e637 * _e637)) + (_e648 * _e648));
let _e920 = (0.5f * (sqrt(select(0f, _e907, (_e907 > 0f))) + sqrt(select(0f, _e915, (_e915 > 0f)))));
let _e924 = global_1.member.member_11.member;
let _e926 = bitcast<i32>((_e924 * _e924));
phi_1943_ = vec3<f32>(0f, 0f, 0f);
phi_1946_ = vec3<f32>(0f, 0f, 0f);
phi_1948_ = 0u;
loop {
let _e928 = phi_1943_;
let _e930 = phi_1946_;
let _e932 = phi_1948_;
local_39 = _e930;
local_40 = _e930;
local_41 = _e930;
local_42 = _e928;
local_43 = _e928;
local_44 = _e928;
let _e936 = global_1.member.member_12.member_9;
let _e937 = (_e932 <= _e936);
if _e937 {
let _e941 = global_1.member.member_12.member_6;
let _e943 = bitcast<i32>((_e932 * _e941));
phi_1968_ = 0u;
loop {
let _e945 = phi_1968_;
local_38 = _e945;
let _e949 = ((1u << bitcast<u32>((_e945 & 31u))) < _e924);
if _e949 {
phi_1969_ = (_e945 + 1u);
} else {
phi_1969_ = u32();
}
let _e952 = phi_1969_;
continue;
continuing {
phi_1968_ = _e952;
break if !(_e949);
}
}
phi_1981_ = 0u;
loop {
let _e955 = phi_1981_;
local_26 = _e955;
local_27 = _e955;
let _e959 = ((1u << bitcast<u32>((_e955 & 31u))) < _e924);
if _e959 {
phi_1982_ = (_e955 + 1u);
} else {
phi_1982_ = u32();
}
let _e962 = phi_1982_;
continue;
continuing {
phi_1981_ = _e962;
break if !(_e959);
}
}
let _e965 = local_26;
let _e968 = local_27;
phi_1999_ = 0u;
loop {
let _e971 = phi_1999_;
local_30 = _e971;
let _e975 = ((1u << bitcast<u32>((_e971 & 31u))) < _e924);
if _e975 {
phi_2000_ = (_e971 + 1u);
} else {
phi_2000_ = u32();
}
let _e978 = phi_2000_;
continue;
continuing {
phi_1999_ = _e978;
break if !(_e975);
}
}
phi_2012_ = 0u;
loop {
let _e981 = phi_2012_;
local_28 = _e981;
local_29 = _e981;
let _e985 = ((1u << bitcast<u32>((_e981 & 31u))) < _e924);
if _e985 {
phi_2013_ = (_e981 + 1u);
} else {
phi_2013_ = u32();
}
let _e988 = phi_2013_;
continue;
continuing {
phi_2012_ = _e988;
break if !(_e985);
}
}
let _e991 = local_28;
let _e994 = local_29;
let _e997 = local_30;
let _e1006 = global_1.member.member_12.member_8;
phi_2038_ = 0u;
loop {
let _e1009 = phi_2038_;
local_31 = _e1009;
local_32 = _e1009;
let _e1013 = ((1u << bitcast<u32>((_e1009 & 31u))) < _e924);
if _e1013 {
phi_2039_ = (_e1009 + 1u);
} else {
phi_2039_ = u32();
}
let _e1016 = phi_2039_;
continue;
continuing {
phi_2038_ = _e1016;
break if !(_e1013);
}
}
let _e1019 = local_31;
let _e1022 = local_32;
phi_2056_ = 0u;
loop {
let _e1025 = phi_2056_;
local_33 = _e1025;
local_34 = _e1025;
let _e1029 = ((1u << bitcast<u32>((_e1025 & 31u))) < _e924);
if _e1029 {
phi_2057_ = (_e1025 + 1u);
} else {
phi_2057_ = u32();
}
let _e1032 = phi_2057_;
continue;
continuing {
phi_2056_ = _e1032;
break if !(_e1029);
}
}
let _e1035 = local_33;
let _e1041 = local_34;
phi_2079_ = 0u;
loop {
let _e1051 = phi_2079_;
local_37 = _e1051;
let _e1055 = ((1u << bitcast<u32>((_e1051 & 31u))) < _e924);
if _e1055 {
phi_2080_ = (_e1051 + 1u);
} else {
phi_2080_ = u32();
}
let _e1058 = phi_2080_;
continue;
continuing {
phi_2079_ = _e1058;
break if !(_e1055);
}
}
phi_2092_ = 0u;
loop {
let _e1061 = phi_2092_;
local_35 = _e1061;
local_36 = _e1061;
let _e1065 = ((1u << bitcast<u32>((_e1061 & 31u))) < _e924);
if _e1065 {
phi_2093_ = (_e1061 + 1u);
} else {
phi_2093_ = u32();
}
let _e1068 = phi_2093_;
continue;
continuing {
phi_2092_ = _e1068;
break if !(_e1065);
}
}
let _e1071 = local_35;
let _e1074 = local_36;
let _e1077 = local_37;
let _e1083 = (((((1u << bitcast<u32>(((2u * _e1035) & 31u))) - (1u << bitcast<u32>(((2u * (_e1041 - select(6u, _e1022, (_e1019 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1077 - select(6u, _e1074, (_e1071 < 6u)))) & 31u))));
let _e1084 = (_e1083 / 64u);
if ((_e1083 % 64u) > 0u) {
phi_2129_ = (_e1084 + 1u);
} else {
phi_2129_ = _e1084;
}
let _e1089 = phi_2129_;
let _e1092 = local_38;
local_23 = type_25(_e1092, select(6u, _e968, (_e965 < 6u)), (1u << bitcast<u32>(((2u * (_e997 - select(6u, _e994, (_e991 < 6u)))) & 31u))), (_e932 * _e1006), (_e1089 * 64u));
let _e1094 = (_e932 == 0u);
let _e1096 = local_23.member_1;
phi_2143_ = _e928;
phi_2146_ = _e930;
phi_2148_ = type_17(_e1096, 0u);
loop {
let _e1099 = phi_2143_;
let _e1101 = phi_2146_;
let _e1103 = phi_2148_;
local_51 = _e1099;
local_52 = _e1101;
let _e1106 = local_23.member_1;
let _e1109 = local_23.member_2;
let _e1111 = ((_e1103.member < _e1106) || (_e1103.member_1 < _e1109));
if _e1111 {
local_21.member = _e1103.member;
local_21.member_1 = _e1103.member_1;
let _e1114 = local_21.member;
let _e1115 = local_21.member_1;
let _e1117 = local_23.member;
let _e1132 = local_23.member_3;
local_22 = (_e1132 + (((((1u << bitcast<u32>(((2u * _e1117) & 31u))) - (1u << bitcast<u32>(((2u * (_e1117 - _e1114)) & 31u)))) / 3u) * 4u) + _e1115));
let _e1134 = local_22;
let _e1135 = bitcast<i32>(_e1134);
let _e1137 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1139 = select(_e1137, _e1135, (_e1135 < _e1137));
let _e1144 = global_4.member[bitcast<u32>(select(0i, _e1139, (_e1139 > 0i)))];
let _e1145 = local_22;
let _e1147 = local_23.member_4;
let _e1149 = bitcast<i32>((_e1145 + _e1147));
let _e1151 = select(_e1137, _e1149, (_e1149 < _e1137));
let _e1156 = global_4.member[bitcast<u32>(select(0i, _e1151, (_e1151 > 0i)))];
let _e1157 = local_22;
let _e1158 = local_23.member_4;
let _e1161 = bitcast<i32>((_e1157 + (2u * _e1158)));
let _e1163 = select(_e1137, _e1161, (_e1161 < _e1137));
let _e1168 = global_4.member[bitcast<u32>(select(0i, _e1163, (_e1163 > 0i)))];
let _e1169 = local_21.member;
let _e1170 = local_21.member_1;
let _e1171 = local_23.member;
let _e1185 = local_23.member_3;
let _e1186 = local_23.member_4;
local_20 = ((_e1185 + (3u * _e1186)) + (((((1u << bitcast<u32>(((2u * _e1171) & 31u))) - (1u << bitcast<u32>(((2u * (_e1171 - _e1169)) & 31u)))) / 3u) * 4u) + _e1170));
let _e1190 = local_20;
let _e1191 = bitcast<i32>(_e1190);
let _e1193 = select(_e1137, _e1191, (_e1191 < _e1137));
let _e1198 = global_4.member[bitcast<u32>(select(0i, _e1193, (_e1193 > 0i)))];
let _e1199 = local_20;
let _e1200 = local_23.member_4;
let _e1202 = bitcast<i32>((_e1199 + _e1200));
let _e1204 = select(_e1137, _e1202, (_e1202 < _e1137));
let _e1209 = global_4.member[bitcast<u32>(select(0i, _e1204, (_e1204 > 0i)))];
let _e1210 = local_20;
let _e1211 = local_23.member_4;
let _e1214 = bitcast<i32>((_e1210 + (2u * _e1211)));
let _e1216 = select(_e1137, _e1214, (_e1214 < _e1137));
let _e1221 = global_4.member[bitcast<u32>(select(0i, _e1216, (_e1216 > 0i)))];
let _e1223 = ((_e1144 - _e793) * _e807);
let _e1225 = ((_e1198 - _e793) * _e807);
let _e1227 = ((_e1156 - _e794) * _e815);
let _e1229 = ((_e1209 - _e794) * _e815);
let _e1231 = ((_e1168 - _e795) * _e823);
let _e1233 = ((_e1221 - _e795) * _e823);
let _e1235 = select(_e1225, _e1223, (_e1223 < _e1225));
let _e1237 = select(_e1229, _e1227, (_e1227 < _e1229));
let _e1239 = select(_e1237, _e1235, (_e1235 > _e1237));
let _e1241 = select(_e1233, _e1231, (_e1231 < _e1233));
let _e1243 = select(_e1241, _e1239, (_e1239 > _e1241));
let _e1245 = select(_e1225, _e1223, (_e1223 > _e1225));
let _e1247 = select(_e1229, _e1227, (_e1227 > _e1229));
let _e1249 = select(_e1247, _e1245, (_e1245 < _e1247));
let _e1251 = select(_e1233, _e1231, (_e1231 > _e1233));
let _e1253 = select(_e1251, _e1249, (_e1249 < _e1251));
if ((_e1144 <= _e1198) && (select(_e875, _e1243, (_e1243 > _e875)) <= select(_e876, _e1253, (_e1253 < _e876)))) {
let _e1261 = local_21.member;
let _e1262 = local_21.member_1;
let _e1263 = local_23.member;
let _e1277 = local_23.member_3;
let _e1278 = local_23.member_4;
local_19 = ((_e1277 + (6u * _e1278)) + (((((1u << bitcast<u32>(((2u * _e1263) & 31u))) - (1u << bitcast<u32>(((2u * (_e1263 - _e1261)) & 31u)))) / 3u) * 4u) + _e1262));
let _e1282 = local_19;
let _e1283 = bitcast<i32>(_e1282);
let _e1285 = select(_e1137, _e1283, (_e1283 < _e1137));
let _e1290 = global_4.member[bitcast<u32>(select(0i, _e1285, (_e1285 > 0i)))];
let _e1291 = local_19;
let _e1292 = local_23.member_4;
let _e1294 = bitcast<i32>((_e1291 + _e1292));
let _e1296 = select(_e1137, _e1294, (_e1294 < _e1137));
let _e1301 = global_4.member[bitcast<u32>(select(0i, _e1296, (_e1296 > 0i)))];
let _e1302 = local_19;
let _e1303 = local_23.member_4;
let _e1306 = bitcast<i32>((_e1302 + (2u * _e1303)));
let _e1308 = select(_e1137, _e1306, (_e1306 < _e1137));
let _e1313 = global_4.member[bitcast<u32>(select(0i, _e1308, (_e1308 > 0i)))];
let _e1314 = local_21.member;
let _e1315 = local_21.member_1;
let _e1316 = local_23.member;
let _e1330 = local_23.member_3;
let _e1331 = local_23.member_4;
local_18 = ((_e1330 + (9u * _e1331)) + (((((1u << bitcast<u32>(((2u * _e1316) & 31u))) - (1u << bitcast<u32>(((2u * (_e1316 - _e1314)) & 31u)))) / 3u) * 4u) + _e1315));
let _e1335 = local_18;
let _e1336 = bitcast<i32>(_e1335);
let _e1338 = select(_e1137, _e1336, (_e1336 < _e1137));
let _e1343 = global_4.member[bitcast<u32>(select(0i, _e1338, (_e1338 > 0i)))];
let _e1344 = local_18;
let _e1345 = local_23.member_4;
let _e1347 = bitcast<i32>((_e1344 + _e1345));
let _e1349 = select(_e1137, _e1347, (_e1347 < _e1137));
let _e1354 = global_4.member[bitcast<u32>(select(0i, _e1349, (_e1349 > 0i)))];
let _e1355 = local_18;
let _e1356 = local_23.member_4;
let _e1359 = bitcast<i32>((_e1355 + (2u * _e1356)));
let _e1361 = select(_e1137, _e1359, (_e1359 < _e1137));
let _e1366 = global_4.member[bitcast<u32>(select(0i, _e1361, (_e1361 > 0i)))];
let _e1367 = local_21.member;
let _e1368 = local_21.member_1;
let _e1369 = local_23.member;
let _e1383 = local_23.member_3;
let _e1384 = local_23.member_4;
local_17 = ((_e1383 + (12u * _e1384)) + (((((1u << bitcast<u32>(((2u * _e1369) & 31u))) - (1u << bitcast<u32>(((2u * (_e1369 - _e1367)) & 31u)))) / 3u) * 4u) + _e1368));
let _e1388 = local_17;
let _e1389 = bitcast<i32>(_e1388);
let _e1391 = select(_e1137, _e1389, (_e1389 < _e1137));
let _e1396 = global_4.member[bitcast<u32>(select(0i, _e1391, (_e1391 > 0i)))];
let _e1397 = local_17;
let _e1398 = local_23.member_4;
let _e1400 = bitcast<i32>((_e1397 + _e1398));
let _e1402 = select(_e1137, _e1400, (_e1400 < _e1137));
let _e1407 = global_4.member[bitcast<u32>(select(0i, _e1402, (_e1402 > 0i)))];
let _e1408 = local_17;
let _e1409 = local_23.member_4;
let _e1412 = bitcast<i32>((_e1408 + (2u * _e1409)));
let _e1414 = select(_e1137, _e1412, (_e1412 < _e1137));
let _e1419 = global_4.member[bitcast<u32>(select(0i, _e1414, (_e1414 > 0i)))];
let _e1420 = local_21.member;
let _e1421 = local_21.member_1;
let _e1422 = local_23.member;
let _e1436 = local_23.member_3;
let _e1437 = local_23.member_4;
local_16 = ((_e1436 + (15u * _e1437)) + (((((1u << bitcast<u32>(((2u * _e1422) & 31u))) - (1u << bitcast<u32>(((2u * (_e1422 - _e1420)) & 31u)))) / 3u) * 4u) + _e1421));
let _e1441 = local_16;
let _e1442 = bitcast<i32>(_e1441);
let _e1444 = select(_e1137, _e1442, (_e1442 < _e1137));
let _e1449 = global_4.member[bitcast<u32>(select(0i, _e1444, (_e1444 > 0i)))];
let _e1450 = local_16;
let _e1451 = local_23.member_4;
let _e1453 = bitcast<i32>((_e1450 + _e1451));
let _e1455 = select(_e1137, _e1453, (_e1453 < _e1137));
let _e1460 = global_4.member[bitcast<u32>(select(0i, _e1455, (_e1455 > 0i)))];
let _e1461 = local_16;
let _e1462 = local_23.member_4;
let _e1465 = bitcast<i32>((_e1461 + (2u * _e1462)));
let _e1467 = select(_e1137, _e1465, (_e1465 < _e1137));
let _e1472 = global_4.member[bitcast<u32>(select(0i, _e1467, (_e1467 > 0i)))];
let _e1473 = (_e1290 - _e793);
let _e1474 = (_e1301 - _e794);
let _e1475 = (_e1313 - _e795);
let _e1478 = ((_e1407 * _e516) - (_e1419 * _e505));
let _e1481 = ((_e1419 * _e494) - (_e1396 * _e516));
let _e1484 = ((_e1396 * _e505) - (_e1407 * _e494));
let _e1532 = (((_e1343 * _e1343) + (_e1354 * _e1354)) + (_e1366 * _e1366));
let _e1535 = sqrt(select(0f, _e1532, (_e1532 > 0f)));
let _e1540 = (((_e1449 * _e1449) + (_e1460 * _e1460)) + (_e1472 * _e1472));
let _e1550 = (((_e1473 * _e1473) + (_e1474 * _e1474)) + (_e1475 * _e1475));
phi_2959_ = (bitcast<f32>((bitcast<u32>((((_e1473 * _e1478) + (_e1474 * _e1481)) + (_e1475 * _e1484))) & 2147483647u)) <= ((((((bitcast<f32>((bitcast<u32>(_e1478) & 2147483647u)) * _e1343) + (bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u)) * _e1354)) + (bitcast<f32>((bitcast<u32>(_e1484) & 2147483647u)) * _e1366)) + (((bitcast<f32>((bitcast<u32>(((_e505 * _e1475) - (_e516 * _e1474))) & 2147483647u)) * _e1449) + (bitcast<f32>((bitcast<u32>(((_e516 * _e1473) - (_e494 * _e1475))) & 2147483647u)) * _e1460)) + (bitcast<f32>((bitcast<u32>(((_e494 * _e1474) - (_e505 * _e1473))) & 2147483647u)) * _e1472))) + (_e1535 * sqrt(select(0f, _e1540, (_e1540 > 0f))))) + (_e902 + (_e920 * (sqrt(select(0f, _e1550, (_e1550 > 0f))) + _e1535)))));
} else {
phi_2959_ = false;
}
let _e1563 = phi_2959_;
let _e1564 = local_23.member_1;
if (_e1564 < 2u) {
let _e1566 = local_23.member_1;
phi_2969_ = _e1566;
} else {
phi_2969_ = 2u;
}
let _e1568 = phi_2969_;
if (_e1563 && (_e1103.member > _e1568)) {
phi_6565_ = _e1099;
phi_6566_ = _e1101;
phi_6567_ = type_17((_e1103.member - 1u), (_e1103.member_1 << bitcast<u32>(2i)));
} else {
if _e1563 {
phi_2993_ = 0u;
phi_2996_ = 0u;
loop {
let _e1572 = phi_2993_;
let _e1574 = phi_2996_;
local_45 = _e1574;
let _e1575 = (_e1572 < 16u);
if _e1575 {
let _e1576 = local_23.member_1;
if (_e1576 < 2u) {
let _e1578 = local_23.member_1;
phi_3015_ = _e1578;
} else {
phi_3015_ = 2u;
}
let _e1580 = phi_3015_;
let _e1582 = ((2u * _e1580) & 31u);
let _e1585 = ((_e1103.member_1 << bitcast<u32>(_e1582)) + _e1572);
let _e1586 = (_e1585 & 1431655765u);
let _e1590 = ((_e1586 | (_e1586 >> bitcast<u32>(1i))) & 858993459u);
let _e1594 = ((_e1590 | (_e1590 >> bitcast<u32>(2i))) & 252645135u);
let _e1598 = ((_e1594 | (_e1594 >> bitcast<u32>(4i))) & 16711935u);
let _e1602 = ((_e1598 | (_e1598 >> bitcast<u32>(8i))) & 65535u);
let _e1605 = ((_e1585 >> bitcast<u32>(1i)) & 1431655765u);
let _e1609 = ((_e1605 | (_e1605 >> bitcast<u32>(1i))) & 858993459u);
let _e1613 = ((_e1609 | (_e1609 >> bitcast<u32>(2i))) & 252645135u);
let _e1617 = ((_e1613 | (_e1613 >> bitcast<u32>(4i))) & 16711935u);
let _e1621 = ((_e1617 | (_e1617 >> bitcast<u32>(8i))) & 65535u);
let _e1628 = (((_e1572 < (1u << bitcast<u32>(_e1582))) && (_e1602 < _e924)) && (_e1621 < _e924));
if _e1628 {
phi_3061_ = bitcast<i32>(((_e1621 * _e924) + _e1602));
} else {
phi_3061_ = 0i;
}
let _e1633 = phi_3061_;
local_13 = _e943;
local_14 = _e1633;
local_15 = _e926;
let _e1634 = local_13;
let _e1635 = local_14;
let _e1636 = (_e1634 + _e1635);
let _e1638 = (bitcast<i32>(_e137) - 1i);
let _e1640 = select(_e1638, _e1636, (_e1636 < _e1638));
let _e1645 = global_3.member[bitcast<u32>(select(0i, _e1640, (_e1640 > 0i)))];
let _e1646 = local_13;
let _e1647 = local_15;
let _e1649 = local_14;
let _e1650 = ((_e1646 + _e1647) + _e1649);
let _e1652 = select(_e1638, _e1650, (_e1650 < _e1638));
let _e1657 = global_3.member[bitcast<u32>(select(0i, _e1652, (_e1652 > 0i)))];
let _e1658 = local_13;
let _e1659 = local_15;
let _e1662 = local_14;
let _e1663 = ((_e1658 + (2i * _e1659)) + _e1662);
let _e1665 = select(_e1638, _e1663, (_e1663 < _e1638));
let _e1670 = global_3.member[bitcast<u32>(select(0i, _e1665, (_e1665 > 0i)))];
let _e1671 = local_13;
let _e1672 = local_15;
let _e1675 = local_14;
let _e1676 = ((_e1671 + (3i * _e1672)) + _e1675);
let _e1678 = select(_e1638, _e1676, (_e1676 < _e1638));
let _e1683 = global_3.member[bitcast<u32>(select(0i, _e1678, (_e1678 > 0i)))];
let _e1684 = local_13;
let _e1685 = local_15;
let _e1688 = local_14;
let _e1689 = ((_e1684 + (4i * _e1685)) + _e1688);
let _e1691 = select(_e1638, _e1689, (_e1689 < _e1638));
let _e1696 = global_3.member[bitcast<u32>(select(0i, _e1691, (_e1691 > 0i)))];
let _e1697 = local_13;
let _e1698 = local_15;
let _e1701 = local_14;
let _e1702 = ((_e1697 + (5i * _e1698)) + _e1701);
let _e1704 = select(_e1638, _e1702, (_e1702 < _e1638));
let _e1709 = global_3.member[bitcast<u32>(select(0i, _e1704, (_e1704 > 0i)))];
let _e1710 = (_e1645 - _e793);
let _e1711 = (_e1657 - _e794);
let _e1712 = (_e1670 - _e795);
let _e1731 = (((_e1710 * _e1710) + (_e1711 * _e1711)) + (_e1712 * _e1712));
let _e1735 = local_13;
let _e1736 = local_15;
let _e1739 = local_14;
let _e1740 = ((_e1735 + (21i * _e1736)) + _e1739);
let _e1742 = select(_e1638, _e1740, (_e1740 < _e1638));
let _e1747 = global_3.member[bitcast<u32>(select(0i, _e1742, (_e1742 > 0i)))];
let _e1752 = local_13;
let _e1753 = local_15;
let _e1756 = local_14;
let _e1757 = ((_e1752 + (22i * _e1753)) + _e1756);
let _e1759 = select(_e1638, _e1757, (_e1757 < _e1638));
let _e1764 = global_3.member[bitcast<u32>(select(0i, _e1759, (_e1759 > 0i)))];
phi_2994_ = (_e1572 + 1u);
phi_2997_ = (_e1574 | (select(0u, 1u, (_e1628 && (bitcast<f32>((bitcast<u32>((((_e494 * ((_e1711 * _e1709) - (_e1712 * _e1696))) + (_e505 * ((_e1712 * _e1683) - (_e1710 * _e1709)))) + (_e516 * ((_e1710 * _e1696) - (_e1711 * _e1683))))) & 2147483647u)) <= ((_e1747 + _e902) + ((_e1764 + _e920) * sqrt(select(0f, _e1731, (_e1731 > 0f)))))))) << bitcast<u32>((_e1572 & 31u))));
} else {
phi_2994_ = u32();
phi_2997_ = u32();
}
let _e1777 = phi_2994_;
let _e1779 = phi_2997_;
continue;
continuing {
phi_2993_ = _e1777;
phi_2996_ = _e1779;
break if !(_e1575);
}
}
let _e4099 = local_45;
phi_3305_ = _e4099;
} else {
phi_3305_ = 0u;
}
let _e1782 = phi_3305_;
phi_3307_ = _e1099;
phi_3310_ = _e1101;
phi_3312_ = 0u;
loop {
let _e1784 = phi_3307_;
let _e1786 = phi_3310_;
let _e1788 = phi_3312_;
local_48 = _e1784;
local_49 = _e1786;
let _e1791 = (_e1782 >> bitcast<u32>((_e1788 & 31u)));
let _e1792 = (_e1791 == 0u);
if _e1792 {
phi_3308_ = vec3<f32>();
phi_3311_ = vec3<f32>();
phi_3313_ = u32();
} else {
if ((_e1791 & 1u) == 0u) {
phi_6532_ = _e1784;
phi_6533_ = _e1786;
} else {
let _e1795 = local_23.member_1;
if (_e1795 < 2u) {
let _e1797 = local_23.member_1;
phi_3341_ = _e1797;
} else {
phi_3341_ = 2u;
}
let _e1799 = phi_3341_;
let _e1801 = ((2u * _e1799) & 31u);
let _e1804 = ((_e1103.member_1 << bitcast<u32>(_e1801)) + _e1788);
let _e1805 = (_e1804 & 1431655765u);
let _e1809 = ((_e1805 | (_e1805 >> bitcast<u32>(1i))) & 858993459u);
let _e1813 = ((_e1809 | (_e1809 >> bitcast<u32>(2i))) & 252645135u);
let _e1817 = ((_e1813 | (_e1813 >> bitcast<u32>(4i))) & 16711935u);
let _e1821 = ((_e1817 | (_e1817 >> bitcast<u32>(8i))) & 65535u);
let _e1824 = ((_e1804 >> bitcast<u32>(1i)) & 1431655765u);
let _e1828 = ((_e1824 | (_e1824 >> bitcast<u32>(1i))) & 858993459u);
let _e1832 = ((_e1828 | (_e1828 >> bitcast<u32>(2i))) & 252645135u);
let _e1836 = ((_e1832 | (_e1832 >> bitcast<u32>(4i))) & 16711935u);
let _e1840 = ((_e1836 | (_e1836 >> bitcast<u32>(8i))) & 65535u);
if (((_e1788 < (1u << bitcast<u32>(_e1801))) && (_e1821 < _e924)) && (_e1840 < _e924)) {
phi_3387_ = bitcast<i32>(((_e1840 * _e924) + _e1821));
} else {
phi_3387_ = 0i;
}
let _e1852 = phi_3387_;
local_10 = _e943;
local_11 = _e1852;
local_12 = _e926;
let _e1853 = local_10;
let _e1854 = local_11;
let _e1855 = (_e1853 + _e1854);
let _e1857 = (bitcast<i32>(_e137) - 1i);
let _e1859 = select(_e1857, _e1855, (_e1855 < _e1857));
let _e1864 = global_3.member[bitcast<u32>(select(0i, _e1859, (_e1859 > 0i)))];
let _e1865 = local_10;
let _e1866 = local_12;
let _e1868 = local_11;
let _e1869 = ((_e1865 + _e1866) + _e1868);
let _e1871 = select(_e1857, _e1869, (_e1869 < _e1857));
let _e1876 = global_3.member[bitcast<u32>(select(0i, _e1871, (_e1871 > 0i)))];
let _e1877 = local_10;
let _e1878 = local_12;
let _e1881 = local_11;
let _e1882 = ((_e1877 + (2i * _e1878)) + _e1881);
let _e1884 = select(_e1857, _e1882, (_e1882 < _e1857));
let _e1889 = global_3.member[bitcast<u32>(select(0i, _e1884, (_e1884 > 0i)))];
let _e1890 = local_10;
let _e1891 = local_12;
let _e1894 = local_11;
let _e1895 = ((_e1890 + (3i * _e1891)) + _e1894);
let _e1897 = select(_e1857, _e1895, (_e1895 < _e1857));
let _e1902 = global_3.member[bitcast<u32>(select(0i, _e1897, (_e1897 > 0i)))];
let _e1903 = local_10;
let _e1904 = local_12;
let _e1907 = local_11;
let _e1908 = ((_e1903 + (4i * _e1904)) + _e1907);
let _e1910 = select(_e1857, _e1908, (_e1908 < _e1857));
let _e1915 = global_3.member[bitcast<u32>(select(0i, _e1910, (_e1910 > 0i)))];
let _e1916 = local_10;
let _e1917 = local_12;
let _e1920 = local_11;
let _e1921 = ((_e1916 + (5i * _e1917)) + _e1920);
let _e1923 = select(_e1857, _e1921, (_e1921 < _e1857));
let _e1928 = global_3.member[bitcast<u32>(select(0i, _e1923, (_e1923 > 0i)))];
let _e1929 = local_10;
let _e1930 = local_12;
let _e1933 = local_11;
let _e1934 = ((_e1929 + (6i * _e1930)) + _e1933);
let _e1936 = select(_e1857, _e1934, (_e1934 < _e1857));
let _e1941 = global_3.member[bitcast<u32>(select(0i, _e1936, (_e1936 > 0i)))];
let _e1942 = local_10;
let _e1943 = local_12;
let _e1946 = local_11;
let _e1947 = ((_e1942 + (7i * _e1943)) + _e1946);
let _e1949 = select(_e1857, _e1947, (_e1947 < _e1857));
let _e1954 = global_3.member[bitcast<u32>(select(0i, _e1949, (_e1949 > 0i)))];
let _e1955 = local_10;
let _e1956 = local_12;
let _e1959 = local_11;
let _e1960 = ((_e1955 + (8i * _e1956)) + _e1959);
let _e1962 = select(_e1857, _e1960, (_e1960 < _e1857));
let _e1967 = global_3.member[bitcast<u32>(select(0i, _e1962, (_e1962 > 0i)))];
let _e1968 = local_10;
let _e1969 = local_12;
let _e1972 = local_11;
let _e1973 = ((_e1968 + (9i * _e1969)) + _e1972);
let _e1975 = select(_e1857, _e1973, (_e1973 < _e1857));
let _e1980 = global_3.member[bitcast<u32>(select(0i, _e1975, (_e1975 > 0i)))];
let _e1981 = local_10;
let _e1982 = local_12;
let _e1985 = local_11;
let _e1986 = ((_e1981 + (10i * _e1982)) + _e1985);
let _e1988 = select(_e1857, _e1986, (_e1986 < _e1857));
let _e1993 = global_3.member[bitcast<u32>(select(0i, _e1988, (_e1988 > 0i)))];
let _e1994 = local_10;
let _e1995 = local_12;
let _e1998 = local_11;
let _e1999 = ((_e1994 + (11i * _e1995)) + _e1998);
let _e2001 = select(_e1857, _e1999, (_e1999 < _e1857));
let _e2006 = global_3.member[bitcast<u32>(select(0i, _e2001, (_e2001 > 0i)))];
let _e2007 = local_10;
let _e2008 = local_12;
let _e2011 = local_11;
let _e2012 = ((_e2007 + (12i * _e2008)) + _e2011);
let _e2014 = select(_e1857, _e2012, (_e2012 < _e1857));
let _e2019 = global_3.member[bitcast<u32>(select(0i, _e2014, (_e2014 > 0i)))];
let _e2020 = local_10;
let _e2021 = local_12;
let _e2024 = local_11;
let _e2025 = ((_e2020 + (13i * _e2021)) + _e2024);
let _e2027 = select(_e1857, _e2025, (_e2025 < _e1857));
let _e2032 = global_3.member[bitcast<u32>(select(0i, _e2027, (_e2027 > 0i)))];
let _e2033 = local_10;
let _e2034 = local_12;
let _e2037 = local_11;
let _e2038 = ((_e2033 + (14i * _e2034)) + _e2037);
let _e2040 = select(_e1857, _e2038, (_e2038 < _e1857));
let _e2045 = global_3.member[bitcast<u32>(select(0i, _e2040, (_e2040 > 0i)))];
let _e2046 = local_10;
let _e2047 = local_12;
let _e2050 = local_11;
let _e2051 = ((_e2046 + (15i * _e2047)) + _e2050);
let _e2053 = select(_e1857, _e2051, (_e2051 < _e1857));
let _e2058 = global_3.member[bitcast<u32>(select(0i, _e2053, (_e2053 > 0i)))];
let _e2059 = local_10;
let _e2060 = local_12;
let _e2063 = local_11;
let _e2064 = ((_e2059 + (16i * _e2060)) + _e2063);
let _e2066 = select(_e1857, _e2064, (_e2064 < _e1857));
let _e2071 = global_3.member[bitcast<u32>(select(0i, _e2066, (_e2066 > 0i)))];
let _e2072 = local_10;
let _e2073 = local_12;
let _e2076 = local_11;
let _e2077 = ((_e2072 + (17i * _e2073)) + _e2076);
let _e2079 = select(_e1857, _e2077, (_e2077 < _e1857));
let _e2084 = global_3.member[bitcast<u32>(select(0i, _e2079, (_e2079 > 0i)))];
let _e2085 = local_10;
let _e2086 = local_12;
let _e2089 = local_11;
let _e2090 = ((_e2085 + (18i * _e2086)) + _e2089);
let _e2092 = select(_e1857, _e2090, (_e2090 < _e1857));
let _e2097 = global_3.member[bitcast<u32>(select(0i, _e2092, (_e2092 > 0i)))];
let _e2098 = local_10;
let _e2099 = local_12;
let _e2102 = local_11;
let _e2103 = ((_e2098 + (19i * _e2099)) + _e2102);
let _e2105 = select(_e1857, _e2103, (_e2103 < _e1857));
let _e2110 = global_3.member[bitcast<u32>(select(0i, _e2105, (_e2105 > 0i)))];
let _e2111 = local_10;
let _e2112 = local_12;
let _e2115 = local_11;
let _e2116 = ((_e2111 + (20i * _e2112)) + _e2115);
let _e2118 = select(_e1857, _e2116, (_e2116 < _e1857));
let _e2123 = global_3.member[bitcast<u32>(select(0i, _e2118, (_e2118 > 0i)))];
let _e2124 = local_10;
let _e2125 = local_12;
let _e2128 = local_11;
let _e2129 = ((_e2124 + (23i * _e2125)) + _e2128);
let _e2131 = select(_e1857, _e2129, (_e2129 < _e1857));
let _e2136 = global_3.member[bitcast<u32>(select(0i, _e2131, (_e2131 > 0i)))];
let _e2137 = (_e1864 - _e793);
let _e2138 = (_e1876 - _e794);
let _e2139 = (_e1889 - _e795);
let _e2142 = ((_e2138 * _e1928) - (_e2139 * _e1915));
let _e2145 = ((_e2139 * _e1902) - (_e2137 * _e1928));
let _e2148 = ((_e2137 * _e1915) - (_e2138 * _e1902));
let _e2153 = (((_e494 * _e2142) + (_e505 * _e2145)) + (_e516 * _e2148));
let _e2182 = bitcast<f32>((bitcast<u32>((((_e494 * (((_e1954 * _e1928) - (_e1967 * _e1915)) + ((_e2138 * _e2045) - (_e2139 * _e2032)))) + (_e505 * (((_e1967 * _e1902) - (_e1941 * _e1928)) + ((_e2139 * _e2019) - (_e2137 * _e2045))))) + (_e516 * (((_e1941 * _e1915) - (_e1954 * _e1902)) + ((_e2137 * _e2032) - (_e2138 * _e2019)))))) & 2147483647u));
let _e2211 = bitcast<f32>((bitcast<u32>((((_e494 * (((_e1993 * _e1928) - (_e2006 * _e1915)) + ((_e2138 * _e2084) - (_e2139 * _e2071)))) + (_e505 * (((_e2006 * _e1902) - (_e1980 * _e1928)) + ((_e2139 * _e2058) - (_e2137 * _e2084))))) + (_e516 * (((_e1980 * _e1915) - (_e1993 * _e1902)) + ((_e2137 * _e2071) - (_e2138 * _e2058)))))) & 2147483647u));
let _e2234 = bitcast<f32>((bitcast<u32>(((((_e593 * _e2142) + (_e604 * _e2145)) + (_e615 * _e2148)) - (((_e494 * ((_e538 * _e1928) - (_e549 * _e1915))) + (_e505 * ((_e549 * _e1902) - (_e527 * _e1928)))) + (_e516 * ((_e527 * _e1915) - (_e538 * _e1902)))))) & 2147483647u));
let _e2257 = bitcast<f32>((bitcast<u32>(((((_e626 * _e2142) + (_e637 * _e2145)) + (_e648 * _e2148)) - (((_e494 * ((_e571 * _e1928) - (_e582 * _e1915))) + (_e505 * ((_e582 * _e1902) - (_e560 * _e1928)))) + (_e516 * ((_e560 * _e1915) - (_e571 * _e1902)))))) & 2147483647u));
let _e2259 = select(_e2257, _e2234, (_e2234 > _e2257));
let _e2261 = select(1e-12f, _e2259, (_e2259 > 1e-12f));
if (bitcast<f32>((bitcast<u32>(_e2153) & 2147483647u)) > (0.5f * ((_e2182 + _e2211) + _e2261))) {
phi_6488_ = vec3<f32>();
phi_6489_ = true;
} else {
let _e2273 = (((_e2137 * _e494) + (_e2138 * _e505)) + (_e2139 * _e516));
let _e2278 = (((_e2137 * _e1902) + (_e2138 * _e1915)) + (_e2139 * _e1928));
let _e2283 = (((_e494 * _e1902) + (_e505 * _e1915)) + (_e516 * _e1928));
let _e2286 = ((_e505 * _e1928) - (_e516 * _e1915));
let _e2289 = ((_e516 * _e1902) - (_e494 * _e1928));
let _e2292 = ((_e494 * _e1915) - (_e505 * _e1902));
let _e2297 = (((_e2286 * _e2286) + (_e2289 * _e2289)) + (_e2292 * _e2292));
let _e2300 = (1f / select(1e-9f, _e2297, (_e2297 > 1e-9f)));
let _e2303 = ((_e2273 - (_e2283 * _e2278)) * _e2300);
let _e2306 = (((_e2283 * _e2273) - _e2278) * _e2300);
let _e2313 = ((((_e2306 >= 0f) && (_e2306 < _e2136)) && (_e2303 > _e875)) && (_e2303 < _e876));
if _e2313 {
let _e2314 = (_e2306 - 0f);
let _e2318 = global_1.member.member_13.member_6;
let _e2319 = (_e2318 == 0u);
if _e2319 {
phi_4950_ = _e2314;
} else {
let _e2321 = (_e2314 / f32(_e2318));
phi_4237_ = 0u;
phi_4240_ = 0f;
loop {
let _e2323 = phi_4237_;
let _e2325 = phi_4240_;
local_46 = _e2325;
let _e2328 = ((_e2323 < _e2318) && (_e2314 > 0f));
if _e2328 {
let _e2331 = (0f + (_e2321 * f32(_e2323)));
let _e2332 = (_e2331 + _e2321);
let _e2334 = (0.5f * (_e2331 + _e2332));
let _e2335 = (_e2332 - _e2331);
let _e2336 = (0.28867513f * _e2335);
let _e2337 = (_e2334 - _e2336);
let _e2347 = global_1.member.member_13.member_7;
let _e2348 = bitcast<i32>(_e2347);
let _e2352 = global_1.member.member_13.member_8;
let _e2353 = bitcast<i32>(_e2352);
let _e2357 = global_1.member.member_13.member_9;
let _e2358 = bitcast<i32>(_e2357);
let _e2359 = f32(_e2348);
let _e2361 = (_e834.member - _e827.member);
let _e2364 = (((((_e1864 + (_e1902 * _e2337)) - _e827.member) / _e2361) * _e2359) - 0.5f);
let _e2365 = (_e2359 - 1f);
let _e2367 = select(0f, _e2364, (_e2364 > 0f));
let _e2369 = select(_e2365, _e2367, (_e2367 < _e2365));
let _e2370 = f32(_e2353);
let _e2372 = (_e834.member_1 - _e827.member_1);
let _e2375 = (((((_e1876 + (_e1915 * _e2337)) - _e827.member_1) / _e2372) * _e2370) - 0.5f);
let _e2376 = (_e2370 - 1f);
let _e2378 = select(0f, _e2375, (_e2375 > 0f));
let _e2380 = select(_e2376, _e2378, (_e2378 < _e2376));
let _e2381 = f32(_e2358);
let _e2383 = (_e834.member_2 - _e827.member_2);
let _e2386 = (((((_e1889 + (_e1928 * _e2337)) - _e827.member_2) / _e2383) * _e2381) - 0.5f);
let _e2387 = (_e2381 - 1f);
let _e2389 = select(0f, _e2386, (_e2386 > 0f));
let _e2391 = select(_e2387, _e2389, (_e2389 < _e2387));
let _e2393 = select(0f, _e2369, (_e2369 > 0f));
let _e2395 = select(1e6f, _e2393, (_e2393 < 1e6f));
let _e2402 = select(0i, select(select(i32(_e2395), i32(-2147483648), (_e2395 < -2147483600f)), 2147483647i, (_e2395 > 2147483500f)), (_e2395 == _e2395));
let _e2406 = (_e2402 - select(0i, 1i, (_e2395 < f32(_e2402))));
let _e2408 = select(0f, _e2380, (_e2380 > 0f));
let _e2410 = select(1e6f, _e2408, (_e2408 < 1e6f));
let _e2417 = select(0i, select(select(i32(_e2410), i32(-2147483648), (_e2410 < -2147483600f)), 2147483647i, (_e2410 > 2147483500f)), (_e2410 == _e2410));
let _e2421 = (_e2417 - select(0i, 1i, (_e2410 < f32(_e2417))));
let _e2423 = select(0f, _e2391, (_e2391 > 0f));
let _e2425 = select(1e6f, _e2423, (_e2423 < 1e6f));
let _e2432 = select(0i, select(select(i32(_e2425), i32(-2147483648), (_e2425 < -2147483600f)), 2147483647i, (_e2425 > 2147483500f)), (_e2425 == _e2425));
let _e2436 = (_e2432 - select(0i, 1i, (_e2425 < f32(_e2432))));
let _e2440 = (_e2380 - f32(_e2421));
let _e2442 = (_e2391 - f32(_e2436));
local_8 = (_e2369 - f32(_e2406));
let _e2443 = (_e2406 + 1i);
let _e2445 = select(_e2443, 0i, (_e2443 < 0i));
if (_e2445 >= _e2348) {
phi_4375_ = (_e2348 - 1i);
} else {
phi_4375_ = _e2445;
}
let _e2449 = phi_4375_;
local_9 = (_e2449 - _e2406);
let _e2451 = (_e2421 + 1i);
let _e2453 = select(_e2451, 0i, (_e2451 < 0i));
if (_e2453 >= _e2353) {
phi_4388_ = (_e2353 - 1i);
} else {
phi_4388_ = _e2453;
}
let _e2457 = phi_4388_;
let _e2459 = ((_e2457 - _e2421) * _e2348);
let _e2460 = (_e2436 + 1i);
let _e2462 = select(_e2460, 0i, (_e2460 < 0i));
if (_e2462 >= _e2358) {
phi_4402_ = (_e2358 - 1i);
} else {
phi_4402_ = _e2462;
}
let _e2466 = phi_4402_;
let _e2473 = global_1.member.member_13.member_10;
let _e2474 = bitcast<i32>(_e2473);
let _e2479 = ((_e2474 + (((_e2436 * _e2353) + _e2421) * _e2348)) + _e2406);
let _e2481 = (bitcast<i32>(_e143) - 1i);
let _e2483 = select(_e2481, _e2479, (_e2479 < _e2481));
let _e2488 = global_5.member[bitcast<u32>(select(0i, _e2483, (_e2483 > 0i)))];
let _e2489 = local_8;
let _e2492 = local_9;
let _e2493 = (_e2479 + _e2492);
let _e2495 = select(_e2481, _e2493, (_e2493 < _e2481));
let _e2500 = global_5.member[bitcast<u32>(select(0i, _e2495, (_e2495 > 0i)))];
let _e2501 = local_8;
let _e2504 = (1f - _e2440);
let _e2506 = (_e2479 + _e2459);
let _e2508 = select(_e2481, _e2506, (_e2506 < _e2481));
let _e2513 = global_5.member[bitcast<u32>(select(0i, _e2508, (_e2508 > 0i)))];
let _e2514 = local_8;
let _e2517 = local_9;
let _e2518 = (_e2506 + _e2517);
let _e2520 = select(_e2481, _e2518, (_e2518 < _e2481));
let _e2525 = global_5.member[bitcast<u32>(select(0i, _e2520, (_e2520 > 0i)))];
let _e2526 = local_8;
let _e2531 = (_e2479 + (((_e2466 - _e2436) * _e2348) * _e2353));
let _e2533 = select(_e2481, _e2531, (_e2531 < _e2481));
let _e2538 = global_5.member[bitcast<u32>(select(0i, _e2533, (_e2533 > 0i)))];
let _e2539 = local_8;
let _e2542 = local_9;
let _e2543 = (_e2531 + _e2542);
let _e2545 = select(_e2481, _e2543, (_e2543 < _e2481));
let _e2550 = global_5.member[bitcast<u32>(select(0i, _e2545, (_e2545 > 0i)))];
let _e2551 = local_8;
let _e2555 = (_e2531 + _e2459);
let _e2557 = select(_e2481, _e2555, (_e2555 < _e2481));
let _e2562 = global_5.member[bitcast<u32>(select(0i, _e2557, (_e2557 > 0i)))];
let _e2563 = local_8;
let _e2566 = local_9;
let _e2567 = (_e2555 + _e2566);
let _e2569 = select(_e2481, _e2567, (_e2567 < _e2481));
let _e2574 = global_5.member[bitcast<u32>(select(0i, _e2569, (_e2569 > 0i)))];
let _e2575 = local_8;
let _e2584 = (_e2334 + _e2336);
let _e2594 = (((((_e1864 + (_e1902 * _e2584)) - _e827.member) / _e2361) * _e2359) - 0.5f);
let _e2596 = select(0f, _e2594, (_e2594 > 0f));
let _e2598 = select(_e2365, _e2596, (_e2596 < _e2365));
let _e2602 = (((((_e1876 + (_e1915 * _e2584)) - _e827.member_1) / _e2372) * _e2370) - 0.5f);
let _e2604 = select(0f, _e2602, (_e2602 > 0f));
let _e2606 = select(_e2376, _e2604, (_e2604 < _e2376));
let _e2610 = (((((_e1889 + (_e1928 * _e2584)) - _e827.member_2) / _e2383) * _e2381) - 0.5f);
let _e2612 = select(0f, _e2610, (_e2610 > 0f));
let _e2614 = select(_e2387, _e2612, (_e2612 < _e2387));
let _e2616 = select(0f, _e2598, (_e2598 > 0f));
let _e2618 = select(1e6f, _e2616, (_e2616 < 1e6f));
let _e2625 = select(0i, select(select(i32(_e2618), i32(-2147483648), (_e2618 < -2147483600f)), 2147483647i, (_e2618 > 2147483500f)), (_e2618 == _e2618));
let _e2629 = (_e2625 - select(0i, 1i, (_e2618 < f32(_e2625))));
let _e2631 = select(0f, _e2606, (_e2606 > 0f));
let _e2633 = select(1e6f, _e2631, (_e2631 < 1e6f));
let _e2640 = select(0i, select(select(i32(_e2633), i32(-2147483648), (_e2633 < -2147483600f)), 2147483647i, (_e2633 > 2147483500f)), (_e2633 == _e2633));
let _e2644 = (_e2640 - select(0i, 1i, (_e2633 < f32(_e2640))));
let _e2646 = select(0f, _e2614, (_e2614 > 0f));
let _e2648 = select(1e6f, _e2646, (_e2646 < 1e6f));
let _e2655 = select(0i, select(select(i32(_e2648), i32(-2147483648), (_e2648 < -2147483600f)), 2147483647i, (_e2648 > 2147483500f)), (_e2648 == _e2648));
let _e2659 = (_e2655 - select(0i, 1i, (_e2648 < f32(_e2655))));
let _e2663 = (_e2606 - f32(_e2644));
let _e2665 = (_e2614 - f32(_e2659));
local_6 = (_e2598 - f32(_e2629));
let _e2666 = (_e2629 + 1i);
let _e2668 = select(_e2666, 0i, (_e2666 < 0i));
if (_e2668 >= _e2348) {
phi_4718_ = (_e2348 - 1i);
} else {
phi_4718_ = _e2668;
}
let _e2672 = phi_4718_;
local_7 = (_e2672 - _e2629);
let _e2674 = (_e2644 + 1i);
let _e2676 = select(_e2674, 0i, (_e2674 < 0i));
if (_e2676 >= _e2353) {
phi_4731_ = (_e2353 - 1i);
} else {
phi_4731_ = _e2676;
}
let _e2680 = phi_4731_;
let _e2682 = ((_e2680 - _e2644) * _e2348);
let _e2683 = (_e2659 + 1i);
let _e2685 = select(_e2683, 0i, (_e2683 < 0i));
if (_e2685 >= _e2358) {
phi_4745_ = (_e2358 - 1i);
} else {
phi_4745_ = _e2685;
}
let _e2689 = phi_4745_;
let _e2697 = ((_e2474 + (((_e2659 * _e2353) + _e2644) * _e2348)) + _e2629);
let _e2699 = select(_e2481, _e2697, (_e2697 < _e2481));
let _e2704 = global_5.member[bitcast<u32>(select(0i, _e2699, (_e2699 > 0i)))];
let _e2705 = local_6;
let _e2708 = local_7;
let _e2709 = (_e2697 + _e2708);
let _e2711 = select(_e2481, _e2709, (_e2709 < _e2481));
let _e2716 = global_5.member[bitcast<u32>(select(0i, _e2711, (_e2711 > 0i)))];
let _e2717 = local_6;
let _e2720 = (1f - _e2663);
let _e2722 = (_e2697 + _e2682);
let _e2724 = select(_e2481, _e2722, (_e2722 < _e2481));
let _e2729 = global_5.member[bitcast<u32>(select(0i, _e2724, (_e2724 > 0i)))];
let _e2730 = local_6;
let _e2733 = local_7;
let _e2734 = (_e2722 + _e2733);
let _e2736 = select(_e2481, _e2734, (_e2734 < _e2481));
let _e2741 = global_5.member[bitcast<u32>(select(0i, _e2736, (_e2736 > 0i)))];
let _e2742 = local_6;
let _e2747 = (_e2697 + (((_e2689 - _e2659) * _e2348) * _e2353));
let _e2749 = select(_e2481, _e2747, (_e2747 < _e2481));
let _e2754 = global_5.member[bitcast<u32>(select(0i, _e2749, (_e2749 > 0i)))];
let _e2755 = local_6;
let _e2758 = local_7;
let _e2759 = (_e2747 + _e2758);
let _e2761 = select(_e2481, _e2759, (_e2759 < _e2481));
let _e2766 = global_5.member[bitcast<u32>(select(0i, _e2761, (_e2761 > 0i)))];
let _e2767 = local_6;
let _e2771 = (_e2747 + _e2682);
let _e2773 = select(_e2481, _e2771, (_e2771 < _e2481));
let _e2778 = global_5.member[bitcast<u32>(select(0i, _e2773, (_e2773 > 0i)))];
let _e2779 = local_6;
let _e2782 = local_7;
let _e2783 = (_e2771 + _e2782);
let _e2785 = select(_e2481, _e2783, (_e2783 < _e2481));
let _e2790 = global_5.member[bitcast<u32>(select(0i, _e2785, (_e2785 > 0i)))];
let _e2791 = local_6;
phi_4238_ = (_e2323 + 1u);
phi_4241_ = (_e2325 + ((0.5f * (((((((_e2488 * (1f - _e2489)) + (_e2500 * _e2501)) * _e2504) + (((_e2513 * (1f - _e2514)) + (_e2525 * _e2526)) * _e2440)) * (1f - _e2442)) + (((((_e2538 * (1f - _e2539)) + (_e2550 * _e2551)) * _e2504) + (((_e2562 * (1f - _e2563)) + (_e2574 * _e2575)) * _e2440)) * _e2442)) + ((((((_e2704 * (1f - _e2705)) + (_e2716 * _e2717)) * _e2720) + (((_e2729 * (1f - _e2730)) + (_e2741 * _e2742)) * _e2663)) * (1f - _e2665)) + (((((_e2754 * (1f - _e2755)) + (_e2766 * _e2767)) * _e2720) + (((_e2778 * (1f - _e2779)) + (_e2790 * _e2791)) * _e2663)) * _e2665)))) * _e2335));
} else {
phi_4238_ = u32();
phi_4241_ = f32();
}
let _e2806 = phi_4238_;
let _e2808 = phi_4241_;
continue;
continuing {
phi_4237_ = _e2806;
phi_4240_ = _e2808;
break if !(_e2328);
}
}
let _e4117 = local_46;
phi_4950_ = _e4117;
}
let _e2811 = phi_4950_;
let _e2812 = (_e2303 - _e875);
if _e2319 {
phi_5676_ = _e2812;
} else {
let _e2814 = (_e2812 / f32(_e2318));
phi_4963_ = 0u;
phi_4966_ = 0f;
loop {
let _e2816 = phi_4963_;
let _e2818 = phi_4966_;
local_47 = _e2818;
let _e2821 = ((_e2816 < _e2318) && (_e2812 > 0f));
if _e2821 {
let _e2824 = (_e875 + (_e2814 * f32(_e2816)));
let _e2825 = (_e2824 + _e2814);
let _e2827 = (0.5f * (_e2824 + _e2825));
let _e2828 = (_e2825 - _e2824);
let _e2829 = (0.28867513f * _e2828);
let _e2830 = (_e2827 - _e2829);
let _e2840 = global_1.member.member_13.member_7;
let _e2841 = bitcast<i32>(_e2840);
let _e2845 = global_1.member.member_13.member_8;
let _e2846 = bitcast<i32>(_e2845);
let _e2850 = global_1.member.member_13.member_9;
let _e2851 = bitcast<i32>(_e2850);
let _e2852 = f32(_e2841);
let _e2854 = (_e834.member - _e827.member);
let _e2857 = (((((_e793 + (_e494 * _e2830)) - _e827.member) / _e2854) * _e2852) - 0.5f);
let _e2858 = (_e2852 - 1f);
let _e2860 = select(0f, _e2857, (_e2857 > 0f));
let _e2862 = select(_e2858, _e2860, (_e2860 < _e2858));
let _e2863 = f32(_e2846);
let _e2865 = (_e834.member_1 - _e827.member_1);
let _e2868 = (((((_e794 + (_e505 * _e2830)) - _e827.member_1) / _e2865) * _e2863) - 0.5f);
let _e2869 = (_e2863 - 1f);
let _e2871 = select(0f, _e2868, (_e2868 > 0f));
let _e2873 = select(_e2869, _e2871, (_e2871 < _e2869));
let _e2874 = f32(_e2851);
let _e2876 = (_e834.member_2 - _e827.member_2);
let _e2879 = (((((_e795 + (_e516 * _e2830)) - _e827.member_2) / _e2876) * _e2874) - 0.5f);
let _e2880 = (_e2874 - 1f);
let _e2882 = select(0f, _e2879, (_e2879 > 0f));
let _e2884 = select(_e2880, _e2882, (_e2882 < _e2880));
let _e2886 = select(0f, _e2862, (_e2862 > 0f));
let _e2888 = select(1e6f, _e2886, (_e2886 < 1e6f));
let _e2895 = select(0i, select(select(i32(_e2888), i32(-2147483648), (_e2888 < -2147483600f)), 2147483647i, (_e2888 > 2147483500f)), (_e2888 == _e2888));
let _e2899 = (_e2895 - select(0i, 1i, (_e2888 < f32(_e2895))));
let _e2901 = select(0f, _e2873, (_e2873 > 0f));
let _e2903 = select(1e6f, _e2901, (_e2901 < 1e6f));
let _e2910 = select(0i, select(select(i32(_e2903), i32(-2147483648), (_e2903 < -2147483600f)), 2147483647i, (_e2903 > 2147483500f)), (_e2903 == _e2903));
let _e2914 = (_e2910 - select(0i, 1i, (_e2903 < f32(_e2910))));
let _e2916 = select(0f, _e2884, (_e2884 > 0f));
let _e2918 = select(1e6f, _e2916, (_e2916 < 1e6f));
let _e2925 = select(0i, select(select(i32(_e2918), i32(-2147483648), (_e2918 < -2147483600f)), 2147483647i, (_e2918 > 2147483500f)), (_e2918 == _e2918));
let _e2929 = (_e2925 - select(0i, 1i, (_e2918 < f32(_e2925))));
let _e2933 = (_e2873 - f32(_e2914));
let _e2935 = (_e2884 - f32(_e2929));
local_4 = (_e2862 - f32(_e2899));
let _e2936 = (_e2899 + 1i);
let _e2938 = select(_e2936, 0i, (_e2936 < 0i));
if (_e2938 >= _e2841) {
phi_5101_ = (_e2841 - 1i);
} else {
phi_5101_ = _e2938;
}
let _e2942 = phi_5101_;
local_5 = (_e2942 - _e2899);
let _e2944 = (_e2914 + 1i);
let _e2946 = select(_e2944, 0i, (_e2944 < 0i));
if (_e2946 >= _e2846) {
phi_5114_ = (_e2846 - 1i);
} else {
phi_5114_ = _e2946;
}
let _e2950 = phi_5114_;
let _e2952 = ((_e2950 - _e2914) * _e2841);
let _e2953 = (_e2929 + 1i);
let _e2955 = select(_e2953, 0i, (_e2953 < 0i));
if (_e2955 >= _e2851) {
phi_5128_ = (_e2851 - 1i);
} else {
phi_5128_ = _e2955;
}
let _e2959 = phi_5128_;
let _e2966 = global_1.member.member_13.member_10;
let _e2967 = bitcast<i32>(_e2966);
let _e2972 = ((_e2967 + (((_e2929 * _e2846) + _e2914) * _e2841)) + _e2899);
let _e2974 = (bitcast<i32>(_e143) - 1i);
let _e2976 = select(_e2974, _e2972, (_e2972 < _e2974));
let _e2981 = global_5.member[bitcast<u32>(select(0i, _e2976, (_e2976 > 0i)))];
let _e2982 = local_4;
let _e2985 = local_5;
let _e2986 = (_e2972 + _e2985);
let _e2988 = select(_e2974, _e2986, (_e2986 < _e2974));
let _e2993 = global_5.member[bitcast<u32>(select(0i, _e2988, (_e2988 > 0i)))];
let _e2994 = local_4;
let _e2997 = (1f - _e2933);
let _e2999 = (_e2972 + _e2952);
let _e3001 = select(_e2974, _e2999, (_e2999 < _e2974));
let _e3006 = global_5.member[bitcast<u32>(select(0i, _e3001, (_e3001 > 0i)))];
let _e3007 = local_4;
let _e3010 = local_5;
let _e3011 = (_e2999 + _e3010);
let _e3013 = select(_e2974, _e3011, (_e3011 < _e2974));
let _e3018 = global_5.member[bitcast<u32>(select(0i, _e3013, (_e3013 > 0i)))];
let _e3019 = local_4;
let _e3024 = (_e2972 + (((_e2959 - _e2929) * _e2841) * _e2846));
let _e3026 = select(_e2974, _e3024, (_e3024 < _e2974));
let _e3031 = global_5.member[bitcast<u32>(select(0i, _e3026, (_e3026 > 0i)))];
let _e3032 = local_4;
let _e3035 = local_5;
let _e3036 = (_e3024 + _e3035);
let _e3038 = select(_e2974, _e3036, (_e3036 < _e2974));
let _e3043 = global_5.member[bitcast<u32>(select(0i, _e3038, (_e3038 > 0i)))];
let _e3044 = local_4;
let _e3048 = (_e3024 + _e2952);
let _e3050 = select(_e2974, _e3048, (_e3048 < _e2974));
let _e3055 = global_5.member[bitcast<u32>(select(0i, _e3050, (_e3050 > 0i)))];
let _e3056 = local_4;
let _e3059 = local_5;
let _e3060 = (_e3048 + _e3059);
let _e3062 = select(_e2974, _e3060, (_e3060 < _e2974));
let _e3067 = global_5.member[bitcast<u32>(select(0i, _e3062, (_e3062 > 0i)))];
let _e3068 = local_4;
let _e3077 = (_e2827 + _e2829);
let _e3087 = (((((_e793 + (_e494 * _e3077)) - _e827.member) / _e2854) * _e2852) - 0.5f);
let _e3089 = select(0f, _e3087, (_e3087 > 0f));
let _e3091 = select(_e2858, _e3089, (_e3089 < _e2858));
let _e3095 = (((((_e794 + (_e505 * _e3077)) - _e827.member_1) / _e2865) * _e2863) - 0.5f);
let _e3097 = select(0f, _e3095, (_e3095 > 0f));
let _e3099 = select(_e2869, _e3097, (_e3097 < _e2869));
let _e3103 = (((((_e795 + (_e516 * _e3077)) - _e827.member_2) / _e2876) * _e2874) - 0.5f);
let _e3105 = select(0f, _e3103, (_e3103 > 0f));
let _e3107 = select(_e2880, _e3105, (_e3105 < _e2880));
let _e3109 = select(0f, _e3091, (_e3091 > 0f));
let _e3111 = select(1e6f, _e3109, (_e3109 < 1e6f));
let _e3118 = select(0i, select(select(i32(_e3111), i32(-2147483648), (_e3111 < -2147483600f)), 2147483647i, (_e3111 > 2147483500f)), (_e3111 == _e3111));
let _e3122 = (_e3118 - select(0i, 1i, (_e3111 < f32(_e3118))));
let _e3124 = select(0f, _e3099, (_e3099 > 0f));
let _e3126 = select(1e6f, _e3124, (_e3124 < 1e6f));
let _e3133 = select(0i, select(select(i32(_e3126), i32(-2147483648), (_e3126 < -2147483600f)), 2147483647i, (_e3126 > 2147483500f)), (_e3126 == _e3126));
let _e3137 = (_e3133 - select(0i, 1i, (_e3126 < f32(_e3133))));
let _e3139 = select(0f, _e3107, (_e3107 > 0f));
let _e3141 = select(1e6f, _e3139, (_e3139 < 1e6f));
let _e3148 = select(0i, select(select(i32(_e3141), i32(-2147483648), (_e3141 < -2147483600f)), 2147483647i, (_e3141 > 2147483500f)), (_e3141 == _e3141));
let _e3152 = (_e3148 - select(0i, 1i, (_e3141 < f32(_e3148))));
let _e3156 = (_e3099 - f32(_e3137));
let _e3158 = (_e3107 - f32(_e3152));
local_2 = (_e3091 - f32(_e3122));
let _e3159 = (_e3122 + 1i);
let _e3161 = select(_e3159, 0i, (_e3159 < 0i));
if (_e3161 >= _e2841) {
phi_5444_ = (_e2841 - 1i);
} else {
phi_5444_ = _e3161;
}
let _e3165 = phi_5444_;
local_3 = (_e3165 - _e3122);
let _e3167 = (_e3137 + 1i);
let _e3169 = select(_e3167, 0i, (_e3167 < 0i));
if (_e3169 >= _e2846) {
phi_5457_ = (_e2846 - 1i);
} else {
phi_5457_ = _e3169;
}
let _e3173 = phi_5457_;
let _e3175 = ((_e3173 - _e3137) * _e2841);
let _e3176 = (_e3152 + 1i);
let _e3178 = select(_e3176, 0i, (_e3176 < 0i));
if (_e3178 >= _e2851) {
phi_5471_ = (_e2851 - 1i);
} else {
phi_5471_ = _e3178;
}
let _e3182 = phi_5471_;
let _e3190 = ((_e2967 + (((_e3152 * _e2846) + _e3137) * _e2841)) + _e3122);
let _e3192 = select(_e2974, _e3190, (_e3190 < _e2974));
let _e3197 = global_5.member[bitcast<u32>(select(0i, _e3192, (_e3192 > 0i)))];
let _e3198 = local_2;
let _e3201 = local_3;
let _e3202 = (_e3190 + _e3201);
let _e3204 = select(_e2974, _e3202, (_e3202 < _e2974));
let _e3209 = global_5.member[bitcast<u32>(select(0i, _e3204, (_e3204 > 0i)))];
let _e3210 = local_2;
let _e3213 = (1f - _e3156);
let _e3215 = (_e3190 + _e3175);
let _e3217 = select(_e2974, _e3215, (_e3215 < _e2974));
let _e3222 = global_5.member[bitcast<u32>(select(0i, _e3217, (_e3217 > 0i)))];
let _e3223 = local_2;
let _e3226 = local_3;
let _e3227 = (_e3215 + _e3226);
let _e3229 = select(_e2974, _e3227, (_e3227 < _e2974));
let _e3234 = global_5.member[bitcast<u32>(select(0i, _e3229, (_e3229 > 0i)))];
let _e3235 = local_2;
let _e3240 = (_e3190 + (((_e3182 - _e3152) * _e2841) * _e2846));
let _e3242 = select(_e2974, _e3240, (_e3240 < _e2974));
let _e3247 = global_5.member[bitcast<u32>(select(0i, _e3242, (_e3242 > 0i)))];
let _e3248 = local_2;
let _e3251 = local_3;
let _e3252 = (_e3240 + _e3251);
let _e3254 = select(_e2974, _e3252, (_e3252 < _e2974));
let _e3259 = global_5.member[bitcast<u32>(select(0i, _e3254, (_e3254 > 0i)))];
let _e3260 = local_2;
let _e3264 = (_e3240 + _e3175);
let _e3266 = select(_e2974, _e3264, (_e3264 < _e2974));
let _e3271 = global_5.member[bitcast<u32>(select(0i, _e3266, (_e3266 > 0i)))];
let _e3272 = local_2;
let _e3275 = local_3;
let _e3276 = (_e3264 + _e3275);
let _e3278 = select(_e2974, _e3276, (_e3276 < _e2974));
let _e3283 = global_5.member[bitcast<u32>(select(0i, _e3278, (_e3278 > 0i)))];
let _e3284 = local_2;
phi_4964_ = (_e2816 + 1u);
phi_4967_ = (_e2818 + ((0.5f * (((((((_e2981 * (1f - _e2982)) + (_e2993 * _e2994)) * _e2997) + (((_e3006 * (1f - _e3007)) + (_e3018 * _e3019)) * _e2933)) * (1f - _e2935)) + (((((_e3031 * (1f - _e3032)) + (_e3043 * _e3044)) * _e2997) + (((_e3055 * (1f - _e3056)) + (_e3067 * _e3068)) * _e2933)) * _e2935)) + ((((((_e3197 * (1f - _e3198)) + (_e3209 * _e3210)) * _e3213) + (((_e3222 * (1f - _e3223)) + (_e3234 * _e3235)) * _e3156)) * (1f - _e3158)) + (((((_e3247 * (1f - _e3248)) + (_e3259 * _e3260)) * _e3213) + (((_e3271 * (1f - _e3272)) + (_e3283 * _e3284)) * _e3156)) * _e3158)))) * _e2828));
} else {
phi_4964_ = u32();
phi_4967_ = f32();
}
let _e3299 = phi_4964_;
let _e3301 = phi_4967_;
continue;
continuing {
phi_4963_ = _e3299;
phi_4966_ = _e3301;
break if !(_e2821);
}
}
let _e4130 = local_47;
phi_5676_ = _e4130;
}
let _e3304 = phi_5676_;
if _e2319 {
phi_6025_ = 1f;
} else {
let _e3314 = global_1.member.member_13.member_7;
let _e3315 = bitcast<i32>(_e3314);
let _e3319 = global_1.member.member_13.member_8;
let _e3320 = bitcast<i32>(_e3319);
let _e3324 = global_1.member.member_13.member_9;
let _e3325 = bitcast<i32>(_e3324);
let _e3326 = f32(_e3315);
let _e3331 = (((((_e793 + (_e494 * _e2303)) - _e827.member) / (_e834.member - _e827.member)) * _e3326) - 0.5f);
let _e3332 = (_e3326 - 1f);
let _e3334 = select(0f, _e3331, (_e3331 > 0f));
let _e3336 = select(_e3332, _e3334, (_e3334 < _e3332));
let _e3337 = f32(_e3320);
let _e3342 = (((((_e794 + (_e505 * _e2303)) - _e827.member_1) / (_e834.member_1 - _e827.member_1)) * _e3337) - 0.5f);
let _e3343 = (_e3337 - 1f);
let _e3345 = select(0f, _e3342, (_e3342 > 0f));
let _e3347 = select(_e3343, _e3345, (_e3345 < _e3343));
let _e3348 = f32(_e3325);
let _e3353 = (((((_e795 + (_e516 * _e2303)) - _e827.member_2) / (_e834.member_2 - _e827.member_2)) * _e3348) - 0.5f);
let _e3354 = (_e3348 - 1f);
let _e3356 = select(0f, _e3353, (_e3353 > 0f));
let _e3358 = select(_e3354, _e3356, (_e3356 < _e3354));
let _e3360 = select(0f, _e3336, (_e3336 > 0f));
let _e3362 = select(1e6f, _e3360, (_e3360 < 1e6f));
let _e3369 = select(0i, select(select(i32(_e3362), i32(-2147483648), (_e3362 < -2147483600f)), 2147483647i, (_e3362 > 2147483500f)), (_e3362 == _e3362));
let _e3373 = (_e3369 - select(0i, 1i, (_e3362 < f32(_e3369))));
let _e3375 = select(0f, _e3347, (_e3347 > 0f));
let _e3377 = select(1e6f, _e3375, (_e3375 < 1e6f));
let _e3384 = select(0i, select(select(i32(_e3377), i32(-2147483648), (_e3377 < -2147483600f)), 2147483647i, (_e3377 > 2147483500f)), (_e3377 == _e3377));
let _e3388 = (_e3384 - select(0i, 1i, (_e3377 < f32(_e3384))));
let _e3390 = select(0f, _e3358, (_e3358 > 0f));
let _e3392 = select(1e6f, _e3390, (_e3390 < 1e6f));
let _e3399 = select(0i, select(select(i32(_e3392), i32(-2147483648), (_e3392 < -2147483600f)), 2147483647i, (_e3392 > 2147483500f)), (_e3392 == _e3392));
let _e3403 = (_e3399 - select(0i, 1i, (_e3392 < f32(_e3399))));
let _e3407 = (_e3347 - f32(_e3388));
let _e3409 = (_e3358 - f32(_e3403));
local = (_e3336 - f32(_e3373));
let _e3410 = (_e3373 + 1i);
let _e3412 = select(_e3410, 0i, (_e3410 < 0i));
if (_e3412 >= _e3315) {
phi_5798_ = (_e3315 - 1i);
} else {
phi_5798_ = _e3412;
}
let _e3416 = phi_5798_;
local_1 = (_e3416 - _e3373);
let _e3418 = (_e3388 + 1i);
let _e3420 = select(_e3418, 0i, (_e3418 < 0i));
if (_e3420 >= _e3320) {
phi_5811_ = (_e3320 - 1i);
} else {
phi_5811_ = _e3420;
}
let _e3424 = phi_5811_;
let _e3426 = ((_e3424 - _e3388) * _e3315);
let _e3427 = (_e3403 + 1i);
let _e3429 = select(_e3427, 0i, (_e3427 < 0i));
if (_e3429 >= _e3325) {
phi_5825_ = (_e3325 - 1i);
} else {
phi_5825_ = _e3429;
}
let _e3433 = phi_5825_;
let _e3440 = global_1.member.member_13.member_10;
let _e3446 = ((bitcast<i32>(_e3440) + (((_e3403 * _e3320) + _e3388) * _e3315)) + _e3373);
let _e3448 = (bitcast<i32>(_e143) - 1i);
let _e3450 = select(_e3448, _e3446, (_e3446 < _e3448));
let _e3455 = global_5.member[bitcast<u32>(select(0i, _e3450, (_e3450 > 0i)))];
let _e3456 = local;
let _e3459 = local_1;
let _e3460 = (_e3446 + _e3459);
let _e3462 = select(_e3448, _e3460, (_e3460 < _e3448));
let _e3467 = global_5.member[bitcast<u32>(select(0i, _e3462, (_e3462 > 0i)))];
let _e3468 = local;
let _e3471 = (1f - _e3407);
let _e3473 = (_e3446 + _e3426);
let _e3475 = select(_e3448, _e3473, (_e3473 < _e3448));
let _e3480 = global_5.member[bitcast<u32>(select(0i, _e3475, (_e3475 > 0i)))];
let _e3481 = local;
let _e3484 = local_1;
let _e3485 = (_e3473 + _e3484);
let _e3487 = select(_e3448, _e3485, (_e3485 < _e3448));
let _e3492 = global_5.member[bitcast<u32>(select(0i, _e3487, (_e3487 > 0i)))];
let _e3493 = local;
let _e3498 = (_e3446 + (((_e3433 - _e3403) * _e3315) * _e3320));
let _e3500 = select(_e3448, _e3498, (_e3498 < _e3448));
let _e3505 = global_5.member[bitcast<u32>(select(0i, _e3500, (_e3500 > 0i)))];
let _e3506 = local;
let _e3509 = local_1;
let _e3510 = (_e3498 + _e3509);
let _e3512 = select(_e3448, _e3510, (_e3510 < _e3448));
let _e3517 = global_5.member[bitcast<u32>(select(0i, _e3512, (_e3512 > 0i)))];
let _e3518 = local;
let _e3522 = (_e3498 + _e3426);
let _e3524 = select(_e3448, _e3522, (_e3522 < _e3448));
let _e3529 = global_5.member[bitcast<u32>(select(0i, _e3524, (_e3524 > 0i)))];
let _e3530 = local;
let _e3533 = local_1;
let _e3534 = (_e3522 + _e3533);
let _e3536 = select(_e3448, _e3534, (_e3534 < _e3448));
let _e3541 = global_5.member[bitcast<u32>(select(0i, _e3536, (_e3536 > 0i)))];
let _e3542 = local;
phi_6025_ = ((((((_e3455 * (1f - _e3456)) + (_e3467 * _e3468)) * _e3471) + (((_e3480 * (1f - _e3481)) + (_e3492 * _e3493)) * _e3407)) * (1f - _e3409)) + (((((_e3505 * (1f - _e3506)) + (_e3517 * _e3518)) * _e3471) + (((_e3529 * (1f - _e3530)) + (_e3541 * _e3542)) * _e3407)) * _e3409));
}
let _e3552 = phi_6025_;
let _e3553 = (_e2811 + _e3304);
let _e3557 = global_1.member.member_13.member;
let _e3562 = -((_e3557.member * _e3553));
let _e3564 = select(-87f, _e3562, (_e3562 > -87f));
let _e3566 = select(88f, _e3564, (_e3564 < 88f));
let _e3568 = ((_e3566 * 1.442695f) + 0.5f);
let _e3570 = select(-127f, _e3568, (_e3568 > -127f));
let _e3572 = select(128f, _e3570, (_e3570 < 128f));
let _e3579 = select(0i, select(select(i32(_e3572), i32(-2147483648), (_e3572 < -2147483600f)), 2147483647i, (_e3572 > 2147483500f)), (_e3572 == _e3572));
let _e3583 = (_e3579 - select(0i, 1i, (_e3572 < f32(_e3579))));
let _e3584 = f32(_e3583);
let _e3588 = ((_e3566 - (_e3584 * 0.6933594f)) - (_e3584 * -2.1219444e-4f));
let _e3610 = -((_e3557.member_1 * _e3553));
let _e3612 = select(-87f, _e3610, (_e3610 > -87f));
let _e3614 = select(88f, _e3612, (_e3612 < 88f));
let _e3616 = ((_e3614 * 1.442695f) + 0.5f);
let _e3618 = select(-127f, _e3616, (_e3616 > -127f));
let _e3620 = select(128f, _e3618, (_e3618 < 128f));
let _e3627 = select(0i, select(select(i32(_e3620), i32(-2147483648), (_e3620 < -2147483600f)), 2147483647i, (_e3620 > 2147483500f)), (_e3620 == _e3620));
let _e3631 = (_e3627 - select(0i, 1i, (_e3620 < f32(_e3627))));
let _e3632 = f32(_e3631);
let _e3636 = ((_e3614 - (_e3632 * 0.6933594f)) - (_e3632 * -2.1219444e-4f));
let _e3658 = -((_e3557.member_2 * _e3553));
let _e3660 = select(-87f, _e3658, (_e3658 > -87f));
let _e3662 = select(88f, _e3660, (_e3660 < 88f));
let _e3664 = ((_e3662 * 1.442695f) + 0.5f);
let _e3666 = select(-127f, _e3664, (_e3664 > -127f));
let _e3668 = select(128f, _e3666, (_e3666 < 128f));
let _e3675 = select(0i, select(select(i32(_e3668), i32(-2147483648), (_e3668 < -2147483600f)), 2147483647i, (_e3668 > 2147483500f)), (_e3668 == _e3668));
let _e3679 = (_e3675 - select(0i, 1i, (_e3668 < f32(_e3675))));
let _e3680 = f32(_e3679);
let _e3684 = ((_e3662 - (_e3680 * 0.6933594f)) - (_e3680 * -2.1219444e-4f));
let _e3705 = -(_e2283);
let _e3709 = global_1.member.member_13.member_2;
let _e3710 = (_e3709 * _e3709);
let _e3714 = ((1f + _e3710) - ((2f * _e3709) * _e3705));
let _e3716 = select(1e-9f, _e3714, (_e3714 > 1e-9f));
let _e3729 = global_1.member.member_13.member_3;
if (_e3729 == 2u) {
let _e3734 = (0.5f - (0.5f * _e3705));
let _e3736 = select(0f, _e3734, (_e3734 > 0f));
let _e3740 = (sqrt(select(0f, _e3736, (_e3736 > 0f))) * 255f);
let _e3741 = (255f - 1f);
let _e3743 = select(0f, _e3740, (_e3740 > 0f));
let _e3745 = select(_e3741, _e3743, (_e3743 < _e3741));
let _e3752 = select(0i, select(select(i32(_e3745), i32(-2147483648), (_e3745 < -2147483600f)), 2147483647i, (_e3745 > 2147483500f)), (_e3745 == _e3745));
let _e3756 = (_e3752 - select(0i, 1i, (_e3745 < f32(_e3752))));
let _e3760 = global_1.member.member_13.member_11;
let _e3761 = bitcast<i32>(_e3760);
let _e3762 = (_e3761 + _e3756);
let _e3764 = (bitcast<i32>(_e143) - 1i);
let _e3766 = select(_e3764, _e3762, (_e3762 < _e3764));
let _e3771 = global_5.member[bitcast<u32>(select(0i, _e3766, (_e3766 > 0i)))];
let _e3773 = (_e3761 + (_e3756 + 1i));
let _e3775 = select(_e3764, _e3773, (_e3773 < _e3764));
let _e3780 = global_5.member[bitcast<u32>(select(0i, _e3775, (_e3775 > 0i)))];
phi_6368_ = (_e3771 + ((_e3780 - _e3771) * (_e3740 - f32(_e3756))));
} else {
phi_6368_ = select(((1f - _e3710) / (_e3716 * sqrt(select(0f, _e3716, (_e3716 > 0f))))), (0.75f * (1f + (_e3705 * _e3705))), (_e3729 == 1u));
}
let _e3787 = phi_6368_;
let _e3790 = (1e-4f * _e2261);
let _e3792 = select(_e2211, _e2182, (_e2182 > _e2211));
let _e3794 = select(_e3790, _e3792, (_e3792 > _e3790));
let _e3796 = select(_e2211, _e2182, (_e2182 < _e2211));
let _e3798 = select(_e3790, _e3796, (_e3796 > _e3790));
let _e3800 = (0.5f * (_e3794 + _e3798));
let _e3801 = (0.5f / _e3798);
let _e3802 = (1f / _e3794);
let _e3804 = (0.5f * _e2261);
let _e3805 = (_e2153 + _e3804);
let _e3806 = -(_e3805);
let _e3809 = (_e3800 - select(_e3806, _e3805, (_e3805 > _e3806)));
let _e3811 = select(0f, _e3809, (_e3809 > 0f));
let _e3813 = select(_e3798, _e3811, (_e3811 < _e3798));
let _e3816 = (_e3809 - _e3798);
let _e3820 = (((_e3813 * (_e3813 * _e3801)) + select(0f, _e3816, (_e3816 > 0f))) * _e3802);
let _e3824 = (_e2153 - _e3804);
let _e3825 = -(_e3824);
let _e3828 = (_e3800 - select(_e3825, _e3824, (_e3824 > _e3825)));
let _e3830 = select(0f, _e3828, (_e3828 > 0f));
let _e3832 = select(_e3798, _e3830, (_e3830 < _e3798));
let _e3835 = (_e3828 - _e3798);
let _e3839 = (((_e3832 * (_e3832 * _e3801)) + select(0f, _e3835, (_e3835 > 0f))) * _e3802);
let _e3846 = (((_e3787 * (0.25f / 3.1415927f)) * ((select(_e3820, (1f - _e3820), (_e3805 >= 0f)) - select(_e3839, (1f - _e3839), (_e3824 >= 0f))) * (1f / _e2261))) * _e3552);
let _e3853 = global_1.member.member_13.member_1;
phi_6486_ = vec3<f32>((((_e2097 * ((1f + (_e3588 * (1f + (_e3588 * (0.5f + (_e3588 * (0.16666667f + (_e3588 * (0.041666668f + (_e3588 * (0.008333334f + (_e3588 * (0.001388889f + (_e3588 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3583 + 127i)) << bitcast<u32>(23i))))) * _e3853.member) * _e3846), (((_e2110 * ((1f + (_e3636 * (1f + (_e3636 * (0.5f + (_e3636 * (0.16666667f + (_e3636 * (0.041666668f + (_e3636 * (0.008333334f + (_e3636 * (0.001388889f + (_e3636 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3631 + 127i)) << bitcast<u32>(23i))))) * _e3853.member_1) * _e3846), (((_e2123 * ((1f + (_e3684 * (1f + (_e3684 * (0.5f + (_e3684 * (0.16666667f + (_e3684 * (0.041666668f + (_e3684 * (0.008333334f + (_e3684 * (0.001388889f + (_e3684 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3679 + 127i)) << bitcast<u32>(23i))))) * _e3853.member_2) * _e3846));
} else {
phi_6486_ = vec3<f32>();
}
let _e3865 = phi_6486_;
phi_6488_ = _e3865;
phi_6489_ = select(true, false, _e2313);
}
let _e3868 = phi_6488_;
let _e3870 = phi_6489_;
let _e3872 = select(_e3868, vec3<f32>(0f, 0f, 0f), vec3(_e3870));
let _e3873 = select(1f, 0f, _e1094);
let _e3887 = select(0f, 1f, _e1094);
phi_6532_ = vec3<f32>((_e1784.x + (_e3872.x * _e3887)), (_e1784.y + (_e3872.y * _e3887)), (_e1784.z + (_e3872.z * _e3887)));
phi_6533_ = vec3<f32>((_e1786.x + (_e3872.x * _e3873)), (_e1786.y + (_e3872.y * _e3873)), (_e1786.z + (_e3872.z * _e3873)));
}
let _e3899 = phi_6532_;
let _e3901 = phi_6533_;
phi_3308_ = _e3899;
phi_3311_ = _e3901;
phi_3313_ = (_e1788 + 1u);
}
let _e3904 = phi_3308_;
let _e3906 = phi_3311_;
let _e3908 = phi_3313_;
continue;
continuing {
phi_3307_ = _e3904;
phi_3310_ = _e3906;
phi_3312_ = _e3908;
break if !(select(true, false, _e1792));
}
}
let _e3911 = local_23.member_1;
phi_6543_ = type_17(_e1103.member, (_e1103.member_1 + 1u));
loop {
let _e3915 = phi_6543_;
local_50 = _e3915;
let _e3921 = (((_e3915.member_1 & 3u) == 0u) && (_e3915.member < _e3911));
if _e3921 {
phi_6544_ = type_17((_e3915.member + 1u), (_e3915.member_1 >> bitcast<u32>(2i)));
} else {
phi_6544_ = type_17();
}
let _e3927 = phi_6544_;
continue;
continuing {
phi_6543_ = _e3927;
break if !(_e3921);
}
}
let _e4148 = local_48;
phi_6565_ = _e4148;
let _e4151 = local_49;
phi_6566_ = _e4151;
let _e4154 = local_50;
phi_6567_ = _e4154;
}
let _e3934 = phi_6565_;
let _e3936 = phi_6566_;
let _e3938 = phi_6567_;
phi_2144_ = _e3934;
phi_2147_ = _e3936;
phi_2149_ = _e3938;
} else {
phi_2144_ = vec3<f32>();
phi_2147_ = vec3<f32>();
phi_2149_ = type_17();
}
let _e3940 = phi_2144_;
let _e3942 = phi_2147_;
let _e3944 = phi_2149_;
continue;
continuing {
phi_2143_ = _e3940;
phi_2146_ = _e3942;
phi_2148_ = _e3944;
break if !(_e1111);
}
}
let _e4160 = local_51;
phi_1944_ = _e4160;
let _e4163 = local_52;
phi_1947_ = _e4163;
phi_1949_ = (_e932 + 1u);
} else {
phi_1944_ = vec3<f32>();
phi_1947_ = vec3<f32>();
phi_1949_ = u32();
}
let _e3948 = phi_1944_;
let _e3950 = phi_1947_;
let _e3952 = phi_1949_;
continue;
continuing {
phi_1943_ = _e3948;
phi_1946_ = _e3950;
phi_1948_ = _e3952;
break if !(_e937);
}
}
let _e3955 = local_39;
let _e3959 = local_40;
let _e3963 = local_41;
let _e3970 = local_42;
let _e3974 = local_43;
let _e3978 = local_44;
phi_6621_ = array<f32, 22>(_e168, _e178, _e189, _e200, _e211, _e222, _e233, _e244, _e255, (_e266 + (_e3955.x * _e797)), (_e277 + (_e3959.y * _e798)), (_e288 + (_e3963.z * _e799)), (_e299 + (_e3970.x * _e797)), (_e310 + (_e3974.y * _e798)), (_e321 + (_e3978.z * _e799)), _e332, _e343, _e354, _e365, _e376, _e387, _e398);
}
let _e3986 = phi_6621_;
global_6.member[_e157] = _e3986[0];
global_6.member[_e169] = _e3986[1];
global_6.member[_e180] = _e3986[2];
global_6.member[_e191] = _e3986[3];
global_6.member[_e202] = _e3986[4];
global_6.member[_e213] = _e3986[5];
global_6.member[_e224] = _e3986[6];
global_6.member[_e235] = _e3986[7];
global_6.member[_e246] = _e3986[8];
global_6.member[_e257] = _e3986[9];
global_6.member[_e268] = _e3986[10];
global_6.member[_e279] = _e3986[11];
global_6.member[_e290] = _e3986[12];
global_6.member[_e301] = _e3986[13];
global_6.member[_e312] = _e3986[14];
global_6.member[_e323] = _e3986[15];
global_6.member[_e334] = _e3986[16];
global_6.member[_e345] = _e3986[17];
global_6.member[_e356] = _e3986[18];
global_6.member[_e367] = _e3986[19];
global_6.member[_e378] = _e3986[20];
global_6.member[_e389] = _e3986[21];
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
