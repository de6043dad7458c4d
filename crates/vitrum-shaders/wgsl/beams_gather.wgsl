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
var phi_1838_: vec3<f32>;
var phi_1841_: vec3<f32>;
var phi_1843_: u32;
var phi_1863_: u32;
var phi_1864_: u32;
var phi_1876_: u32;
var phi_1877_: u32;
var local_16: u32;
var local_17: u32;
var phi_1894_: u32;
var phi_1895_: u32;
var phi_1907_: u32;
var phi_1908_: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var phi_1933_: u32;
var phi_1934_: u32;
var local_21: u32;
var local_22: u32;
var phi_1951_: u32;
var phi_1952_: u32;
var local_23: u32;
var local_24: u32;
var phi_1974_: u32;
var phi_1975_: u32;
var phi_1987_: u32;
var phi_1988_: u32;
var local_25: u32;
var local_26: u32;
var local_27: u32;
var phi_2024_: u32;
var local_28: u32;
var phi_2038_: vec3<f32>;
var phi_2041_: vec3<f32>;
var phi_2043_: type_17;
var phi_2105_: i32;
var phi_2906_: bool;
var phi_3145_: bool;
var phi_4352_: vec3<f32>;
var phi_4391_: vec3<f32>;
var phi_4392_: vec3<f32>;
var phi_4400_: type_17;
var phi_4401_: type_17;
var phi_4422_: vec3<f32>;
var phi_4423_: vec3<f32>;
var phi_4424_: type_17;
var phi_2039_: vec3<f32>;
var phi_2042_: vec3<f32>;
var phi_2044_: type_17;
var phi_1839_: vec3<f32>;
var phi_1842_: vec3<f32>;
var phi_1844_: u32;
var local_29: vec3<f32>;
var local_30: vec3<f32>;
var local_31: vec3<f32>;
var local_32: vec3<f32>;
var local_33: vec3<f32>;
var local_34: vec3<f32>;
var phi_4474_: array<f32, 18>;
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
let _e811 = select(_e807, _e809, (_e809 > _e807));
if ((_e647 || (_e811 <= _e807)) || ((((_e733 + _e734) + _e735) * (1f / 3f)) < 0.01f)) {
phi_4474_ = array<f32, 18>(_e148, _e158, _e169, _e180, _e191, _e202, _e213, _e224, _e235, _e246, _e257, _e268, _e279, _e290, _e301, _e312, _e323, _e334);
} else {
let _e824 = (((_e463 * _e463) + (_e474 * _e474)) + (_e485 * _e485));
let _e832 = (((_e496 * _e496) + (_e507 * _e507)) + (_e518 * _e518));
let _e837 = (0.5f * (sqrt(select(0f, _e824, (_e824 > 0f))) + sqrt(select(0f, _e832, (_e832 > 0f)))));
let _e842 = (((_e529 * _e529) + (_e540 * _e540)) + (_e551 * _e551));
let _e850 = (((_e562 * _e562) + (_e573 * _e573)) + (_e584 * _e584));
let _e855 = (0.5f * (sqrt(select(0f, _e842, (_e842 > 0f))) + sqrt(select(0f, _e850, (_e850 > 0f)))));
let _e859 = global_2.member.member_11.member;
let _e861 = bitcast<i32>((_e859 * _e859));
phi_1838_ = vec3<f32>(0f, 0f, 0f);
phi_1841_ = vec3<f32>(0f, 0f, 0f);
phi_1843_ = 0u;
loop {
let _e863 = phi_1838_;
let _e865 = phi_1841_;
let _e867 = phi_1843_;
local_29 = _e865;
local_30 = _e865;
local_31 = _e865;
local_32 = _e863;
local_33 = _e863;
local_34 = _e863;
let _e871 = global_2.member.member_12.member_7;
let _e872 = (_e867 <= _e871);
if _e872 {
let _e876 = global_2.member.member_12.member_5;
let _e878 = bitcast<i32>((_e867 * _e876));
phi_1863_ = 0u;
loop {
let _e880 = phi_1863_;
local_28 = _e880;
let _e884 = ((1u << bitcast<u32>((_e880 & 31u))) < _e859);
if _e884 {
phi_1864_ = (_e880 + 1u);
} else {
phi_1864_ = u32();
}
let _e887 = phi_1864_;
continue;
continuing {
phi_1863_ = _e887;
break if !(_e884);
}
}
phi_1876_ = 0u;
loop {
let _e890 = phi_1876_;
local_16 = _e890;
local_17 = _e890;
let _e894 = ((1u << bitcast<u32>((_e890 & 31u))) < _e859);
if _e894 {
phi_1877_ = (_e890 + 1u);
} else {
phi_1877_ = u32();
}
let _e897 = phi_1877_;
continue;
continuing {
phi_1876_ = _e897;
break if !(_e894);
}
}
let _e900 = local_16;
let _e903 = local_17;
phi_1894_ = 0u;
loop {
let _e906 = phi_1894_;
local_20 = _e906;
let _e910 = ((1u << bitcast<u32>((_e906 & 31u))) < _e859);
if _e910 {
phi_1895_ = (_e906 + 1u);
} else {
phi_1895_ = u32();
}
let _e913 = phi_1895_;
continue;
continuing {
phi_1894_ = _e913;
break if !(_e910);
}
}
phi_1907_ = 0u;
loop {
let _e916 = phi_1907_;
local_18 = _e916;
local_19 = _e916;
let _e920 = ((1u << bitcast<u32>((_e916 & 31u))) < _e859);
if _e920 {
phi_1908_ = (_e916 + 1u);
} else {
phi_1908_ = u32();
}
let _e923 = phi_1908_;
continue;
continuing {
phi_1907_ = _e923;
break if !(_e920);
}
}
let _e926 = local_18;
let _e929 = local_19;
let _e932 = local_20;
let _e941 = global_2.member.member_12.member_6;
phi_1933_ = 0u;
loop {
let _e944 = phi_1933_;
local_21 = _e944;
local_22 = _e944;
let _e948 = ((1u << bitcast<u32>((_e944 & 31u))) < _e859);
if _e948 {
phi_1934_ = (_e944 + 1u);
} else {
phi_1934_ = u32();
}
let _e951 = phi_1934_;
continue;
continuing {
phi_1933_ = _e951;
break if !(_e948);
}
}
let _e954 = local_21;
let _e957 = local_22;
phi_1951_ = 0u;
loop {
let _e960 = phi_1951_;
local_23 = _e960;
local_24 = _e960;
let _e964 = ((1u << bitcast<u32>((_e960 & 31u))) < _e859);
if _e964 {
phi_1952_ = (_e960 + 1u);
} else {
phi_1952_ = u32();
}
let _e967 = phi_1952_;
continue;
continuing {
phi_1951_ = _e967;
break if !(_e964);
}
}
let _e970 = local_23;
let _e976 = local_24;
phi_1974_ = 0u;
loop {
let _e986 = phi_1974_;
local_27 = _e986;
let _e990 = ((1u << bitcast<u32>((_e986 & 31u))) < _e859);
if _e990 {
phi_1975_ = (_e986 + 1u);
} else {
phi_1975_ = u32();
}
let _e993 = phi_1975_;
continue;
continuing {
phi_1974_ = _e993;
break if !(_e990);
}
}
phi_1987_ = 0u;
loop {
let _e996 = phi_1987_;
local_25 = _e996;
local_26 = _e996;
let _e1000 = ((1u << bitcast<u32>((_e996 & 31u))) < _e859);
if _e1000 {
phi_1988_ = (_e996 + 1u);
} else {
phi_1988_ = u32();
}
let _e1003 = phi_1988_;
continue;
continuing {
phi_1987_ = _e1003;
break if !(_e1000);
}
}
let _e1006 = local_25;
let _e1009 = local_26;
let _e1012 = local_27;
let _e1018 = (((((1u << bitcast<u32>(((2u * _e970) & 31u))) - (1u << bitcast<u32>(((2u * (_e976 - select(6u, _e957, (_e954 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1012 - select(6u, _e1009, (_e1006 < 6u)))) & 31u))));
let _e1019 = (_e1018 / 64u);
if ((_e1018 % 64u) > 0u) {
phi_2024_ = (_e1019 + 1u);
} else {
phi_2024_ = _e1019;
}
let _e1024 = phi_2024_;
let _e1027 = local_28;
local_13 = type_24(_e1027, select(6u, _e903, (_e900 < 6u)), (1u << bitcast<u32>(((2u * (_e932 - select(6u, _e929, (_e926 < 6u)))) & 31u))), (_e867 * _e941), (_e1024 * 64u));
let _e1029 = (_e867 == 0u);
let _e1031 = local_13.member_1;
phi_2038_ = _e863;
phi_2041_ = _e865;
phi_2043_ = type_17(_e1031, 0u);
loop {
let _e1034 = phi_2038_;
let _e1036 = phi_2041_;
let _e1038 = phi_2043_;
local_36 = _e1034;
local_37 = _e1036;
let _e1041 = local_13.member_1;
let _e1044 = local_13.member_2;
let _e1046 = ((_e1038.member < _e1041) || (_e1038.member_1 < _e1044));
if _e1046 {
let _e1047 = (_e1038.member_1 & 1431655765u);
let _e1051 = ((_e1047 | (_e1047 >> bitcast<u32>(1i))) & 858993459u);
let _e1055 = ((_e1051 | (_e1051 >> bitcast<u32>(2i))) & 252645135u);
let _e1059 = ((_e1055 | (_e1055 >> bitcast<u32>(4i))) & 16711935u);
let _e1063 = ((_e1059 | (_e1059 >> bitcast<u32>(8i))) & 65535u);
let _e1066 = ((_e1038.member_1 >> bitcast<u32>(1i)) & 1431655765u);
let _e1070 = ((_e1066 | (_e1066 >> bitcast<u32>(1i))) & 858993459u);
let _e1074 = ((_e1070 | (_e1070 >> bitcast<u32>(2i))) & 252645135u);
let _e1078 = ((_e1074 | (_e1074 >> bitcast<u32>(4i))) & 16711935u);
let _e1082 = ((_e1078 | (_e1078 >> bitcast<u32>(8i))) & 65535u);
let _e1085 = ((_e1063 < _e859) && (_e1082 < _e859));
if _e1085 {
phi_2105_ = bitcast<i32>(((_e1082 * _e859) + _e1063));
} else {
phi_2105_ = 0i;
}
let _e1090 = phi_2105_;
let _e1091 = (_e1038.member > 0u);
if _e1091 {
local_11.member = _e1038.member;
local_11.member_1 = _e1038.member_1;
let _e1230 = local_11.member;
let _e1231 = local_11.member_1;
let _e1233 = local_13.member;
let _e1248 = local_13.member_3;
local_12 = (_e1248 + (((((1u << bitcast<u32>(((2u * _e1233) & 31u))) - (1u << bitcast<u32>(((2u * (_e1233 - _e1230)) & 31u)))) / 3u) * 4u) + _e1231));
let _e1250 = local_12;
let _e1251 = bitcast<i32>(_e1250);
let _e1253 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1255 = select(_e1253, _e1251, (_e1251 < _e1253));
let _e1260 = global_5.member[bitcast<u32>(select(0i, _e1255, (_e1255 > 0i)))];
let _e1261 = local_12;
let _e1263 = local_13.member_4;
let _e1265 = bitcast<i32>((_e1261 + _e1263));
let _e1267 = select(_e1253, _e1265, (_e1265 < _e1253));
let _e1272 = global_5.member[bitcast<u32>(select(0i, _e1267, (_e1267 > 0i)))];
let _e1273 = local_12;
let _e1274 = local_13.member_4;
let _e1277 = bitcast<i32>((_e1273 + (2u * _e1274)));
let _e1279 = select(_e1253, _e1277, (_e1277 < _e1253));
let _e1284 = global_5.member[bitcast<u32>(select(0i, _e1279, (_e1279 > 0i)))];
let _e1285 = local_11.member;
let _e1286 = local_11.member_1;
let _e1287 = local_13.member;
let _e1301 = local_13.member_3;
let _e1302 = local_13.member_4;
local_10 = ((_e1301 + (3u * _e1302)) + (((((1u << bitcast<u32>(((2u * _e1287) & 31u))) - (1u << bitcast<u32>(((2u * (_e1287 - _e1285)) & 31u)))) / 3u) * 4u) + _e1286));
let _e1306 = local_10;
let _e1307 = bitcast<i32>(_e1306);
let _e1309 = select(_e1253, _e1307, (_e1307 < _e1253));
let _e1314 = global_5.member[bitcast<u32>(select(0i, _e1309, (_e1309 > 0i)))];
let _e1315 = local_10;
let _e1316 = local_13.member_4;
let _e1318 = bitcast<i32>((_e1315 + _e1316));
let _e1320 = select(_e1253, _e1318, (_e1318 < _e1253));
let _e1325 = global_5.member[bitcast<u32>(select(0i, _e1320, (_e1320 > 0i)))];
let _e1326 = local_10;
let _e1327 = local_13.member_4;
let _e1330 = bitcast<i32>((_e1326 + (2u * _e1327)));
let _e1332 = select(_e1253, _e1330, (_e1330 < _e1253));
let _e1337 = global_5.member[bitcast<u32>(select(0i, _e1332, (_e1332 > 0i)))];
let _e1339 = ((_e1260 - _e729) * _e743);
let _e1341 = ((_e1314 - _e729) * _e743);
let _e1343 = ((_e1272 - _e730) * _e751);
let _e1345 = ((_e1325 - _e730) * _e751);
let _e1347 = ((_e1284 - _e731) * _e759);
let _e1349 = ((_e1337 - _e731) * _e759);
let _e1351 = select(_e1341, _e1339, (_e1339 < _e1341));
let _e1353 = select(_e1345, _e1343, (_e1343 < _e1345));
let _e1355 = select(_e1353, _e1351, (_e1351 > _e1353));
let _e1357 = select(_e1349, _e1347, (_e1347 < _e1349));
let _e1359 = select(_e1357, _e1355, (_e1355 > _e1357));
let _e1361 = select(_e1341, _e1339, (_e1339 > _e1341));
let _e1363 = select(_e1345, _e1343, (_e1343 > _e1345));
let _e1365 = select(_e1363, _e1361, (_e1361 < _e1363));
let _e1367 = select(_e1349, _e1347, (_e1347 > _e1349));
let _e1369 = select(_e1367, _e1365, (_e1365 < _e1367));
if ((_e1260 <= _e1314) && (select(_e807, _e1359, (_e1359 > _e807)) <= select(_e811, _e1369, (_e1369 < _e811)))) {
let _e1377 = local_11.member;
let _e1378 = local_11.member_1;
let _e1379 = local_13.member;
let _e1393 = local_13.member_3;
let _e1394 = local_13.member_4;
local_9 = ((_e1393 + (6u * _e1394)) + (((((1u << bitcast<u32>(((2u * _e1379) & 31u))) - (1u << bitcast<u32>(((2u * (_e1379 - _e1377)) & 31u)))) / 3u) * 4u) + _e1378));
let _e1398 = local_9;
let _e1399 = bitcast<i32>(_e1398);
let _e1401 = select(_e1253, _e1399, (_e1399 < _e1253));
let _e1406 = global_5.member[bitcast<u32>(select(0i, _e1401, (_e1401 > 0i)))];
let _e1407 = local_9;
let _e1408 = local_13.member_4;
let _e1410 = bitcast<i32>((_e1407 + _e1408));
let _e1412 = select(_e1253, _e1410, (_e1410 < _e1253));
let _e1417 = global_5.member[bitcast<u32>(select(0i, _e1412, (_e1412 > 0i)))];
let _e1418 = local_9;
let _e1419 = local_13.member_4;
let _e1422 = bitcast<i32>((_e1418 + (2u * _e1419)));
let _e1424 = select(_e1253, _e1422, (_e1422 < _e1253));
let _e1429 = global_5.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1430 = local_11.member;
let _e1431 = local_11.member_1;
let _e1432 = local_13.member;
let _e1446 = local_13.member_3;
let _e1447 = local_13.member_4;
local_8 = ((_e1446 + (9u * _e1447)) + (((((1u << bitcast<u32>(((2u * _e1432) & 31u))) - (1u << bitcast<u32>(((2u * (_e1432 - _e1430)) & 31u)))) / 3u) * 4u) + _e1431));
let _e1451 = local_8;
let _e1452 = bitcast<i32>(_e1451);
let _e1454 = select(_e1253, _e1452, (_e1452 < _e1253));
let _e1459 = global_5.member[bitcast<u32>(select(0i, _e1454, (_e1454 > 0i)))];
let _e1460 = local_8;
let _e1461 = local_13.member_4;
let _e1463 = bitcast<i32>((_e1460 + _e1461));
let _e1465 = select(_e1253, _e1463, (_e1463 < _e1253));
let _e1470 = global_5.member[bitcast<u32>(select(0i, _e1465, (_e1465 > 0i)))];
let _e1471 = local_8;
let _e1472 = local_13.member_4;
let _e1475 = bitcast<i32>((_e1471 + (2u * _e1472)));
let _e1477 = select(_e1253, _e1475, (_e1475 < _e1253));
let _e1482 = global_5.member[bitcast<u32>(select(0i, _e1477, (_e1477 > 0i)))];
let _e1483 = local_11.member;
let _e1484 = local_11.member_1;
let _e1485 = local_13.member;
let _e1499 = local_13.member_3;
let _e1500 = local_13.member_4;
local_7 = ((_e1499 + (12u * _e1500)) + (((((1u << bitcast<u32>(((2u * _e1485) & 31u))) - (1u << bitcast<u32>(((2u * (_e1485 - _e1483)) & 31u)))) / 3u) * 4u) + _e1484));
let _e1504 = local_7;
let _e1505 = bitcast<i32>(_e1504);
let _e1507 = select(_e1253, _e1505, (_e1505 < _e1253));
let _e1512 = global_5.member[bitcast<u32>(select(0i, _e1507, (_e1507 > 0i)))];
let _e1513 = local_7;
let _e1514 = local_13.member_4;
let _e1516 = bitcast<i32>((_e1513 + _e1514));
let _e1518 = select(_e1253, _e1516, (_e1516 < _e1253));
let _e1523 = global_5.member[bitcast<u32>(select(0i, _e1518, (_e1518 > 0i)))];
let _e1524 = local_7;
let _e1525 = local_13.member_4;
let _e1528 = bitcast<i32>((_e1524 + (2u * _e1525)));
let _e1530 = select(_e1253, _e1528, (_e1528 < _e1253));
let _e1535 = global_5.member[bitcast<u32>(select(0i, _e1530, (_e1530 > 0i)))];
let _e1536 = local_11.member;
let _e1537 = local_11.member_1;
let _e1538 = local_13.member;
let _e1552 = local_13.member_3;
let _e1553 = local_13.member_4;
local_6 = ((_e1552 + (15u * _e1553)) + (((((1u << bitcast<u32>(((2u * _e1538) & 31u))) - (1u << bitcast<u32>(((2u * (_e1538 - _e1536)) & 31u)))) / 3u) * 4u) + _e1537));
let _e1557 = local_6;
let _e1558 = bitcast<i32>(_e1557);
let _e1560 = select(_e1253, _e1558, (_e1558 < _e1253));
let _e1565 = global_5.member[bitcast<u32>(select(0i, _e1560, (_e1560 > 0i)))];
let _e1566 = local_6;
let _e1567 = local_13.member_4;
let _e1569 = bitcast<i32>((_e1566 + _e1567));
let _e1571 = select(_e1253, _e1569, (_e1569 < _e1253));
let _e1576 = global_5.member[bitcast<u32>(select(0i, _e1571, (_e1571 > 0i)))];
let _e1577 = local_6;
let _e1578 = local_13.member_4;
let _e1581 = bitcast<i32>((_e1577 + (2u * _e1578)));
let _e1583 = select(_e1253, _e1581, (_e1581 < _e1253));
let _e1588 = global_5.member[bitcast<u32>(select(0i, _e1583, (_e1583 > 0i)))];
let _e1589 = (_e1406 - _e729);
let _e1590 = (_e1417 - _e730);
let _e1591 = (_e1429 - _e731);
let _e1594 = ((_e1523 * _e452) - (_e1535 * _e441));
let _e1597 = ((_e1535 * _e430) - (_e1512 * _e452));
let _e1600 = ((_e1512 * _e441) - (_e1523 * _e430));
let _e1648 = (((_e1459 * _e1459) + (_e1470 * _e1470)) + (_e1482 * _e1482));
let _e1651 = sqrt(select(0f, _e1648, (_e1648 > 0f)));
let _e1656 = (((_e1565 * _e1565) + (_e1576 * _e1576)) + (_e1588 * _e1588));
let _e1666 = (((_e1589 * _e1589) + (_e1590 * _e1590)) + (_e1591 * _e1591));
phi_2906_ = (bitcast<f32>((bitcast<u32>((((_e1589 * _e1594) + (_e1590 * _e1597)) + (_e1591 * _e1600))) & 2147483647u)) <= ((((((bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u)) * _e1459) + (bitcast<f32>((bitcast<u32>(_e1597) & 2147483647u)) * _e1470)) + (bitcast<f32>((bitcast<u32>(_e1600) & 2147483647u)) * _e1482)) + (((bitcast<f32>((bitcast<u32>(((_e441 * _e1591) - (_e452 * _e1590))) & 2147483647u)) * _e1565) + (bitcast<f32>((bitcast<u32>(((_e452 * _e1589) - (_e430 * _e1591))) & 2147483647u)) * _e1576)) + (bitcast<f32>((bitcast<u32>(((_e430 * _e1590) - (_e441 * _e1589))) & 2147483647u)) * _e1588))) + (_e1651 * sqrt(select(0f, _e1656, (_e1656 > 0f))))) + (_e837 + (_e855 * (sqrt(select(0f, _e1666, (_e1666 > 0f))) + _e1651)))));
} else {
phi_2906_ = false;
}
let _e1679 = phi_2906_;
phi_3145_ = _e1679;
} else {
local_3 = _e878;
local_4 = _e1090;
local_5 = _e861;
let _e1092 = local_3;
let _e1093 = local_4;
let _e1094 = (_e1092 + _e1093);
let _e1096 = (bitcast<i32>(_e120) - 1i);
let _e1098 = select(_e1096, _e1094, (_e1094 < _e1096));
let _e1103 = global_4.member[bitcast<u32>(select(0i, _e1098, (_e1098 > 0i)))];
let _e1104 = local_3;
let _e1105 = local_5;
let _e1107 = local_4;
let _e1108 = ((_e1104 + _e1105) + _e1107);
let _e1110 = select(_e1096, _e1108, (_e1108 < _e1096));
let _e1115 = global_4.member[bitcast<u32>(select(0i, _e1110, (_e1110 > 0i)))];
let _e1116 = local_3;
let _e1117 = local_5;
let _e1120 = local_4;
let _e1121 = ((_e1116 + (2i * _e1117)) + _e1120);
let _e1123 = select(_e1096, _e1121, (_e1121 < _e1096));
let _e1128 = global_4.member[bitcast<u32>(select(0i, _e1123, (_e1123 > 0i)))];
let _e1129 = local_3;
let _e1130 = local_5;
let _e1133 = local_4;
let _e1134 = ((_e1129 + (3i * _e1130)) + _e1133);
let _e1136 = select(_e1096, _e1134, (_e1134 < _e1096));
let _e1141 = global_4.member[bitcast<u32>(select(0i, _e1136, (_e1136 > 0i)))];
let _e1142 = local_3;
let _e1143 = local_5;
let _e1146 = local_4;
let _e1147 = ((_e1142 + (4i * _e1143)) + _e1146);
let _e1149 = select(_e1096, _e1147, (_e1147 < _e1096));
let _e1154 = global_4.member[bitcast<u32>(select(0i, _e1149, (_e1149 > 0i)))];
let _e1155 = local_3;
let _e1156 = local_5;
let _e1159 = local_4;
let _e1160 = ((_e1155 + (5i * _e1156)) + _e1159);
let _e1162 = select(_e1096, _e1160, (_e1160 < _e1096));
let _e1167 = global_4.member[bitcast<u32>(select(0i, _e1162, (_e1162 > 0i)))];
let _e1168 = (_e1103 - _e729);
let _e1169 = (_e1115 - _e730);
let _e1170 = (_e1128 - _e731);
let _e1189 = (((_e1168 * _e1168) + (_e1169 * _e1169)) + (_e1170 * _e1170));
let _e1193 = local_3;
let _e1194 = local_5;
let _e1197 = local_4;
let _e1198 = ((_e1193 + (21i * _e1194)) + _e1197);
let _e1200 = select(_e1096, _e1198, (_e1198 < _e1096));
let _e1205 = global_4.member[bitcast<u32>(select(0i, _e1200, (_e1200 > 0i)))];
let _e1210 = local_3;
let _e1211 = local_5;
let _e1214 = local_4;
let _e1215 = ((_e1210 + (22i * _e1211)) + _e1214);
let _e1217 = select(_e1096, _e1215, (_e1215 < _e1096));
let _e1222 = global_4.member[bitcast<u32>(select(0i, _e1217, (_e1217 > 0i)))];
phi_3145_ = (_e1085 && (bitcast<f32>((bitcast<u32>((((_e430 * ((_e1169 * _e1167) - (_e1170 * _e1154))) + (_e441 * ((_e1170 * _e1141) - (_e1168 * _e1167)))) + (_e452 * ((_e1168 * _e1154) - (_e1169 * _e1141))))) & 2147483647u)) <= ((_e1205 + _e837) + ((_e1222 + _e855) * sqrt(select(0f, _e1189, (_e1189 > 0f)))))));
}
let _e1681 = phi_3145_;
if (_e1681 && _e1091) {
phi_4422_ = _e1034;
phi_4423_ = _e1036;
phi_4424_ = type_17((_e1038.member - 1u), (_e1038.member_1 << bitcast<u32>(2i)));
} else {
if _e1681 {
local = _e878;
local_1 = _e1090;
local_2 = _e861;
let _e1683 = local;
let _e1684 = local_1;
let _e1685 = (_e1683 + _e1684);
let _e1687 = (bitcast<i32>(_e120) - 1i);
let _e1689 = select(_e1687, _e1685, (_e1685 < _e1687));
let _e1694 = global_4.member[bitcast<u32>(select(0i, _e1689, (_e1689 > 0i)))];
let _e1695 = local;
let _e1696 = local_2;
let _e1698 = local_1;
let _e1699 = ((_e1695 + _e1696) + _e1698);
let _e1701 = select(_e1687, _e1699, (_e1699 < _e1687));
let _e1706 = global_4.member[bitcast<u32>(select(0i, _e1701, (_e1701 > 0i)))];
let _e1707 = local;
let _e1708 = local_2;
let _e1711 = local_1;
let _e1712 = ((_e1707 + (2i * _e1708)) + _e1711);
let _e1714 = select(_e1687, _e1712, (_e1712 < _e1687));
let _e1719 = global_4.member[bitcast<u32>(select(0i, _e1714, (_e1714 > 0i)))];
let _e1720 = local;
let _e1721 = local_2;
let _e1724 = local_1;
let _e1725 = ((_e1720 + (3i * _e1721)) + _e1724);
let _e1727 = select(_e1687, _e1725, (_e1725 < _e1687));
let _e1732 = global_4.member[bitcast<u32>(select(0i, _e1727, (_e1727 > 0i)))];
let _e1733 = local;
let _e1734 = local_2;
let _e1737 = local_1;
let _e1738 = ((_e1733 + (4i * _e1734)) + _e1737);
let _e1740 = select(_e1687, _e1738, (_e1738 < _e1687));
let _e1745 = global_4.member[bitcast<u32>(select(0i, _e1740, (_e1740 > 0i)))];
let _e1746 = local;
let _e1747 = local_2;
let _e1750 = local_1;
let _e1751 = ((_e1746 + (5i * _e1747)) + _e1750);
let _e1753 = select(_e1687, _e1751, (_e1751 < _e1687));
let _e1758 = global_4.member[bitcast<u32>(select(0i, _e1753, (_e1753 > 0i)))];
let _e1759 = local;
let _e1760 = local_2;
let _e1763 = local_1;
let _e1764 = ((_e1759 + (6i * _e1760)) + _e1763);
let _e1766 = select(_e1687, _e1764, (_e1764 < _e1687));
let _e1771 = global_4.member[bitcast<u32>(select(0i, _e1766, (_e1766 > 0i)))];
let _e1772 = local;
let _e1773 = local_2;
let _e1776 = local_1;
let _e1777 = ((_e1772 + (7i * _e1773)) + _e1776);
let _e1779 = select(_e1687, _e1777, (_e1777 < _e1687));
let _e1784 = global_4.member[bitcast<u32>(select(0i, _e1779, (_e1779 > 0i)))];
let _e1785 = local;
let _e1786 = local_2;
let _e1789 = local_1;
let _e1790 = ((_e1785 + (8i * _e1786)) + _e1789);
let _e1792 = select(_e1687, _e1790, (_e1790 < _e1687));
let _e1797 = global_4.member[bitcast<u32>(select(0i, _e1792, (_e1792 > 0i)))];
let _e1798 = local;
let _e1799 = local_2;
let _e1802 = local_1;
let _e1803 = ((_e1798 + (9i * _e1799)) + _e1802);
let _e1805 = select(_e1687, _e1803, (_e1803 < _e1687));
let _e1810 = global_4.member[bitcast<u32>(select(0i, _e1805, (_e1805 > 0i)))];
let _e1811 = local;
let _e1812 = local_2;
let _e1815 = local_1;
let _e1816 = ((_e1811 + (10i * _e1812)) + _e1815);
let _e1818 = select(_e1687, _e1816, (_e1816 < _e1687));
let _e1823 = global_4.member[bitcast<u32>(select(0i, _e1818, (_e1818 > 0i)))];
let _e1824 = local;
let _e1825 = local_2;
let _e1828 = local_1;
let _e1829 = ((_e1824 + (11i * _e1825)) + _e1828);
let _e1831 = select(_e1687, _e1829, (_e1829 < _e1687));
let _e1836 = global_4.member[bitcast<u32>(select(0i, _e1831, (_e1831 > 0i)))];
let _e1837 = local;
let _e1838 = local_2;
let _e1841 = local_1;
let _e1842 = ((_e1837 + (12i * _e1838)) + _e1841);
let _e1844 = select(_e1687, _e1842, (_e1842 < _e1687));
let _e1849 = global_4.member[bitcast<u32>(select(0i, _e1844, (_e1844 > 0i)))];
let _e1850 = local;
let _e1851 = local_2;
let _e1854 = local_1;
let _e1855 = ((_e1850 + (13i * _e1851)) + _e1854);
let _e1857 = select(_e1687, _e1855, (_e1855 < _e1687));
let _e1862 = global_4.member[bitcast<u32>(select(0i, _e1857, (_e1857 > 0i)))];
let _e1863 = local;
let _e1864 = local_2;
let _e1867 = local_1;
let _e1868 = ((_e1863 + (14i * _e1864)) + _e1867);
let _e1870 = select(_e1687, _e1868, (_e1868 < _e1687));
let _e1875 = global_4.member[bitcast<u32>(select(0i, _e1870, (_e1870 > 0i)))];
let _e1876 = local;
let _e1877 = local_2;
let _e1880 = local_1;
let _e1881 = ((_e1876 + (15i * _e1877)) + _e1880);
let _e1883 = select(_e1687, _e1881, (_e1881 < _e1687));
let _e1888 = global_4.member[bitcast<u32>(select(0i, _e1883, (_e1883 > 0i)))];
let _e1889 = local;
let _e1890 = local_2;
let _e1893 = local_1;
let _e1894 = ((_e1889 + (16i * _e1890)) + _e1893);
let _e1896 = select(_e1687, _e1894, (_e1894 < _e1687));
let _e1901 = global_4.member[bitcast<u32>(select(0i, _e1896, (_e1896 > 0i)))];
let _e1902 = local;
let _e1903 = local_2;
let _e1906 = local_1;
let _e1907 = ((_e1902 + (17i * _e1903)) + _e1906);
let _e1909 = select(_e1687, _e1907, (_e1907 < _e1687));
let _e1914 = global_4.member[bitcast<u32>(select(0i, _e1909, (_e1909 > 0i)))];
let _e1915 = local;
let _e1916 = local_2;
let _e1919 = local_1;
let _e1920 = ((_e1915 + (18i * _e1916)) + _e1919);
let _e1922 = select(_e1687, _e1920, (_e1920 < _e1687));
let _e1927 = global_4.member[bitcast<u32>(select(0i, _e1922, (_e1922 > 0i)))];
let _e1928 = local;
let _e1929 = local_2;
let _e1932 = local_1;
let _e1933 = ((_e1928 + (19i * _e1929)) + _e1932);
let _e1935 = select(_e1687, _e1933, (_e1933 < _e1687));
let _e1940 = global_4.member[bitcast<u32>(select(0i, _e1935, (_e1935 > 0i)))];
let _e1941 = local;
let _e1942 = local_2;
let _e1945 = local_1;
let _e1946 = ((_e1941 + (20i * _e1942)) + _e1945);
let _e1948 = select(_e1687, _e1946, (_e1946 < _e1687));
let _e1953 = global_4.member[bitcast<u32>(select(0i, _e1948, (_e1948 > 0i)))];
let _e1954 = local;
let _e1955 = local_2;
let _e1958 = local_1;
let _e1959 = ((_e1954 + (23i * _e1955)) + _e1958);
let _e1961 = select(_e1687, _e1959, (_e1959 < _e1687));
let _e1966 = global_4.member[bitcast<u32>(select(0i, _e1961, (_e1961 > 0i)))];
let _e1967 = (_e1694 - _e729);
let _e1968 = (_e1706 - _e730);
let _e1969 = (_e1719 - _e731);
let _e1972 = ((_e1968 * _e1758) - (_e1969 * _e1745));
let _e1975 = ((_e1969 * _e1732) - (_e1967 * _e1758));
let _e1978 = ((_e1967 * _e1745) - (_e1968 * _e1732));
let _e1983 = (((_e430 * _e1972) + (_e441 * _e1975)) + (_e452 * _e1978));
let _e2012 = bitcast<f32>((bitcast<u32>((((_e430 * (((_e1784 * _e1758) - (_e1797 * _e1745)) + ((_e1968 * _e1875) - (_e1969 * _e1862)))) + (_e441 * (((_e1797 * _e1732) - (_e1771 * _e1758)) + ((_e1969 * _e1849) - (_e1967 * _e1875))))) + (_e452 * (((_e1771 * _e1745) - (_e1784 * _e1732)) + ((_e1967 * _e1862) - (_e1968 * _e1849)))))) & 2147483647u));
let _e2041 = bitcast<f32>((bitcast<u32>((((_e430 * (((_e1823 * _e1758) - (_e1836 * _e1745)) + ((_e1968 * _e1914) - (_e1969 * _e1901)))) + (_e441 * (((_e1836 * _e1732) - (_e1810 * _e1758)) + ((_e1969 * _e1888) - (_e1967 * _e1914))))) + (_e452 * (((_e1810 * _e1745) - (_e1823 * _e1732)) + ((_e1967 * _e1901) - (_e1968 * _e1888)))))) & 2147483647u));
let _e2064 = bitcast<f32>((bitcast<u32>(((((_e529 * _e1972) + (_e540 * _e1975)) + (_e551 * _e1978)) - (((_e430 * ((_e474 * _e1758) - (_e485 * _e1745))) + (_e441 * ((_e485 * _e1732) - (_e463 * _e1758)))) + (_e452 * ((_e463 * _e1745) - (_e474 * _e1732)))))) & 2147483647u));
let _e2087 = bitcast<f32>((bitcast<u32>(((((_e562 * _e1972) + (_e573 * _e1975)) + (_e584 * _e1978)) - (((_e430 * ((_e507 * _e1758) - (_e518 * _e1745))) + (_e441 * ((_e518 * _e1732) - (_e496 * _e1758)))) + (_e452 * ((_e496 * _e1745) - (_e507 * _e1732)))))) & 2147483647u));
let _e2089 = select(_e2087, _e2064, (_e2064 > _e2087));
let _e2091 = select(1e-12f, _e2089, (_e2089 > 1e-12f));
if (bitcast<f32>((bitcast<u32>(_e1983) & 2147483647u)) > (0.5f * ((_e2012 + _e2041) + _e2091))) {
phi_4352_ = vec3<f32>(0f, 0f, 0f);
} else {
let _e2103 = (((_e1967 * _e430) + (_e1968 * _e441)) + (_e1969 * _e452));
let _e2108 = (((_e1967 * _e1732) + (_e1968 * _e1745)) + (_e1969 * _e1758));
let _e2113 = (((_e430 * _e1732) + (_e441 * _e1745)) + (_e452 * _e1758));
let _e2116 = ((_e441 * _e1758) - (_e452 * _e1745));
let _e2119 = ((_e452 * _e1732) - (_e430 * _e1758));
let _e2122 = ((_e430 * _e1745) - (_e441 * _e1732));
let _e2127 = (((_e2116 * _e2116) + (_e2119 * _e2119)) + (_e2122 * _e2122));
let _e2130 = (1f / select(1e-9f, _e2127, (_e2127 > 1e-9f)));
let _e2133 = ((_e2103 - (_e2113 * _e2108)) * _e2130);
let _e2136 = (((_e2113 * _e2103) - _e2108) * _e2130);
let _e2143 = ((((_e2136 >= 0f) && (_e2136 < _e1966)) && (_e2133 > _e807)) && (_e2133 < _e811));
let _e2145 = (_e2136 + (_e2133 - _e807));
let _e2149 = global_2.member.member_13.member;
let _e2154 = -((_e2149.member * _e2145));
let _e2156 = select(-87f, _e2154, (_e2154 > -87f));
let _e2158 = select(88f, _e2156, (_e2156 < 88f));
let _e2160 = ((_e2158 * 1.442695f) + 0.5f);
let _e2162 = select(-127f, _e2160, (_e2160 > -127f));
let _e2164 = select(128f, _e2162, (_e2162 < 128f));
let _e2171 = select(0i, select(select(i32(_e2164), i32(-2147483648), (_e2164 < -2147483600f)), 2147483647i, (_e2164 > 2147483500f)), (_e2164 == _e2164));
let _e2175 = (_e2171 - select(0i, 1i, (_e2164 < f32(_e2171))));
let _e2176 = f32(_e2175);
let _e2180 = ((_e2158 - (_e2176 * 0.6933594f)) - (_e2176 * -2.1219444e-4f));
let _e2202 = -((_e2149.member_1 * _e2145));
let _e2204 = select(-87f, _e2202, (_e2202 > -87f));
let _e2206 = select(88f, _e2204, (_e2204 < 88f));
let _e2208 = ((_e2206 * 1.442695f) + 0.5f);
let _e2210 = select(-127f, _e2208, (_e2208 > -127f));
let _e2212 = select(128f, _e2210, (_e2210 < 128f));
let _e2219 = select(0i, select(select(i32(_e2212), i32(-2147483648), (_e2212 < -2147483600f)), 2147483647i, (_e2212 > 2147483500f)), (_e2212 == _e2212));
let _e2223 = (_e2219 - select(0i, 1i, (_e2212 < f32(_e2219))));
let _e2224 = f32(_e2223);
let _e2228 = ((_e2206 - (_e2224 * 0.6933594f)) - (_e2224 * -2.1219444e-4f));
let _e2250 = -((_e2149.member_2 * _e2145));
let _e2252 = select(-87f, _e2250, (_e2250 > -87f));
let _e2254 = select(88f, _e2252, (_e2252 < 88f));
let _e2256 = ((_e2254 * 1.442695f) + 0.5f);
let _e2258 = select(-127f, _e2256, (_e2256 > -127f));
let _e2260 = select(128f, _e2258, (_e2258 < 128f));
let _e2267 = select(0i, select(select(i32(_e2260), i32(-2147483648), (_e2260 < -2147483600f)), 2147483647i, (_e2260 > 2147483500f)), (_e2260 == _e2260));
let _e2271 = (_e2267 - select(0i, 1i, (_e2260 < f32(_e2267))));
let _e2272 = f32(_e2271);
let _e2276 = ((_e2254 - (_e2272 * 0.6933594f)) - (_e2272 * -2.1219444e-4f));
let _e2297 = -(_e2113);
let _e2301 = global_2.member.member_13.member_2;
let _e2302 = (_e2301 * _e2301);
let _e2306 = ((1f + _e2302) - ((2f * _e2301) * _e2297));
let _e2308 = select(1e-9f, _e2306, (_e2306 > 1e-9f));
let _e2321 = global_2.member.member_13.member_3;
let _e2326 = (1e-4f * _e2091);
let _e2328 = select(_e2041, _e2012, (_e2012 > _e2041));
let _e2330 = select(_e2326, _e2328, (_e2328 > _e2326));
let _e2332 = select(_e2041, _e2012, (_e2012 < _e2041));
let _e2334 = select(_e2326, _e2332, (_e2332 > _e2326));
let _e2335 = (0.5f * _e2091);
let _e2336 = (_e1983 + _e2335);
let _e2337 = -(_e2336);
let _e2341 = (0.5f * (_e2330 + _e2334));
let _e2342 = (_e2341 - select(_e2337, _e2336, (_e2336 > _e2337)));
let _e2344 = select(0f, _e2342, (_e2342 > 0f));
let _e2346 = select(_e2334, _e2344, (_e2344 < _e2334));
let _e2350 = (_e2342 - _e2334);
let _e2354 = ((((_e2346 * (_e2346 / _e2334)) * 0.5f) + select(0f, _e2350, (_e2350 > 0f))) / _e2330);
let _e2358 = (_e1983 - _e2335);
let _e2359 = -(_e2358);
let _e2362 = (_e2341 - select(_e2359, _e2358, (_e2358 > _e2359)));
let _e2364 = select(0f, _e2362, (_e2362 > 0f));
let _e2366 = select(_e2334, _e2364, (_e2364 < _e2334));
let _e2370 = (_e2362 - _e2334);
let _e2374 = ((((_e2366 * (_e2366 / _e2334)) * 0.5f) + select(0f, _e2370, (_e2370 > 0f))) / _e2330);
let _e2380 = ((select(((1f - _e2302) / (_e2308 * sqrt(select(0f, _e2308, (_e2308 > 0f))))), (0.75f * (1f + (_e2297 * _e2297))), (_e2321 == 1u)) * (0.25f / 3.1415927f)) * ((select(_e2354, (1f - _e2354), (_e2336 >= 0f)) - select(_e2374, (1f - _e2374), (_e2358 >= 0f))) / _e2091));
let _e2387 = global_2.member.member_13.member_1;
phi_4352_ = vec3<f32>(select(0f, (((_e1927 * ((1f + (_e2180 * (1f + (_e2180 * (0.5f + (_e2180 * (0.16666667f + (_e2180 * (0.041666668f + (_e2180 * (0.008333334f + (_e2180 * (0.001388889f + (_e2180 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2175 + 127i)) << bitcast<u32>(23i))))) * _e2387.member) * _e2380), _e2143), select(0f, (((_e1940 * ((1f + (_e2228 * (1f + (_e2228 * (0.5f + (_e2228 * (0.16666667f + (_e2228 * (0.041666668f + (_e2228 * (0.008333334f + (_e2228 * (0.001388889f + (_e2228 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2223 + 127i)) << bitcast<u32>(23i))))) * _e2387.member_1) * _e2380), _e2143), select(0f, (((_e1953 * ((1f + (_e2276 * (1f + (_e2276 * (0.5f + (_e2276 * (0.16666667f + (_e2276 * (0.041666668f + (_e2276 * (0.008333334f + (_e2276 * (0.001388889f + (_e2276 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2271 + 127i)) << bitcast<u32>(23i))))) * _e2387.member_2) * _e2380), _e2143));
}
let _e2402 = phi_4352_;
let _e2403 = select(1f, 0f, _e1029);
let _e2417 = select(0f, 1f, _e1029);
phi_4391_ = vec3<f32>((_e1034.x + (_e2402.x * _e2417)), (_e1034.y + (_e2402.y * _e2417)), (_e1034.z + (_e2402.z * _e2417)));
phi_4392_ = vec3<f32>((_e1036.x + (_e2402.x * _e2403)), (_e1036.y + (_e2402.y * _e2403)), (_e1036.z + (_e2402.z * _e2403)));
} else {
phi_4391_ = _e1034;
phi_4392_ = _e1036;
}
let _e2429 = phi_4391_;
let _e2431 = phi_4392_;
let _e2432 = local_13.member_1;
phi_4400_ = type_17(_e1038.member, (_e1038.member_1 + 1u));
loop {
let _e2436 = phi_4400_;
local_35 = _e2436;
let _e2442 = (((_e2436.member_1 & 3u) == 0u) && (_e2436.member < _e2432));
if _e2442 {
phi_4401_ = type_17((_e2436.member + 1u), (_e2436.member_1 >> bitcast<u32>(2i)));
} else {
phi_4401_ = type_17();
}
let _e2448 = phi_4401_;
continue;
continuing {
phi_4400_ = _e2448;
break if !(_e2442);
}
}
phi_4422_ = _e2429;
phi_4423_ = _e2431;
let _e2610 = local_35;
phi_4424_ = _e2610;
}
let _e2455 = phi_4422_;
let _e2457 = phi_4423_;
let _e2459 = phi_4424_;
phi_2039_ = _e2455;
phi_2042_ = _e2457;
phi_2044_ = _e2459;
} else {
phi_2039_ = vec3<f32>();
phi_2042_ = vec3<f32>();
phi_2044_ = type_17();
}
let _e2461 = phi_2039_;
let _e2463 = phi_2042_;
let _e2465 = phi_2044_;
continue;
continuing {
phi_2038_ = _e2461;
phi_2041_ = _e2463;
phi_2043_ = _e2465;
break if !(_e1046);
}
}
let _e2616 = local_36;
phi_1839_ = _e2616;
let _e2619 = local_37;
phi_1842_ = _e2619;
phi_1844_ = (_e867 + 1u);
} else {
phi_1839_ = vec3<f32>();
phi_1842_ = vec3<f32>();
phi_1844_ = u32();
}
let _e2469 = phi_1839_;
let _e2471 = phi_1842_;
let _e2473 = phi_1844_;
continue;
continuing {
phi_1838_ = _e2469;
phi_1841_ = _e2471;
phi_1843_ = _e2473;
break if !(_e872);
}
}
let _e2476 = local_29;
let _e2480 = local_30;
let _e2484 = local_31;
let _e2491 = local_32;
let _e2495 = local_33;
let _e2499 = local_34;
phi_4474_ = array<f32, 18>(_e148, _e158, _e169, _e180, _e191, _e202, _e213, _e224, (_e235 + (_e2476.x * _e733)), (_e246 + (_e2480.y * _e734)), (_e257 + (_e2484.z * _e735)), (_e268 + (_e2491.x * _e733)), (_e279 + (_e2495.y * _e734)), (_e290 + (_e2499.z * _e735)), _e301, _e312, _e323, _e334);
}
let _e2507 = phi_4474_;
global_1.member[_e137] = _e2507[0];
global_1.member[_e149] = _e2507[1];
global_1.member[_e160] = _e2507[2];
global_1.member[_e171] = _e2507[3];
global_1.member[_e182] = _e2507[4];
global_1.member[_e193] = _e2507[5];
global_1.member[_e204] = _e2507[6];
global_1.member[_e215] = _e2507[7];
global_1.member[_e226] = _e2507[8];
global_1.member[_e237] = _e2507[9];
global_1.member[_e248] = _e2507[10];
global_1.member[_e259] = _e2507[11];
global_1.member[_e270] = _e2507[12];
global_1.member[_e281] = _e2507[13];
global_1.member[_e292] = _e2507[14];
global_1.member[_e303] = _e2507[15];
global_1.member[_e314] = _e2507[16];
global_1.member[_e325] = _e2507[17];
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
