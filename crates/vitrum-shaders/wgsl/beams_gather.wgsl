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
var local_16: u32;
var local_17: u32;
var phi_1881_: u32;
var phi_1882_: u32;
var phi_1894_: u32;
var phi_1895_: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var phi_1920_: u32;
var phi_1921_: u32;
var local_21: u32;
var local_22: u32;
var phi_1938_: u32;
var phi_1939_: u32;
var local_23: u32;
var local_24: u32;
var phi_1961_: u32;
var phi_1962_: u32;
var phi_1974_: u32;
var phi_1975_: u32;
var local_25: u32;
var local_26: u32;
var local_27: u32;
var phi_2011_: u32;
var phi_2025_: vec3<f32>;
var phi_2028_: vec3<f32>;
var phi_2030_: type_17;
var phi_2092_: i32;
var phi_2116_: u32;
var phi_2117_: u32;
var local_28: u32;
var local_29: u32;
var phi_2229_: u32;
var phi_2230_: u32;
var local_30: u32;
var local_31: u32;
var phi_2420_: u32;
var phi_2421_: u32;
var local_32: u32;
var local_33: u32;
var phi_2533_: u32;
var phi_2534_: u32;
var local_34: u32;
var local_35: u32;
var phi_2646_: u32;
var phi_2647_: u32;
var local_36: u32;
var local_37: u32;
var phi_2759_: u32;
var phi_2760_: u32;
var local_38: u32;
var local_39: u32;
var phi_2971_: bool;
var phi_3210_: bool;
var phi_4417_: vec3<f32>;
var phi_4456_: vec3<f32>;
var phi_4457_: vec3<f32>;
var phi_4465_: type_17;
var phi_4466_: type_17;
var phi_4487_: vec3<f32>;
var phi_4488_: vec3<f32>;
var phi_4489_: type_17;
var phi_2026_: vec3<f32>;
var phi_2029_: vec3<f32>;
var phi_2031_: type_17;
var phi_1839_: vec3<f32>;
var phi_1842_: vec3<f32>;
var phi_1844_: u32;
var local_40: vec3<f32>;
var local_41: vec3<f32>;
var local_42: vec3<f32>;
var local_43: vec3<f32>;
var local_44: vec3<f32>;
var local_45: vec3<f32>;
var phi_4539_: array<f32, 18>;
var local_46: type_17;
var local_47: vec3<f32>;
var local_48: vec3<f32>;
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
phi_4539_ = array<f32, 18>(_e148, _e158, _e169, _e180, _e191, _e202, _e213, _e224, _e235, _e246, _e257, _e268, _e279, _e290, _e301, _e312, _e323, _e334);
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
local_40 = _e865;
local_41 = _e865;
local_42 = _e865;
local_43 = _e863;
local_44 = _e863;
local_45 = _e863;
let _e871 = global_2.member.member_12.member_7;
let _e872 = (_e867 <= _e871);
if _e872 {
let _e876 = global_2.member.member_12.member_5;
let _e878 = bitcast<i32>((_e867 * _e876));
phi_1863_ = 0u;
loop {
let _e880 = phi_1863_;
local_16 = _e880;
local_17 = _e880;
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
let _e890 = local_16;
let _e893 = local_17;
phi_1881_ = 0u;
loop {
let _e896 = phi_1881_;
local_20 = _e896;
let _e900 = ((1u << bitcast<u32>((_e896 & 31u))) < _e859);
if _e900 {
phi_1882_ = (_e896 + 1u);
} else {
phi_1882_ = u32();
}
let _e903 = phi_1882_;
continue;
continuing {
phi_1881_ = _e903;
break if !(_e900);
}
}
phi_1894_ = 0u;
loop {
let _e906 = phi_1894_;
local_18 = _e906;
local_19 = _e906;
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
let _e916 = local_18;
let _e919 = local_19;
let _e922 = local_20;
let _e931 = global_2.member.member_12.member_6;
phi_1920_ = 0u;
loop {
let _e934 = phi_1920_;
local_21 = _e934;
local_22 = _e934;
let _e938 = ((1u << bitcast<u32>((_e934 & 31u))) < _e859);
if _e938 {
phi_1921_ = (_e934 + 1u);
} else {
phi_1921_ = u32();
}
let _e941 = phi_1921_;
continue;
continuing {
phi_1920_ = _e941;
break if !(_e938);
}
}
let _e944 = local_21;
let _e947 = local_22;
phi_1938_ = 0u;
loop {
let _e950 = phi_1938_;
local_23 = _e950;
local_24 = _e950;
let _e954 = ((1u << bitcast<u32>((_e950 & 31u))) < _e859);
if _e954 {
phi_1939_ = (_e950 + 1u);
} else {
phi_1939_ = u32();
}
let _e957 = phi_1939_;
continue;
continuing {
phi_1938_ = _e957;
break if !(_e954);
}
}
let _e960 = local_23;
let _e966 = local_24;
phi_1961_ = 0u;
loop {
let _e976 = phi_1961_;
local_27 = _e976;
let _e980 = ((1u << bitcast<u32>((_e976 & 31u))) < _e859);
if _e980 {
phi_1962_ = (_e976 + 1u);
} else {
phi_1962_ = u32();
}
let _e983 = phi_1962_;
continue;
continuing {
phi_1961_ = _e983;
break if !(_e980);
}
}
phi_1974_ = 0u;
loop {
let _e986 = phi_1974_;
local_25 = _e986;
local_26 = _e986;
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
let _e996 = local_25;
let _e999 = local_26;
let _e1002 = local_27;
let _e1008 = (((((1u << bitcast<u32>(((2u * _e960) & 31u))) - (1u << bitcast<u32>(((2u * (_e966 - select(6u, _e947, (_e944 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1002 - select(6u, _e999, (_e996 < 6u)))) & 31u))));
let _e1009 = (_e1008 / 64u);
if ((_e1008 % 64u) > 0u) {
phi_2011_ = (_e1009 + 1u);
} else {
phi_2011_ = _e1009;
}
let _e1014 = phi_2011_;
local_13 = type_24(_e859, select(6u, _e893, (_e890 < 6u)), (1u << bitcast<u32>(((2u * (_e922 - select(6u, _e919, (_e916 < 6u)))) & 31u))), (_e867 * _e931), (_e1014 * 64u));
let _e1017 = (_e867 == 0u);
let _e1019 = local_13.member_1;
phi_2025_ = _e863;
phi_2028_ = _e865;
phi_2030_ = type_17(_e1019, 0u);
loop {
let _e1022 = phi_2025_;
let _e1024 = phi_2028_;
let _e1026 = phi_2030_;
local_47 = _e1022;
local_48 = _e1024;
let _e1029 = local_13.member_1;
let _e1032 = local_13.member_2;
let _e1034 = ((_e1026.member < _e1029) || (_e1026.member_1 < _e1032));
if _e1034 {
let _e1035 = (_e1026.member_1 & 1431655765u);
let _e1039 = ((_e1035 | (_e1035 >> bitcast<u32>(1i))) & 858993459u);
let _e1043 = ((_e1039 | (_e1039 >> bitcast<u32>(2i))) & 252645135u);
let _e1047 = ((_e1043 | (_e1043 >> bitcast<u32>(4i))) & 16711935u);
let _e1051 = ((_e1047 | (_e1047 >> bitcast<u32>(8i))) & 65535u);
let _e1054 = ((_e1026.member_1 >> bitcast<u32>(1i)) & 1431655765u);
let _e1058 = ((_e1054 | (_e1054 >> bitcast<u32>(1i))) & 858993459u);
let _e1062 = ((_e1058 | (_e1058 >> bitcast<u32>(2i))) & 252645135u);
let _e1066 = ((_e1062 | (_e1062 >> bitcast<u32>(4i))) & 16711935u);
let _e1070 = ((_e1066 | (_e1066 >> bitcast<u32>(8i))) & 65535u);
let _e1073 = ((_e1051 < _e859) && (_e1070 < _e859));
if _e1073 {
phi_2092_ = bitcast<i32>(((_e1070 * _e859) + _e1051));
} else {
phi_2092_ = 0i;
}
let _e1078 = phi_2092_;
let _e1079 = (_e1026.member > 0u);
if _e1079 {
local_11.member = _e1026.member;
local_11.member_1 = _e1026.member_1;
let _e1218 = local_11.member;
let _e1219 = local_11.member_1;
let _e1221 = local_13.member;
phi_2116_ = 0u;
loop {
let _e1223 = phi_2116_;
local_28 = _e1223;
local_29 = _e1223;
let _e1227 = ((1u << bitcast<u32>((_e1223 & 31u))) < _e1221);
if _e1227 {
phi_2117_ = (_e1223 + 1u);
} else {
phi_2117_ = u32();
}
let _e1230 = phi_2117_;
continue;
continuing {
phi_2116_ = _e1230;
break if !(_e1227);
}
}
let _e1233 = local_28;
let _e1239 = local_29;
let _e1250 = local_13.member_3;
local_12 = (_e1250 + (((((1u << bitcast<u32>(((2u * _e1233) & 31u))) - (1u << bitcast<u32>(((2u * (_e1239 - _e1218)) & 31u)))) / 3u) * 4u) + _e1219));
let _e1252 = local_12;
let _e1253 = bitcast<i32>(_e1252);
let _e1255 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1257 = select(_e1255, _e1253, (_e1253 < _e1255));
let _e1262 = global_5.member[bitcast<u32>(select(0i, _e1257, (_e1257 > 0i)))];
let _e1263 = local_12;
let _e1265 = local_13.member_4;
let _e1267 = bitcast<i32>((_e1263 + _e1265));
let _e1269 = select(_e1255, _e1267, (_e1267 < _e1255));
let _e1274 = global_5.member[bitcast<u32>(select(0i, _e1269, (_e1269 > 0i)))];
let _e1275 = local_12;
let _e1276 = local_13.member_4;
let _e1279 = bitcast<i32>((_e1275 + (2u * _e1276)));
let _e1281 = select(_e1255, _e1279, (_e1279 < _e1255));
let _e1286 = global_5.member[bitcast<u32>(select(0i, _e1281, (_e1281 > 0i)))];
let _e1287 = local_11.member;
let _e1288 = local_11.member_1;
let _e1289 = local_13.member;
phi_2229_ = 0u;
loop {
let _e1291 = phi_2229_;
local_30 = _e1291;
local_31 = _e1291;
let _e1295 = ((1u << bitcast<u32>((_e1291 & 31u))) < _e1289);
if _e1295 {
phi_2230_ = (_e1291 + 1u);
} else {
phi_2230_ = u32();
}
let _e1298 = phi_2230_;
continue;
continuing {
phi_2229_ = _e1298;
break if !(_e1295);
}
}
let _e1301 = local_30;
let _e1307 = local_31;
let _e1317 = local_13.member_3;
let _e1318 = local_13.member_4;
local_10 = ((_e1317 + (3u * _e1318)) + (((((1u << bitcast<u32>(((2u * _e1301) & 31u))) - (1u << bitcast<u32>(((2u * (_e1307 - _e1287)) & 31u)))) / 3u) * 4u) + _e1288));
let _e1322 = local_10;
let _e1323 = bitcast<i32>(_e1322);
let _e1325 = select(_e1255, _e1323, (_e1323 < _e1255));
let _e1330 = global_5.member[bitcast<u32>(select(0i, _e1325, (_e1325 > 0i)))];
let _e1331 = local_10;
let _e1332 = local_13.member_4;
let _e1334 = bitcast<i32>((_e1331 + _e1332));
let _e1336 = select(_e1255, _e1334, (_e1334 < _e1255));
let _e1341 = global_5.member[bitcast<u32>(select(0i, _e1336, (_e1336 > 0i)))];
let _e1342 = local_10;
let _e1343 = local_13.member_4;
let _e1346 = bitcast<i32>((_e1342 + (2u * _e1343)));
let _e1348 = select(_e1255, _e1346, (_e1346 < _e1255));
let _e1353 = global_5.member[bitcast<u32>(select(0i, _e1348, (_e1348 > 0i)))];
let _e1355 = ((_e1262 - _e729) * _e743);
let _e1357 = ((_e1330 - _e729) * _e743);
let _e1359 = ((_e1274 - _e730) * _e751);
let _e1361 = ((_e1341 - _e730) * _e751);
let _e1363 = ((_e1286 - _e731) * _e759);
let _e1365 = ((_e1353 - _e731) * _e759);
let _e1367 = select(_e1357, _e1355, (_e1355 < _e1357));
let _e1369 = select(_e1361, _e1359, (_e1359 < _e1361));
let _e1371 = select(_e1369, _e1367, (_e1367 > _e1369));
let _e1373 = select(_e1365, _e1363, (_e1363 < _e1365));
let _e1375 = select(_e1373, _e1371, (_e1371 > _e1373));
let _e1377 = select(_e1357, _e1355, (_e1355 > _e1357));
let _e1379 = select(_e1361, _e1359, (_e1359 > _e1361));
let _e1381 = select(_e1379, _e1377, (_e1377 < _e1379));
let _e1383 = select(_e1365, _e1363, (_e1363 > _e1365));
let _e1385 = select(_e1383, _e1381, (_e1381 < _e1383));
if ((_e1262 <= _e1330) && (select(_e807, _e1375, (_e1375 > _e807)) <= select(_e811, _e1385, (_e1385 < _e811)))) {
let _e1393 = local_11.member;
let _e1394 = local_11.member_1;
let _e1395 = local_13.member;
phi_2420_ = 0u;
loop {
let _e1397 = phi_2420_;
local_32 = _e1397;
local_33 = _e1397;
let _e1401 = ((1u << bitcast<u32>((_e1397 & 31u))) < _e1395);
if _e1401 {
phi_2421_ = (_e1397 + 1u);
} else {
phi_2421_ = u32();
}
let _e1404 = phi_2421_;
continue;
continuing {
phi_2420_ = _e1404;
break if !(_e1401);
}
}
let _e1407 = local_32;
let _e1413 = local_33;
let _e1423 = local_13.member_3;
let _e1424 = local_13.member_4;
local_9 = ((_e1423 + (6u * _e1424)) + (((((1u << bitcast<u32>(((2u * _e1407) & 31u))) - (1u << bitcast<u32>(((2u * (_e1413 - _e1393)) & 31u)))) / 3u) * 4u) + _e1394));
let _e1428 = local_9;
let _e1429 = bitcast<i32>(_e1428);
let _e1431 = select(_e1255, _e1429, (_e1429 < _e1255));
let _e1436 = global_5.member[bitcast<u32>(select(0i, _e1431, (_e1431 > 0i)))];
let _e1437 = local_9;
let _e1438 = local_13.member_4;
let _e1440 = bitcast<i32>((_e1437 + _e1438));
let _e1442 = select(_e1255, _e1440, (_e1440 < _e1255));
let _e1447 = global_5.member[bitcast<u32>(select(0i, _e1442, (_e1442 > 0i)))];
let _e1448 = local_9;
let _e1449 = local_13.member_4;
let _e1452 = bitcast<i32>((_e1448 + (2u * _e1449)));
let _e1454 = select(_e1255, _e1452, (_e1452 < _e1255));
let _e1459 = global_5.member[bitcast<u32>(select(0i, _e1454, (_e1454 > 0i)))];
let _e1460 = local_11.member;
let _e1461 = local_11.member_1;
let _e1462 = local_13.member;
phi_2533_ = 0u;
loop {
let _e1464 = phi_2533_;
local_34 = _e1464;
local_35 = _e1464;
let _e1468 = ((1u << bitcast<u32>((_e1464 & 31u))) < _e1462);
if _e1468 {
phi_2534_ = (_e1464 + 1u);
} else {
phi_2534_ = u32();
}
let _e1471 = phi_2534_;
continue;
continuing {
phi_2533_ = _e1471;
break if !(_e1468);
}
}
let _e1474 = local_34;
let _e1480 = local_35;
let _e1490 = local_13.member_3;
let _e1491 = local_13.member_4;
local_8 = ((_e1490 + (9u * _e1491)) + (((((1u << bitcast<u32>(((2u * _e1474) & 31u))) - (1u << bitcast<u32>(((2u * (_e1480 - _e1460)) & 31u)))) / 3u) * 4u) + _e1461));
let _e1495 = local_8;
let _e1496 = bitcast<i32>(_e1495);
let _e1498 = select(_e1255, _e1496, (_e1496 < _e1255));
let _e1503 = global_5.member[bitcast<u32>(select(0i, _e1498, (_e1498 > 0i)))];
let _e1504 = local_8;
let _e1505 = local_13.member_4;
let _e1507 = bitcast<i32>((_e1504 + _e1505));
let _e1509 = select(_e1255, _e1507, (_e1507 < _e1255));
let _e1514 = global_5.member[bitcast<u32>(select(0i, _e1509, (_e1509 > 0i)))];
let _e1515 = local_8;
let _e1516 = local_13.member_4;
let _e1519 = bitcast<i32>((_e1515 + (2u * _e1516)));
let _e1521 = select(_e1255, _e1519, (_e1519 < _e1255));
let _e1526 = global_5.member[bitcast<u32>(select(0i, _e1521, (_e1521 > 0i)))];
let _e1527 = local_11.member;
let _e1528 = local_11.member_1;
let _e1529 = local_13.member;
phi_2646_ = 0u;
loop {
let _e1531 = phi_2646_;
local_36 = _e1531;
local_37 = _e1531;
let _e1535 = ((1u << bitcast<u32>((_e1531 & 31u))) < _e1529);
if _e1535 {
phi_2647_ = (_e1531 + 1u);
} else {
phi_2647_ = u32();
}
let _e1538 = phi_2647_;
continue;
continuing {
phi_2646_ = _e1538;
break if !(_e1535);
}
}
let _e1541 = local_36;
let _e1547 = local_37;
let _e1557 = local_13.member_3;
let _e1558 = local_13.member_4;
local_7 = ((_e1557 + (12u * _e1558)) + (((((1u << bitcast<u32>(((2u * _e1541) & 31u))) - (1u << bitcast<u32>(((2u * (_e1547 - _e1527)) & 31u)))) / 3u) * 4u) + _e1528));
let _e1562 = local_7;
let _e1563 = bitcast<i32>(_e1562);
let _e1565 = select(_e1255, _e1563, (_e1563 < _e1255));
let _e1570 = global_5.member[bitcast<u32>(select(0i, _e1565, (_e1565 > 0i)))];
let _e1571 = local_7;
let _e1572 = local_13.member_4;
let _e1574 = bitcast<i32>((_e1571 + _e1572));
let _e1576 = select(_e1255, _e1574, (_e1574 < _e1255));
let _e1581 = global_5.member[bitcast<u32>(select(0i, _e1576, (_e1576 > 0i)))];
let _e1582 = local_7;
let _e1583 = local_13.member_4;
let _e1586 = bitcast<i32>((_e1582 + (2u * _e1583)));
let _e1588 = select(_e1255, _e1586, (_e1586 < _e1255));
let _e1593 = global_5.member[bitcast<u32>(select(0i, _e1588, (_e1588 > 0i)))];
let _e1594 = local_11.member;
let _e1595 = local_11.member_1;
let _e1596 = local_13.member;
phi_2759_ = 0u;
loop {
let _e1598 = phi_2759_;
local_38 = _e1598;
local_39 = _e1598;
let _e1602 = ((1u << bitcast<u32>((_e1598 & 31u))) < _e1596);
if _e1602 {
phi_2760_ = (_e1598 + 1u);
} else {
phi_2760_ = u32();
}
let _e1605 = phi_2760_;
continue;
continuing {
phi_2759_ = _e1605;
break if !(_e1602);
}
}
let _e1608 = local_38;
let _e1614 = local_39;
let _e1624 = local_13.member_3;
let _e1625 = local_13.member_4;
local_6 = ((_e1624 + (15u * _e1625)) + (((((1u << bitcast<u32>(((2u * _e1608) & 31u))) - (1u << bitcast<u32>(((2u * (_e1614 - _e1594)) & 31u)))) / 3u) * 4u) + _e1595));
let _e1629 = local_6;
let _e1630 = bitcast<i32>(_e1629);
let _e1632 = select(_e1255, _e1630, (_e1630 < _e1255));
let _e1637 = global_5.member[bitcast<u32>(select(0i, _e1632, (_e1632 > 0i)))];
let _e1638 = local_6;
let _e1639 = local_13.member_4;
let _e1641 = bitcast<i32>((_e1638 + _e1639));
let _e1643 = select(_e1255, _e1641, (_e1641 < _e1255));
let _e1648 = global_5.member[bitcast<u32>(select(0i, _e1643, (_e1643 > 0i)))];
let _e1649 = local_6;
let _e1650 = local_13.member_4;
let _e1653 = bitcast<i32>((_e1649 + (2u * _e1650)));
let _e1655 = select(_e1255, _e1653, (_e1653 < _e1255));
let _e1660 = global_5.member[bitcast<u32>(select(0i, _e1655, (_e1655 > 0i)))];
let _e1661 = (_e1436 - _e729);
let _e1662 = (_e1447 - _e730);
let _e1663 = (_e1459 - _e731);
let _e1666 = ((_e1581 * _e452) - (_e1593 * _e441));
let _e1669 = ((_e1593 * _e430) - (_e1570 * _e452));
let _e1672 = ((_e1570 * _e441) - (_e1581 * _e430));
let _e1720 = (((_e1503 * _e1503) + (_e1514 * _e1514)) + (_e1526 * _e1526));
let _e1723 = sqrt(select(0f, _e1720, (_e1720 > 0f)));
let _e1728 = (((_e1637 * _e1637) + (_e1648 * _e1648)) + (_e1660 * _e1660));
let _e1738 = (((_e1661 * _e1661) + (_e1662 * _e1662)) + (_e1663 * _e1663));
phi_2971_ = (bitcast<f32>((bitcast<u32>((((_e1661 * _e1666) + (_e1662 * _e1669)) + (_e1663 * _e1672))) & 2147483647u)) <= ((((((bitcast<f32>((bitcast<u32>(_e1666) & 2147483647u)) * _e1503) + (bitcast<f32>((bitcast<u32>(_e1669) & 2147483647u)) * _e1514)) + (bitcast<f32>((bitcast<u32>(_e1672) & 2147483647u)) * _e1526)) + (((bitcast<f32>((bitcast<u32>(((_e441 * _e1663) - (_e452 * _e1662))) & 2147483647u)) * _e1637) + (bitcast<f32>((bitcast<u32>(((_e452 * _e1661) - (_e430 * _e1663))) & 2147483647u)) * _e1648)) + (bitcast<f32>((bitcast<u32>(((_e430 * _e1662) - (_e441 * _e1661))) & 2147483647u)) * _e1660))) + (_e1723 * sqrt(select(0f, _e1728, (_e1728 > 0f))))) + (_e837 + (_e855 * (sqrt(select(0f, _e1738, (_e1738 > 0f))) + _e1723)))));
} else {
phi_2971_ = false;
}
let _e1751 = phi_2971_;
phi_3210_ = _e1751;
} else {
local_3 = _e878;
local_4 = _e1078;
local_5 = _e861;
let _e1080 = local_3;
let _e1081 = local_4;
let _e1082 = (_e1080 + _e1081);
let _e1084 = (bitcast<i32>(_e120) - 1i);
let _e1086 = select(_e1084, _e1082, (_e1082 < _e1084));
let _e1091 = global_4.member[bitcast<u32>(select(0i, _e1086, (_e1086 > 0i)))];
let _e1092 = local_3;
let _e1093 = local_5;
let _e1095 = local_4;
let _e1096 = ((_e1092 + _e1093) + _e1095);
let _e1098 = select(_e1084, _e1096, (_e1096 < _e1084));
let _e1103 = global_4.member[bitcast<u32>(select(0i, _e1098, (_e1098 > 0i)))];
let _e1104 = local_3;
let _e1105 = local_5;
let _e1108 = local_4;
let _e1109 = ((_e1104 + (2i * _e1105)) + _e1108);
let _e1111 = select(_e1084, _e1109, (_e1109 < _e1084));
let _e1116 = global_4.member[bitcast<u32>(select(0i, _e1111, (_e1111 > 0i)))];
let _e1117 = local_3;
let _e1118 = local_5;
let _e1121 = local_4;
let _e1122 = ((_e1117 + (3i * _e1118)) + _e1121);
let _e1124 = select(_e1084, _e1122, (_e1122 < _e1084));
let _e1129 = global_4.member[bitcast<u32>(select(0i, _e1124, (_e1124 > 0i)))];
let _e1130 = local_3;
let _e1131 = local_5;
let _e1134 = local_4;
let _e1135 = ((_e1130 + (4i * _e1131)) + _e1134);
let _e1137 = select(_e1084, _e1135, (_e1135 < _e1084));
let _e1142 = global_4.member[bitcast<u32>(select(0i, _e1137, (_e1137 > 0i)))];
let _e1143 = local_3;
let _e1144 = local_5;
let _e1147 = local_4;
let _e1148 = ((_e1143 + (5i * _e1144)) + _e1147);
let _e1150 = select(_e1084, _e1148, (_e1148 < _e1084));
let _e1155 = global_4.member[bitcast<u32>(select(0i, _e1150, (_e1150 > 0i)))];
let _e1156 = (_e1091 - _e729);
let _e1157 = (_e1103 - _e730);
let _e1158 = (_e1116 - _e731);
let _e1177 = (((_e1156 * _e1156) + (_e1157 * _e1157)) + (_e1158 * _e1158));
let _e1181 = local_3;
let _e1182 = local_5;
let _e1185 = local_4;
let _e1186 = ((_e1181 + (21i * _e1182)) + _e1185);
let _e1188 = select(_e1084, _e1186, (_e1186 < _e1084));
let _e1193 = global_4.member[bitcast<u32>(select(0i, _e1188, (_e1188 > 0i)))];
let _e1198 = local_3;
let _e1199 = local_5;
let _e1202 = local_4;
let _e1203 = ((_e1198 + (22i * _e1199)) + _e1202);
let _e1205 = select(_e1084, _e1203, (_e1203 < _e1084));
let _e1210 = global_4.member[bitcast<u32>(select(0i, _e1205, (_e1205 > 0i)))];
phi_3210_ = (_e1073 && (bitcast<f32>((bitcast<u32>((((_e430 * ((_e1157 * _e1155) - (_e1158 * _e1142))) + (_e441 * ((_e1158 * _e1129) - (_e1156 * _e1155)))) + (_e452 * ((_e1156 * _e1142) - (_e1157 * _e1129))))) & 2147483647u)) <= ((_e1193 + _e837) + ((_e1210 + _e855) * sqrt(select(0f, _e1177, (_e1177 > 0f)))))));
}
let _e1753 = phi_3210_;
if (_e1753 && _e1079) {
phi_4487_ = _e1022;
phi_4488_ = _e1024;
phi_4489_ = type_17((_e1026.member - 1u), (_e1026.member_1 << bitcast<u32>(2i)));
} else {
if _e1753 {
local = _e878;
local_1 = _e1078;
local_2 = _e861;
let _e1755 = local;
let _e1756 = local_1;
let _e1757 = (_e1755 + _e1756);
let _e1759 = (bitcast<i32>(_e120) - 1i);
let _e1761 = select(_e1759, _e1757, (_e1757 < _e1759));
let _e1766 = global_4.member[bitcast<u32>(select(0i, _e1761, (_e1761 > 0i)))];
let _e1767 = local;
let _e1768 = local_2;
let _e1770 = local_1;
let _e1771 = ((_e1767 + _e1768) + _e1770);
let _e1773 = select(_e1759, _e1771, (_e1771 < _e1759));
let _e1778 = global_4.member[bitcast<u32>(select(0i, _e1773, (_e1773 > 0i)))];
let _e1779 = local;
let _e1780 = local_2;
let _e1783 = local_1;
let _e1784 = ((_e1779 + (2i * _e1780)) + _e1783);
let _e1786 = select(_e1759, _e1784, (_e1784 < _e1759));
let _e1791 = global_4.member[bitcast<u32>(select(0i, _e1786, (_e1786 > 0i)))];
let _e1792 = local;
let _e1793 = local_2;
let _e1796 = local_1;
let _e1797 = ((_e1792 + (3i * _e1793)) + _e1796);
let _e1799 = select(_e1759, _e1797, (_e1797 < _e1759));
let _e1804 = global_4.member[bitcast<u32>(select(0i, _e1799, (_e1799 > 0i)))];
let _e1805 = local;
let _e1806 = local_2;
let _e1809 = local_1;
let _e1810 = ((_e1805 + (4i * _e1806)) + _e1809);
let _e1812 = select(_e1759, _e1810, (_e1810 < _e1759));
let _e1817 = global_4.member[bitcast<u32>(select(0i, _e1812, (_e1812 > 0i)))];
let _e1818 = local;
let _e1819 = local_2;
let _e1822 = local_1;
let _e1823 = ((_e1818 + (5i * _e1819)) + _e1822);
let _e1825 = select(_e1759, _e1823, (_e1823 < _e1759));
let _e1830 = global_4.member[bitcast<u32>(select(0i, _e1825, (_e1825 > 0i)))];
let _e1831 = local;
let _e1832 = local_2;
let _e1835 = local_1;
let _e1836 = ((_e1831 + (6i * _e1832)) + _e1835);
let _e1838 = select(_e1759, _e1836, (_e1836 < _e1759));
let _e1843 = global_4.member[bitcast<u32>(select(0i, _e1838, (_e1838 > 0i)))];
let _e1844 = local;
let _e1845 = local_2;
let _e1848 = local_1;
let _e1849 = ((_e1844 + (7i * _e1845)) + _e1848);
let _e1851 = select(_e1759, _e1849, (_e1849 < _e1759));
let _e1856 = global_4.member[bitcast<u32>(select(0i, _e1851, (_e1851 > 0i)))];
let _e1857 = local;
let _e1858 = local_2;
let _e1861 = local_1;
let _e1862 = ((_e1857 + (8i * _e1858)) + _e1861);
let _e1864 = select(_e1759, _e1862, (_e1862 < _e1759));
let _e1869 = global_4.member[bitcast<u32>(select(0i, _e1864, (_e1864 > 0i)))];
let _e1870 = local;
let _e1871 = local_2;
let _e1874 = local_1;
let _e1875 = ((_e1870 + (9i * _e1871)) + _e1874);
let _e1877 = select(_e1759, _e1875, (_e1875 < _e1759));
let _e1882 = global_4.member[bitcast<u32>(select(0i, _e1877, (_e1877 > 0i)))];
let _e1883 = local;
let _e1884 = local_2;
let _e1887 = local_1;
let _e1888 = ((_e1883 + (10i * _e1884)) + _e1887);
let _e1890 = select(_e1759, _e1888, (_e1888 < _e1759));
let _e1895 = global_4.member[bitcast<u32>(select(0i, _e1890, (_e1890 > 0i)))];
let _e1896 = local;
let _e1897 = local_2;
let _e1900 = local_1;
let _e1901 = ((_e1896 + (11i * _e1897)) + _e1900);
let _e1903 = select(_e1759, _e1901, (_e1901 < _e1759));
let _e1908 = global_4.member[bitcast<u32>(select(0i, _e1903, (_e1903 > 0i)))];
let _e1909 = local;
let _e1910 = local_2;
let _e1913 = local_1;
let _e1914 = ((_e1909 + (12i * _e1910)) + _e1913);
let _e1916 = select(_e1759, _e1914, (_e1914 < _e1759));
let _e1921 = global_4.member[bitcast<u32>(select(0i, _e1916, (_e1916 > 0i)))];
let _e1922 = local;
let _e1923 = local_2;
let _e1926 = local_1;
let _e1927 = ((_e1922 + (13i * _e1923)) + _e1926);
let _e1929 = select(_e1759, _e1927, (_e1927 < _e1759));
let _e1934 = global_4.member[bitcast<u32>(select(0i, _e1929, (_e1929 > 0i)))];
let _e1935 = local;
let _e1936 = local_2;
let _e1939 = local_1;
let _e1940 = ((_e1935 + (14i * _e1936)) + _e1939);
let _e1942 = select(_e1759, _e1940, (_e1940 < _e1759));
let _e1947 = global_4.member[bitcast<u32>(select(0i, _e1942, (_e1942 > 0i)))];
let _e1948 = local;
let _e1949 = local_2;
let _e1952 = local_1;
let _e1953 = ((_e1948 + (15i * _e1949)) + _e1952);
let _e1955 = select(_e1759, _e1953, (_e1953 < _e1759));
let _e1960 = global_4.member[bitcast<u32>(select(0i, _e1955, (_e1955 > 0i)))];
let _e1961 = local;
let _e1962 = local_2;
let _e1965 = local_1;
let _e1966 = ((_e1961 + (16i * _e1962)) + _e1965);
let _e1968 = select(_e1759, _e1966, (_e1966 < _e1759));
let _e1973 = global_4.member[bitcast<u32>(select(0i, _e1968, (_e1968 > 0i)))];
let _e1974 = local;
let _e1975 = local_2;
let _e1978 = local_1;
let _e1979 = ((_e1974 + (17i * _e1975)) + _e1978);
let _e1981 = select(_e1759, _e1979, (_e1979 < _e1759));
let _e1986 = global_4.member[bitcast<u32>(select(0i, _e1981, (_e1981 > 0i)))];
let _e1987 = local;
let _e1988 = local_2;
let _e1991 = local_1;
let _e1992 = ((_e1987 + (18i * _e1988)) + _e1991);
let _e1994 = select(_e1759, _e1992, (_e1992 < _e1759));
let _e1999 = global_4.member[bitcast<u32>(select(0i, _e1994, (_e1994 > 0i)))];
let _e2000 = local;
let _e2001 = local_2;
let _e2004 = local_1;
let _e2005 = ((_e2000 + (19i * _e2001)) + _e2004);
let _e2007 = select(_e1759, _e2005, (_e2005 < _e1759));
let _e2012 = global_4.member[bitcast<u32>(select(0i, _e2007, (_e2007 > 0i)))];
let _e2013 = local;
let _e2014 = local_2;
let _e2017 = local_1;
let _e2018 = ((_e2013 + (20i * _e2014)) + _e2017);
let _e2020 = select(_e1759, _e2018, (_e2018 < _e1759));
let _e2025 = global_4.member[bitcast<u32>(select(0i, _e2020, (_e2020 > 0i)))];
let _e2026 = local;
let _e2027 = local_2;
let _e2030 = local_1;
let _e2031 = ((_e2026 + (23i * _e2027)) + _e2030);
let _e2033 = select(_e1759, _e2031, (_e2031 < _e1759));
let _e2038 = global_4.member[bitcast<u32>(select(0i, _e2033, (_e2033 > 0i)))];
let _e2039 = (_e1766 - _e729);
let _e2040 = (_e1778 - _e730);
let _e2041 = (_e1791 - _e731);
let _e2044 = ((_e2040 * _e1830) - (_e2041 * _e1817));
let _e2047 = ((_e2041 * _e1804) - (_e2039 * _e1830));
let _e2050 = ((_e2039 * _e1817) - (_e2040 * _e1804));
let _e2055 = (((_e430 * _e2044) + (_e441 * _e2047)) + (_e452 * _e2050));
let _e2084 = bitcast<f32>((bitcast<u32>((((_e430 * (((_e1856 * _e1830) - (_e1869 * _e1817)) + ((_e2040 * _e1947) - (_e2041 * _e1934)))) + (_e441 * (((_e1869 * _e1804) - (_e1843 * _e1830)) + ((_e2041 * _e1921) - (_e2039 * _e1947))))) + (_e452 * (((_e1843 * _e1817) - (_e1856 * _e1804)) + ((_e2039 * _e1934) - (_e2040 * _e1921)))))) & 2147483647u));
let _e2113 = bitcast<f32>((bitcast<u32>((((_e430 * (((_e1895 * _e1830) - (_e1908 * _e1817)) + ((_e2040 * _e1986) - (_e2041 * _e1973)))) + (_e441 * (((_e1908 * _e1804) - (_e1882 * _e1830)) + ((_e2041 * _e1960) - (_e2039 * _e1986))))) + (_e452 * (((_e1882 * _e1817) - (_e1895 * _e1804)) + ((_e2039 * _e1973) - (_e2040 * _e1960)))))) & 2147483647u));
let _e2136 = bitcast<f32>((bitcast<u32>(((((_e529 * _e2044) + (_e540 * _e2047)) + (_e551 * _e2050)) - (((_e430 * ((_e474 * _e1830) - (_e485 * _e1817))) + (_e441 * ((_e485 * _e1804) - (_e463 * _e1830)))) + (_e452 * ((_e463 * _e1817) - (_e474 * _e1804)))))) & 2147483647u));
let _e2159 = bitcast<f32>((bitcast<u32>(((((_e562 * _e2044) + (_e573 * _e2047)) + (_e584 * _e2050)) - (((_e430 * ((_e507 * _e1830) - (_e518 * _e1817))) + (_e441 * ((_e518 * _e1804) - (_e496 * _e1830)))) + (_e452 * ((_e496 * _e1817) - (_e507 * _e1804)))))) & 2147483647u));
let _e2161 = select(_e2159, _e2136, (_e2136 > _e2159));
let _e2163 = select(1e-12f, _e2161, (_e2161 > 1e-12f));
if (bitcast<f32>((bitcast<u32>(_e2055) & 2147483647u)) > (0.5f * ((_e2084 + _e2113) + _e2163))) {
phi_4417_ = vec3<f32>(0f, 0f, 0f);
} else {
let _e2175 = (((_e2039 * _e430) + (_e2040 * _e441)) + (_e2041 * _e452));
let _e2180 = (((_e2039 * _e1804) + (_e2040 * _e1817)) + (_e2041 * _e1830));
let _e2185 = (((_e430 * _e1804) + (_e441 * _e1817)) + (_e452 * _e1830));
let _e2188 = ((_e441 * _e1830) - (_e452 * _e1817));
let _e2191 = ((_e452 * _e1804) - (_e430 * _e1830));
let _e2194 = ((_e430 * _e1817) - (_e441 * _e1804));
let _e2199 = (((_e2188 * _e2188) + (_e2191 * _e2191)) + (_e2194 * _e2194));
let _e2202 = (1f / select(1e-9f, _e2199, (_e2199 > 1e-9f)));
let _e2205 = ((_e2175 - (_e2185 * _e2180)) * _e2202);
let _e2208 = (((_e2185 * _e2175) - _e2180) * _e2202);
let _e2215 = ((((_e2208 >= 0f) && (_e2208 < _e2038)) && (_e2205 > _e807)) && (_e2205 < _e811));
let _e2217 = (_e2208 + (_e2205 - _e807));
let _e2221 = global_2.member.member_13.member;
let _e2226 = -((_e2221.member * _e2217));
let _e2228 = select(-87f, _e2226, (_e2226 > -87f));
let _e2230 = select(88f, _e2228, (_e2228 < 88f));
let _e2232 = ((_e2230 * 1.442695f) + 0.5f);
let _e2234 = select(-127f, _e2232, (_e2232 > -127f));
let _e2236 = select(128f, _e2234, (_e2234 < 128f));
let _e2243 = select(0i, select(select(i32(_e2236), i32(-2147483648), (_e2236 < -2147483600f)), 2147483647i, (_e2236 > 2147483500f)), (_e2236 == _e2236));
let _e2247 = (_e2243 - select(0i, 1i, (_e2236 < f32(_e2243))));
let _e2248 = f32(_e2247);
let _e2252 = ((_e2230 - (_e2248 * 0.6933594f)) - (_e2248 * -2.1219444e-4f));
let _e2274 = -((_e2221.member_1 * _e2217));
let _e2276 = select(-87f, _e2274, (_e2274 > -87f));
let _e2278 = select(88f, _e2276, (_e2276 < 88f));
let _e2280 = ((_e2278 * 1.442695f) + 0.5f);
let _e2282 = select(-127f, _e2280, (_e2280 > -127f));
let _e2284 = select(128f, _e2282, (_e2282 < 128f));
let _e2291 = select(0i, select(select(i32(_e2284), i32(-2147483648), (_e2284 < -2147483600f)), 2147483647i, (_e2284 > 2147483500f)), (_e2284 == _e2284));
let _e2295 = (_e2291 - select(0i, 1i, (_e2284 < f32(_e2291))));
let _e2296 = f32(_e2295);
let _e2300 = ((_e2278 - (_e2296 * 0.6933594f)) - (_e2296 * -2.1219444e-4f));
let _e2322 = -((_e2221.member_2 * _e2217));
let _e2324 = select(-87f, _e2322, (_e2322 > -87f));
let _e2326 = select(88f, _e2324, (_e2324 < 88f));
let _e2328 = ((_e2326 * 1.442695f) + 0.5f);
let _e2330 = select(-127f, _e2328, (_e2328 > -127f));
let _e2332 = select(128f, _e2330, (_e2330 < 128f));
let _e2339 = select(0i, select(select(i32(_e2332), i32(-2147483648), (_e2332 < -2147483600f)), 2147483647i, (_e2332 > 2147483500f)), (_e2332 == _e2332));
let _e2343 = (_e2339 - select(0i, 1i, (_e2332 < f32(_e2339))));
let _e2344 = f32(_e2343);
let _e2348 = ((_e2326 - (_e2344 * 0.6933594f)) - (_e2344 * -2.1219444e-4f));
let _e2369 = -(_e2185);
let _e2373 = global_2.member.member_13.member_2;
let _e2374 = (_e2373 * _e2373);
let _e2378 = ((1f + _e2374) - ((2f * _e2373) * _e2369));
let _e2380 = select(1e-9f, _e2378, (_e2378 > 1e-9f));
let _e2393 = global_2.member.member_13.member_3;
let _e2398 = (1e-4f * _e2163);
let _e2400 = select(_e2113, _e2084, (_e2084 > _e2113));
let _e2402 = select(_e2398, _e2400, (_e2400 > _e2398));
let _e2404 = select(_e2113, _e2084, (_e2084 < _e2113));
let _e2406 = select(_e2398, _e2404, (_e2404 > _e2398));
let _e2407 = (0.5f * _e2163);
let _e2408 = (_e2055 + _e2407);
let _e2409 = -(_e2408);
let _e2413 = (0.5f * (_e2402 + _e2406));
let _e2414 = (_e2413 - select(_e2409, _e2408, (_e2408 > _e2409)));
let _e2416 = select(0f, _e2414, (_e2414 > 0f));
let _e2418 = select(_e2406, _e2416, (_e2416 < _e2406));
let _e2422 = (_e2414 - _e2406);
let _e2426 = ((((_e2418 * (_e2418 / _e2406)) * 0.5f) + select(0f, _e2422, (_e2422 > 0f))) / _e2402);
let _e2430 = (_e2055 - _e2407);
let _e2431 = -(_e2430);
let _e2434 = (_e2413 - select(_e2431, _e2430, (_e2430 > _e2431)));
let _e2436 = select(0f, _e2434, (_e2434 > 0f));
let _e2438 = select(_e2406, _e2436, (_e2436 < _e2406));
let _e2442 = (_e2434 - _e2406);
let _e2446 = ((((_e2438 * (_e2438 / _e2406)) * 0.5f) + select(0f, _e2442, (_e2442 > 0f))) / _e2402);
let _e2452 = ((select(((1f - _e2374) / (_e2380 * sqrt(select(0f, _e2380, (_e2380 > 0f))))), (0.75f * (1f + (_e2369 * _e2369))), (_e2393 == 1u)) * (0.25f / 3.1415927f)) * ((select(_e2426, (1f - _e2426), (_e2408 >= 0f)) - select(_e2446, (1f - _e2446), (_e2430 >= 0f))) / _e2163));
let _e2459 = global_2.member.member_13.member_1;
phi_4417_ = vec3<f32>(select(0f, (((_e1999 * ((1f + (_e2252 * (1f + (_e2252 * (0.5f + (_e2252 * (0.16666667f + (_e2252 * (0.041666668f + (_e2252 * (0.008333334f + (_e2252 * (0.001388889f + (_e2252 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2247 + 127i)) << bitcast<u32>(23i))))) * _e2459.member) * _e2452), _e2215), select(0f, (((_e2012 * ((1f + (_e2300 * (1f + (_e2300 * (0.5f + (_e2300 * (0.16666667f + (_e2300 * (0.041666668f + (_e2300 * (0.008333334f + (_e2300 * (0.001388889f + (_e2300 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2295 + 127i)) << bitcast<u32>(23i))))) * _e2459.member_1) * _e2452), _e2215), select(0f, (((_e2025 * ((1f + (_e2348 * (1f + (_e2348 * (0.5f + (_e2348 * (0.16666667f + (_e2348 * (0.041666668f + (_e2348 * (0.008333334f + (_e2348 * (0.001388889f + (_e2348 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2343 + 127i)) << bitcast<u32>(23i))))) * _e2459.member_2) * _e2452), _e2215));
}
let _e2474 = phi_4417_;
let _e2475 = select(1f, 0f, _e1017);
let _e2489 = select(0f, 1f, _e1017);
phi_4456_ = vec3<f32>((_e1022.x + (_e2474.x * _e2489)), (_e1022.y + (_e2474.y * _e2489)), (_e1022.z + (_e2474.z * _e2489)));
phi_4457_ = vec3<f32>((_e1024.x + (_e2474.x * _e2475)), (_e1024.y + (_e2474.y * _e2475)), (_e1024.z + (_e2474.z * _e2475)));
} else {
phi_4456_ = _e1022;
phi_4457_ = _e1024;
}
let _e2501 = phi_4456_;
let _e2503 = phi_4457_;
let _e2504 = local_13.member_1;
phi_4465_ = type_17(_e1026.member, (_e1026.member_1 + 1u));
loop {
let _e2508 = phi_4465_;
local_46 = _e2508;
let _e2514 = (((_e2508.member_1 & 3u) == 0u) && (_e2508.member < _e2504));
if _e2514 {
phi_4466_ = type_17((_e2508.member + 1u), (_e2508.member_1 >> bitcast<u32>(2i)));
} else {
phi_4466_ = type_17();
}
let _e2520 = phi_4466_;
continue;
continuing {
phi_4465_ = _e2520;
break if !(_e2514);
}
}
phi_4487_ = _e2501;
phi_4488_ = _e2503;
let _e2703 = local_46;
phi_4489_ = _e2703;
}
let _e2527 = phi_4487_;
let _e2529 = phi_4488_;
let _e2531 = phi_4489_;
phi_2026_ = _e2527;
phi_2029_ = _e2529;
phi_2031_ = _e2531;
} else {
phi_2026_ = vec3<f32>();
phi_2029_ = vec3<f32>();
phi_2031_ = type_17();
}
let _e2533 = phi_2026_;
let _e2535 = phi_2029_;
let _e2537 = phi_2031_;
continue;
continuing {
phi_2025_ = _e2533;
phi_2028_ = _e2535;
phi_2030_ = _e2537;
break if !(_e1034);
}
}
let _e2709 = local_47;
phi_1839_ = _e2709;
let _e2712 = local_48;
phi_1842_ = _e2712;
phi_1844_ = (_e867 + 1u);
} else {
phi_1839_ = vec3<f32>();
phi_1842_ = vec3<f32>();
phi_1844_ = u32();
}
let _e2541 = phi_1839_;
let _e2543 = phi_1842_;
let _e2545 = phi_1844_;
continue;
continuing {
phi_1838_ = _e2541;
phi_1841_ = _e2543;
phi_1843_ = _e2545;
break if !(_e872);
}
}
let _e2548 = local_40;
let _e2552 = local_41;
let _e2556 = local_42;
let _e2563 = local_43;
let _e2567 = local_44;
let _e2571 = local_45;
phi_4539_ = array<f32, 18>(_e148, _e158, _e169, _e180, _e191, _e202, _e213, _e224, (_e235 + (_e2548.x * _e733)), (_e246 + (_e2552.y * _e734)), (_e257 + (_e2556.z * _e735)), (_e268 + (_e2563.x * _e733)), (_e279 + (_e2567.y * _e734)), (_e290 + (_e2571.z * _e735)), _e301, _e312, _e323, _e334);
}
let _e2579 = phi_4539_;
global_1.member[_e137] = _e2579[0];
global_1.member[_e149] = _e2579[1];
global_1.member[_e160] = _e2579[2];
global_1.member[_e171] = _e2579[3];
global_1.member[_e182] = _e2579[4];
global_1.member[_e193] = _e2579[5];
global_1.member[_e204] = _e2579[6];
global_1.member[_e215] = _e2579[7];
global_1.member[_e226] = _e2579[8];
global_1.member[_e237] = _e2579[9];
global_1.member[_e248] = _e2579[10];
global_1.member[_e259] = _e2579[11];
global_1.member[_e270] = _e2579[12];
global_1.member[_e281] = _e2579[13];
global_1.member[_e292] = _e2579[14];
global_1.member[_e303] = _e2579[15];
global_1.member[_e314] = _e2579[16];
global_1.member[_e325] = _e2579[17];
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
