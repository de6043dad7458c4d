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
}
struct type_20 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
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
}
struct type_23 {
member: type_22,
}
struct type_24 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_13;
@group(0) @binding(0)
var<storage> global_2: type_23;
@group(0) @binding(1)
var<storage> global_3: type_13;
@group(0) @binding(2)
var<storage> global_4: type_13;
@group(0) @binding(3)
var<storage> global_5: type_13;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: u32;
var local_7: u32;
var local_8: u32;
var local_9: u32;
var local_10: u32;
var local_11: type_17;
var local_12: u32;
var local_13: type_24;
var local_14: i32;
var local_15: i32;
var phi_1843_: vec3<f32>;
var phi_1846_: vec3<f32>;
var phi_1848_: u32;
var phi_1868_: u32;
var phi_1869_: u32;
var phi_1881_: u32;
var phi_1882_: u32;
var local_16: u32;
var local_17: u32;
var phi_1899_: u32;
var phi_1900_: u32;
var phi_1912_: u32;
var phi_1913_: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var phi_1938_: u32;
var phi_1939_: u32;
var local_21: u32;
var local_22: u32;
var phi_1956_: u32;
var phi_1957_: u32;
var local_23: u32;
var local_24: u32;
var phi_1979_: u32;
var phi_1980_: u32;
var phi_1992_: u32;
var phi_1993_: u32;
var local_25: u32;
var local_26: u32;
var local_27: u32;
var phi_2029_: u32;
var local_28: u32;
var phi_2043_: vec3<f32>;
var phi_2046_: vec3<f32>;
var phi_2048_: type_17;
var phi_2110_: i32;
var phi_2911_: bool;
var phi_3150_: bool;
var phi_4354_: vec3<f32>;
var phi_4393_: vec3<f32>;
var phi_4394_: vec3<f32>;
var phi_4402_: type_17;
var phi_4403_: type_17;
var phi_4424_: vec3<f32>;
var phi_4425_: vec3<f32>;
var phi_4426_: type_17;
var phi_2044_: vec3<f32>;
var phi_2047_: vec3<f32>;
var phi_2049_: type_17;
var phi_1844_: vec3<f32>;
var phi_1847_: vec3<f32>;
var phi_1849_: u32;
var local_29: vec3<f32>;
var local_30: vec3<f32>;
var local_31: vec3<f32>;
var local_32: vec3<f32>;
var local_33: vec3<f32>;
var local_34: vec3<f32>;
var phi_4476_: array<f32, 18>;
var local_35: type_17;
var local_36: vec3<f32>;
var local_37: vec3<f32>;
let _e114 = global;
let _e120 = arrayLength((&global_4.member));
let _e128 = global_2.member.member;
if (_e114.x < _e128.member) {
if (_e114.y < _e128.member_1) {
let _e135 = (_e128.member * _e128.member_1);
let _e137 = ((_e114.y * _e128.member) + _e114.x);
let _e138 = bitcast<i32>(_e137);
let _e140 = (bitcast<i32>(arrayLength((&global_1.member))) - 1i);
let _e142 = select(_e140, _e138, (_e138 < _e140));
let _e148 = global_1.member[bitcast<u32>(select(0i, _e142, (_e142 > 0i)))];
let _e149 = (_e135 + _e137);
let _e150 = bitcast<i32>(_e149);
let _e152 = select(_e140, _e150, (_e150 < _e140));
let _e158 = global_1.member[bitcast<u32>(select(0i, _e152, (_e152 > 0i)))];
let _e160 = ((2u * _e135) + _e137);
let _e161 = bitcast<i32>(_e160);
let _e163 = select(_e140, _e161, (_e161 < _e140));
let _e169 = global_1.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e171 = ((3u * _e135) + _e137);
let _e172 = bitcast<i32>(_e171);
let _e174 = select(_e140, _e172, (_e172 < _e140));
let _e180 = global_1.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e182 = ((4u * _e135) + _e137);
let _e183 = bitcast<i32>(_e182);
let _e185 = select(_e140, _e183, (_e183 < _e140));
let _e191 = global_1.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e193 = ((5u * _e135) + _e137);
let _e194 = bitcast<i32>(_e193);
let _e196 = select(_e140, _e194, (_e194 < _e140));
let _e202 = global_1.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e204 = ((6u * _e135) + _e137);
let _e205 = bitcast<i32>(_e204);
let _e207 = select(_e140, _e205, (_e205 < _e140));
let _e213 = global_1.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e215 = ((7u * _e135) + _e137);
let _e216 = bitcast<i32>(_e215);
let _e218 = select(_e140, _e216, (_e216 < _e140));
let _e224 = global_1.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e226 = ((8u * _e135) + _e137);
let _e227 = bitcast<i32>(_e226);
let _e229 = select(_e140, _e227, (_e227 < _e140));
let _e235 = global_1.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e237 = ((9u * _e135) + _e137);
let _e238 = bitcast<i32>(_e237);
let _e240 = select(_e140, _e238, (_e238 < _e140));
let _e246 = global_1.member[bitcast<u32>(select(0i, _e240, (_e240 > 0i)))];
let _e248 = ((10u * _e135) + _e137);
let _e249 = bitcast<i32>(_e248);
let _e251 = select(_e140, _e249, (_e249 < _e140));
let _e257 = global_1.member[bitcast<u32>(select(0i, _e251, (_e251 > 0i)))];
let _e259 = ((11u * _e135) + _e137);
let _e260 = bitcast<i32>(_e259);
let _e262 = select(_e140, _e260, (_e260 < _e140));
let _e268 = global_1.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e270 = ((12u * _e135) + _e137);
let _e271 = bitcast<i32>(_e270);
let _e273 = select(_e140, _e271, (_e271 < _e140));
let _e279 = global_1.member[bitcast<u32>(select(0i, _e273, (_e273 > 0i)))];
let _e281 = ((13u * _e135) + _e137);
let _e282 = bitcast<i32>(_e281);
let _e284 = select(_e140, _e282, (_e282 < _e140));
let _e290 = global_1.member[bitcast<u32>(select(0i, _e284, (_e284 > 0i)))];
let _e292 = ((14u * _e135) + _e137);
let _e293 = bitcast<i32>(_e292);
let _e295 = select(_e140, _e293, (_e293 < _e140));
let _e301 = global_1.member[bitcast<u32>(select(0i, _e295, (_e295 > 0i)))];
let _e303 = ((15u * _e135) + _e137);
let _e304 = bitcast<i32>(_e303);
let _e306 = select(_e140, _e304, (_e304 < _e140));
let _e312 = global_1.member[bitcast<u32>(select(0i, _e306, (_e306 > 0i)))];
let _e314 = ((16u * _e135) + _e137);
let _e315 = bitcast<i32>(_e314);
let _e317 = select(_e140, _e315, (_e315 < _e140));
let _e323 = global_1.member[bitcast<u32>(select(0i, _e317, (_e317 > 0i)))];
let _e325 = ((17u * _e135) + _e137);
let _e326 = bitcast<i32>(_e325);
let _e328 = select(_e140, _e326, (_e326 < _e140));
let _e334 = global_1.member[bitcast<u32>(select(0i, _e328, (_e328 > 0i)))];
let _e339 = global_2.member.member.member;
let _e343 = global_2.member.member.member_1;
let _e344 = (_e339 * _e343);
local_14 = bitcast<i32>(_e344);
let _e347 = ((_e114.y * _e339) + _e114.x);
let _e348 = bitcast<i32>(_e347);
local_15 = _e348;
let _e349 = local_14;
let _e351 = local_15;
let _e352 = ((29i * _e349) + _e351);
let _e354 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e356 = select(_e354, _e352, (_e352 < _e354));
let _e361 = global_3.member[bitcast<u32>(select(0i, _e356, (_e356 > 0i)))];
let _e363 = local_14;
let _e365 = local_15;
let _e366 = ((36i * _e363) + _e365);
let _e368 = select(_e354, _e366, (_e366 < _e354));
let _e373 = global_3.member[bitcast<u32>(select(0i, _e368, (_e368 > 0i)))];
let _e384 = global_2.member.member_12.member_4;
if (select(0u, 3u, ((_e361 == 2f) && (select(0i, select(select(i32(_e373), i32(-2147483648), (_e373 < -2147483600f)), 2147483647i, (_e373 > 2147483500f)), (_e373 == _e373)) == (bitcast<i32>(_e384) + 1i)))) > 1u) {
let _e392 = select(_e354, _e348, (_e348 < _e354));
let _e398 = global_3.member[bitcast<u32>(select(0i, _e392, (_e392 > 0i)))];
let _e400 = bitcast<i32>((_e344 + _e347));
let _e402 = select(_e354, _e400, (_e400 < _e354));
let _e408 = global_3.member[bitcast<u32>(select(0i, _e402, (_e402 > 0i)))];
let _e411 = bitcast<i32>(((2u * _e344) + _e347));
let _e413 = select(_e354, _e411, (_e411 < _e354));
let _e419 = global_3.member[bitcast<u32>(select(0i, _e413, (_e413 > 0i)))];
let _e422 = bitcast<i32>(((3u * _e344) + _e347));
let _e424 = select(_e354, _e422, (_e422 < _e354));
let _e430 = global_3.member[bitcast<u32>(select(0i, _e424, (_e424 > 0i)))];
let _e433 = bitcast<i32>(((4u * _e344) + _e347));
let _e435 = select(_e354, _e433, (_e433 < _e354));
let _e441 = global_3.member[bitcast<u32>(select(0i, _e435, (_e435 > 0i)))];
let _e444 = bitcast<i32>(((5u * _e344) + _e347));
let _e446 = select(_e354, _e444, (_e444 < _e354));
let _e452 = global_3.member[bitcast<u32>(select(0i, _e446, (_e446 > 0i)))];
let _e455 = bitcast<i32>(((6u * _e344) + _e347));
let _e457 = select(_e354, _e455, (_e455 < _e354));
let _e463 = global_3.member[bitcast<u32>(select(0i, _e457, (_e457 > 0i)))];
let _e466 = bitcast<i32>(((7u * _e344) + _e347));
let _e468 = select(_e354, _e466, (_e466 < _e354));
let _e474 = global_3.member[bitcast<u32>(select(0i, _e468, (_e468 > 0i)))];
let _e477 = bitcast<i32>(((8u * _e344) + _e347));
let _e479 = select(_e354, _e477, (_e477 < _e354));
let _e485 = global_3.member[bitcast<u32>(select(0i, _e479, (_e479 > 0i)))];
let _e488 = bitcast<i32>(((9u * _e344) + _e347));
let _e490 = select(_e354, _e488, (_e488 < _e354));
let _e496 = global_3.member[bitcast<u32>(select(0i, _e490, (_e490 > 0i)))];
let _e499 = bitcast<i32>(((10u * _e344) + _e347));
let _e501 = select(_e354, _e499, (_e499 < _e354));
let _e507 = global_3.member[bitcast<u32>(select(0i, _e501, (_e501 > 0i)))];
let _e510 = bitcast<i32>(((11u * _e344) + _e347));
let _e512 = select(_e354, _e510, (_e510 < _e354));
let _e518 = global_3.member[bitcast<u32>(select(0i, _e512, (_e512 > 0i)))];
let _e521 = bitcast<i32>(((12u * _e344) + _e347));
let _e523 = select(_e354, _e521, (_e521 < _e354));
let _e529 = global_3.member[bitcast<u32>(select(0i, _e523, (_e523 > 0i)))];
let _e532 = bitcast<i32>(((13u * _e344) + _e347));
let _e534 = select(_e354, _e532, (_e532 < _e354));
let _e540 = global_3.member[bitcast<u32>(select(0i, _e534, (_e534 > 0i)))];
let _e543 = bitcast<i32>(((14u * _e344) + _e347));
let _e545 = select(_e354, _e543, (_e543 < _e354));
let _e551 = global_3.member[bitcast<u32>(select(0i, _e545, (_e545 > 0i)))];
let _e554 = bitcast<i32>(((15u * _e344) + _e347));
let _e556 = select(_e354, _e554, (_e554 < _e354));
let _e562 = global_3.member[bitcast<u32>(select(0i, _e556, (_e556 > 0i)))];
let _e565 = bitcast<i32>(((16u * _e344) + _e347));
let _e567 = select(_e354, _e565, (_e565 < _e354));
let _e573 = global_3.member[bitcast<u32>(select(0i, _e567, (_e567 > 0i)))];
let _e576 = bitcast<i32>(((17u * _e344) + _e347));
let _e578 = select(_e354, _e576, (_e576 < _e354));
let _e584 = global_3.member[bitcast<u32>(select(0i, _e578, (_e578 > 0i)))];
let _e587 = bitcast<i32>(((18u * _e344) + _e347));
let _e589 = select(_e354, _e587, (_e587 < _e354));
let _e595 = global_3.member[bitcast<u32>(select(0i, _e589, (_e589 > 0i)))];
let _e598 = bitcast<i32>(((19u * _e344) + _e347));
let _e600 = select(_e354, _e598, (_e598 < _e354));
let _e606 = global_3.member[bitcast<u32>(select(0i, _e600, (_e600 > 0i)))];
let _e609 = bitcast<i32>(((20u * _e344) + _e347));
let _e611 = select(_e354, _e609, (_e609 < _e354));
let _e617 = global_3.member[bitcast<u32>(select(0i, _e611, (_e611 > 0i)))];
let _e620 = bitcast<i32>(((24u * _e344) + _e347));
let _e622 = select(_e354, _e620, (_e620 < _e354));
let _e628 = global_3.member[bitcast<u32>(select(0i, _e622, (_e622 > 0i)))];
let _e631 = bitcast<i32>(((30u * _e344) + _e347));
let _e633 = select(_e354, _e631, (_e631 < _e354));
let _e639 = global_3.member[bitcast<u32>(select(0i, _e633, (_e633 > 0i)))];
let _e647 = (select(0i, select(select(i32(_e639), i32(-2147483648), (_e639 < -2147483600f)), 2147483647i, (_e639 > 2147483500f)), (_e639 == _e639)) == 0i);
let _e655 = global_2.member.member_1.member;
let _e661 = global_2.member.member_1.member_1;
let _e671 = global_2.member.member_2.member;
let _e672 = (((((f32(bitcast<i32>(_e114.x)) + 0.5f) / f32(bitcast<i32>(_e655))) * 2f) - 1f) * _e671);
let _e680 = global_2.member.member_2.member_1;
let _e681 = ((1f - (((f32(bitcast<i32>(_e114.y)) + 0.5f) / f32(bitcast<i32>(_e661))) * 2f)) * _e680);
let _e684 = global_2.member.member_3;
let _e693 = global_2.member.member_4;
let _e706 = global_2.member.member_2.member_3;
let _e707 = (_e706 != 0u);
let _e710 = global_2.member.member_6;
let _e717 = select(_e710.member, (_e710.member + ((_e684.member * _e672) + (_e693.member * _e681))), _e707);
let _e718 = select(_e710.member_1, (_e710.member_1 + ((_e684.member_1 * _e672) + (_e693.member_1 * _e681))), _e707);
let _e719 = select(_e710.member_2, (_e710.member_2 + ((_e684.member_2 * _e672) + (_e693.member_2 * _e681))), _e707);
let _e729 = select(_e398, _e717, _e647);
let _e730 = select(_e408, _e718, _e647);
let _e731 = select(_e419, _e719, _e647);
let _e732 = (select(0f, ((((_e398 - _e717) * _e430) + ((_e408 - _e718) * _e441)) + ((_e419 - _e719) * _e452)), _e647) + _e628);
let _e733 = select(_e595, 1f, _e647);
let _e734 = select(_e606, 1f, _e647);
let _e735 = select(_e617, 1f, _e647);
let _e743 = (1f / select(_e430, select(1e-12f, -1e-12f, (_e430 < 0f)), (bitcast<f32>((bitcast<u32>(_e430) & 2147483647u)) < 1e-12f)));
let _e751 = (1f / select(_e441, select(1e-12f, -1e-12f, (_e441 < 0f)), (bitcast<f32>((bitcast<u32>(_e441) & 2147483647u)) < 1e-12f)));
let _e759 = (1f / select(_e452, select(1e-12f, -1e-12f, (_e452 < 0f)), (bitcast<f32>((bitcast<u32>(_e452) & 2147483647u)) < 1e-12f)));
let _e763 = global_2.member.member_13.member_4;
let _e770 = global_2.member.member_13.member_5;
let _e775 = ((_e763.member - _e729) * _e743);
let _e777 = ((_e770.member - _e729) * _e743);
let _e779 = ((_e763.member_1 - _e730) * _e751);
let _e781 = ((_e770.member_1 - _e730) * _e751);
let _e783 = ((_e763.member_2 - _e731) * _e759);
let _e785 = ((_e770.member_2 - _e731) * _e759);
let _e787 = select(_e777, _e775, (_e775 < _e777));
let _e789 = select(_e781, _e779, (_e779 < _e781));
let _e791 = select(_e789, _e787, (_e787 > _e789));
let _e793 = select(_e785, _e783, (_e783 < _e785));
let _e795 = select(_e793, _e791, (_e791 > _e793));
let _e797 = select(_e777, _e775, (_e775 > _e777));
let _e799 = select(_e781, _e779, (_e779 > _e781));
let _e801 = select(_e799, _e797, (_e797 < _e799));
let _e803 = select(_e785, _e783, (_e783 > _e785));
let _e805 = select(_e803, _e801, (_e801 < _e803));
let _e807 = select(0f, _e795, (_e795 > 0f));
let _e809 = select(_e732, _e805, (_e805 < _e732));
let _e810 = (_e809 > _e807);
let _e811 = select(0f, _e807, _e810);
let _e812 = select(0f, _e809, _e810);
if ((_e647 || (_e812 <= _e811)) || ((((_e733 + _e734) + _e735) * (1f / 3f)) < 0.01f)) {
phi_4476_ = array<f32, 18>(_e148, _e158, _e169, _e180, _e191, _e202, _e213, _e224, _e235, _e246, _e257, _e268, _e279, _e290, _e301, _e312, _e323, _e334);
} else {
let _e825 = (((_e463 * _e463) + (_e474 * _e474)) + (_e485 * _e485));
let _e833 = (((_e496 * _e496) + (_e507 * _e507)) + (_e518 * _e518));
let _e838 = (0.5f * (sqrt(select(0f, _e825, (_e825 > 0f))) + sqrt(select(0f, _e833, (_e833 > 0f)))));
let _e843 = (((_e529 * _e529) + (_e540 * _e540)) + (_e551 * _e551));
let _e851 = (((_e562 * _e562) + (_e573 * _e573)) + (_e584 * _e584));
let _e856 = (0.5f * (sqrt(select(0f, _e843, (_e843 > 0f))) + sqrt(select(0f, _e851, (_e851 > 0f)))));
let _e860 = global_2.member.member_11.member;
let _e862 = bitcast<i32>((_e860 * _e860));
phi_1843_ = vec3<f32>(0f, 0f, 0f);
phi_1846_ = vec3<f32>(0f, 0f, 0f);
phi_1848_ = 0u;
loop {
let _e864 = phi_1843_;
let _e866 = phi_1846_;
let _e868 = phi_1848_;
local_29 = _e866;
local_30 = _e866;
local_31 = _e866;
local_32 = _e864;
local_33 = _e864;
local_34 = _e864;
let _e872 = global_2.member.member_12.member_8;
let _e873 = (_e868 <= _e872);
if _e873 {
let _e877 = global_2.member.member_12.member_5;
let _e879 = bitcast<i32>((_e868 * _e877));
phi_1868_ = 0u;
loop {
let _e881 = phi_1868_;
local_28 = _e881;
let _e885 = ((1u << bitcast<u32>((_e881 & 31u))) < _e860);
if _e885 {
phi_1869_ = (_e881 + 1u);
} else {
phi_1869_ = u32();
}
let _e888 = phi_1869_;
continue;
continuing {
phi_1868_ = _e888;
break if !(_e885);
}
}
phi_1881_ = 0u;
loop {
let _e891 = phi_1881_;
local_16 = _e891;
local_17 = _e891;
let _e895 = ((1u << bitcast<u32>((_e891 & 31u))) < _e860);
if _e895 {
phi_1882_ = (_e891 + 1u);
} else {
phi_1882_ = u32();
}
let _e898 = phi_1882_;
continue;
continuing {
phi_1881_ = _e898;
break if !(_e895);
}
}
let _e901 = local_16;
let _e904 = local_17;
phi_1899_ = 0u;
loop {
let _e907 = phi_1899_;
local_20 = _e907;
let _e911 = ((1u << bitcast<u32>((_e907 & 31u))) < _e860);
if _e911 {
phi_1900_ = (_e907 + 1u);
} else {
phi_1900_ = u32();
}
let _e914 = phi_1900_;
continue;
continuing {
phi_1899_ = _e914;
break if !(_e911);
}
}
phi_1912_ = 0u;
loop {
let _e917 = phi_1912_;
local_18 = _e917;
local_19 = _e917;
let _e921 = ((1u << bitcast<u32>((_e917 & 31u))) < _e860);
if _e921 {
phi_1913_ = (_e917 + 1u);
} else {
phi_1913_ = u32();
}
let _e924 = phi_1913_;
continue;
continuing {
phi_1912_ = _e924;
break if !(_e921);
}
}
let _e927 = local_18;
let _e930 = local_19;
let _e933 = local_20;
let _e942 = global_2.member.member_12.member_7;
phi_1938_ = 0u;
loop {
let _e945 = phi_1938_;
local_21 = _e945;
local_22 = _e945;
let _e949 = ((1u << bitcast<u32>((_e945 & 31u))) < _e860);
if _e949 {
phi_1939_ = (_e945 + 1u);
} else {
phi_1939_ = u32();
}
let _e952 = phi_1939_;
continue;
continuing {
phi_1938_ = _e952;
break if !(_e949);
}
}
let _e955 = local_21;
let _e958 = local_22;
phi_1956_ = 0u;
loop {
let _e961 = phi_1956_;
local_23 = _e961;
local_24 = _e961;
let _e965 = ((1u << bitcast<u32>((_e961 & 31u))) < _e860);
if _e965 {
phi_1957_ = (_e961 + 1u);
} else {
phi_1957_ = u32();
}
let _e968 = phi_1957_;
continue;
continuing {
phi_1956_ = _e968;
break if !(_e965);
}
}
let _e971 = local_23;
let _e977 = local_24;
phi_1979_ = 0u;
loop {
let _e987 = phi_1979_;
local_27 = _e987;
let _e991 = ((1u << bitcast<u32>((_e987 & 31u))) < _e860);
if _e991 {
phi_1980_ = (_e987 + 1u);
} else {
phi_1980_ = u32();
}
let _e994 = phi_1980_;
continue;
continuing {
phi_1979_ = _e994;
break if !(_e991);
}
}
phi_1992_ = 0u;
loop {
let _e997 = phi_1992_;
local_25 = _e997;
local_26 = _e997;
let _e1001 = ((1u << bitcast<u32>((_e997 & 31u))) < _e860);
if _e1001 {
phi_1993_ = (_e997 + 1u);
} else {
phi_1993_ = u32();
}
let _e1004 = phi_1993_;
continue;
continuing {
phi_1992_ = _e1004;
break if !(_e1001);
}
}
let _e1007 = local_25;
let _e1010 = local_26;
let _e1013 = local_27;
let _e1019 = (((((1u << bitcast<u32>(((2u * _e971) & 31u))) - (1u << bitcast<u32>(((2u * (_e977 - select(6u, _e958, (_e955 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1013 - select(6u, _e1010, (_e1007 < 6u)))) & 31u))));
let _e1020 = (_e1019 / 64u);
if ((_e1019 % 64u) > 0u) {
phi_2029_ = (_e1020 + 1u);
} else {
phi_2029_ = _e1020;
}
let _e1025 = phi_2029_;
let _e1028 = local_28;
local_13 = type_24(_e1028, select(6u, _e904, (_e901 < 6u)), (1u << bitcast<u32>(((2u * (_e933 - select(6u, _e930, (_e927 < 6u)))) & 31u))), (_e868 * _e942), (_e1025 * 64u));
let _e1030 = (_e868 == 0u);
let _e1032 = local_13.member_1;
phi_2043_ = _e864;
phi_2046_ = _e866;
phi_2048_ = type_17(_e1032, 0u);
loop {
let _e1035 = phi_2043_;
let _e1037 = phi_2046_;
let _e1039 = phi_2048_;
local_36 = _e1035;
local_37 = _e1037;
let _e1042 = local_13.member_1;
let _e1045 = local_13.member_2;
let _e1047 = ((_e1039.member < _e1042) || (_e1039.member_1 < _e1045));
if _e1047 {
let _e1048 = (_e1039.member_1 & 1431655765u);
let _e1052 = ((_e1048 | (_e1048 >> bitcast<u32>(1i))) & 858993459u);
let _e1056 = ((_e1052 | (_e1052 >> bitcast<u32>(2i))) & 252645135u);
let _e1060 = ((_e1056 | (_e1056 >> bitcast<u32>(4i))) & 16711935u);
let _e1064 = ((_e1060 | (_e1060 >> bitcast<u32>(8i))) & 65535u);
let _e1067 = ((_e1039.member_1 >> bitcast<u32>(1i)) & 1431655765u);
let _e1071 = ((_e1067 | (_e1067 >> bitcast<u32>(1i))) & 858993459u);
let _e1075 = ((_e1071 | (_e1071 >> bitcast<u32>(2i))) & 252645135u);
let _e1079 = ((_e1075 | (_e1075 >> bitcast<u32>(4i))) & 16711935u);
let _e1083 = ((_e1079 | (_e1079 >> bitcast<u32>(8i))) & 65535u);
let _e1086 = ((_e1064 < _e860) && (_e1083 < _e860));
if _e1086 {
phi_2110_ = bitcast<i32>(((_e1083 * _e860) + _e1064));
} else {
phi_2110_ = 0i;
}
let _e1091 = phi_2110_;
let _e1092 = (_e1039.member > 0u);
if _e1092 {
local_11.member = _e1039.member;
local_11.member_1 = _e1039.member_1;
let _e1231 = local_11.member;
let _e1232 = local_11.member_1;
let _e1234 = local_13.member;
let _e1249 = local_13.member_3;
local_12 = (_e1249 + (((((1u << bitcast<u32>(((2u * _e1234) & 31u))) - (1u << bitcast<u32>(((2u * (_e1234 - _e1231)) & 31u)))) / 3u) * 4u) + _e1232));
let _e1251 = local_12;
let _e1252 = bitcast<i32>(_e1251);
let _e1254 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1256 = select(_e1254, _e1252, (_e1252 < _e1254));
let _e1261 = global_5.member[bitcast<u32>(select(0i, _e1256, (_e1256 > 0i)))];
let _e1262 = local_12;
let _e1264 = local_13.member_4;
let _e1266 = bitcast<i32>((_e1262 + _e1264));
let _e1268 = select(_e1254, _e1266, (_e1266 < _e1254));
let _e1273 = global_5.member[bitcast<u32>(select(0i, _e1268, (_e1268 > 0i)))];
let _e1274 = local_12;
let _e1275 = local_13.member_4;
let _e1278 = bitcast<i32>((_e1274 + (2u * _e1275)));
let _e1280 = select(_e1254, _e1278, (_e1278 < _e1254));
let _e1285 = global_5.member[bitcast<u32>(select(0i, _e1280, (_e1280 > 0i)))];
let _e1286 = local_11.member;
let _e1287 = local_11.member_1;
let _e1288 = local_13.member;
let _e1302 = local_13.member_3;
let _e1303 = local_13.member_4;
local_10 = ((_e1302 + (3u * _e1303)) + (((((1u << bitcast<u32>(((2u * _e1288) & 31u))) - (1u << bitcast<u32>(((2u * (_e1288 - _e1286)) & 31u)))) / 3u) * 4u) + _e1287));
let _e1307 = local_10;
let _e1308 = bitcast<i32>(_e1307);
let _e1310 = select(_e1254, _e1308, (_e1308 < _e1254));
let _e1315 = global_5.member[bitcast<u32>(select(0i, _e1310, (_e1310 > 0i)))];
let _e1316 = local_10;
let _e1317 = local_13.member_4;
let _e1319 = bitcast<i32>((_e1316 + _e1317));
let _e1321 = select(_e1254, _e1319, (_e1319 < _e1254));
let _e1326 = global_5.member[bitcast<u32>(select(0i, _e1321, (_e1321 > 0i)))];
let _e1327 = local_10;
let _e1328 = local_13.member_4;
let _e1331 = bitcast<i32>((_e1327 + (2u * _e1328)));
let _e1333 = select(_e1254, _e1331, (_e1331 < _e1254));
let _e1338 = global_5.member[bitcast<u32>(select(0i, _e1333, (_e1333 > 0i)))];
let _e1340 = ((_e1261 - _e729) * _e743);
let _e1342 = ((_e1315 - _e729) * _e743);
let _e1344 = ((_e1273 - _e730) * _e751);
let _e1346 = ((_e1326 - _e730) * _e751);
let _e1348 = ((_e1285 - _e731) * _e759);
let _e1350 = ((_e1338 - _e731) * _e759);
let _e1352 = select(_e1342, _e1340, (_e1340 < _e1342));
let _e1354 = select(_e1346, _e1344, (_e1344 < _e1346));
let _e1356 = select(_e1354, _e1352, (_e1352 > _e1354));
let _e1358 = select(_e1350, _e1348, (_e1348 < _e1350));
let _e1360 = select(_e1358, _e1356, (_e1356 > _e1358));
let _e1362 = select(_e1342, _e1340, (_e1340 > _e1342));
let _e1364 = select(_e1346, _e1344, (_e1344 > _e1346));
let _e1366 = select(_e1364, _e1362, (_e1362 < _e1364));
let _e1368 = select(_e1350, _e1348, (_e1348 > _e1350));
let _e1370 = select(_e1368, _e1366, (_e1366 < _e1368));
if ((_e1261 <= _e1315) && (select(_e811, _e1360, (_e1360 > _e811)) <= select(_e812, _e1370, (_e1370 < _e812)))) {
let _e1378 = local_11.member;
let _e1379 = local_11.member_1;
let _e1380 = local_13.member;
let _e1394 = local_13.member_3;
let _e1395 = local_13.member_4;
local_9 = ((_e1394 + (6u * _e1395)) + (((((1u << bitcast<u32>(((2u * _e1380) & 31u))) - (1u << bitcast<u32>(((2u * (_e1380 - _e1378)) & 31u)))) / 3u) * 4u) + _e1379));
let _e1399 = local_9;
let _e1400 = bitcast<i32>(_e1399);
let _e1402 = select(_e1254, _e1400, (_e1400 < _e1254));
let _e1407 = global_5.member[bitcast<u32>(select(0i, _e1402, (_e1402 > 0i)))];
let _e1408 = local_9;
let _e1409 = local_13.member_4;
let _e1411 = bitcast<i32>((_e1408 + _e1409));
let _e1413 = select(_e1254, _e1411, (_e1411 < _e1254));
let _e1418 = global_5.member[bitcast<u32>(select(0i, _e1413, (_e1413 > 0i)))];
let _e1419 = local_9;
let _e1420 = local_13.member_4;
let _e1423 = bitcast<i32>((_e1419 + (2u * _e1420)));
let _e1425 = select(_e1254, _e1423, (_e1423 < _e1254));
let _e1430 = global_5.member[bitcast<u32>(select(0i, _e1425, (_e1425 > 0i)))];
let _e1431 = local_11.member;
let _e1432 = local_11.member_1;
let _e1433 = local_13.member;
let _e1447 = local_13.member_3;
let _e1448 = local_13.member_4;
local_8 = ((_e1447 + (9u * _e1448)) + (((((1u << bitcast<u32>(((2u * _e1433) & 31u))) - (1u << bitcast<u32>(((2u * (_e1433 - _e1431)) & 31u)))) / 3u) * 4u) + _e1432));
let _e1452 = local_8;
let _e1453 = bitcast<i32>(_e1452);
let _e1455 = select(_e1254, _e1453, (_e1453 < _e1254));
let _e1460 = global_5.member[bitcast<u32>(select(0i, _e1455, (_e1455 > 0i)))];
let _e1461 = local_8;
let _e1462 = local_13.member_4;
let _e1464 = bitcast<i32>((_e1461 + _e1462));
let _e1466 = select(_e1254, _e1464, (_e1464 < _e1254));
let _e1471 = global_5.member[bitcast<u32>(select(0i, _e1466, (_e1466 > 0i)))];
let _e1472 = local_8;
let _e1473 = local_13.member_4;
let _e1476 = bitcast<i32>((_e1472 + (2u * _e1473)));
let _e1478 = select(_e1254, _e1476, (_e1476 < _e1254));
let _e1483 = global_5.member[bitcast<u32>(select(0i, _e1478, (_e1478 > 0i)))];
let _e1484 = local_11.member;
let _e1485 = local_11.member_1;
let _e1486 = local_13.member;
let _e1500 = local_13.member_3;
let _e1501 = local_13.member_4;
local_7 = ((_e1500 + (12u * _e1501)) + (((((1u << bitcast<u32>(((2u * _e1486) & 31u))) - (1u << bitcast<u32>(((2u * (_e1486 - _e1484)) & 31u)))) / 3u) * 4u) + _e1485));
let _e1505 = local_7;
let _e1506 = bitcast<i32>(_e1505);
let _e1508 = select(_e1254, _e1506, (_e1506 < _e1254));
let _e1513 = global_5.member[bitcast<u32>(select(0i, _e1508, (_e1508 > 0i)))];
let _e1514 = local_7;
let _e1515 = local_13.member_4;
let _e1517 = bitcast<i32>((_e1514 + _e1515));
let _e1519 = select(_e1254, _e1517, (_e1517 < _e1254));
let _e1524 = global_5.member[bitcast<u32>(select(0i, _e1519, (_e1519 > 0i)))];
let _e1525 = local_7;
let _e1526 = local_13.member_4;
let _e1529 = bitcast<i32>((_e1525 + (2u * _e1526)));
let _e1531 = select(_e1254, _e1529, (_e1529 < _e1254));
let _e1536 = global_5.member[bitcast<u32>(select(0i, _e1531, (_e1531 > 0i)))];
let _e1537 = local_11.member;
let _e1538 = local_11.member_1;
let _e1539 = local_13.member;
let _e1553 = local_13.member_3;
let _e1554 = local_13.member_4;
local_6 = ((_e1553 + (15u * _e1554)) + (((((1u << bitcast<u32>(((2u * _e1539) & 31u))) - (1u << bitcast<u32>(((2u * (_e1539 - _e1537)) & 31u)))) / 3u) * 4u) + _e1538));
let _e1558 = local_6;
let _e1559 = bitcast<i32>(_e1558);
let _e1561 = select(_e1254, _e1559, (_e1559 < _e1254));
let _e1566 = global_5.member[bitcast<u32>(select(0i, _e1561, (_e1561 > 0i)))];
let _e1567 = local_6;
let _e1568 = local_13.member_4;
let _e1570 = bitcast<i32>((_e1567 + _e1568));
let _e1572 = select(_e1254, _e1570, (_e1570 < _e1254));
let _e1577 = global_5.member[bitcast<u32>(select(0i, _e1572, (_e1572 > 0i)))];
let _e1578 = local_6;
let _e1579 = local_13.member_4;
let _e1582 = bitcast<i32>((_e1578 + (2u * _e1579)));
let _e1584 = select(_e1254, _e1582, (_e1582 < _e1254));
let _e1589 = global_5.member[bitcast<u32>(select(0i, _e1584, (_e1584 > 0i)))];
let _e1590 = (_e1407 - _e729);
let _e1591 = (_e1418 - _e730);
let _e1592 = (_e1430 - _e731);
let _e1595 = ((_e1524 * _e452) - (_e1536 * _e441));
let _e1598 = ((_e1536 * _e430) - (_e1513 * _e452));
let _e1601 = ((_e1513 * _e441) - (_e1524 * _e430));
let _e1649 = (((_e1460 * _e1460) + (_e1471 * _e1471)) + (_e1483 * _e1483));
let _e1652 = sqrt(select(0f, _e1649, (_e1649 > 0f)));
let _e1657 = (((_e1566 * _e1566) + (_e1577 * _e1577)) + (_e1589 * _e1589));
let _e1667 = (((_e1590 * _e1590) + (_e1591 * _e1591)) + (_e1592 * _e1592));
phi_2911_ = (bitcast<f32>((bitcast<u32>((((_e1590 * _e1595) + (_e1591 * _e1598)) + (_e1592 * _e1601))) & 2147483647u)) <= ((((((bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u)) * _e1460) + (bitcast<f32>((bitcast<u32>(_e1598) & 2147483647u)) * _e1471)) + (bitcast<f32>((bitcast<u32>(_e1601) & 2147483647u)) * _e1483)) + (((bitcast<f32>((bitcast<u32>(((_e441 * _e1592) - (_e452 * _e1591))) & 2147483647u)) * _e1566) + (bitcast<f32>((bitcast<u32>(((_e452 * _e1590) - (_e430 * _e1592))) & 2147483647u)) * _e1577)) + (bitcast<f32>((bitcast<u32>(((_e430 * _e1591) - (_e441 * _e1590))) & 2147483647u)) * _e1589))) + (_e1652 * sqrt(select(0f, _e1657, (_e1657 > 0f))))) + (_e838 + (_e856 * (sqrt(select(0f, _e1667, (_e1667 > 0f))) + _e1652)))));
} else {
phi_2911_ = false;
}
let _e1680 = phi_2911_;
phi_3150_ = _e1680;
} else {
local_3 = _e879;
local_4 = _e1091;
local_5 = _e862;
let _e1093 = local_3;
let _e1094 = local_4;
let _e1095 = (_e1093 + _e1094);
let _e1097 = (bitcast<i32>(_e120) - 1i);
let _e1099 = select(_e1097, _e1095, (_e1095 < _e1097));
let _e1104 = global_4.member[bitcast<u32>(select(0i, _e1099, (_e1099 > 0i)))];
let _e1105 = local_3;
let _e1106 = local_5;
let _e1108 = local_4;
let _e1109 = ((_e1105 + _e1106) + _e1108);
let _e1111 = select(_e1097, _e1109, (_e1109 < _e1097));
let _e1116 = global_4.member[bitcast<u32>(select(0i, _e1111, (_e1111 > 0i)))];
let _e1117 = local_3;
let _e1118 = local_5;
let _e1121 = local_4;
let _e1122 = ((_e1117 + (2i * _e1118)) + _e1121);
let _e1124 = select(_e1097, _e1122, (_e1122 < _e1097));
let _e1129 = global_4.member[bitcast<u32>(select(0i, _e1124, (_e1124 > 0i)))];
let _e1130 = local_3;
let _e1131 = local_5;
let _e1134 = local_4;
let _e1135 = ((_e1130 + (3i * _e1131)) + _e1134);
let _e1137 = select(_e1097, _e1135, (_e1135 < _e1097));
let _e1142 = global_4.member[bitcast<u32>(select(0i, _e1137, (_e1137 > 0i)))];
let _e1143 = local_3;
let _e1144 = local_5;
let _e1147 = local_4;
let _e1148 = ((_e1143 + (4i * _e1144)) + _e1147);
let _e1150 = select(_e1097, _e1148, (_e1148 < _e1097));
let _e1155 = global_4.member[bitcast<u32>(select(0i, _e1150, (_e1150 > 0i)))];
let _e1156 = local_3;
let _e1157 = local_5;
let _e1160 = local_4;
let _e1161 = ((_e1156 + (5i * _e1157)) + _e1160);
let _e1163 = select(_e1097, _e1161, (_e1161 < _e1097));
let _e1168 = global_4.member[bitcast<u32>(select(0i, _e1163, (_e1163 > 0i)))];
let _e1169 = (_e1104 - _e729);
let _e1170 = (_e1116 - _e730);
let _e1171 = (_e1129 - _e731);
let _e1190 = (((_e1169 * _e1169) + (_e1170 * _e1170)) + (_e1171 * _e1171));
let _e1194 = local_3;
let _e1195 = local_5;
let _e1198 = local_4;
let _e1199 = ((_e1194 + (21i * _e1195)) + _e1198);
let _e1201 = select(_e1097, _e1199, (_e1199 < _e1097));
let _e1206 = global_4.member[bitcast<u32>(select(0i, _e1201, (_e1201 > 0i)))];
let _e1211 = local_3;
let _e1212 = local_5;
let _e1215 = local_4;
let _e1216 = ((_e1211 + (22i * _e1212)) + _e1215);
let _e1218 = select(_e1097, _e1216, (_e1216 < _e1097));
let _e1223 = global_4.member[bitcast<u32>(select(0i, _e1218, (_e1218 > 0i)))];
phi_3150_ = (_e1086 && (bitcast<f32>((bitcast<u32>((((_e430 * ((_e1170 * _e1168) - (_e1171 * _e1155))) + (_e441 * ((_e1171 * _e1142) - (_e1169 * _e1168)))) + (_e452 * ((_e1169 * _e1155) - (_e1170 * _e1142))))) & 2147483647u)) <= ((_e1206 + _e838) + ((_e1223 + _e856) * sqrt(select(0f, _e1190, (_e1190 > 0f)))))));
}
let _e1682 = phi_3150_;
if (_e1682 && _e1092) {
phi_4424_ = _e1035;
phi_4425_ = _e1037;
phi_4426_ = type_17((_e1039.member - 1u), (_e1039.member_1 << bitcast<u32>(2i)));
} else {
if _e1682 {
local = _e879;
local_1 = _e1091;
local_2 = _e862;
let _e1684 = local;
let _e1685 = local_1;
let _e1686 = (_e1684 + _e1685);
let _e1688 = (bitcast<i32>(_e120) - 1i);
let _e1690 = select(_e1688, _e1686, (_e1686 < _e1688));
let _e1695 = global_4.member[bitcast<u32>(select(0i, _e1690, (_e1690 > 0i)))];
let _e1696 = local;
let _e1697 = local_2;
let _e1699 = local_1;
let _e1700 = ((_e1696 + _e1697) + _e1699);
let _e1702 = select(_e1688, _e1700, (_e1700 < _e1688));
let _e1707 = global_4.member[bitcast<u32>(select(0i, _e1702, (_e1702 > 0i)))];
let _e1708 = local;
let _e1709 = local_2;
let _e1712 = local_1;
let _e1713 = ((_e1708 + (2i * _e1709)) + _e1712);
let _e1715 = select(_e1688, _e1713, (_e1713 < _e1688));
let _e1720 = global_4.member[bitcast<u32>(select(0i, _e1715, (_e1715 > 0i)))];
let _e1721 = local;
let _e1722 = local_2;
let _e1725 = local_1;
let _e1726 = ((_e1721 + (3i * _e1722)) + _e1725);
let _e1728 = select(_e1688, _e1726, (_e1726 < _e1688));
let _e1733 = global_4.member[bitcast<u32>(select(0i, _e1728, (_e1728 > 0i)))];
let _e1734 = local;
let _e1735 = local_2;
let _e1738 = local_1;
let _e1739 = ((_e1734 + (4i * _e1735)) + _e1738);
let _e1741 = select(_e1688, _e1739, (_e1739 < _e1688));
let _e1746 = global_4.member[bitcast<u32>(select(0i, _e1741, (_e1741 > 0i)))];
let _e1747 = local;
let _e1748 = local_2;
let _e1751 = local_1;
let _e1752 = ((_e1747 + (5i * _e1748)) + _e1751);
let _e1754 = select(_e1688, _e1752, (_e1752 < _e1688));
let _e1759 = global_4.member[bitcast<u32>(select(0i, _e1754, (_e1754 > 0i)))];
let _e1760 = local;
let _e1761 = local_2;
let _e1764 = local_1;
let _e1765 = ((_e1760 + (6i * _e1761)) + _e1764);
let _e1767 = select(_e1688, _e1765, (_e1765 < _e1688));
let _e1772 = global_4.member[bitcast<u32>(select(0i, _e1767, (_e1767 > 0i)))];
let _e1773 = local;
let _e1774 = local_2;
let _e1777 = local_1;
let _e1778 = ((_e1773 + (7i * _e1774)) + _e1777);
let _e1780 = select(_e1688, _e1778, (_e1778 < _e1688));
let _e1785 = global_4.member[bitcast<u32>(select(0i, _e1780, (_e1780 > 0i)))];
let _e1786 = local;
let _e1787 = local_2;
let _e1790 = local_1;
let _e1791 = ((_e1786 + (8i * _e1787)) + _e1790);
let _e1793 = select(_e1688, _e1791, (_e1791 < _e1688));
let _e1798 = global_4.member[bitcast<u32>(select(0i, _e1793, (_e1793 > 0i)))];
let _e1799 = local;
let _e1800 = local_2;
let _e1803 = local_1;
let _e1804 = ((_e1799 + (9i * _e1800)) + _e1803);
let _e1806 = select(_e1688, _e1804, (_e1804 < _e1688));
let _e1811 = global_4.member[bitcast<u32>(select(0i, _e1806, (_e1806 > 0i)))];
let _e1812 = local;
let _e1813 = local_2;
let _e1816 = local_1;
let _e1817 = ((_e1812 + (10i * _e1813)) + _e1816);
let _e1819 = select(_e1688, _e1817, (_e1817 < _e1688));
let _e1824 = global_4.member[bitcast<u32>(select(0i, _e1819, (_e1819 > 0i)))];
let _e1825 = local;
let _e1826 = local_2;
let _e1829 = local_1;
let _e1830 = ((_e1825 + (11i * _e1826)) + _e1829);
let _e1832 = select(_e1688, _e1830, (_e1830 < _e1688));
let _e1837 = global_4.member[bitcast<u32>(select(0i, _e1832, (_e1832 > 0i)))];
let _e1838 = local;
let _e1839 = local_2;
let _e1842 = local_1;
let _e1843 = ((_e1838 + (12i * _e1839)) + _e1842);
let _e1845 = select(_e1688, _e1843, (_e1843 < _e1688));
let _e1850 = global_4.member[bitcast<u32>(select(0i, _e1845, (_e1845 > 0i)))];
let _e1851 = local;
let _e1852 = local_2;
let _e1855 = local_1;
let _e1856 = ((_e1851 + (13i * _e1852)) + _e1855);
let _e1858 = select(_e1688, _e1856, (_e1856 < _e1688));
let _e1863 = global_4.member[bitcast<u32>(select(0i, _e1858, (_e1858 > 0i)))];
let _e1864 = local;
let _e1865 = local_2;
let _e1868 = local_1;
let _e1869 = ((_e1864 + (14i * _e1865)) + _e1868);
let _e1871 = select(_e1688, _e1869, (_e1869 < _e1688));
let _e1876 = global_4.member[bitcast<u32>(select(0i, _e1871, (_e1871 > 0i)))];
let _e1877 = local;
let _e1878 = local_2;
let _e1881 = local_1;
let _e1882 = ((_e1877 + (15i * _e1878)) + _e1881);
let _e1884 = select(_e1688, _e1882, (_e1882 < _e1688));
let _e1889 = global_4.member[bitcast<u32>(select(0i, _e1884, (_e1884 > 0i)))];
let _e1890 = local;
let _e1891 = local_2;
let _e1894 = local_1;
let _e1895 = ((_e1890 + (16i * _e1891)) + _e1894);
let _e1897 = select(_e1688, _e1895, (_e1895 < _e1688));
let _e1902 = global_4.member[bitcast<u32>(select(0i, _e1897, (_e1897 > 0i)))];
let _e1903 = local;
let _e1904 = local_2;
let _e1907 = local_1;
let _e1908 = ((_e1903 + (17i * _e1904)) + _e1907);
let _e1910 = select(_e1688, _e1908, (_e1908 < _e1688));
let _e1915 = global_4.member[bitcast<u32>(select(0i, _e1910, (_e1910 > 0i)))];
let _e1916 = local;
let _e1917 = local_2;
let _e1920 = local_1;
let _e1921 = ((_e1916 + (18i * _e1917)) + _e1920);
let _e1923 = select(_e1688, _e1921, (_e1921 < _e1688));
let _e1928 = global_4.member[bitcast<u32>(select(0i, _e1923, (_e1923 > 0i)))];
let _e1929 = local;
let _e1930 = local_2;
let _e1933 = local_1;
let _e1934 = ((_e1929 + (19i * _e1930)) + _e1933);
let _e1936 = select(_e1688, _e1934, (_e1934 < _e1688));
let _e1941 = global_4.member[bitcast<u32>(select(0i, _e1936, (_e1936 > 0i)))];
let _e1942 = local;
let _e1943 = local_2;
let _e1946 = local_1;
let _e1947 = ((_e1942 + (20i * _e1943)) + _e1946);
let _e1949 = select(_e1688, _e1947, (_e1947 < _e1688));
let _e1954 = global_4.member[bitcast<u32>(select(0i, _e1949, (_e1949 > 0i)))];
let _e1955 = local;
let _e1956 = local_2;
let _e1959 = local_1;
let _e1960 = ((_e1955 + (23i * _e1956)) + _e1959);
let _e1962 = select(_e1688, _e1960, (_e1960 < _e1688));
let _e1967 = global_4.member[bitcast<u32>(select(0i, _e1962, (_e1962 > 0i)))];
let _e1968 = (_e1695 - _e729);
let _e1969 = (_e1707 - _e730);
let _e1970 = (_e1720 - _e731);
let _e1973 = ((_e1969 * _e1759) - (_e1970 * _e1746));
let _e1976 = ((_e1970 * _e1733) - (_e1968 * _e1759));
let _e1979 = ((_e1968 * _e1746) - (_e1969 * _e1733));
let _e1984 = (((_e430 * _e1973) + (_e441 * _e1976)) + (_e452 * _e1979));
let _e2013 = bitcast<f32>((bitcast<u32>((((_e430 * (((_e1785 * _e1759) - (_e1798 * _e1746)) + ((_e1969 * _e1876) - (_e1970 * _e1863)))) + (_e441 * (((_e1798 * _e1733) - (_e1772 * _e1759)) + ((_e1970 * _e1850) - (_e1968 * _e1876))))) + (_e452 * (((_e1772 * _e1746) - (_e1785 * _e1733)) + ((_e1968 * _e1863) - (_e1969 * _e1850)))))) & 2147483647u));
let _e2042 = bitcast<f32>((bitcast<u32>((((_e430 * (((_e1824 * _e1759) - (_e1837 * _e1746)) + ((_e1969 * _e1915) - (_e1970 * _e1902)))) + (_e441 * (((_e1837 * _e1733) - (_e1811 * _e1759)) + ((_e1970 * _e1889) - (_e1968 * _e1915))))) + (_e452 * (((_e1811 * _e1746) - (_e1824 * _e1733)) + ((_e1968 * _e1902) - (_e1969 * _e1889)))))) & 2147483647u));
let _e2065 = bitcast<f32>((bitcast<u32>(((((_e529 * _e1973) + (_e540 * _e1976)) + (_e551 * _e1979)) - (((_e430 * ((_e474 * _e1759) - (_e485 * _e1746))) + (_e441 * ((_e485 * _e1733) - (_e463 * _e1759)))) + (_e452 * ((_e463 * _e1746) - (_e474 * _e1733)))))) & 2147483647u));
let _e2088 = bitcast<f32>((bitcast<u32>(((((_e562 * _e1973) + (_e573 * _e1976)) + (_e584 * _e1979)) - (((_e430 * ((_e507 * _e1759) - (_e518 * _e1746))) + (_e441 * ((_e518 * _e1733) - (_e496 * _e1759)))) + (_e452 * ((_e496 * _e1746) - (_e507 * _e1733)))))) & 2147483647u));
let _e2090 = select(_e2088, _e2065, (_e2065 > _e2088));
let _e2092 = select(1e-12f, _e2090, (_e2090 > 1e-12f));
if (bitcast<f32>((bitcast<u32>(_e1984) & 2147483647u)) > (0.5f * ((_e2013 + _e2042) + _e2092))) {
phi_4354_ = vec3<f32>(0f, 0f, 0f);
} else {
let _e2104 = (((_e1968 * _e430) + (_e1969 * _e441)) + (_e1970 * _e452));
let _e2109 = (((_e1968 * _e1733) + (_e1969 * _e1746)) + (_e1970 * _e1759));
let _e2114 = (((_e430 * _e1733) + (_e441 * _e1746)) + (_e452 * _e1759));
let _e2117 = ((_e441 * _e1759) - (_e452 * _e1746));
let _e2120 = ((_e452 * _e1733) - (_e430 * _e1759));
let _e2123 = ((_e430 * _e1746) - (_e441 * _e1733));
let _e2128 = (((_e2117 * _e2117) + (_e2120 * _e2120)) + (_e2123 * _e2123));
let _e2131 = (1f / select(1e-9f, _e2128, (_e2128 > 1e-9f)));
let _e2134 = ((_e2104 - (_e2114 * _e2109)) * _e2131);
let _e2137 = (((_e2114 * _e2104) - _e2109) * _e2131);
let _e2144 = ((((_e2137 >= 0f) && (_e2137 < _e1967)) && (_e2134 > _e811)) && (_e2134 < _e812));
let _e2146 = (_e2137 + (_e2134 - _e811));
let _e2150 = global_2.member.member_13.member;
let _e2155 = -((_e2150.member * _e2146));
let _e2157 = select(-87f, _e2155, (_e2155 > -87f));
let _e2159 = select(88f, _e2157, (_e2157 < 88f));
let _e2161 = ((_e2159 * 1.442695f) + 0.5f);
let _e2163 = select(-127f, _e2161, (_e2161 > -127f));
let _e2165 = select(128f, _e2163, (_e2163 < 128f));
let _e2172 = select(0i, select(select(i32(_e2165), i32(-2147483648), (_e2165 < -2147483600f)), 2147483647i, (_e2165 > 2147483500f)), (_e2165 == _e2165));
let _e2176 = (_e2172 - select(0i, 1i, (_e2165 < f32(_e2172))));
let _e2177 = f32(_e2176);
let _e2181 = ((_e2159 - (_e2177 * 0.6933594f)) - (_e2177 * -2.1219444e-4f));
let _e2203 = -((_e2150.member_1 * _e2146));
let _e2205 = select(-87f, _e2203, (_e2203 > -87f));
let _e2207 = select(88f, _e2205, (_e2205 < 88f));
let _e2209 = ((_e2207 * 1.442695f) + 0.5f);
let _e2211 = select(-127f, _e2209, (_e2209 > -127f));
let _e2213 = select(128f, _e2211, (_e2211 < 128f));
let _e2220 = select(0i, select(select(i32(_e2213), i32(-2147483648), (_e2213 < -2147483600f)), 2147483647i, (_e2213 > 2147483500f)), (_e2213 == _e2213));
let _e2224 = (_e2220 - select(0i, 1i, (_e2213 < f32(_e2220))));
let _e2225 = f32(_e2224);
let _e2229 = ((_e2207 - (_e2225 * 0.6933594f)) - (_e2225 * -2.1219444e-4f));
let _e2251 = -((_e2150.member_2 * _e2146));
let _e2253 = select(-87f, _e2251, (_e2251 > -87f));
let _e2255 = select(88f, _e2253, (_e2253 < 88f));
let _e2257 = ((_e2255 * 1.442695f) + 0.5f);
let _e2259 = select(-127f, _e2257, (_e2257 > -127f));
let _e2261 = select(128f, _e2259, (_e2259 < 128f));
let _e2268 = select(0i, select(select(i32(_e2261), i32(-2147483648), (_e2261 < -2147483600f)), 2147483647i, (_e2261 > 2147483500f)), (_e2261 == _e2261));
let _e2272 = (_e2268 - select(0i, 1i, (_e2261 < f32(_e2268))));
let _e2273 = f32(_e2272);
let _e2277 = ((_e2255 - (_e2273 * 0.6933594f)) - (_e2273 * -2.1219444e-4f));
let _e2298 = -(_e2114);
let _e2302 = global_2.member.member_13.member_2;
let _e2303 = (_e2302 * _e2302);
let _e2307 = ((1f + _e2303) - ((2f * _e2302) * _e2298));
let _e2309 = select(1e-9f, _e2307, (_e2307 > 1e-9f));
let _e2322 = global_2.member.member_13.member_3;
let _e2327 = (1e-4f * _e2092);
let _e2329 = select(_e2042, _e2013, (_e2013 > _e2042));
let _e2331 = select(_e2327, _e2329, (_e2329 > _e2327));
let _e2333 = select(_e2042, _e2013, (_e2013 < _e2042));
let _e2335 = select(_e2327, _e2333, (_e2333 > _e2327));
let _e2337 = (0.5f * (_e2331 + _e2335));
let _e2338 = (0.5f / _e2335);
let _e2339 = (1f / _e2331);
let _e2341 = (0.5f * _e2092);
let _e2342 = (_e1984 + _e2341);
let _e2343 = -(_e2342);
let _e2346 = (_e2337 - select(_e2343, _e2342, (_e2342 > _e2343)));
let _e2348 = select(0f, _e2346, (_e2346 > 0f));
let _e2350 = select(_e2335, _e2348, (_e2348 < _e2335));
let _e2353 = (_e2346 - _e2335);
let _e2357 = (((_e2350 * (_e2350 * _e2338)) + select(0f, _e2353, (_e2353 > 0f))) * _e2339);
let _e2361 = (_e1984 - _e2341);
let _e2362 = -(_e2361);
let _e2365 = (_e2337 - select(_e2362, _e2361, (_e2361 > _e2362)));
let _e2367 = select(0f, _e2365, (_e2365 > 0f));
let _e2369 = select(_e2335, _e2367, (_e2367 < _e2335));
let _e2372 = (_e2365 - _e2335);
let _e2376 = (((_e2369 * (_e2369 * _e2338)) + select(0f, _e2372, (_e2372 > 0f))) * _e2339);
let _e2382 = ((select(((1f - _e2303) / (_e2309 * sqrt(select(0f, _e2309, (_e2309 > 0f))))), (0.75f * (1f + (_e2298 * _e2298))), (_e2322 == 1u)) * (0.25f / 3.1415927f)) * ((select(_e2357, (1f - _e2357), (_e2342 >= 0f)) - select(_e2376, (1f - _e2376), (_e2361 >= 0f))) * (1f / _e2092)));
let _e2389 = global_2.member.member_13.member_1;
phi_4354_ = vec3<f32>(select(0f, (((_e1928 * ((1f + (_e2181 * (1f + (_e2181 * (0.5f + (_e2181 * (0.16666667f + (_e2181 * (0.041666668f + (_e2181 * (0.008333334f + (_e2181 * (0.001388889f + (_e2181 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2176 + 127i)) << bitcast<u32>(23i))))) * _e2389.member) * _e2382), _e2144), select(0f, (((_e1941 * ((1f + (_e2229 * (1f + (_e2229 * (0.5f + (_e2229 * (0.16666667f + (_e2229 * (0.041666668f + (_e2229 * (0.008333334f + (_e2229 * (0.001388889f + (_e2229 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2224 + 127i)) << bitcast<u32>(23i))))) * _e2389.member_1) * _e2382), _e2144), select(0f, (((_e1954 * ((1f + (_e2277 * (1f + (_e2277 * (0.5f + (_e2277 * (0.16666667f + (_e2277 * (0.041666668f + (_e2277 * (0.008333334f + (_e2277 * (0.001388889f + (_e2277 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2272 + 127i)) << bitcast<u32>(23i))))) * _e2389.member_2) * _e2382), _e2144));
}
let _e2404 = phi_4354_;
let _e2405 = select(1f, 0f, _e1030);
let _e2419 = select(0f, 1f, _e1030);
phi_4393_ = vec3<f32>((_e1035.x + (_e2404.x * _e2419)), (_e1035.y + (_e2404.y * _e2419)), (_e1035.z + (_e2404.z * _e2419)));
phi_4394_ = vec3<f32>((_e1037.x + (_e2404.x * _e2405)), (_e1037.y + (_e2404.y * _e2405)), (_e1037.z + (_e2404.z * _e2405)));
} else {
phi_4393_ = _e1035;
phi_4394_ = _e1037;
}
let _e2431 = phi_4393_;
let _e2433 = phi_4394_;
let _e2434 = local_13.member_1;
phi_4402_ = type_17(_e1039.member, (_e1039.member_1 + 1u));
loop {
let _e2438 = phi_4402_;
local_35 = _e2438;
let _e2444 = (((_e2438.member_1 & 3u) == 0u) && (_e2438.member < _e2434));
if _e2444 {
phi_4403_ = type_17((_e2438.member + 1u), (_e2438.member_1 >> bitcast<u32>(2i)));
} else {
phi_4403_ = type_17();
}
let _e2450 = phi_4403_;
continue;
continuing {
phi_4402_ = _e2450;
break if !(_e2444);
}
}
phi_4424_ = _e2431;
phi_4425_ = _e2433;
let _e2612 = local_35;
phi_4426_ = _e2612;
}
let _e2457 = phi_4424_;
let _e2459 = phi_4425_;
let _e2461 = phi_4426_;
phi_2044_ = _e2457;
phi_2047_ = _e2459;
phi_2049_ = _e2461;
} else {
phi_2044_ = vec3<f32>();
phi_2047_ = vec3<f32>();
phi_2049_ = type_17();
}
let _e2463 = phi_2044_;
let _e2465 = phi_2047_;
let _e2467 = phi_2049_;
continue;
continuing {
phi_2043_ = _e2463;
phi_2046_ = _e2465;
phi_2048_ = _e2467;
break if !(_e1047);
}
}
let _e2618 = local_36;
phi_1844_ = _e2618;
let _e2621 = local_37;
phi_1847_ = _e2621;
phi_1849_ = (_e868 + 1u);
} else {
phi_1844_ = vec3<f32>();
phi_1847_ = vec3<f32>();
phi_1849_ = u32();
}
let _e2471 = phi_1844_;
let _e2473 = phi_1847_;
let _e2475 = phi_1849_;
continue;
continuing {
phi_1843_ = _e2471;
phi_1846_ = _e2473;
phi_1848_ = _e2475;
break if !(_e873);
}
}
let _e2478 = local_29;
let _e2482 = local_30;
let _e2486 = local_31;
let _e2493 = local_32;
let _e2497 = local_33;
let _e2501 = local_34;
phi_4476_ = array<f32, 18>(_e148, _e158, _e169, _e180, _e191, _e202, _e213, _e224, (_e235 + (_e2478.x * _e733)), (_e246 + (_e2482.y * _e734)), (_e257 + (_e2486.z * _e735)), (_e268 + (_e2493.x * _e733)), (_e279 + (_e2497.y * _e734)), (_e290 + (_e2501.z * _e735)), _e301, _e312, _e323, _e334);
}
let _e2509 = phi_4476_;
global_1.member[_e137] = _e2509[0];
global_1.member[_e149] = _e2509[1];
global_1.member[_e160] = _e2509[2];
global_1.member[_e171] = _e2509[3];
global_1.member[_e182] = _e2509[4];
global_1.member[_e193] = _e2509[5];
global_1.member[_e204] = _e2509[6];
global_1.member[_e215] = _e2509[7];
global_1.member[_e226] = _e2509[8];
global_1.member[_e237] = _e2509[9];
global_1.member[_e248] = _e2509[10];
global_1.member[_e259] = _e2509[11];
global_1.member[_e270] = _e2509[12];
global_1.member[_e281] = _e2509[13];
global_1.member[_e292] = _e2509[14];
global_1.member[_e303] = _e2509[15];
global_1.member[_e314] = _e2509[16];
global_1.member[_e325] = _e2509[17];
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
