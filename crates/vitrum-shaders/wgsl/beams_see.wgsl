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
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: vec3<f32>,
member_6: f32,
member_7: vec3<f32>,
}
struct type_25 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
struct type_26 {
member: vec3<f32>,
member_1: vec3<f32>,
}
struct type_27 {
member: f32,
member_1: f32,
}
struct type_28 {
member: f32,
member_1: f32,
member_2: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_13;
@group(0) @binding(3)
var<storage> global_4: type_13;
@group(0) @binding(4)
var<storage> global_5: type_13;
@group(0) @binding(7)
var<storage, read_write> global_6: type_13;
@group(0) @binding(5)
var<storage> global_7: type_13;
@group(0) @binding(6)
var<storage> global_8: type_13;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: vec3<f32>;
var local_6: vec3<f32>;
var local_7: f32;
var local_8: type_28;
var local_9: f32;
var local_10: f32;
var local_11: i32;
var local_12: i32;
var phi_2160_: type_27;
var phi_2164_: type_27;
var phi_2281_: vec3<f32>;
var phi_2283_: i32;
var phi_2868_: vec3<f32>;
var phi_2871_: vec3<f32>;
var phi_2884_: type_26;
var phi_3882_: vec3<f32>;
var phi_3885_: vec3<f32>;
var phi_3898_: type_26;
var phi_4913_: vec3<f32>;
var phi_4916_: vec3<f32>;
var phi_4929_: type_26;
var phi_5927_: vec3<f32>;
var phi_5930_: vec3<f32>;
var phi_5943_: type_26;
var phi_2282_: vec3<f32>;
var phi_2284_: i32;
var phi_6393_: vec3<f32>;
var phi_6408_: type_24;
var phi_7143_: type_25;
var phi_7207_: bool;
var phi_7321_: type_24;
var phi_7425_: vec3<f32>;
var phi_8027_: i32;
var phi_8030_: i32;
var phi_8032_: i32;
var phi_8034_: i32;
var phi_8049_: i32;
var phi_8055_: i32;
var phi_8028_: i32;
var phi_8031_: i32;
var phi_8033_: i32;
var phi_8035_: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var phi_8130_: i32;
var local_16: i32;
var local_17: i32;
var phi_8136_: i32;
var local_18: i32;
var phi_8143_: i32;
var local_19: i32;
var local_20: i32;
var phi_8149_: i32;
var local_21: i32;
var local_22: i32;
var phi_8160_: i32;
var local_23: i32;
var local_24: i32;
var phi_8172_: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var phi_8408_: i32;
var phi_8411_: i32;
var phi_8413_: i32;
var phi_8415_: i32;
var phi_8430_: i32;
var phi_8436_: i32;
var phi_8409_: i32;
var phi_8412_: i32;
var phi_8414_: i32;
var phi_8416_: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var phi_8511_: i32;
var local_32: i32;
var local_33: i32;
var phi_8517_: i32;
var local_34: i32;
var phi_8524_: i32;
var local_35: i32;
var local_36: i32;
var phi_8530_: i32;
var local_37: i32;
var local_38: i32;
var phi_8541_: i32;
var local_39: i32;
var local_40: i32;
var phi_8553_: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var phi_8808_: vec3<f32>;
var phi_8809_: vec3<f32>;
var phi_8810_: vec3<f32>;
var phi_9350_: vec3<f32>;
var phi_9353_: vec3<f32>;
var phi_9366_: type_26;
var phi_9917_: type_24;
var phi_9918_: type_24;
var local_45: vec3<f32>;
let _e139 = global;
let _e146 = arrayLength((&global_3.member));
let _e148 = arrayLength((&global_4.member));
let _e159 = global_1.member.member;
if (_e139.x < _e159.member) {
if (_e139.y < _e159.member_1) {
let _e166 = (_e159.member * _e159.member_1);
let _e168 = ((_e139.y * _e159.member) + _e139.x);
let _e169 = bitcast<i32>(_e168);
let _e171 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e173 = select(_e171, _e169, (_e169 < _e171));
let _e179 = global_6.member[bitcast<u32>(select(0i, _e173, (_e173 > 0i)))];
let _e180 = (_e166 + _e168);
let _e181 = bitcast<i32>(_e180);
let _e183 = select(_e171, _e181, (_e181 < _e171));
let _e189 = global_6.member[bitcast<u32>(select(0i, _e183, (_e183 > 0i)))];
let _e191 = ((2u * _e166) + _e168);
let _e192 = bitcast<i32>(_e191);
let _e194 = select(_e171, _e192, (_e192 < _e171));
let _e200 = global_6.member[bitcast<u32>(select(0i, _e194, (_e194 > 0i)))];
let _e202 = ((3u * _e166) + _e168);
let _e203 = bitcast<i32>(_e202);
let _e205 = select(_e171, _e203, (_e203 < _e171));
let _e211 = global_6.member[bitcast<u32>(select(0i, _e205, (_e205 > 0i)))];
let _e213 = ((4u * _e166) + _e168);
let _e214 = bitcast<i32>(_e213);
let _e216 = select(_e171, _e214, (_e214 < _e171));
let _e222 = global_6.member[bitcast<u32>(select(0i, _e216, (_e216 > 0i)))];
let _e224 = ((5u * _e166) + _e168);
let _e225 = bitcast<i32>(_e224);
let _e227 = select(_e171, _e225, (_e225 < _e171));
let _e233 = global_6.member[bitcast<u32>(select(0i, _e227, (_e227 > 0i)))];
let _e235 = ((6u * _e166) + _e168);
let _e236 = bitcast<i32>(_e235);
let _e238 = select(_e171, _e236, (_e236 < _e171));
let _e244 = global_6.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e246 = ((7u * _e166) + _e168);
let _e247 = bitcast<i32>(_e246);
let _e249 = select(_e171, _e247, (_e247 < _e171));
let _e255 = global_6.member[bitcast<u32>(select(0i, _e249, (_e249 > 0i)))];
let _e257 = ((8u * _e166) + _e168);
let _e258 = bitcast<i32>(_e257);
let _e260 = select(_e171, _e258, (_e258 < _e171));
let _e266 = global_6.member[bitcast<u32>(select(0i, _e260, (_e260 > 0i)))];
let _e268 = ((9u * _e166) + _e168);
let _e269 = bitcast<i32>(_e268);
let _e271 = select(_e171, _e269, (_e269 < _e171));
let _e277 = global_6.member[bitcast<u32>(select(0i, _e271, (_e271 > 0i)))];
let _e279 = ((10u * _e166) + _e168);
let _e280 = bitcast<i32>(_e279);
let _e282 = select(_e171, _e280, (_e280 < _e171));
let _e288 = global_6.member[bitcast<u32>(select(0i, _e282, (_e282 > 0i)))];
let _e290 = ((11u * _e166) + _e168);
let _e291 = bitcast<i32>(_e290);
let _e293 = select(_e171, _e291, (_e291 < _e171));
let _e299 = global_6.member[bitcast<u32>(select(0i, _e293, (_e293 > 0i)))];
let _e301 = ((12u * _e166) + _e168);
let _e302 = bitcast<i32>(_e301);
let _e304 = select(_e171, _e302, (_e302 < _e171));
let _e310 = global_6.member[bitcast<u32>(select(0i, _e304, (_e304 > 0i)))];
let _e312 = ((13u * _e166) + _e168);
let _e313 = bitcast<i32>(_e312);
let _e315 = select(_e171, _e313, (_e313 < _e171));
let _e321 = global_6.member[bitcast<u32>(select(0i, _e315, (_e315 > 0i)))];
let _e323 = ((14u * _e166) + _e168);
let _e324 = bitcast<i32>(_e323);
let _e326 = select(_e171, _e324, (_e324 < _e171));
let _e332 = global_6.member[bitcast<u32>(select(0i, _e326, (_e326 > 0i)))];
let _e334 = ((15u * _e166) + _e168);
let _e335 = bitcast<i32>(_e334);
let _e337 = select(_e171, _e335, (_e335 < _e171));
let _e343 = global_6.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e345 = ((16u * _e166) + _e168);
let _e346 = bitcast<i32>(_e345);
let _e348 = select(_e171, _e346, (_e346 < _e171));
let _e354 = global_6.member[bitcast<u32>(select(0i, _e348, (_e348 > 0i)))];
let _e356 = ((17u * _e166) + _e168);
let _e357 = bitcast<i32>(_e356);
let _e359 = select(_e171, _e357, (_e357 < _e171));
let _e365 = global_6.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e369 = global_1.member.member.member;
let _e373 = global_1.member.member.member_1;
let _e374 = (_e369 * _e373);
local_11 = bitcast<i32>(_e374);
let _e377 = ((_e139.y * _e369) + _e139.x);
let _e378 = bitcast<i32>(_e377);
local_12 = _e378;
let _e379 = local_11;
let _e381 = local_12;
let _e382 = ((29i * _e379) + _e381);
let _e384 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e386 = select(_e384, _e382, (_e382 < _e384));
let _e391 = global_2.member[bitcast<u32>(select(0i, _e386, (_e386 > 0i)))];
let _e393 = local_11;
let _e395 = local_12;
let _e396 = ((36i * _e393) + _e395);
let _e398 = select(_e384, _e396, (_e396 < _e384));
let _e403 = global_2.member[bitcast<u32>(select(0i, _e398, (_e398 > 0i)))];
let _e414 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e391 == 2f) && (select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < -2147483600f)), 2147483647i, (_e403 > 2147483500f)), (_e403 == _e403)) == (bitcast<i32>(_e414) + 1i)))) > 1u) {
let _e426 = type_24(_e179, _e189, vec3<f32>(_e200, _e211, _e222), vec3<f32>(_e233, _e244, _e255), vec3<f32>(_e266, _e277, _e288), vec3<f32>(_e299, _e310, _e321), _e332, vec3<f32>(_e343, _e354, _e365));
let _e428 = select(_e384, _e378, (_e378 < _e384));
let _e434 = global_2.member[bitcast<u32>(select(0i, _e428, (_e428 > 0i)))];
let _e436 = bitcast<i32>((_e374 + _e377));
let _e438 = select(_e384, _e436, (_e436 < _e384));
let _e444 = global_2.member[bitcast<u32>(select(0i, _e438, (_e438 > 0i)))];
let _e447 = bitcast<i32>(((2u * _e374) + _e377));
let _e449 = select(_e384, _e447, (_e447 < _e384));
let _e455 = global_2.member[bitcast<u32>(select(0i, _e449, (_e449 > 0i)))];
let _e458 = bitcast<i32>(((3u * _e374) + _e377));
let _e460 = select(_e384, _e458, (_e458 < _e384));
let _e466 = global_2.member[bitcast<u32>(select(0i, _e460, (_e460 > 0i)))];
let _e469 = bitcast<i32>(((4u * _e374) + _e377));
let _e471 = select(_e384, _e469, (_e469 < _e384));
let _e477 = global_2.member[bitcast<u32>(select(0i, _e471, (_e471 > 0i)))];
let _e480 = bitcast<i32>(((5u * _e374) + _e377));
let _e482 = select(_e384, _e480, (_e480 < _e384));
let _e488 = global_2.member[bitcast<u32>(select(0i, _e482, (_e482 > 0i)))];
let _e491 = bitcast<i32>(((12u * _e374) + _e377));
let _e493 = select(_e384, _e491, (_e491 < _e384));
let _e499 = global_2.member[bitcast<u32>(select(0i, _e493, (_e493 > 0i)))];
let _e502 = bitcast<i32>(((13u * _e374) + _e377));
let _e504 = select(_e384, _e502, (_e502 < _e384));
let _e510 = global_2.member[bitcast<u32>(select(0i, _e504, (_e504 > 0i)))];
let _e513 = bitcast<i32>(((14u * _e374) + _e377));
let _e515 = select(_e384, _e513, (_e513 < _e384));
let _e521 = global_2.member[bitcast<u32>(select(0i, _e515, (_e515 > 0i)))];
let _e524 = bitcast<i32>(((15u * _e374) + _e377));
let _e526 = select(_e384, _e524, (_e524 < _e384));
let _e532 = global_2.member[bitcast<u32>(select(0i, _e526, (_e526 > 0i)))];
let _e535 = bitcast<i32>(((16u * _e374) + _e377));
let _e537 = select(_e384, _e535, (_e535 < _e384));
let _e543 = global_2.member[bitcast<u32>(select(0i, _e537, (_e537 > 0i)))];
let _e546 = bitcast<i32>(((17u * _e374) + _e377));
let _e548 = select(_e384, _e546, (_e546 < _e384));
let _e554 = global_2.member[bitcast<u32>(select(0i, _e548, (_e548 > 0i)))];
let _e557 = bitcast<i32>(((18u * _e374) + _e377));
let _e559 = select(_e384, _e557, (_e557 < _e384));
let _e565 = global_2.member[bitcast<u32>(select(0i, _e559, (_e559 > 0i)))];
let _e568 = bitcast<i32>(((19u * _e374) + _e377));
let _e570 = select(_e384, _e568, (_e568 < _e384));
let _e576 = global_2.member[bitcast<u32>(select(0i, _e570, (_e570 > 0i)))];
let _e579 = bitcast<i32>(((20u * _e374) + _e377));
let _e581 = select(_e384, _e579, (_e579 < _e384));
let _e587 = global_2.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e590 = bitcast<i32>(((23u * _e374) + _e377));
let _e592 = select(_e384, _e590, (_e590 < _e384));
let _e598 = global_2.member[bitcast<u32>(select(0i, _e592, (_e592 > 0i)))];
let _e601 = bitcast<i32>(((24u * _e374) + _e377));
let _e603 = select(_e384, _e601, (_e601 < _e384));
let _e609 = global_2.member[bitcast<u32>(select(0i, _e603, (_e603 > 0i)))];
let _e612 = bitcast<i32>(((30u * _e374) + _e377));
let _e614 = select(_e384, _e612, (_e612 < _e384));
let _e620 = global_2.member[bitcast<u32>(select(0i, _e614, (_e614 > 0i)))];
let _e628 = select(0i, select(select(i32(_e598), i32(-2147483648), (_e598 < -2147483600f)), 2147483647i, (_e598 > 2147483500f)), (_e598 == _e598));
let _e636 = (select(0i, select(select(i32(_e620), i32(-2147483648), (_e620 < -2147483600f)), 2147483647i, (_e620 > 2147483500f)), (_e620 == _e620)) == 0i);
let _e644 = global_1.member.member_1.member;
let _e650 = global_1.member.member_1.member_1;
let _e660 = global_1.member.member_2.member;
let _e661 = (((((f32(bitcast<i32>(_e139.x)) + 0.5f) / f32(bitcast<i32>(_e644))) * 2f) - 1f) * _e660);
let _e669 = global_1.member.member_2.member_1;
let _e670 = ((1f - (((f32(bitcast<i32>(_e139.y)) + 0.5f) / f32(bitcast<i32>(_e650))) * 2f)) * _e669);
let _e673 = global_1.member.member_3;
let _e682 = global_1.member.member_4;
let _e695 = global_1.member.member_2.member_3;
let _e696 = (_e695 != 0u);
let _e699 = global_1.member.member_6;
let _e706 = select(_e699.member, (_e699.member + ((_e673.member * _e661) + (_e682.member * _e670))), _e696);
let _e707 = select(_e699.member_1, (_e699.member_1 + ((_e673.member_1 * _e661) + (_e682.member_1 * _e670))), _e696);
let _e708 = select(_e699.member_2, (_e699.member_2 + ((_e673.member_2 * _e661) + (_e682.member_2 * _e670))), _e696);
let _e718 = select(_e434, _e706, _e636);
let _e719 = select(_e444, _e707, _e636);
let _e720 = select(_e455, _e708, _e636);
let _e722 = (select(0f, ((((_e434 - _e706) * _e466) + ((_e444 - _e707) * _e477)) + ((_e455 - _e708) * _e488)), _e636) + _e609);
let _e723 = select(_e565, 1f, _e636);
let _e724 = select(_e576, 1f, _e636);
let _e725 = select(_e587, 1f, _e636);
let _e733 = (1f / select(_e466, select(1e-12f, -1e-12f, (_e466 < 0f)), (bitcast<f32>((bitcast<u32>(_e466) & 2147483647u)) < 1e-12f)));
let _e741 = (1f / select(_e477, select(1e-12f, -1e-12f, (_e477 < 0f)), (bitcast<f32>((bitcast<u32>(_e477) & 2147483647u)) < 1e-12f)));
let _e749 = (1f / select(_e488, select(1e-12f, -1e-12f, (_e488 < 0f)), (bitcast<f32>((bitcast<u32>(_e488) & 2147483647u)) < 1e-12f)));
let _e753 = global_1.member.member_13.member_4;
let _e760 = global_1.member.member_13.member_5;
let _e765 = ((_e753.member - _e718) * _e733);
let _e767 = ((_e760.member - _e718) * _e733);
let _e769 = ((_e753.member_1 - _e719) * _e741);
let _e771 = ((_e760.member_1 - _e719) * _e741);
let _e773 = ((_e753.member_2 - _e720) * _e749);
let _e775 = ((_e760.member_2 - _e720) * _e749);
let _e777 = select(_e767, _e765, (_e765 < _e767));
let _e779 = select(_e771, _e769, (_e769 < _e771));
let _e781 = select(_e779, _e777, (_e777 > _e779));
let _e783 = select(_e775, _e773, (_e773 < _e775));
let _e785 = select(_e783, _e781, (_e781 > _e783));
let _e787 = select(_e767, _e765, (_e765 > _e767));
let _e789 = select(_e771, _e769, (_e769 > _e771));
let _e791 = select(_e789, _e787, (_e787 < _e789));
let _e793 = select(_e775, _e773, (_e773 > _e775));
let _e795 = select(_e793, _e791, (_e791 < _e793));
let _e797 = select(0f, _e785, (_e785 > 0f));
let _e799 = select(_e722, _e795, (_e795 < _e722));
let _e800 = (_e799 > _e797);
let _e801 = select(0f, _e797, _e800);
let _e802 = select(0f, _e799, _e800);
let _e803 = (_e802 - _e801);
let _e807 = global_1.member.member_13.member;
let _e812 = -((_e807.member * _e803));
let _e814 = select(-87f, _e812, (_e812 > -87f));
let _e816 = select(88f, _e814, (_e814 < 88f));
let _e818 = ((_e816 * 1.442695f) + 0.5f);
let _e820 = select(-127f, _e818, (_e818 > -127f));
let _e822 = select(128f, _e820, (_e820 < 128f));
let _e829 = select(0i, select(select(i32(_e822), i32(-2147483648), (_e822 < -2147483600f)), 2147483647i, (_e822 > 2147483500f)), (_e822 == _e822));
let _e833 = (_e829 - select(0i, 1i, (_e822 < f32(_e829))));
let _e834 = f32(_e833);
let _e838 = ((_e816 - (_e834 * 0.6933594f)) - (_e834 * -2.1219444e-4f));
let _e858 = ((1f + (_e838 * (1f + (_e838 * (0.5f + (_e838 * (0.16666667f + (_e838 * (0.041666668f + (_e838 * (0.008333334f + (_e838 * (0.001388889f + (_e838 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e833 + 127i)) << bitcast<u32>(23i))));
let _e860 = -((_e807.member_1 * _e803));
let _e862 = select(-87f, _e860, (_e860 > -87f));
let _e864 = select(88f, _e862, (_e862 < 88f));
let _e866 = ((_e864 * 1.442695f) + 0.5f);
let _e868 = select(-127f, _e866, (_e866 > -127f));
let _e870 = select(128f, _e868, (_e868 < 128f));
let _e877 = select(0i, select(select(i32(_e870), i32(-2147483648), (_e870 < -2147483600f)), 2147483647i, (_e870 > 2147483500f)), (_e870 == _e870));
let _e881 = (_e877 - select(0i, 1i, (_e870 < f32(_e877))));
let _e882 = f32(_e881);
let _e886 = ((_e864 - (_e882 * 0.6933594f)) - (_e882 * -2.1219444e-4f));
let _e906 = ((1f + (_e886 * (1f + (_e886 * (0.5f + (_e886 * (0.16666667f + (_e886 * (0.041666668f + (_e886 * (0.008333334f + (_e886 * (0.001388889f + (_e886 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e881 + 127i)) << bitcast<u32>(23i))));
let _e908 = -((_e807.member_2 * _e803));
let _e910 = select(-87f, _e908, (_e908 > -87f));
let _e912 = select(88f, _e910, (_e910 < 88f));
let _e914 = ((_e912 * 1.442695f) + 0.5f);
let _e916 = select(-127f, _e914, (_e914 > -127f));
let _e918 = select(128f, _e916, (_e916 < 128f));
let _e925 = select(0i, select(select(i32(_e918), i32(-2147483648), (_e918 < -2147483600f)), 2147483647i, (_e918 > 2147483500f)), (_e918 == _e918));
let _e929 = (_e925 - select(0i, 1i, (_e918 < f32(_e925))));
let _e930 = f32(_e929);
let _e934 = ((_e912 - (_e930 * 0.6933594f)) - (_e930 * -2.1219444e-4f));
let _e954 = ((1f + (_e934 * (1f + (_e934 * (0.5f + (_e934 * (0.16666667f + (_e934 * (0.041666668f + (_e934 * (0.008333334f + (_e934 * (0.001388889f + (_e934 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e929 + 127i)) << bitcast<u32>(23i))));
let _e957 = global_1.member.member_17;
let _e962 = (1f / 3f);
if (((_e957 & 2u) != 0u) && ((((_e723 + _e724) + _e725) * _e962) >= 0.01f)) {
local_5 = vec3<f32>(_e718, _e719, _e720);
local_6 = vec3<f32>(_e466, _e477, _e488);
local_7 = _e801;
let _e966 = local_7;
let _e971 = global_1.member.member_10.member;
if (_e971 == 2u) {
let _e973 = local_5;
let _e974 = local_6;
let _e978 = global_1.member.member_10.member_1;
let _e985 = global_1.member.member_10.member_3;
let _e990 = (_e973.x - _e985.member);
let _e992 = (_e973.y - _e985.member_1);
let _e994 = (_e973.z - _e985.member_2);
let _e999 = global_1.member.member_10.member_4.member_2;
let _e1001 = (1f + (_e999 * _e999));
let _e1006 = (((_e978.member * _e990) + (_e978.member_1 * _e992)) + (_e978.member_2 * _e994));
let _e1014 = (((_e978.member * _e974.x) + (_e978.member_1 * _e974.y)) + (_e978.member_2 * _e974.z));
let _e1015 = (_e1001 * _e1014);
let _e1017 = ((_e1015 * _e1014) - 1f);
let _e1024 = ((_e1015 * _e1006) - (((_e990 * _e974.x) + (_e992 * _e974.y)) + (_e994 * _e974.z)));
let _e1035 = ((_e1024 * _e1024) - (_e1017 * (((_e1001 * _e1006) * _e1006) - (((_e990 * _e990) + (_e992 * _e992)) + (_e994 * _e994)))));
let _e1036 = (_e1035 > 0f);
let _e1038 = sqrt(select(0f, _e1035, _e1036));
let _e1041 = (1f / select(_e1017, 1e-20f, (_e1017 == 0f)));
let _e1042 = -(_e1024);
let _e1044 = ((_e1042 - _e1038) * _e1041);
let _e1046 = ((_e1042 + _e1038) * _e1041);
let _e1048 = select(_e1046, _e1044, (_e1044 < _e1046));
let _e1050 = select(_e1046, _e1044, (_e1044 > _e1046));
if (_e1017 < 0f) {
let _e1057 = (_e1036 && ((_e1006 + (_e1014 * (0.5f * (_e1048 + _e1050)))) > 0f));
let _e1058 = select(_e802, _e1048, _e1057);
let _e1061 = select(_e966, _e1050, _e1057);
phi_2160_ = type_27(select(_e1058, _e966, (_e966 > _e1058)), select(_e1061, _e802, (_e802 < _e1061)));
} else {
let _e1068 = (-(_e1006) / select(_e1014, 1e-20f, (_e1014 == 0f)));
let _e1071 = (_e1014 > 0f);
let _e1072 = select(_e966, select(_e1068, _e1050, _e1036), _e1071);
let _e1075 = select(select(_e1068, _e1048, _e1036), _e802, _e1071);
phi_2160_ = type_27(select(_e1072, _e966, (_e966 > _e1072)), select(_e1075, _e802, (_e802 < _e1075)));
}
let _e1080 = phi_2160_;
phi_2164_ = _e1080;
} else {
phi_2164_ = type_27(_e966, _e802);
}
let _e1082 = phi_2164_;
if (_e1082.member_1 > _e1082.member) {
let _e1089 = global_1.member.member_10.member_3;
let _e1093 = local_5;
let _e1095 = (_e1089.member - _e1093.x);
let _e1097 = (_e1089.member_1 - _e1093.y);
let _e1099 = (_e1089.member_2 - _e1093.z);
let _e1100 = local_6;
let _e1108 = (((_e1095 * _e1100.x) + (_e1097 * _e1100.y)) + (_e1099 * _e1100.z));
let _e1109 = local_6;
let _e1116 = (_e1095 - (_e1109.x * _e1108));
let _e1117 = (_e1097 - (_e1109.y * _e1108));
let _e1118 = (_e1099 - (_e1109.z * _e1108));
let _e1123 = (((_e1116 * _e1116) + (_e1117 * _e1117)) + (_e1118 * _e1118));
let _e1126 = sqrt(select(0f, _e1123, (_e1123 > 0f)));
local_8.member_2 = (_e971 == 0u);
local_8.member = _e1108;
local_8.member_1 = select(1e-6f, _e1126, (_e1126 > 1e-6f));
let _e1133 = local_8.member;
let _e1135 = local_8.member_1;
let _e1136 = ((_e1082.member - _e1133) / _e1135);
let _e1137 = local_8.member_2;
let _e1139 = (1f + (_e1136 * _e1136));
let _e1145 = select((_e1136 / (1f + sqrt(select(0f, _e1139, (_e1139 > 0f))))), _e1082.member, _e1137);
let _e1146 = local_8.member;
let _e1148 = local_8.member_1;
let _e1149 = ((_e1082.member_1 - _e1146) / _e1148);
let _e1150 = local_8.member_2;
let _e1152 = (1f + (_e1149 * _e1149));
local_9 = ((select((_e1149 / (1f + sqrt(select(0f, _e1152, (_e1152 > 0f))))), _e1082.member_1, _e1150) - _e1145) * (0.5f / 6f));
phi_2281_ = vec3<f32>(0f, 0f, 0f);
phi_2283_ = 0i;
loop {
let _e1163 = phi_2281_;
let _e1165 = phi_2283_;
local_45 = _e1163;
let _e1166 = (_e1165 < 6i);
if _e1166 {
let _e1170 = local_9;
local_10 = (_e1145 + (_e1170 * ((2f * f32(_e1165)) + 1f)));
let _e1174 = local_5;
let _e1175 = local_6;
let _e1176 = local_7;
let _e1177 = local_10;
let _e1178 = local_9;
let _e1180 = (_e1177 + (_e1178 * -(0.8611363f)));
let _e1181 = (_e1180 * _e1180);
let _e1182 = (1f - _e1181);
let _e1184 = select(1e-9f, _e1182, (_e1182 > 1e-9f));
let _e1185 = local_8.member;
let _e1186 = local_8.member_1;
let _e1191 = local_8.member_1;
let _e1197 = local_8.member_2;
let _e1198 = select((_e1185 + (_e1186 * ((2f * _e1180) / _e1184))), _e1180, _e1197);
let _e1199 = local_8.member_2;
let _e1208 = (_e1174.x + (_e1175.x * _e1198));
let _e1210 = (_e1174.y + (_e1175.y * _e1198));
let _e1212 = (_e1174.z + (_e1175.z * _e1198));
let _e1215 = global_1.member.member_10.member_2;
let _e1219 = vec3<f32>(_e1215.member, _e1215.member_1, _e1215.member_2);
let _e1222 = global_1.member.member_10.member;
let _e1223 = (_e1222 == 0u);
if _e1223 {
let _e1226 = global_1.member.member_10.member_1;
phi_2884_ = type_26(vec3<f32>(_e1226.member, _e1226.member_1, _e1226.member_2), _e1219);
} else {
let _e1234 = global_1.member.member_10.member_3;
let _e1238 = (_e1208 - _e1234.member);
let _e1239 = (_e1210 - _e1234.member_1);
let _e1240 = (_e1212 - _e1234.member_2);
let _e1245 = (((_e1238 * _e1238) + (_e1239 * _e1239)) + (_e1240 * _e1240));
let _e1247 = select(1e-12f, _e1245, (_e1245 > 1e-12f));
let _e1248 = (1f / _e1247);
let _e1252 = vec3<f32>((_e1215.member * _e1248), (_e1215.member_1 * _e1248), (_e1215.member_2 * _e1248));
if (_e1222 == 2u) {
let _e1256 = global_1.member.member_10.member_1;
let _e1264 = (((_e1256.member * _e1238) + (_e1256.member_1 * _e1239)) + (_e1256.member_2 * _e1240));
let _e1267 = (1f / select(1e-20f, _e1264, (_e1264 > 1e-20f)));
let _e1271 = global_1.member.member_10.member_4.member;
let _e1280 = ((((_e1271.member * _e1238) + (_e1271.member_1 * _e1239)) + (_e1271.member_2 * _e1240)) * _e1267);
let _e1284 = global_1.member.member_10.member_4.member_1;
let _e1293 = ((((_e1284.member * _e1238) + (_e1284.member_1 * _e1239)) + (_e1284.member_2 * _e1240)) * _e1267);
let _e1297 = global_1.member.member_10.member_4.member_2;
let _e1300 = ((_e1280 * _e1280) + (_e1293 * _e1293));
let _e1308 = global_1.member.member_10.member_4.member_3;
let _e1309 = ((_e1297 - sqrt(select(0f, _e1300, (_e1300 > 0f)))) * _e1308);
let _e1311 = select(0f, _e1309, (_e1309 > 0f));
let _e1313 = select(1f, _e1311, (_e1311 < 1f));
let _e1319 = select(0f, ((_e1313 * _e1313) * (3f - (2f * _e1313))), (_e1264 > 0f));
let _e1323 = global_1.member.member_10.member_4.member_5;
if ((_e1323 > 0u) && (_e1319 > 0f)) {
let _e1327 = (0.5f / _e1297);
let _e1336 = global_1.member.member_10.member_4.member_6;
let _e1337 = bitcast<i32>(_e1336);
local_4 = bitcast<i32>(_e1323);
let _e1338 = local_4;
let _e1340 = f32((_e1338 - 1i));
let _e1342 = f32((_e1337 - 1i));
let _e1343 = local_4;
let _e1346 = (((0.5f + (_e1280 * _e1327)) * f32(_e1343)) - 0.5f);
let _e1348 = select(0f, _e1346, (_e1346 > 0f));
let _e1350 = select(_e1340, _e1348, (_e1348 < _e1340));
let _e1353 = (((0.5f - (_e1293 * _e1327)) * f32(_e1337)) - 0.5f);
let _e1355 = select(0f, _e1353, (_e1353 > 0f));
let _e1357 = select(_e1342, _e1355, (_e1355 < _e1342));
let _e1359 = select(0f, _e1350, (_e1350 > 0f));
let _e1361 = select(_e1340, _e1359, (_e1359 < _e1340));
let _e1368 = select(0i, select(select(i32(_e1361), i32(-2147483648), (_e1361 < -2147483600f)), 2147483647i, (_e1361 > 2147483500f)), (_e1361 == _e1361));
let _e1372 = (_e1368 - select(0i, 1i, (_e1361 < f32(_e1368))));
let _e1374 = select(0f, _e1357, (_e1357 > 0f));
let _e1376 = select(_e1342, _e1374, (_e1374 < _e1342));
let _e1383 = select(0i, select(select(i32(_e1376), i32(-2147483648), (_e1376 < -2147483600f)), 2147483647i, (_e1376 > 2147483500f)), (_e1376 == _e1376));
let _e1387 = (_e1383 - select(0i, 1i, (_e1376 < f32(_e1383))));
let _e1389 = (_e1350 - f32(_e1372));
let _e1391 = (_e1357 - f32(_e1387));
let _e1392 = (_e1372 + 1i);
let _e1393 = local_4;
let _e1395 = select(_e1372, _e1392, (_e1392 < _e1393));
let _e1396 = (_e1387 + 1i);
let _e1398 = select(_e1387, _e1396, (_e1396 < _e1337));
let _e1402 = global_1.member.member_10.member_4.member_4;
let _e1403 = bitcast<i32>(_e1402);
let _e1404 = local_4;
let _e1408 = (_e1403 + (3i * ((_e1387 * _e1404) + _e1372)));
let _e1410 = (bitcast<i32>(_e146) - 1i);
let _e1412 = select(_e1410, _e1408, (_e1408 < _e1410));
let _e1417 = global_3.member[bitcast<u32>(select(0i, _e1412, (_e1412 > 0i)))];
let _e1418 = (_e1408 + 1i);
let _e1420 = select(_e1410, _e1418, (_e1418 < _e1410));
let _e1425 = global_3.member[bitcast<u32>(select(0i, _e1420, (_e1420 > 0i)))];
let _e1426 = (_e1408 + 2i);
let _e1428 = select(_e1410, _e1426, (_e1426 < _e1410));
let _e1433 = global_3.member[bitcast<u32>(select(0i, _e1428, (_e1428 > 0i)))];
let _e1434 = local_4;
let _e1438 = (_e1403 + (3i * ((_e1387 * _e1434) + _e1395)));
let _e1440 = select(_e1410, _e1438, (_e1438 < _e1410));
let _e1445 = global_3.member[bitcast<u32>(select(0i, _e1440, (_e1440 > 0i)))];
let _e1446 = (_e1438 + 1i);
let _e1448 = select(_e1410, _e1446, (_e1446 < _e1410));
let _e1453 = global_3.member[bitcast<u32>(select(0i, _e1448, (_e1448 > 0i)))];
let _e1454 = (_e1438 + 2i);
let _e1456 = select(_e1410, _e1454, (_e1454 < _e1410));
let _e1461 = global_3.member[bitcast<u32>(select(0i, _e1456, (_e1456 > 0i)))];
let _e1462 = local_4;
let _e1466 = (_e1403 + (3i * ((_e1398 * _e1462) + _e1372)));
let _e1468 = select(_e1410, _e1466, (_e1466 < _e1410));
let _e1473 = global_3.member[bitcast<u32>(select(0i, _e1468, (_e1468 > 0i)))];
let _e1474 = (_e1466 + 1i);
let _e1476 = select(_e1410, _e1474, (_e1474 < _e1410));
let _e1481 = global_3.member[bitcast<u32>(select(0i, _e1476, (_e1476 > 0i)))];
let _e1482 = (_e1466 + 2i);
let _e1484 = select(_e1410, _e1482, (_e1482 < _e1410));
let _e1489 = global_3.member[bitcast<u32>(select(0i, _e1484, (_e1484 > 0i)))];
let _e1490 = local_4;
let _e1494 = (_e1403 + (3i * ((_e1398 * _e1490) + _e1395)));
let _e1496 = select(_e1410, _e1494, (_e1494 < _e1410));
let _e1501 = global_3.member[bitcast<u32>(select(0i, _e1496, (_e1496 > 0i)))];
let _e1502 = (_e1494 + 1i);
let _e1504 = select(_e1410, _e1502, (_e1502 < _e1410));
let _e1509 = global_3.member[bitcast<u32>(select(0i, _e1504, (_e1504 > 0i)))];
let _e1510 = (_e1494 + 2i);
let _e1512 = select(_e1410, _e1510, (_e1510 < _e1410));
let _e1517 = global_3.member[bitcast<u32>(select(0i, _e1512, (_e1512 > 0i)))];
let _e1524 = (_e1417 + ((_e1445 - _e1417) * _e1389));
let _e1525 = (_e1425 + ((_e1453 - _e1425) * _e1389));
let _e1526 = (_e1433 + ((_e1461 - _e1433) * _e1389));
phi_2868_ = vec3<f32>(((_e1524 + (((_e1473 + ((_e1501 - _e1473) * _e1389)) - _e1524) * _e1391)) * _e1319), ((_e1525 + (((_e1481 + ((_e1509 - _e1481) * _e1389)) - _e1525) * _e1391)) * _e1319), ((_e1526 + (((_e1489 + ((_e1517 - _e1489) * _e1389)) - _e1526) * _e1391)) * _e1319));
} else {
phi_2868_ = vec3(_e1319);
}
let _e1551 = phi_2868_;
phi_2871_ = (_e1252 * _e1551);
} else {
phi_2871_ = _e1252;
}
let _e1554 = phi_2871_;
let _e1558 = (1f / sqrt(select(0f, _e1247, (_e1247 > 0f))));
phi_2884_ = type_26(vec3<f32>((_e1238 * _e1558), (_e1239 * _e1558), (_e1240 * _e1558)), _e1554);
}
let _e1565 = phi_2884_;
let _e1568 = global_1.member.member_10.member_3;
let _e1572 = (_e1568.member - _e1208);
let _e1573 = (_e1568.member_1 - _e1210);
let _e1574 = (_e1568.member_2 - _e1212);
let _e1575 = local_8.member_2;
let _e1580 = (((_e1572 * _e1572) + (_e1573 * _e1573)) + (_e1574 * _e1574));
let _e1584 = select(sqrt(select(0f, _e1580, (_e1580 > 0f))), 1e30f, _e1575);
let _e1587 = -(_e1565.member.x);
let _e1589 = -(_e1565.member.y);
let _e1591 = -(_e1565.member.z);
let _e1599 = (1f / select(_e1587, select(1e-12f, -1e-12f, (_e1587 < 0f)), (bitcast<f32>((bitcast<u32>(_e1587) & 2147483647u)) < 1e-12f)));
let _e1607 = (1f / select(_e1589, select(1e-12f, -1e-12f, (_e1589 < 0f)), (bitcast<f32>((bitcast<u32>(_e1589) & 2147483647u)) < 1e-12f)));
let _e1615 = (1f / select(_e1591, select(1e-12f, -1e-12f, (_e1591 < 0f)), (bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u)) < 1e-12f)));
let _e1618 = global_1.member.member_13.member_4;
let _e1624 = global_1.member.member_13.member_5;
let _e1629 = ((_e1618.member - _e1208) * _e1599);
let _e1631 = ((_e1624.member - _e1208) * _e1599);
let _e1633 = ((_e1618.member_1 - _e1210) * _e1607);
let _e1635 = ((_e1624.member_1 - _e1210) * _e1607);
let _e1637 = ((_e1618.member_2 - _e1212) * _e1615);
let _e1639 = ((_e1624.member_2 - _e1212) * _e1615);
let _e1641 = select(_e1631, _e1629, (_e1629 < _e1631));
let _e1643 = select(_e1635, _e1633, (_e1633 < _e1635));
let _e1645 = select(_e1643, _e1641, (_e1641 > _e1643));
let _e1647 = select(_e1639, _e1637, (_e1637 < _e1639));
let _e1649 = select(_e1647, _e1645, (_e1645 > _e1647));
let _e1651 = select(_e1631, _e1629, (_e1629 > _e1631));
let _e1653 = select(_e1635, _e1633, (_e1633 > _e1635));
let _e1655 = select(_e1653, _e1651, (_e1651 < _e1653));
let _e1657 = select(_e1639, _e1637, (_e1637 > _e1639));
let _e1659 = select(_e1657, _e1655, (_e1655 < _e1657));
let _e1661 = select(0f, _e1649, (_e1649 > 0f));
let _e1663 = select(_e1584, _e1659, (_e1659 < _e1584));
let _e1664 = (_e1663 > _e1661);
let _e1668 = (_e1198 - _e1176);
let _e1671 = ((select(0f, _e1663, _e1664) - select(0f, _e1661, _e1664)) + select(0f, _e1668, (_e1668 > 0f)));
let _e1674 = global_1.member.member_13.member;
let _e1679 = -((_e1674.member * _e1671));
let _e1681 = select(-87f, _e1679, (_e1679 > -87f));
let _e1683 = select(88f, _e1681, (_e1681 < 88f));
let _e1685 = ((_e1683 * 1.442695f) + 0.5f);
let _e1687 = select(-127f, _e1685, (_e1685 > -127f));
let _e1689 = select(128f, _e1687, (_e1687 < 128f));
let _e1696 = select(0i, select(select(i32(_e1689), i32(-2147483648), (_e1689 < -2147483600f)), 2147483647i, (_e1689 > 2147483500f)), (_e1689 == _e1689));
let _e1700 = (_e1696 - select(0i, 1i, (_e1689 < f32(_e1696))));
let _e1701 = f32(_e1700);
let _e1705 = ((_e1683 - (_e1701 * 0.6933594f)) - (_e1701 * -2.1219444e-4f));
let _e1727 = -((_e1674.member_1 * _e1671));
let _e1729 = select(-87f, _e1727, (_e1727 > -87f));
let _e1731 = select(88f, _e1729, (_e1729 < 88f));
let _e1733 = ((_e1731 * 1.442695f) + 0.5f);
let _e1735 = select(-127f, _e1733, (_e1733 > -127f));
let _e1737 = select(128f, _e1735, (_e1735 < 128f));
let _e1744 = select(0i, select(select(i32(_e1737), i32(-2147483648), (_e1737 < -2147483600f)), 2147483647i, (_e1737 > 2147483500f)), (_e1737 == _e1737));
let _e1748 = (_e1744 - select(0i, 1i, (_e1737 < f32(_e1744))));
let _e1749 = f32(_e1748);
let _e1753 = ((_e1731 - (_e1749 * 0.6933594f)) - (_e1749 * -2.1219444e-4f));
let _e1775 = -((_e1674.member_2 * _e1671));
let _e1777 = select(-87f, _e1775, (_e1775 > -87f));
let _e1779 = select(88f, _e1777, (_e1777 < 88f));
let _e1781 = ((_e1779 * 1.442695f) + 0.5f);
let _e1783 = select(-127f, _e1781, (_e1781 > -127f));
let _e1785 = select(128f, _e1783, (_e1783 < 128f));
let _e1792 = select(0i, select(select(i32(_e1785), i32(-2147483648), (_e1785 < -2147483600f)), 2147483647i, (_e1785 > 2147483500f)), (_e1785 == _e1785));
let _e1796 = (_e1792 - select(0i, 1i, (_e1785 < f32(_e1792))));
let _e1797 = f32(_e1796);
let _e1801 = ((_e1779 - (_e1797 * 0.6933594f)) - (_e1797 * -2.1219444e-4f));
let _e1827 = -((((_e1565.member.x * _e1175.x) + (_e1565.member.y * _e1175.y)) + (_e1565.member.z * _e1175.z)));
let _e1830 = global_1.member.member_13.member_2;
let _e1831 = (_e1830 * _e1830);
let _e1832 = (1f + _e1831);
let _e1833 = (2f * _e1830);
let _e1835 = (_e1832 - (_e1833 * _e1827));
let _e1837 = select(1e-9f, _e1835, (_e1835 > 1e-9f));
let _e1838 = (1f - _e1831);
let _e1849 = global_1.member.member_13.member_3;
let _e1850 = (_e1849 == 1u);
let _e1852 = (0.25f / 3.1415927f);
let _e1855 = ((3.1415927f * (select((_e1838 / (_e1837 * sqrt(select(0f, _e1837, (_e1837 > 0f))))), (0.75f * (1f + (_e1827 * _e1827))), _e1850) * _e1852)) * select((_e1191 * ((2f * (1f + _e1181)) / (_e1184 * _e1184))), 1f, _e1199));
let _e1865 = global_1.member.member_13.member_1;
let _e1875 = local_5;
let _e1876 = local_6;
let _e1877 = local_7;
let _e1878 = local_10;
let _e1879 = local_9;
let _e1881 = (_e1878 + (_e1879 * 0.8611363f));
let _e1882 = (_e1881 * _e1881);
let _e1883 = (1f - _e1882);
let _e1885 = select(1e-9f, _e1883, (_e1883 > 1e-9f));
let _e1886 = local_8.member;
let _e1887 = local_8.member_1;
let _e1892 = local_8.member_1;
let _e1898 = local_8.member_2;
let _e1899 = select((_e1886 + (_e1887 * ((2f * _e1881) / _e1885))), _e1881, _e1898);
let _e1900 = local_8.member_2;
let _e1909 = (_e1875.x + (_e1876.x * _e1899));
let _e1911 = (_e1875.y + (_e1876.y * _e1899));
let _e1913 = (_e1875.z + (_e1876.z * _e1899));
if _e1223 {
let _e1916 = global_1.member.member_10.member_1;
phi_3898_ = type_26(vec3<f32>(_e1916.member, _e1916.member_1, _e1916.member_2), _e1219);
} else {
let _e1922 = (_e1909 - _e1568.member);
let _e1923 = (_e1911 - _e1568.member_1);
let _e1924 = (_e1913 - _e1568.member_2);
let _e1929 = (((_e1922 * _e1922) + (_e1923 * _e1923)) + (_e1924 * _e1924));
let _e1931 = select(1e-12f, _e1929, (_e1929 > 1e-12f));
let _e1932 = (1f / _e1931);
let _e1936 = vec3<f32>((_e1215.member * _e1932), (_e1215.member_1 * _e1932), (_e1215.member_2 * _e1932));
if (_e1222 == 2u) {
let _e1940 = global_1.member.member_10.member_1;
let _e1948 = (((_e1940.member * _e1922) + (_e1940.member_1 * _e1923)) + (_e1940.member_2 * _e1924));
let _e1951 = (1f / select(1e-20f, _e1948, (_e1948 > 1e-20f)));
let _e1955 = global_1.member.member_10.member_4.member;
let _e1964 = ((((_e1955.member * _e1922) + (_e1955.member_1 * _e1923)) + (_e1955.member_2 * _e1924)) * _e1951);
let _e1968 = global_1.member.member_10.member_4.member_1;
let _e1977 = ((((_e1968.member * _e1922) + (_e1968.member_1 * _e1923)) + (_e1968.member_2 * _e1924)) * _e1951);
let _e1981 = global_1.member.member_10.member_4.member_2;
let _e1984 = ((_e1964 * _e1964) + (_e1977 * _e1977));
let _e1992 = global_1.member.member_10.member_4.member_3;
let _e1993 = ((_e1981 - sqrt(select(0f, _e1984, (_e1984 > 0f)))) * _e1992);
let _e1995 = select(0f, _e1993, (_e1993 > 0f));
let _e1997 = select(1f, _e1995, (_e1995 < 1f));
let _e2003 = select(0f, ((_e1997 * _e1997) * (3f - (2f * _e1997))), (_e1948 > 0f));
let _e2007 = global_1.member.member_10.member_4.member_5;
if ((_e2007 > 0u) && (_e2003 > 0f)) {
let _e2011 = (0.5f / _e1981);
let _e2020 = global_1.member.member_10.member_4.member_6;
let _e2021 = bitcast<i32>(_e2020);
local_3 = bitcast<i32>(_e2007);
let _e2022 = local_3;
let _e2024 = f32((_e2022 - 1i));
let _e2026 = f32((_e2021 - 1i));
let _e2027 = local_3;
let _e2030 = (((0.5f + (_e1964 * _e2011)) * f32(_e2027)) - 0.5f);
let _e2032 = select(0f, _e2030, (_e2030 > 0f));
let _e2034 = select(_e2024, _e2032, (_e2032 < _e2024));
let _e2037 = (((0.5f - (_e1977 * _e2011)) * f32(_e2021)) - 0.5f);
let _e2039 = select(0f, _e2037, (_e2037 > 0f));
let _e2041 = select(_e2026, _e2039, (_e2039 < _e2026));
let _e2043 = select(0f, _e2034, (_e2034 > 0f));
let _e2045 = select(_e2024, _e2043, (_e2043 < _e2024));
let _e2052 = select(0i, select(select(i32(_e2045), i32(-2147483648), (_e2045 < -2147483600f)), 2147483647i, (_e2045 > 2147483500f)), (_e2045 == _e2045));
let _e2056 = (_e2052 - select(0i, 1i, (_e2045 < f32(_e2052))));
let _e2058 = select(0f, _e2041, (_e2041 > 0f));
let _e2060 = select(_e2026, _e2058, (_e2058 < _e2026));
let _e2067 = select(0i, select(select(i32(_e2060), i32(-2147483648), (_e2060 < -2147483600f)), 2147483647i, (_e2060 > 2147483500f)), (_e2060 == _e2060));
let _e2071 = (_e2067 - select(0i, 1i, (_e2060 < f32(_e2067))));
let _e2073 = (_e2034 - f32(_e2056));
let _e2075 = (_e2041 - f32(_e2071));
let _e2076 = (_e2056 + 1i);
let _e2077 = local_3;
let _e2079 = select(_e2056, _e2076, (_e2076 < _e2077));
let _e2080 = (_e2071 + 1i);
let _e2082 = select(_e2071, _e2080, (_e2080 < _e2021));
let _e2086 = global_1.member.member_10.member_4.member_4;
let _e2087 = bitcast<i32>(_e2086);
let _e2088 = local_3;
let _e2092 = (_e2087 + (3i * ((_e2071 * _e2088) + _e2056)));
let _e2094 = (bitcast<i32>(_e146) - 1i);
let _e2096 = select(_e2094, _e2092, (_e2092 < _e2094));
let _e2101 = global_3.member[bitcast<u32>(select(0i, _e2096, (_e2096 > 0i)))];
let _e2102 = (_e2092 + 1i);
let _e2104 = select(_e2094, _e2102, (_e2102 < _e2094));
let _e2109 = global_3.member[bitcast<u32>(select(0i, _e2104, (_e2104 > 0i)))];
let _e2110 = (_e2092 + 2i);
let _e2112 = select(_e2094, _e2110, (_e2110 < _e2094));
let _e2117 = global_3.member[bitcast<u32>(select(0i, _e2112, (_e2112 > 0i)))];
let _e2118 = local_3;
let _e2122 = (_e2087 + (3i * ((_e2071 * _e2118) + _e2079)));
let _e2124 = select(_e2094, _e2122, (_e2122 < _e2094));
let _e2129 = global_3.member[bitcast<u32>(select(0i, _e2124, (_e2124 > 0i)))];
let _e2130 = (_e2122 + 1i);
let _e2132 = select(_e2094, _e2130, (_e2130 < _e2094));
let _e2137 = global_3.member[bitcast<u32>(select(0i, _e2132, (_e2132 > 0i)))];
let _e2138 = (_e2122 + 2i);
let _e2140 = select(_e2094, _e2138, (_e2138 < _e2094));
let _e2145 = global_3.member[bitcast<u32>(select(0i, _e2140, (_e2140 > 0i)))];
let _e2146 = local_3;
let _e2150 = (_e2087 + (3i * ((_e2082 * _e2146) + _e2056)));
let _e2152 = select(_e2094, _e2150, (_e2150 < _e2094));
let _e2157 = global_3.member[bitcast<u32>(select(0i, _e2152, (_e2152 > 0i)))];
let _e2158 = (_e2150 + 1i);
let _e2160 = select(_e2094, _e2158, (_e2158 < _e2094));
let _e2165 = global_3.member[bitcast<u32>(select(0i, _e2160, (_e2160 > 0i)))];
let _e2166 = (_e2150 + 2i);
let _e2168 = select(_e2094, _e2166, (_e2166 < _e2094));
let _e2173 = global_3.member[bitcast<u32>(select(0i, _e2168, (_e2168 > 0i)))];
let _e2174 = local_3;
let _e2178 = (_e2087 + (3i * ((_e2082 * _e2174) + _e2079)));
let _e2180 = select(_e2094, _e2178, (_e2178 < _e2094));
let _e2185 = global_3.member[bitcast<u32>(select(0i, _e2180, (_e2180 > 0i)))];
let _e2186 = (_e2178 + 1i);
let _e2188 = select(_e2094, _e2186, (_e2186 < _e2094));
let _e2193 = global_3.member[bitcast<u32>(select(0i, _e2188, (_e2188 > 0i)))];
let _e2194 = (_e2178 + 2i);
let _e2196 = select(_e2094, _e2194, (_e2194 < _e2094));
let _e2201 = global_3.member[bitcast<u32>(select(0i, _e2196, (_e2196 > 0i)))];
let _e2208 = (_e2101 + ((_e2129 - _e2101) * _e2073));
let _e2209 = (_e2109 + ((_e2137 - _e2109) * _e2073));
let _e2210 = (_e2117 + ((_e2145 - _e2117) * _e2073));
phi_3882_ = vec3<f32>(((_e2208 + (((_e2157 + ((_e2185 - _e2157) * _e2073)) - _e2208) * _e2075)) * _e2003), ((_e2209 + (((_e2165 + ((_e2193 - _e2165) * _e2073)) - _e2209) * _e2075)) * _e2003), ((_e2210 + (((_e2173 + ((_e2201 - _e2173) * _e2073)) - _e2210) * _e2075)) * _e2003));
} else {
phi_3882_ = vec3(_e2003);
}
let _e2235 = phi_3882_;
phi_3885_ = (_e1936 * _e2235);
} else {
phi_3885_ = _e1936;
}
let _e2238 = phi_3885_;
let _e2242 = (1f / sqrt(select(0f, _e1931, (_e1931 > 0f))));
phi_3898_ = type_26(vec3<f32>((_e1922 * _e2242), (_e1923 * _e2242), (_e1924 * _e2242)), _e2238);
}
let _e2249 = phi_3898_;
let _e2250 = (_e1568.member - _e1909);
let _e2251 = (_e1568.member_1 - _e1911);
let _e2252 = (_e1568.member_2 - _e1913);
let _e2253 = local_8.member_2;
let _e2258 = (((_e2250 * _e2250) + (_e2251 * _e2251)) + (_e2252 * _e2252));
let _e2262 = select(sqrt(select(0f, _e2258, (_e2258 > 0f))), 1e30f, _e2253);
let _e2265 = -(_e2249.member.x);
let _e2267 = -(_e2249.member.y);
let _e2269 = -(_e2249.member.z);
let _e2277 = (1f / select(_e2265, select(1e-12f, -1e-12f, (_e2265 < 0f)), (bitcast<f32>((bitcast<u32>(_e2265) & 2147483647u)) < 1e-12f)));
let _e2285 = (1f / select(_e2267, select(1e-12f, -1e-12f, (_e2267 < 0f)), (bitcast<f32>((bitcast<u32>(_e2267) & 2147483647u)) < 1e-12f)));
let _e2293 = (1f / select(_e2269, select(1e-12f, -1e-12f, (_e2269 < 0f)), (bitcast<f32>((bitcast<u32>(_e2269) & 2147483647u)) < 1e-12f)));
let _e2295 = ((_e1618.member - _e1909) * _e2277);
let _e2297 = ((_e1624.member - _e1909) * _e2277);
let _e2299 = ((_e1618.member_1 - _e1911) * _e2285);
let _e2301 = ((_e1624.member_1 - _e1911) * _e2285);
let _e2303 = ((_e1618.member_2 - _e1913) * _e2293);
let _e2305 = ((_e1624.member_2 - _e1913) * _e2293);
let _e2307 = select(_e2297, _e2295, (_e2295 < _e2297));
let _e2309 = select(_e2301, _e2299, (_e2299 < _e2301));
let _e2311 = select(_e2309, _e2307, (_e2307 > _e2309));
let _e2313 = select(_e2305, _e2303, (_e2303 < _e2305));
let _e2315 = select(_e2313, _e2311, (_e2311 > _e2313));
let _e2317 = select(_e2297, _e2295, (_e2295 > _e2297));
let _e2319 = select(_e2301, _e2299, (_e2299 > _e2301));
let _e2321 = select(_e2319, _e2317, (_e2317 < _e2319));
let _e2323 = select(_e2305, _e2303, (_e2303 > _e2305));
let _e2325 = select(_e2323, _e2321, (_e2321 < _e2323));
let _e2327 = select(0f, _e2315, (_e2315 > 0f));
let _e2329 = select(_e2262, _e2325, (_e2325 < _e2262));
let _e2330 = (_e2329 > _e2327);
let _e2334 = (_e1899 - _e1877);
let _e2337 = ((select(0f, _e2329, _e2330) - select(0f, _e2327, _e2330)) + select(0f, _e2334, (_e2334 > 0f)));
let _e2339 = -((_e1674.member * _e2337));
let _e2341 = select(-87f, _e2339, (_e2339 > -87f));
let _e2343 = select(88f, _e2341, (_e2341 < 88f));
let _e2345 = ((_e2343 * 1.442695f) + 0.5f);
let _e2347 = select(-127f, _e2345, (_e2345 > -127f));
let _e2349 = select(128f, _e2347, (_e2347 < 128f));
let _e2356 = select(0i, select(select(i32(_e2349), i32(-2147483648), (_e2349 < -2147483600f)), 2147483647i, (_e2349 > 2147483500f)), (_e2349 == _e2349));
let _e2360 = (_e2356 - select(0i, 1i, (_e2349 < f32(_e2356))));
let _e2361 = f32(_e2360);
let _e2365 = ((_e2343 - (_e2361 * 0.6933594f)) - (_e2361 * -2.1219444e-4f));
let _e2387 = -((_e1674.member_1 * _e2337));
let _e2389 = select(-87f, _e2387, (_e2387 > -87f));
let _e2391 = select(88f, _e2389, (_e2389 < 88f));
let _e2393 = ((_e2391 * 1.442695f) + 0.5f);
let _e2395 = select(-127f, _e2393, (_e2393 > -127f));
let _e2397 = select(128f, _e2395, (_e2395 < 128f));
let _e2404 = select(0i, select(select(i32(_e2397), i32(-2147483648), (_e2397 < -2147483600f)), 2147483647i, (_e2397 > 2147483500f)), (_e2397 == _e2397));
let _e2408 = (_e2404 - select(0i, 1i, (_e2397 < f32(_e2404))));
let _e2409 = f32(_e2408);
let _e2413 = ((_e2391 - (_e2409 * 0.6933594f)) - (_e2409 * -2.1219444e-4f));
let _e2435 = -((_e1674.member_2 * _e2337));
let _e2437 = select(-87f, _e2435, (_e2435 > -87f));
let _e2439 = select(88f, _e2437, (_e2437 < 88f));
let _e2441 = ((_e2439 * 1.442695f) + 0.5f);
let _e2443 = select(-127f, _e2441, (_e2441 > -127f));
let _e2445 = select(128f, _e2443, (_e2443 < 128f));
let _e2452 = select(0i, select(select(i32(_e2445), i32(-2147483648), (_e2445 < -2147483600f)), 2147483647i, (_e2445 > 2147483500f)), (_e2445 == _e2445));
let _e2456 = (_e2452 - select(0i, 1i, (_e2445 < f32(_e2452))));
let _e2457 = f32(_e2456);
let _e2461 = ((_e2439 - (_e2457 * 0.6933594f)) - (_e2457 * -2.1219444e-4f));
let _e2487 = -((((_e2249.member.x * _e1876.x) + (_e2249.member.y * _e1876.y)) + (_e2249.member.z * _e1876.z)));
let _e2489 = (_e1832 - (_e1833 * _e2487));
let _e2491 = select(1e-9f, _e2489, (_e2489 > 1e-9f));
let _e2503 = ((3.1415927f * (select((_e1838 / (_e2491 * sqrt(select(0f, _e2491, (_e2491 > 0f))))), (0.75f * (1f + (_e2487 * _e2487))), _e1850) * _e1852)) * select((_e1892 * ((2f * (1f + _e1882)) / (_e1885 * _e1885))), 1f, _e1900));
let _e2520 = local_9;
let _e2521 = (_e2520 * 0.34785485f);
let _e2532 = local_5;
let _e2533 = local_6;
let _e2534 = local_7;
let _e2535 = local_10;
let _e2536 = local_9;
let _e2538 = (_e2535 + (_e2536 * -(0.33998105f)));
let _e2539 = (_e2538 * _e2538);
let _e2540 = (1f - _e2539);
let _e2542 = select(1e-9f, _e2540, (_e2540 > 1e-9f));
let _e2543 = local_8.member;
let _e2544 = local_8.member_1;
let _e2549 = local_8.member_1;
let _e2555 = local_8.member_2;
let _e2556 = select((_e2543 + (_e2544 * ((2f * _e2538) / _e2542))), _e2538, _e2555);
let _e2557 = local_8.member_2;
let _e2566 = (_e2532.x + (_e2533.x * _e2556));
let _e2568 = (_e2532.y + (_e2533.y * _e2556));
let _e2570 = (_e2532.z + (_e2533.z * _e2556));
if _e1223 {
let _e2573 = global_1.member.member_10.member_1;
phi_4929_ = type_26(vec3<f32>(_e2573.member, _e2573.member_1, _e2573.member_2), _e1219);
} else {
let _e2579 = (_e2566 - _e1568.member);
let _e2580 = (_e2568 - _e1568.member_1);
let _e2581 = (_e2570 - _e1568.member_2);
let _e2586 = (((_e2579 * _e2579) + (_e2580 * _e2580)) + (_e2581 * _e2581));
let _e2588 = select(1e-12f, _e2586, (_e2586 > 1e-12f));
let _e2589 = (1f / _e2588);
let _e2593 = vec3<f32>((_e1215.member * _e2589), (_e1215.member_1 * _e2589), (_e1215.member_2 * _e2589));
if (_e1222 == 2u) {
let _e2597 = global_1.member.member_10.member_1;
let _e2605 = (((_e2597.member * _e2579) + (_e2597.member_1 * _e2580)) + (_e2597.member_2 * _e2581));
let _e2608 = (1f / select(1e-20f, _e2605, (_e2605 > 1e-20f)));
let _e2612 = global_1.member.member_10.member_4.member;
let _e2621 = ((((_e2612.member * _e2579) + (_e2612.member_1 * _e2580)) + (_e2612.member_2 * _e2581)) * _e2608);
let _e2625 = global_1.member.member_10.member_4.member_1;
let _e2634 = ((((_e2625.member * _e2579) + (_e2625.member_1 * _e2580)) + (_e2625.member_2 * _e2581)) * _e2608);
let _e2638 = global_1.member.member_10.member_4.member_2;
let _e2641 = ((_e2621 * _e2621) + (_e2634 * _e2634));
let _e2649 = global_1.member.member_10.member_4.member_3;
let _e2650 = ((_e2638 - sqrt(select(0f, _e2641, (_e2641 > 0f)))) * _e2649);
let _e2652 = select(0f, _e2650, (_e2650 > 0f));
let _e2654 = select(1f, _e2652, (_e2652 < 1f));
let _e2660 = select(0f, ((_e2654 * _e2654) * (3f - (2f * _e2654))), (_e2605 > 0f));
let _e2664 = global_1.member.member_10.member_4.member_5;
if ((_e2664 > 0u) && (_e2660 > 0f)) {
let _e2668 = (0.5f / _e2638);
let _e2677 = global_1.member.member_10.member_4.member_6;
let _e2678 = bitcast<i32>(_e2677);
local_2 = bitcast<i32>(_e2664);
let _e2679 = local_2;
let _e2681 = f32((_e2679 - 1i));
let _e2683 = f32((_e2678 - 1i));
let _e2684 = local_2;
let _e2687 = (((0.5f + (_e2621 * _e2668)) * f32(_e2684)) - 0.5f);
let _e2689 = select(0f, _e2687, (_e2687 > 0f));
let _e2691 = select(_e2681, _e2689, (_e2689 < _e2681));
let _e2694 = (((0.5f - (_e2634 * _e2668)) * f32(_e2678)) - 0.5f);
let _e2696 = select(0f, _e2694, (_e2694 > 0f));
let _e2698 = select(_e2683, _e2696, (_e2696 < _e2683));
let _e2700 = select(0f, _e2691, (_e2691 > 0f));
let _e2702 = select(_e2681, _e2700, (_e2700 < _e2681));
let _e2709 = select(0i, select(select(i32(_e2702), i32(-2147483648), (_e2702 < -2147483600f)), 2147483647i, (_e2702 > 2147483500f)), (_e2702 == _e2702));
let _e2713 = (_e2709 - select(0i, 1i, (_e2702 < f32(_e2709))));
let _e2715 = select(0f, _e2698, (_e2698 > 0f));
let _e2717 = select(_e2683, _e2715, (_e2715 < _e2683));
let _e2724 = select(0i, select(select(i32(_e2717), i32(-2147483648), (_e2717 < -2147483600f)), 2147483647i, (_e2717 > 2147483500f)), (_e2717 == _e2717));
let _e2728 = (_e2724 - select(0i, 1i, (_e2717 < f32(_e2724))));
let _e2730 = (_e2691 - f32(_e2713));
let _e2732 = (_e2698 - f32(_e2728));
let _e2733 = (_e2713 + 1i);
let _e2734 = local_2;
let _e2736 = select(_e2713, _e2733, (_e2733 < _e2734));
let _e2737 = (_e2728 + 1i);
let _e2739 = select(_e2728, _e2737, (_e2737 < _e2678));
let _e2743 = global_1.member.member_10.member_4.member_4;
let _e2744 = bitcast<i32>(_e2743);
let _e2745 = local_2;
let _e2749 = (_e2744 + (3i * ((_e2728 * _e2745) + _e2713)));
let _e2751 = (bitcast<i32>(_e146) - 1i);
let _e2753 = select(_e2751, _e2749, (_e2749 < _e2751));
let _e2758 = global_3.member[bitcast<u32>(select(0i, _e2753, (_e2753 > 0i)))];
let _e2759 = (_e2749 + 1i);
let _e2761 = select(_e2751, _e2759, (_e2759 < _e2751));
let _e2766 = global_3.member[bitcast<u32>(select(0i, _e2761, (_e2761 > 0i)))];
let _e2767 = (_e2749 + 2i);
let _e2769 = select(_e2751, _e2767, (_e2767 < _e2751));
let _e2774 = global_3.member[bitcast<u32>(select(0i, _e2769, (_e2769 > 0i)))];
let _e2775 = local_2;
let _e2779 = (_e2744 + (3i * ((_e2728 * _e2775) + _e2736)));
let _e2781 = select(_e2751, _e2779, (_e2779 < _e2751));
let _e2786 = global_3.member[bitcast<u32>(select(0i, _e2781, (_e2781 > 0i)))];
let _e2787 = (_e2779 + 1i);
let _e2789 = select(_e2751, _e2787, (_e2787 < _e2751));
let _e2794 = global_3.member[bitcast<u32>(select(0i, _e2789, (_e2789 > 0i)))];
let _e2795 = (_e2779 + 2i);
let _e2797 = select(_e2751, _e2795, (_e2795 < _e2751));
let _e2802 = global_3.member[bitcast<u32>(select(0i, _e2797, (_e2797 > 0i)))];
let _e2803 = local_2;
let _e2807 = (_e2744 + (3i * ((_e2739 * _e2803) + _e2713)));
let _e2809 = select(_e2751, _e2807, (_e2807 < _e2751));
let _e2814 = global_3.member[bitcast<u32>(select(0i, _e2809, (_e2809 > 0i)))];
let _e2815 = (_e2807 + 1i);
let _e2817 = select(_e2751, _e2815, (_e2815 < _e2751));
let _e2822 = global_3.member[bitcast<u32>(select(0i, _e2817, (_e2817 > 0i)))];
let _e2823 = (_e2807 + 2i);
let _e2825 = select(_e2751, _e2823, (_e2823 < _e2751));
let _e2830 = global_3.member[bitcast<u32>(select(0i, _e2825, (_e2825 > 0i)))];
let _e2831 = local_2;
let _e2835 = (_e2744 + (3i * ((_e2739 * _e2831) + _e2736)));
let _e2837 = select(_e2751, _e2835, (_e2835 < _e2751));
let _e2842 = global_3.member[bitcast<u32>(select(0i, _e2837, (_e2837 > 0i)))];
let _e2843 = (_e2835 + 1i);
let _e2845 = select(_e2751, _e2843, (_e2843 < _e2751));
let _e2850 = global_3.member[bitcast<u32>(select(0i, _e2845, (_e2845 > 0i)))];
let _e2851 = (_e2835 + 2i);
let _e2853 = select(_e2751, _e2851, (_e2851 < _e2751));
let _e2858 = global_3.member[bitcast<u32>(select(0i, _e2853, (_e2853 > 0i)))];
let _e2865 = (_e2758 + ((_e2786 - _e2758) * _e2730));
let _e2866 = (_e2766 + ((_e2794 - _e2766) * _e2730));
let _e2867 = (_e2774 + ((_e2802 - _e2774) * _e2730));
phi_4913_ = vec3<f32>(((_e2865 + (((_e2814 + ((_e2842 - _e2814) * _e2730)) - _e2865) * _e2732)) * _e2660), ((_e2866 + (((_e2822 + ((_e2850 - _e2822) * _e2730)) - _e2866) * _e2732)) * _e2660), ((_e2867 + (((_e2830 + ((_e2858 - _e2830) * _e2730)) - _e2867) * _e2732)) * _e2660));
} else {
phi_4913_ = vec3(_e2660);
}
let _e2892 = phi_4913_;
phi_4916_ = (_e2593 * _e2892);
} else {
phi_4916_ = _e2593;
}
let _e2895 = phi_4916_;
let _e2899 = (1f / sqrt(select(0f, _e2588, (_e2588 > 0f))));
phi_4929_ = type_26(vec3<f32>((_e2579 * _e2899), (_e2580 * _e2899), (_e2581 * _e2899)), _e2895);
}
let _e2906 = phi_4929_;
let _e2907 = (_e1568.member - _e2566);
let _e2908 = (_e1568.member_1 - _e2568);
let _e2909 = (_e1568.member_2 - _e2570);
let _e2910 = local_8.member_2;
let _e2915 = (((_e2907 * _e2907) + (_e2908 * _e2908)) + (_e2909 * _e2909));
let _e2919 = select(sqrt(select(0f, _e2915, (_e2915 > 0f))), 1e30f, _e2910);
let _e2922 = -(_e2906.member.x);
let _e2924 = -(_e2906.member.y);
let _e2926 = -(_e2906.member.z);
let _e2934 = (1f / select(_e2922, select(1e-12f, -1e-12f, (_e2922 < 0f)), (bitcast<f32>((bitcast<u32>(_e2922) & 2147483647u)) < 1e-12f)));
let _e2942 = (1f / select(_e2924, select(1e-12f, -1e-12f, (_e2924 < 0f)), (bitcast<f32>((bitcast<u32>(_e2924) & 2147483647u)) < 1e-12f)));
let _e2950 = (1f / select(_e2926, select(1e-12f, -1e-12f, (_e2926 < 0f)), (bitcast<f32>((bitcast<u32>(_e2926) & 2147483647u)) < 1e-12f)));
let _e2952 = ((_e1618.member - _e2566) * _e2934);
let _e2954 = ((_e1624.member - _e2566) * _e2934);
let _e2956 = ((_e1618.member_1 - _e2568) * _e2942);
let _e2958 = ((_e1624.member_1 - _e2568) * _e2942);
let _e2960 = ((_e1618.member_2 - _e2570) * _e2950);
let _e2962 = ((_e1624.member_2 - _e2570) * _e2950);
let _e2964 = select(_e2954, _e2952, (_e2952 < _e2954));
let _e2966 = select(_e2958, _e2956, (_e2956 < _e2958));
let _e2968 = select(_e2966, _e2964, (_e2964 > _e2966));
let _e2970 = select(_e2962, _e2960, (_e2960 < _e2962));
let _e2972 = select(_e2970, _e2968, (_e2968 > _e2970));
let _e2974 = select(_e2954, _e2952, (_e2952 > _e2954));
let _e2976 = select(_e2958, _e2956, (_e2956 > _e2958));
let _e2978 = select(_e2976, _e2974, (_e2974 < _e2976));
let _e2980 = select(_e2962, _e2960, (_e2960 > _e2962));
let _e2982 = select(_e2980, _e2978, (_e2978 < _e2980));
let _e2984 = select(0f, _e2972, (_e2972 > 0f));
let _e2986 = select(_e2919, _e2982, (_e2982 < _e2919));
let _e2987 = (_e2986 > _e2984);
let _e2991 = (_e2556 - _e2534);
let _e2994 = ((select(0f, _e2986, _e2987) - select(0f, _e2984, _e2987)) + select(0f, _e2991, (_e2991 > 0f)));
let _e2996 = -((_e1674.member * _e2994));
let _e2998 = select(-87f, _e2996, (_e2996 > -87f));
let _e3000 = select(88f, _e2998, (_e2998 < 88f));
let _e3002 = ((_e3000 * 1.442695f) + 0.5f);
let _e3004 = select(-127f, _e3002, (_e3002 > -127f));
let _e3006 = select(128f, _e3004, (_e3004 < 128f));
let _e3013 = select(0i, select(select(i32(_e3006), i32(-2147483648), (_e3006 < -2147483600f)), 2147483647i, (_e3006 > 2147483500f)), (_e3006 == _e3006));
let _e3017 = (_e3013 - select(0i, 1i, (_e3006 < f32(_e3013))));
let _e3018 = f32(_e3017);
let _e3022 = ((_e3000 - (_e3018 * 0.6933594f)) - (_e3018 * -2.1219444e-4f));
let _e3044 = -((_e1674.member_1 * _e2994));
let _e3046 = select(-87f, _e3044, (_e3044 > -87f));
let _e3048 = select(88f, _e3046, (_e3046 < 88f));
let _e3050 = ((_e3048 * 1.442695f) + 0.5f);
let _e3052 = select(-127f, _e3050, (_e3050 > -127f));
let _e3054 = select(128f, _e3052, (_e3052 < 128f));
let _e3061 = select(0i, select(select(i32(_e3054), i32(-2147483648), (_e3054 < -2147483600f)), 2147483647i, (_e3054 > 2147483500f)), (_e3054 == _e3054));
let _e3065 = (_e3061 - select(0i, 1i, (_e3054 < f32(_e3061))));
let _e3066 = f32(_e3065);
let _e3070 = ((_e3048 - (_e3066 * 0.6933594f)) - (_e3066 * -2.1219444e-4f));
let _e3092 = -((_e1674.member_2 * _e2994));
let _e3094 = select(-87f, _e3092, (_e3092 > -87f));
let _e3096 = select(88f, _e3094, (_e3094 < 88f));
let _e3098 = ((_e3096 * 1.442695f) + 0.5f);
let _e3100 = select(-127f, _e3098, (_e3098 > -127f));
let _e3102 = select(128f, _e3100, (_e3100 < 128f));
let _e3109 = select(0i, select(select(i32(_e3102), i32(-2147483648), (_e3102 < -2147483600f)), 2147483647i, (_e3102 > 2147483500f)), (_e3102 == _e3102));
let _e3113 = (_e3109 - select(0i, 1i, (_e3102 < f32(_e3109))));
let _e3114 = f32(_e3113);
let _e3118 = ((_e3096 - (_e3114 * 0.6933594f)) - (_e3114 * -2.1219444e-4f));
let _e3144 = -((((_e2906.member.x * _e2533.x) + (_e2906.member.y * _e2533.y)) + (_e2906.member.z * _e2533.z)));
let _e3146 = (_e1832 - (_e1833 * _e3144));
let _e3148 = select(1e-9f, _e3146, (_e3146 > 1e-9f));
let _e3160 = ((3.1415927f * (select((_e1838 / (_e3148 * sqrt(select(0f, _e3148, (_e3148 > 0f))))), (0.75f * (1f + (_e3144 * _e3144))), _e1850) * _e1852)) * select((_e2549 * ((2f * (1f + _e2539)) / (_e2542 * _e2542))), 1f, _e2557));
let _e3174 = local_5;
let _e3175 = local_6;
let _e3176 = local_7;
let _e3177 = local_10;
let _e3178 = local_9;
let _e3180 = (_e3177 + (_e3178 * 0.33998105f));
let _e3181 = (_e3180 * _e3180);
let _e3182 = (1f - _e3181);
let _e3184 = select(1e-9f, _e3182, (_e3182 > 1e-9f));
let _e3185 = local_8.member;
let _e3186 = local_8.member_1;
let _e3191 = local_8.member_1;
let _e3197 = local_8.member_2;
let _e3198 = select((_e3185 + (_e3186 * ((2f * _e3180) / _e3184))), _e3180, _e3197);
let _e3199 = local_8.member_2;
let _e3208 = (_e3174.x + (_e3175.x * _e3198));
let _e3210 = (_e3174.y + (_e3175.y * _e3198));
let _e3212 = (_e3174.z + (_e3175.z * _e3198));
if _e1223 {
let _e3215 = global_1.member.member_10.member_1;
phi_5943_ = type_26(vec3<f32>(_e3215.member, _e3215.member_1, _e3215.member_2), _e1219);
} else {
let _e3221 = (_e3208 - _e1568.member);
let _e3222 = (_e3210 - _e1568.member_1);
let _e3223 = (_e3212 - _e1568.member_2);
let _e3228 = (((_e3221 * _e3221) + (_e3222 * _e3222)) + (_e3223 * _e3223));
let _e3230 = select(1e-12f, _e3228, (_e3228 > 1e-12f));
let _e3231 = (1f / _e3230);
let _e3235 = vec3<f32>((_e1215.member * _e3231), (_e1215.member_1 * _e3231), (_e1215.member_2 * _e3231));
if (_e1222 == 2u) {
let _e3239 = global_1.member.member_10.member_1;
let _e3247 = (((_e3239.member * _e3221) + (_e3239.member_1 * _e3222)) + (_e3239.member_2 * _e3223));
let _e3250 = (1f / select(1e-20f, _e3247, (_e3247 > 1e-20f)));
let _e3254 = global_1.member.member_10.member_4.member;
let _e3263 = ((((_e3254.member * _e3221) + (_e3254.member_1 * _e3222)) + (_e3254.member_2 * _e3223)) * _e3250);
let _e3267 = global_1.member.member_10.member_4.member_1;
let _e3276 = ((((_e3267.member * _e3221) + (_e3267.member_1 * _e3222)) + (_e3267.member_2 * _e3223)) * _e3250);
let _e3280 = global_1.member.member_10.member_4.member_2;
let _e3283 = ((_e3263 * _e3263) + (_e3276 * _e3276));
let _e3291 = global_1.member.member_10.member_4.member_3;
let _e3292 = ((_e3280 - sqrt(select(0f, _e3283, (_e3283 > 0f)))) * _e3291);
let _e3294 = select(0f, _e3292, (_e3292 > 0f));
let _e3296 = select(1f, _e3294, (_e3294 < 1f));
let _e3302 = select(0f, ((_e3296 * _e3296) * (3f - (2f * _e3296))), (_e3247 > 0f));
let _e3306 = global_1.member.member_10.member_4.member_5;
if ((_e3306 > 0u) && (_e3302 > 0f)) {
let _e3310 = (0.5f / _e3280);
let _e3319 = global_1.member.member_10.member_4.member_6;
let _e3320 = bitcast<i32>(_e3319);
local_1 = bitcast<i32>(_e3306);
let _e3321 = local_1;
let _e3323 = f32((_e3321 - 1i));
let _e3325 = f32((_e3320 - 1i));
let _e3326 = local_1;
let _e3329 = (((0.5f + (_e3263 * _e3310)) * f32(_e3326)) - 0.5f);
let _e3331 = select(0f, _e3329, (_e3329 > 0f));
let _e3333 = select(_e3323, _e3331, (_e3331 < _e3323));
let _e3336 = (((0.5f - (_e3276 * _e3310)) * f32(_e3320)) - 0.5f);
let _e3338 = select(0f, _e3336, (_e3336 > 0f));
let _e3340 = select(_e3325, _e3338, (_e3338 < _e3325));
let _e3342 = select(0f, _e3333, (_e3333 > 0f));
let _e3344 = select(_e3323, _e3342, (_e3342 < _e3323));
let _e3351 = select(0i, select(select(i32(_e3344), i32(-2147483648), (_e3344 < -2147483600f)), 2147483647i, (_e3344 > 2147483500f)), (_e3344 == _e3344));
let _e3355 = (_e3351 - select(0i, 1i, (_e3344 < f32(_e3351))));
let _e3357 = select(0f, _e3340, (_e3340 > 0f));
let _e3359 = select(_e3325, _e3357, (_e3357 < _e3325));
let _e3366 = select(0i, select(select(i32(_e3359), i32(-2147483648), (_e3359 < -2147483600f)), 2147483647i, (_e3359 > 2147483500f)), (_e3359 == _e3359));
let _e3370 = (_e3366 - select(0i, 1i, (_e3359 < f32(_e3366))));
let _e3372 = (_e3333 - f32(_e3355));
let _e3374 = (_e3340 - f32(_e3370));
let _e3375 = (_e3355 + 1i);
let _e3376 = local_1;
let _e3378 = select(_e3355, _e3375, (_e3375 < _e3376));
let _e3379 = (_e3370 + 1i);
let _e3381 = select(_e3370, _e3379, (_e3379 < _e3320));
let _e3385 = global_1.member.member_10.member_4.member_4;
let _e3386 = bitcast<i32>(_e3385);
let _e3387 = local_1;
let _e3391 = (_e3386 + (3i * ((_e3370 * _e3387) + _e3355)));
let _e3393 = (bitcast<i32>(_e146) - 1i);
let _e3395 = select(_e3393, _e3391, (_e3391 < _e3393));
let _e3400 = global_3.member[bitcast<u32>(select(0i, _e3395, (_e3395 > 0i)))];
let _e3401 = (_e3391 + 1i);
let _e3403 = select(_e3393, _e3401, (_e3401 < _e3393));
let _e3408 = global_3.member[bitcast<u32>(select(0i, _e3403, (_e3403 > 0i)))];
let _e3409 = (_e3391 + 2i);
let _e3411 = select(_e3393, _e3409, (_e3409 < _e3393));
let _e3416 = global_3.member[bitcast<u32>(select(0i, _e3411, (_e3411 > 0i)))];
let _e3417 = local_1;
let _e3421 = (_e3386 + (3i * ((_e3370 * _e3417) + _e3378)));
let _e3423 = select(_e3393, _e3421, (_e3421 < _e3393));
let _e3428 = global_3.member[bitcast<u32>(select(0i, _e3423, (_e3423 > 0i)))];
let _e3429 = (_e3421 + 1i);
let _e3431 = select(_e3393, _e3429, (_e3429 < _e3393));
let _e3436 = global_3.member[bitcast<u32>(select(0i, _e3431, (_e3431 > 0i)))];
let _e3437 = (_e3421 + 2i);
let _e3439 = select(_e3393, _e3437, (_e3437 < _e3393));
let _e3444 = global_3.member[bitcast<u32>(select(0i, _e3439, (_e3439 > 0i)))];
let _e3445 = local_1;
let _e3449 = (_e3386 + (3i * ((_e3381 * _e3445) + _e3355)));
let _e3451 = select(_e3393, _e3449, (_e3449 < _e3393));
let _e3456 = global_3.member[bitcast<u32>(select(0i, _e3451, (_e3451 > 0i)))];
let _e3457 = (_e3449 + 1i);
let _e3459 = select(_e3393, _e3457, (_e3457 < _e3393));
let _e3464 = global_3.member[bitcast<u32>(select(0i, _e3459, (_e3459 > 0i)))];
let _e3465 = (_e3449 + 2i);
let _e3467 = select(_e3393, _e3465, (_e3465 < _e3393));
let _e3472 = global_3.member[bitcast<u32>(select(0i, _e3467, (_e3467 > 0i)))];
let _e3473 = local_1;
let _e3477 = (_e3386 + (3i * ((_e3381 * _e3473) + _e3378)));
let _e3479 = select(_e3393, _e3477, (_e3477 < _e3393));
let _e3484 = global_3.member[bitcast<u32>(select(0i, _e3479, (_e3479 > 0i)))];
let _e3485 = (_e3477 + 1i);
let _e3487 = select(_e3393, _e3485, (_e3485 < _e3393));
let _e3492 = global_3.member[bitcast<u32>(select(0i, _e3487, (_e3487 > 0i)))];
let _e3493 = (_e3477 + 2i);
let _e3495 = select(_e3393, _e3493, (_e3493 < _e3393));
let _e3500 = global_3.member[bitcast<u32>(select(0i, _e3495, (_e3495 > 0i)))];
let _e3507 = (_e3400 + ((_e3428 - _e3400) * _e3372));
let _e3508 = (_e3408 + ((_e3436 - _e3408) * _e3372));
let _e3509 = (_e3416 + ((_e3444 - _e3416) * _e3372));
phi_5927_ = vec3<f32>(((_e3507 + (((_e3456 + ((_e3484 - _e3456) * _e3372)) - _e3507) * _e3374)) * _e3302), ((_e3508 + (((_e3464 + ((_e3492 - _e3464) * _e3372)) - _e3508) * _e3374)) * _e3302), ((_e3509 + (((_e3472 + ((_e3500 - _e3472) * _e3372)) - _e3509) * _e3374)) * _e3302));
} else {
phi_5927_ = vec3(_e3302);
}
let _e3534 = phi_5927_;
phi_5930_ = (_e3235 * _e3534);
} else {
phi_5930_ = _e3235;
}
let _e3537 = phi_5930_;
let _e3541 = (1f / sqrt(select(0f, _e3230, (_e3230 > 0f))));
phi_5943_ = type_26(vec3<f32>((_e3221 * _e3541), (_e3222 * _e3541), (_e3223 * _e3541)), _e3537);
}
let _e3548 = phi_5943_;
let _e3549 = (_e1568.member - _e3208);
let _e3550 = (_e1568.member_1 - _e3210);
let _e3551 = (_e1568.member_2 - _e3212);
let _e3552 = local_8.member_2;
let _e3557 = (((_e3549 * _e3549) + (_e3550 * _e3550)) + (_e3551 * _e3551));
let _e3561 = select(sqrt(select(0f, _e3557, (_e3557 > 0f))), 1e30f, _e3552);
let _e3564 = -(_e3548.member.x);
let _e3566 = -(_e3548.member.y);
let _e3568 = -(_e3548.member.z);
let _e3576 = (1f / select(_e3564, select(1e-12f, -1e-12f, (_e3564 < 0f)), (bitcast<f32>((bitcast<u32>(_e3564) & 2147483647u)) < 1e-12f)));
let _e3584 = (1f / select(_e3566, select(1e-12f, -1e-12f, (_e3566 < 0f)), (bitcast<f32>((bitcast<u32>(_e3566) & 2147483647u)) < 1e-12f)));
let _e3592 = (1f / select(_e3568, select(1e-12f, -1e-12f, (_e3568 < 0f)), (bitcast<f32>((bitcast<u32>(_e3568) & 2147483647u)) < 1e-12f)));
let _e3594 = ((_e1618.member - _e3208) * _e3576);
let _e3596 = ((_e1624.member - _e3208) * _e3576);
let _e3598 = ((_e1618.member_1 - _e3210) * _e3584);
let _e3600 = ((_e1624.member_1 - _e3210) * _e3584);
let _e3602 = ((_e1618.member_2 - _e3212) * _e3592);
let _e3604 = ((_e1624.member_2 - _e3212) * _e3592);
let _e3606 = select(_e3596, _e3594, (_e3594 < _e3596));
let _e3608 = select(_e3600, _e3598, (_e3598 < _e3600));
let _e3610 = select(_e3608, _e3606, (_e3606 > _e3608));
let _e3612 = select(_e3604, _e3602, (_e3602 < _e3604));
let _e3614 = select(_e3612, _e3610, (_e3610 > _e3612));
let _e3616 = select(_e3596, _e3594, (_e3594 > _e3596));
let _e3618 = select(_e3600, _e3598, (_e3598 > _e3600));
let _e3620 = select(_e3618, _e3616, (_e3616 < _e3618));
let _e3622 = select(_e3604, _e3602, (_e3602 > _e3604));
let _e3624 = select(_e3622, _e3620, (_e3620 < _e3622));
let _e3626 = select(0f, _e3614, (_e3614 > 0f));
let _e3628 = select(_e3561, _e3624, (_e3624 < _e3561));
let _e3629 = (_e3628 > _e3626);
let _e3633 = (_e3198 - _e3176);
let _e3636 = ((select(0f, _e3628, _e3629) - select(0f, _e3626, _e3629)) + select(0f, _e3633, (_e3633 > 0f)));
let _e3638 = -((_e1674.member * _e3636));
let _e3640 = select(-87f, _e3638, (_e3638 > -87f));
let _e3642 = select(88f, _e3640, (_e3640 < 88f));
let _e3644 = ((_e3642 * 1.442695f) + 0.5f);
let _e3646 = select(-127f, _e3644, (_e3644 > -127f));
let _e3648 = select(128f, _e3646, (_e3646 < 128f));
let _e3655 = select(0i, select(select(i32(_e3648), i32(-2147483648), (_e3648 < -2147483600f)), 2147483647i, (_e3648 > 2147483500f)), (_e3648 == _e3648));
let _e3659 = (_e3655 - select(0i, 1i, (_e3648 < f32(_e3655))));
let _e3660 = f32(_e3659);
let _e3664 = ((_e3642 - (_e3660 * 0.6933594f)) - (_e3660 * -2.1219444e-4f));
let _e3686 = -((_e1674.member_1 * _e3636));
let _e3688 = select(-87f, _e3686, (_e3686 > -87f));
let _e3690 = select(88f, _e3688, (_e3688 < 88f));
let _e3692 = ((_e3690 * 1.442695f) + 0.5f);
let _e3694 = select(-127f, _e3692, (_e3692 > -127f));
let _e3696 = select(128f, _e3694, (_e3694 < 128f));
let _e3703 = select(0i, select(select(i32(_e3696), i32(-2147483648), (_e3696 < -2147483600f)), 2147483647i, (_e3696 > 2147483500f)), (_e3696 == _e3696));
let _e3707 = (_e3703 - select(0i, 1i, (_e3696 < f32(_e3703))));
let _e3708 = f32(_e3707);
let _e3712 = ((_e3690 - (_e3708 * 0.6933594f)) - (_e3708 * -2.1219444e-4f));
let _e3734 = -((_e1674.member_2 * _e3636));
let _e3736 = select(-87f, _e3734, (_e3734 > -87f));
let _e3738 = select(88f, _e3736, (_e3736 < 88f));
let _e3740 = ((_e3738 * 1.442695f) + 0.5f);
let _e3742 = select(-127f, _e3740, (_e3740 > -127f));
let _e3744 = select(128f, _e3742, (_e3742 < 128f));
let _e3751 = select(0i, select(select(i32(_e3744), i32(-2147483648), (_e3744 < -2147483600f)), 2147483647i, (_e3744 > 2147483500f)), (_e3744 == _e3744));
let _e3755 = (_e3751 - select(0i, 1i, (_e3744 < f32(_e3751))));
let _e3756 = f32(_e3755);
let _e3760 = ((_e3738 - (_e3756 * 0.6933594f)) - (_e3756 * -2.1219444e-4f));
let _e3786 = -((((_e3548.member.x * _e3175.x) + (_e3548.member.y * _e3175.y)) + (_e3548.member.z * _e3175.z)));
let _e3788 = (_e1832 - (_e1833 * _e3786));
let _e3790 = select(1e-9f, _e3788, (_e3788 > 1e-9f));
let _e3802 = ((3.1415927f * (select((_e1838 / (_e3790 * sqrt(select(0f, _e3790, (_e3790 > 0f))))), (0.75f * (1f + (_e3786 * _e3786))), _e1850) * _e1852)) * select((_e3191 * ((2f * (1f + _e3181)) / (_e3184 * _e3184))), 1f, _e3199));
let _e3819 = local_9;
let _e3820 = (_e3819 * 0.65214515f);
phi_2282_ = vec3<f32>(((_e1163.x + (((((_e1565.member_1.x * ((1f + (_e1705 * (1f + (_e1705 * (0.5f + (_e1705 * (0.16666667f + (_e1705 * (0.041666668f + (_e1705 * (0.008333334f + (_e1705 * (0.001388889f + (_e1705 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1700 + 127i)) << bitcast<u32>(23i))))) * _e1865.member) * _e1855) + (((_e2249.member_1.x * ((1f + (_e2365 * (1f + (_e2365 * (0.5f + (_e2365 * (0.16666667f + (_e2365 * (0.041666668f + (_e2365 * (0.008333334f + (_e2365 * (0.001388889f + (_e2365 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2360 + 127i)) << bitcast<u32>(23i))))) * _e1865.member) * _e2503)) * _e2521)) + (((((_e2906.member_1.x * ((1f + (_e3022 * (1f + (_e3022 * (0.5f + (_e3022 * (0.16666667f + (_e3022 * (0.041666668f + (_e3022 * (0.008333334f + (_e3022 * (0.001388889f + (_e3022 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3017 + 127i)) << bitcast<u32>(23i))))) * _e1865.member) * _e3160) + (((_e3548.member_1.x * ((1f + (_e3664 * (1f + (_e3664 * (0.5f + (_e3664 * (0.16666667f + (_e3664 * (0.041666668f + (_e3664 * (0.008333334f + (_e3664 * (0.001388889f + (_e3664 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3659 + 127i)) << bitcast<u32>(23i))))) * _e1865.member) * _e3802)) * _e3820)), ((_e1163.y + (((((_e1565.member_1.y * ((1f + (_e1753 * (1f + (_e1753 * (0.5f + (_e1753 * (0.16666667f + (_e1753 * (0.041666668f + (_e1753 * (0.008333334f + (_e1753 * (0.001388889f + (_e1753 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1748 + 127i)) << bitcast<u32>(23i))))) * _e1865.member_1) * _e1855) + (((_e2249.member_1.y * ((1f + (_e2413 * (1f + (_e2413 * (0.5f + (_e2413 * (0.16666667f + (_e2413 * (0.041666668f + (_e2413 * (0.008333334f + (_e2413 * (0.001388889f + (_e2413 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2408 + 127i)) << bitcast<u32>(23i))))) * _e1865.member_1) * _e2503)) * _e2521)) + (((((_e2906.member_1.y * ((1f + (_e3070 * (1f + (_e3070 * (0.5f + (_e3070 * (0.16666667f + (_e3070 * (0.041666668f + (_e3070 * (0.008333334f + (_e3070 * (0.001388889f + (_e3070 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3065 + 127i)) << bitcast<u32>(23i))))) * _e1865.member_1) * _e3160) + (((_e3548.member_1.y * ((1f + (_e3712 * (1f + (_e3712 * (0.5f + (_e3712 * (0.16666667f + (_e3712 * (0.041666668f + (_e3712 * (0.008333334f + (_e3712 * (0.001388889f + (_e3712 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3707 + 127i)) << bitcast<u32>(23i))))) * _e1865.member_1) * _e3802)) * _e3820)), ((_e1163.z + (((((_e1565.member_1.z * ((1f + (_e1801 * (1f + (_e1801 * (0.5f + (_e1801 * (0.16666667f + (_e1801 * (0.041666668f + (_e1801 * (0.008333334f + (_e1801 * (0.001388889f + (_e1801 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1796 + 127i)) << bitcast<u32>(23i))))) * _e1865.member_2) * _e1855) + (((_e2249.member_1.z * ((1f + (_e2461 * (1f + (_e2461 * (0.5f + (_e2461 * (0.16666667f + (_e2461 * (0.041666668f + (_e2461 * (0.008333334f + (_e2461 * (0.001388889f + (_e2461 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2456 + 127i)) << bitcast<u32>(23i))))) * _e1865.member_2) * _e2503)) * _e2521)) + (((((_e2906.member_1.z * ((1f + (_e3118 * (1f + (_e3118 * (0.5f + (_e3118 * (0.16666667f + (_e3118 * (0.041666668f + (_e3118 * (0.008333334f + (_e3118 * (0.001388889f + (_e3118 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3113 + 127i)) << bitcast<u32>(23i))))) * _e1865.member_2) * _e3160) + (((_e3548.member_1.z * ((1f + (_e3760 * (1f + (_e3760 * (0.5f + (_e3760 * (0.16666667f + (_e3760 * (0.041666668f + (_e3760 * (0.008333334f + (_e3760 * (0.001388889f + (_e3760 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3755 + 127i)) << bitcast<u32>(23i))))) * _e1865.member_2) * _e3802)) * _e3820)));
phi_2284_ = (_e1165 + 1i);
} else {
phi_2282_ = vec3<f32>();
phi_2284_ = i32();
}
let _e3830 = phi_2282_;
let _e3832 = phi_2284_;
continue;
continuing {
phi_2281_ = _e3830;
phi_2283_ = _e3832;
break if !(_e1166);
}
}
let _e6395 = local_45;
phi_6393_ = _e6395;
} else {
phi_6393_ = vec3<f32>(0f, 0f, 0f);
}
let _e3835 = phi_6393_;
phi_6408_ = type_24(_e426.member, _e426.member_1, _e426.member_2, vec3<f32>((_e233 + (_e3835.x * _e723)), (_e244 + (_e3835.y * _e724)), (_e255 + (_e3835.z * _e725))), _e426.member_4, _e426.member_5, _e426.member_6, _e426.member_7);
} else {
phi_6408_ = _e426;
}
let _e3855 = phi_6408_;
let _e3856 = (_e628 == -1i);
let _e3857 = select(_e722, 0f, _e3856);
let _e3861 = (_e718 + (_e466 * _e3857));
let _e3862 = (_e719 + (_e477 * _e3857));
let _e3863 = (_e720 + (_e488 * _e3857));
let _e3864 = vec3<f32>(_e3861, _e3862, _e3863);
let _e3867 = (_e628 >= 0i);
if _e3867 {
let _e3868 = (_e628 * 19i);
let _e3870 = (bitcast<i32>(_e148) - 1i);
let _e3872 = select(_e3870, _e3868, (_e3868 < _e3870));
let _e3878 = global_4.member[bitcast<u32>(select(0i, _e3872, (_e3872 > 0i)))];
let _e3879 = (_e3868 + 1i);
let _e3881 = select(_e3870, _e3879, (_e3879 < _e3870));
let _e3887 = global_4.member[bitcast<u32>(select(0i, _e3881, (_e3881 > 0i)))];
let _e3888 = (_e3868 + 2i);
let _e3890 = select(_e3870, _e3888, (_e3888 < _e3870));
let _e3896 = global_4.member[bitcast<u32>(select(0i, _e3890, (_e3890 > 0i)))];
let _e3897 = (_e3868 + 3i);
let _e3899 = select(_e3870, _e3897, (_e3897 < _e3870));
let _e3905 = global_4.member[bitcast<u32>(select(0i, _e3899, (_e3899 > 0i)))];
let _e3906 = (_e3868 + 4i);
let _e3908 = select(_e3870, _e3906, (_e3906 < _e3870));
let _e3914 = global_4.member[bitcast<u32>(select(0i, _e3908, (_e3908 > 0i)))];
let _e3915 = (_e3868 + 5i);
let _e3917 = select(_e3870, _e3915, (_e3915 < _e3870));
let _e3923 = global_4.member[bitcast<u32>(select(0i, _e3917, (_e3917 > 0i)))];
let _e3924 = (_e3868 + 6i);
let _e3926 = select(_e3870, _e3924, (_e3924 < _e3870));
let _e3932 = global_4.member[bitcast<u32>(select(0i, _e3926, (_e3926 > 0i)))];
let _e3933 = (_e3868 + 7i);
let _e3935 = select(_e3870, _e3933, (_e3933 < _e3870));
let _e3941 = global_4.member[bitcast<u32>(select(0i, _e3935, (_e3935 > 0i)))];
let _e3942 = (_e3868 + 8i);
let _e3944 = select(_e3870, _e3942, (_e3942 < _e3870));
let _e3950 = global_4.member[bitcast<u32>(select(0i, _e3944, (_e3944 > 0i)))];
let _e3951 = (_e3905 - _e3878);
let _e3952 = (_e3914 - _e3887);
let _e3953 = (_e3923 - _e3896);
let _e3954 = (_e3932 - _e3878);
let _e3955 = (_e3941 - _e3887);
let _e3956 = (_e3950 - _e3896);
let _e3959 = ((_e3952 * _e3956) - (_e3953 * _e3955));
let _e3962 = ((_e3953 * _e3954) - (_e3951 * _e3956));
let _e3965 = ((_e3951 * _e3955) - (_e3952 * _e3954));
let _e3966 = (_e3905 - _e3861);
let _e3967 = (_e3914 - _e3862);
let _e3968 = (_e3923 - _e3863);
let _e3969 = (_e3932 - _e3861);
let _e3970 = (_e3941 - _e3862);
let _e3971 = (_e3950 - _e3863);
let _e3985 = (((((_e3967 * _e3971) - (_e3968 * _e3970)) * _e3959) + (((_e3968 * _e3969) - (_e3966 * _e3971)) * _e3962)) + (((_e3966 * _e3970) - (_e3967 * _e3969)) * _e3965));
let _e3987 = select(0f, _e3985, (_e3985 > 0f));
let _e3988 = (_e3878 - _e3861);
let _e3989 = (_e3887 - _e3862);
let _e3990 = (_e3896 - _e3863);
let _e4004 = (((((_e3970 * _e3990) - (_e3971 * _e3989)) * _e3959) + (((_e3971 * _e3988) - (_e3969 * _e3990)) * _e3962)) + (((_e3969 * _e3989) - (_e3970 * _e3988)) * _e3965));
let _e4006 = select(0f, _e4004, (_e4004 > 0f));
let _e4020 = (((((_e3989 * _e3968) - (_e3990 * _e3967)) * _e3959) + (((_e3990 * _e3966) - (_e3988 * _e3968)) * _e3962)) + (((_e3988 * _e3967) - (_e3989 * _e3966)) * _e3965));
let _e4022 = select(0f, _e4020, (_e4020 > 0f));
let _e4024 = ((_e3987 + _e4006) + _e4022);
let _e4026 = select(1e-30f, _e4024, (_e4024 > 1e-30f));
let _e4027 = (_e3987 / _e4026);
let _e4028 = (_e4006 / _e4026);
let _e4029 = (_e4022 / _e4026);
let _e4034 = (((_e3959 * _e3959) + (_e3962 * _e3962)) + (_e3965 * _e3965));
let _e4037 = sqrt(select(0f, _e4034, (_e4034 > 0f)));
let _e4040 = (1f / select(1e-20f, _e4037, (_e4037 > 1e-20f)));
let _e4045 = (_e3868 + 9i);
let _e4047 = select(_e3870, _e4045, (_e4045 < _e3870));
let _e4053 = global_4.member[bitcast<u32>(select(0i, _e4047, (_e4047 > 0i)))];
let _e4054 = (_e3868 + 10i);
let _e4056 = select(_e3870, _e4054, (_e4054 < _e3870));
let _e4062 = global_4.member[bitcast<u32>(select(0i, _e4056, (_e4056 > 0i)))];
let _e4063 = (_e3868 + 11i);
let _e4065 = select(_e3870, _e4063, (_e4063 < _e3870));
let _e4071 = global_4.member[bitcast<u32>(select(0i, _e4065, (_e4065 > 0i)))];
let _e4075 = (_e3868 + 12i);
let _e4077 = select(_e3870, _e4075, (_e4075 < _e3870));
let _e4083 = global_4.member[bitcast<u32>(select(0i, _e4077, (_e4077 > 0i)))];
let _e4084 = (_e3868 + 13i);
let _e4086 = select(_e3870, _e4084, (_e4084 < _e3870));
let _e4092 = global_4.member[bitcast<u32>(select(0i, _e4086, (_e4086 > 0i)))];
let _e4093 = (_e3868 + 14i);
let _e4095 = select(_e3870, _e4093, (_e4093 < _e3870));
let _e4101 = global_4.member[bitcast<u32>(select(0i, _e4095, (_e4095 > 0i)))];
let _e4108 = (_e3868 + 15i);
let _e4110 = select(_e3870, _e4108, (_e4108 < _e3870));
let _e4116 = global_4.member[bitcast<u32>(select(0i, _e4110, (_e4110 > 0i)))];
let _e4117 = (_e3868 + 16i);
let _e4119 = select(_e3870, _e4117, (_e4117 < _e3870));
let _e4125 = global_4.member[bitcast<u32>(select(0i, _e4119, (_e4119 > 0i)))];
let _e4126 = (_e3868 + 17i);
let _e4128 = select(_e3870, _e4126, (_e4126 < _e3870));
let _e4134 = global_4.member[bitcast<u32>(select(0i, _e4128, (_e4128 > 0i)))];
let _e4138 = (((_e4053 * _e4027) + (_e4083 * _e4028)) + (_e4116 * _e4029));
let _e4139 = (((_e4062 * _e4027) + (_e4092 * _e4028)) + (_e4125 * _e4029));
let _e4140 = (((_e4071 * _e4027) + (_e4101 * _e4028)) + (_e4134 * _e4029));
let _e4145 = (((_e4138 * _e4138) + (_e4139 * _e4139)) + (_e4140 * _e4140));
let _e4148 = sqrt(select(0f, _e4145, (_e4145 > 0f)));
let _e4151 = (1f / select(1e-20f, _e4148, (_e4148 > 1e-20f)));
let _e4156 = (_e3868 + 18i);
let _e4158 = select(_e3870, _e4156, (_e4156 < _e3870));
let _e4164 = global_4.member[bitcast<u32>(select(0i, _e4158, (_e4158 > 0i)))];
let _e4173 = (select(select(0i, select(select(i32(_e4164), i32(-2147483648), (_e4164 < -2147483600f)), 2147483647i, (_e4164 > 2147483500f)), (_e4164 == _e4164)), _e628, ((_e957 & 1u) != 0u)) * 10i);
let _e4175 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e4177 = select(_e4175, _e4173, (_e4173 < _e4175));
let _e4183 = global_5.member[bitcast<u32>(select(0i, _e4177, (_e4177 > 0i)))];
let _e4184 = (_e4173 + 1i);
let _e4186 = select(_e4175, _e4184, (_e4184 < _e4175));
let _e4192 = global_5.member[bitcast<u32>(select(0i, _e4186, (_e4186 > 0i)))];
let _e4193 = (_e4173 + 2i);
let _e4195 = select(_e4175, _e4193, (_e4193 < _e4175));
let _e4201 = global_5.member[bitcast<u32>(select(0i, _e4195, (_e4195 > 0i)))];
let _e4205 = (_e4173 + 3i);
let _e4207 = select(_e4175, _e4205, (_e4205 < _e4175));
let _e4213 = global_5.member[bitcast<u32>(select(0i, _e4207, (_e4207 > 0i)))];
let _e4214 = (_e4173 + 4i);
let _e4216 = select(_e4175, _e4214, (_e4214 < _e4175));
let _e4222 = global_5.member[bitcast<u32>(select(0i, _e4216, (_e4216 > 0i)))];
let _e4223 = (_e4173 + 5i);
let _e4225 = select(_e4175, _e4223, (_e4223 < _e4175));
let _e4231 = global_5.member[bitcast<u32>(select(0i, _e4225, (_e4225 > 0i)))];
let _e4238 = (_e4173 + 6i);
let _e4240 = select(_e4175, _e4238, (_e4238 < _e4175));
let _e4246 = global_5.member[bitcast<u32>(select(0i, _e4240, (_e4240 > 0i)))];
let _e4247 = (_e4173 + 7i);
let _e4249 = select(_e4175, _e4247, (_e4247 < _e4175));
let _e4255 = global_5.member[bitcast<u32>(select(0i, _e4249, (_e4249 > 0i)))];
let _e4256 = (_e4173 + 8i);
let _e4258 = select(_e4175, _e4256, (_e4256 < _e4175));
let _e4264 = global_5.member[bitcast<u32>(select(0i, _e4258, (_e4258 > 0i)))];
let _e4272 = (_e4173 + 9i);
let _e4274 = select(_e4175, _e4272, (_e4272 < _e4175));
let _e4280 = global_5.member[bitcast<u32>(select(0i, _e4274, (_e4274 > 0i)))];
phi_7143_ = type_25(_e3864, vec3<f32>((_e3959 * _e4040), (_e3962 * _e4040), (_e3965 * _e4040)), vec3<f32>((_e4138 * _e4151), (_e4139 * _e4151), (_e4140 * _e4151)), vec3<f32>((((_e4183 * _e4027) + (_e4213 * _e4028)) + (_e4246 * _e4029)), (((_e4192 * _e4027) + (_e4222 * _e4028)) + (_e4255 * _e4029)), (((_e4201 * _e4027) + (_e4231 * _e4028)) + (_e4264 * _e4029))), _e4280, true);
} else {
let _e4282 = (_e628 == -3i);
let _e4288 = global_1.member.member_14.member_1.member.member;
let _e4293 = global_1.member.member_14.member_1.member_1;
let _e4299 = global_1.member.member_14.member.member.member;
let _e4304 = global_1.member.member_14.member.member_1;
let _e4314 = vec3<f32>(select(_e4299.member, _e4288.member, _e4282), select(_e4299.member_1, _e4288.member_1, _e4282), select(_e4299.member_2, _e4288.member_2, _e4282));
phi_7143_ = type_25(_e3864, _e4314, _e4314, vec3<f32>(select(_e4304.member, _e4293.member, _e4282), select(_e4304.member_1, _e4293.member_1, _e4282), select(_e4304.member_2, _e4293.member_2, _e4282)), 0f, false);
}
let _e4327 = phi_7143_;
let _e4330 = ((select(0i, _e628, _e3867) * 19i) + 18i);
let _e4332 = (bitcast<i32>(_e148) - 1i);
let _e4334 = select(_e4332, _e4330, (_e4330 < _e4332));
let _e4340 = global_4.member[bitcast<u32>(select(0i, _e4334, (_e4334 > 0i)))];
let _e4347 = select(0i, select(select(i32(_e4340), i32(-2147483648), (_e4340 < -2147483600f)), 2147483647i, (_e4340 > 2147483500f)), (_e4340 == _e4340));
let _e4348 = (_e4347 * 4i);
let _e4350 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e4352 = select(_e4350, _e4348, (_e4348 < _e4350));
let _e4358 = global_7.member[bitcast<u32>(select(0i, _e4352, (_e4352 > 0i)))];
if _e3867 {
phi_7207_ = (select(_e4358, 1f, (_e4347 == 16i)) == 0f);
} else {
phi_7207_ = (_e628 != -1i);
}
let _e4364 = phi_7207_;
if _e636 {
let _e4373 = type_24(select(_e722, 1e30f, _e3856), _e3855.member_1, _e3855.member_2, _e3855.member_3, _e3855.member_4, _e3855.member_5, _e3855.member_6, _e3855.member_7);
let _e4383 = type_24(_e4373.member, select(_e722, _e801, (_e801 < _e722)), _e4373.member_2, _e4373.member_3, _e4373.member_4, _e4373.member_5, _e4373.member_6, _e4373.member_7);
let _e4394 = select(1f, -1f, ((((_e4327.member_1.x * _e466) + (_e4327.member_1.y * _e477)) + (_e4327.member_1.z * _e488)) > 0f));
let _e4406 = select(_e4394, -(_e4394), ((((_e4327.member_2.x * _e4327.member_1.x) + (_e4327.member_2.y * _e4327.member_1.y)) + (_e4327.member_2.z * _e4327.member_1.z)) < 0f));
let _e4407 = (_e4327.member_2.x * _e4406);
let _e4408 = (_e4327.member_2.y * _e4406);
let _e4409 = (_e4327.member_2.z * _e4406);
let _e4418 = ((((_e4407 * _e466) + (_e4408 * _e477)) + (_e4409 * _e488)) > 0f);
let _e4433 = type_24(_e4383.member, _e4383.member_1, _e4383.member_2, _e4383.member_3, _e4383.member_4, _e4383.member_5, _e4383.member_6, vec3<f32>(select(select(_e4407, (_e4327.member_1.x * _e4394), _e4418), 0f, _e3856), select(select(_e4408, (_e4327.member_1.y * _e4394), _e4418), 0f, _e3856), select(select(_e4409, (_e4327.member_1.z * _e4394), _e4418), 0f, _e3856)));
let _e4437 = (1f - (((_e858 + _e906) + _e954) * _e962));
let _e4441 = global_1.member.member_15.member_12;
phi_7321_ = type_24(_e4433.member, _e4433.member_1, _e4433.member_2, _e4433.member_3, _e4433.member_4, _e4433.member_5, select(1f, select(_e4437, _e4441, (_e4441 > _e4437)), _e3856), _e4433.member_7);
} else {
phi_7321_ = _e3855;
}
let _e4454 = phi_7321_;
if _e3856 {
let _e4459 = (((_e499 * _e499) + (_e510 * _e510)) + (_e521 * _e521));
let _e4462 = sqrt(select(0f, _e4459, (_e4459 > 0f)));
let _e4467 = (((_e532 * _e532) + (_e543 * _e543)) + (_e554 * _e554));
let _e4470 = sqrt(select(0f, _e4467, (_e4467 > 0f)));
let _e4472 = select(_e4470, _e4462, (_e4462 > _e4470));
let _e4476 = global_1.member.member_15.member_4;
let _e4484 = (((_e4476.member * _e466) + (_e4476.member_1 * _e477)) + (_e4476.member_2 * _e488));
let _e4488 = global_1.member.member_15.member_5;
let _e4496 = (((_e4488.member * _e466) + (_e4488.member_1 * _e477)) + (_e4488.member_2 * _e488));
let _e4500 = global_1.member.member_15.member_6;
let _e4508 = (((_e4500.member * _e466) + (_e4500.member_1 * _e477)) + (_e4500.member_2 * _e488));
let _e4512 = global_1.member.member_15.member;
let _e4516 = global_1.member.member_15.member_7;
let _e4520 = vec3<f32>(_e4516.member, _e4516.member_1, _e4516.member_2);
let _e4524 = global_1.member.member_15.member_8;
if (_e4512 == 0u) {
phi_8810_ = _e4520;
} else {
if (_e4512 == 1u) {
let _e4531 = select(-1f, _e4508, (_e4508 > -1f));
let _e4533 = select(1f, _e4531, (_e4531 < 1f));
if (_e4533 > 0f) {
phi_7425_ = _e4520;
} else {
let _e4538 = global_1.member.member_15.member_9;
phi_7425_ = vec3<f32>(_e4538.member, _e4538.member_1, _e4538.member_2);
}
let _e4544 = phi_7425_;
let _e4553 = bitcast<f32>((bitcast<u32>(_e4533) & 2147483647u));
let _e4556 = sqrt(select(0f, _e4553, (_e4553 > 0f)));
phi_8809_ = vec3<f32>((_e4524.member + ((_e4544.x - _e4524.member) * _e4556)), (_e4524.member_1 + ((_e4544.y - _e4524.member_1) * _e4556)), (_e4524.member_2 + ((_e4544.z - _e4524.member_2) * _e4556)));
} else {
if (_e4512 == 2u) {
let _e4568 = global_1.member.member_15.member_10;
let _e4569 = (_e4472 / _e4568);
let _e4571 = select(1e-4f, _e4569, (_e4569 > 1e-4f));
let _e4574 = bitcast<f32>((bitcast<u32>(_e4484) & 2147483647u));
let _e4577 = bitcast<f32>((bitcast<u32>(_e4496) & 2147483647u));
let _e4581 = select(_e4577, _e4574, (_e4574 > _e4577));
let _e4584 = (select(_e4577, _e4574, (_e4574 < _e4577)) / select(1.1754944e-38f, _e4581, (_e4581 > 1.1754944e-38f)));
let _e4585 = (_e4584 > 0.41421357f);
let _e4589 = select(_e4584, ((_e4584 - 1f) / (_e4584 + 1f)), _e4585);
let _e4590 = (_e4589 * _e4589);
let _e4605 = (select(0f, 0.7853982f, _e4585) + (_e4589 + ((_e4589 * _e4590) * (-0.33333334f + (_e4590 * (0.2f + (_e4590 * (-0.14285713f + (_e4590 * (0.11111111f + (_e4590 * (-0.09090909f + (_e4590 * 0.0585f)))))))))))));
let _e4608 = select(_e4605, (1.5707964f - _e4605), (_e4577 > _e4574));
let _e4611 = select(_e4608, (3.1415927f - _e4608), (_e4484 < 0f));
let _e4617 = (1f - (_e4508 * _e4508));
let _e4620 = sqrt(select(0f, _e4617, (_e4617 > 0f)));
let _e4623 = (_e4571 / select(1e-3f, _e4620, (_e4620 > 1e-3f)));
let _e4624 = ((select(_e4611, -(_e4611), (_e4496 < 0f)) / _e4568) * 0.5f);
let _e4626 = select(-8e6f, _e4624, (_e4624 > -8e6f));
let _e4628 = select(8e6f, _e4626, (_e4626 < 8e6f));
let _e4635 = select(0i, select(select(i32(_e4628), i32(-2147483648), (_e4628 < -2147483600f)), 2147483647i, (_e4628 > 2147483500f)), (_e4628 == _e4628));
let _e4642 = ((_e4624 - f32((_e4635 - select(0i, 1i, (_e4628 < f32(_e4635)))))) * 2f);
let _e4650 = ((select(select((_e4642 - 2f), (1f - _e4642), (_e4642 < 1.5f)), _e4642, (_e4642 < 0.5f)) * 2f) / _e4623);
let _e4652 = select(-1f, _e4650, (_e4650 > -1f));
let _e4655 = (2f - _e4623);
let _e4657 = select(0f, _e4655, (_e4655 > 0f));
let _e4662 = select(-1f, _e4508, (_e4508 > -1f));
let _e4664 = select(1f, _e4662, (_e4662 < 1f));
let _e4667 = ((1f - _e4664) * (1f + _e4664));
let _e4670 = sqrt(select(0f, _e4667, (_e4667 > 0f)));
let _e4673 = bitcast<f32>((bitcast<u32>(_e4670) & 2147483647u));
let _e4676 = bitcast<f32>((bitcast<u32>(_e4664) & 2147483647u));
let _e4680 = select(_e4676, _e4673, (_e4673 > _e4676));
let _e4683 = (select(_e4676, _e4673, (_e4673 < _e4676)) / select(1.1754944e-38f, _e4680, (_e4680 > 1.1754944e-38f)));
let _e4684 = (_e4683 > 0.41421357f);
let _e4688 = select(_e4683, ((_e4683 - 1f) / (_e4683 + 1f)), _e4684);
let _e4689 = (_e4688 * _e4688);
let _e4704 = (select(0f, 0.7853982f, _e4684) + (_e4688 + ((_e4688 * _e4689) * (-0.33333334f + (_e4689 * (0.2f + (_e4689 * (-0.14285713f + (_e4689 * (0.11111111f + (_e4689 * (-0.09090909f + (_e4689 * 0.0585f)))))))))))));
let _e4707 = select(_e4704, (1.5707964f - _e4704), (_e4676 > _e4673));
let _e4710 = select(_e4707, (3.1415927f - _e4707), (_e4670 < 0f));
let _e4715 = ((select(_e4710, -(_e4710), (_e4664 < 0f)) / _e4568) * 0.5f);
let _e4717 = select(-8e6f, _e4715, (_e4715 > -8e6f));
let _e4719 = select(8e6f, _e4717, (_e4717 < 8e6f));
let _e4726 = select(0i, select(select(i32(_e4719), i32(-2147483648), (_e4719 < -2147483600f)), 2147483647i, (_e4719 > 2147483500f)), (_e4719 == _e4719));
let _e4733 = ((_e4715 - f32((_e4726 - select(0i, 1i, (_e4719 < f32(_e4726)))))) * 2f);
let _e4741 = ((select(select((_e4733 - 2f), (1f - _e4733), (_e4733 < 1.5f)), _e4733, (_e4733 < 0.5f)) * 2f) / _e4571);
let _e4743 = select(-1f, _e4741, (_e4741 > -1f));
let _e4746 = (2f - _e4571);
let _e4748 = select(0f, _e4746, (_e4746 > 0f));
let _e4754 = (0.5f + ((0.5f * (select(1f, _e4652, (_e4652 < 1f)) * select(1f, _e4657, (_e4657 < 1f)))) * (select(1f, _e4743, (_e4743 < 1f)) * select(1f, _e4748, (_e4748 < 1f)))));
phi_8808_ = vec3<f32>((_e4516.member + ((_e4524.member - _e4516.member) * _e4754)), (_e4516.member_1 + ((_e4524.member_1 - _e4516.member_1) * _e4754)), (_e4516.member_2 + ((_e4524.member_2 - _e4516.member_2) * _e4754)));
} else {
let _e4768 = global_1.member.member_15.member_1;
let _e4769 = bitcast<i32>(_e4768);
let _e4774 = global_1.member.member_15.member_3;
let _e4776 = f32(bitcast<i32>(_e4774));
let _e4778 = (2f * 3.1415927f);
let _e4779 = ((_e4472 * f32(_e4769)) / _e4778);
let _e4781 = select(1e-6f, _e4779, (_e4779 > 1e-6f));
let _e4784 = bitcast<u32>(select(1.1754944e-38f, _e4781, (_e4781 > 1.1754944e-38f)));
let _e4785 = (_e4784 & 8388607u);
let _e4787 = select(0u, 1u, (_e4785 > 3474675u));
let _e4798 = bitcast<f32>((_e4785 | ((127u - _e4787) << bitcast<u32>(23i))));
let _e4801 = ((_e4798 - 1f) / (_e4798 + 1f));
let _e4802 = (_e4801 * _e4801);
let _e4817 = (f32(((bitcast<i32>((_e4784 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e4787))) + (((2f * _e4801) + ((_e4801 * _e4802) * (0.6666667f + (_e4802 * (0.4f + (_e4802 * (0.2857143f + (_e4802 * (0.22222222f + (_e4802 * 0.18181819f)))))))))) * 1.442695f));
let _e4818 = (_e4776 - 1f);
let _e4820 = select(0f, _e4817, (_e4817 > 0f));
let _e4822 = select(_e4818, _e4820, (_e4820 < _e4818));
let _e4823 = (_e4776 - 2f);
let _e4825 = select(0f, _e4823, (_e4823 > 0f));
let _e4827 = select(0f, _e4822, (_e4822 > 0f));
let _e4829 = select(_e4825, _e4827, (_e4827 < _e4825));
let _e4836 = select(0i, select(select(i32(_e4829), i32(-2147483648), (_e4829 < -2147483600f)), 2147483647i, (_e4829 > 2147483500f)), (_e4829 == _e4829));
let _e4840 = (_e4836 - select(0i, 1i, (_e4829 < f32(_e4836))));
let _e4843 = bitcast<f32>((bitcast<u32>(_e4496) & 2147483647u));
let _e4846 = bitcast<f32>((bitcast<u32>(_e4484) & 2147483647u));
let _e4850 = select(_e4846, _e4843, (_e4843 > _e4846));
let _e4853 = (select(_e4846, _e4843, (_e4843 < _e4846)) / select(1.1754944e-38f, _e4850, (_e4850 > 1.1754944e-38f)));
let _e4854 = (_e4853 > 0.41421357f);
let _e4858 = select(_e4853, ((_e4853 - 1f) / (_e4853 + 1f)), _e4854);
let _e4859 = (_e4858 * _e4858);
let _e4874 = (select(0f, 0.7853982f, _e4854) + (_e4858 + ((_e4858 * _e4859) * (-0.33333334f + (_e4859 * (0.2f + (_e4859 * (-0.14285713f + (_e4859 * (0.11111111f + (_e4859 * (-0.09090909f + (_e4859 * 0.0585f)))))))))))));
let _e4877 = select(_e4874, (1.5707964f - _e4874), (_e4846 > _e4843));
let _e4880 = select(_e4877, (3.1415927f - _e4877), (_e4496 < 0f));
let _e4885 = (0.5f - (select(_e4880, -(_e4880), (_e4484 < 0f)) / _e4778));
let _e4887 = select(-1f, _e4508, (_e4508 > -1f));
let _e4889 = select(1f, _e4887, (_e4887 < 1f));
let _e4892 = ((1f - _e4889) * (1f + _e4889));
let _e4895 = sqrt(select(0f, _e4892, (_e4892 > 0f)));
let _e4898 = bitcast<f32>((bitcast<u32>(_e4895) & 2147483647u));
let _e4901 = bitcast<f32>((bitcast<u32>(_e4889) & 2147483647u));
let _e4905 = select(_e4901, _e4898, (_e4898 > _e4901));
let _e4908 = (select(_e4901, _e4898, (_e4898 < _e4901)) / select(1.1754944e-38f, _e4905, (_e4905 > 1.1754944e-38f)));
let _e4909 = (_e4908 > 0.41421357f);
let _e4913 = select(_e4908, ((_e4908 - 1f) / (_e4908 + 1f)), _e4909);
let _e4914 = (_e4913 * _e4913);
let _e4929 = (select(0f, 0.7853982f, _e4909) + (_e4913 + ((_e4913 * _e4914) * (-0.33333334f + (_e4914 * (0.2f + (_e4914 * (-0.14285713f + (_e4914 * (0.11111111f + (_e4914 * (-0.09090909f + (_e4914 * 0.0585f)))))))))))));
let _e4932 = select(_e4929, (1.5707964f - _e4929), (_e4901 > _e4898));
let _e4935 = select(_e4932, (3.1415927f - _e4932), (_e4895 < 0f));
let _e4940 = (0.5f - (select(_e4935, -(_e4935), (_e4889 < 0f)) / 3.1415927f));
let _e4944 = global_1.member.member_15.member_2;
let _e4945 = bitcast<i32>(_e4944);
phi_8027_ = 0i;
phi_8030_ = 0i;
phi_8032_ = _e4945;
phi_8034_ = _e4769;
loop {
let _e4947 = phi_8027_;
let _e4949 = phi_8030_;
let _e4951 = phi_8032_;
let _e4953 = phi_8034_;
local_13 = _e4953;
local_14 = _e4951;
local_15 = _e4953;
local_16 = _e4953;
local_17 = _e4953;
local_18 = _e4953;
local_19 = _e4953;
local_20 = _e4953;
local_21 = _e4951;
local_22 = _e4951;
local_23 = _e4951;
local_24 = _e4951;
local_25 = _e4953;
local_26 = _e4949;
local_27 = _e4953;
local_28 = _e4949;
let _e4954 = (_e4947 < _e4840);
if _e4954 {
if (_e4953 > 1i) {
phi_8049_ = (_e4953 >> bitcast<u32>(1i));
} else {
phi_8049_ = 1i;
}
let _e4961 = phi_8049_;
if (_e4951 > 1i) {
phi_8055_ = (_e4951 >> bitcast<u32>(1i));
} else {
phi_8055_ = 1i;
}
let _e4966 = phi_8055_;
phi_8028_ = (_e4947 + 1i);
phi_8031_ = (_e4949 + (_e4953 * _e4951));
phi_8033_ = _e4966;
phi_8035_ = _e4961;
} else {
phi_8028_ = i32();
phi_8031_ = i32();
phi_8033_ = i32();
phi_8035_ = i32();
}
let _e4969 = phi_8028_;
let _e4971 = phi_8031_;
let _e4973 = phi_8033_;
let _e4975 = phi_8035_;
continue;
continuing {
phi_8027_ = _e4969;
phi_8030_ = _e4971;
phi_8032_ = _e4973;
phi_8034_ = _e4975;
break if !(_e4954);
}
}
let _e4978 = local_13;
let _e4979 = f32(_e4978);
let _e4981 = ((_e4885 * _e4979) - 0.5f);
let _e4983 = local_14;
let _e4984 = f32(_e4983);
let _e4986 = ((_e4940 * _e4984) - 0.5f);
let _e4988 = select(-1f, _e4981, (_e4981 > -1f));
let _e4990 = select(_e4979, _e4988, (_e4988 < _e4979));
let _e4997 = select(0i, select(select(i32(_e4990), i32(-2147483648), (_e4990 < -2147483600f)), 2147483647i, (_e4990 > 2147483500f)), (_e4990 == _e4990));
let _e5001 = (_e4997 - select(0i, 1i, (_e4990 < f32(_e4997))));
let _e5003 = select(-1f, _e4986, (_e4986 > -1f));
let _e5005 = select(_e4984, _e5003, (_e5003 < _e4984));
let _e5012 = select(0i, select(select(i32(_e5005), i32(-2147483648), (_e5005 < -2147483600f)), 2147483647i, (_e5005 > 2147483500f)), (_e5005 == _e5005));
let _e5016 = (_e5012 - select(0i, 1i, (_e5005 < f32(_e5012))));
let _e5018 = (_e4981 - f32(_e5001));
let _e5020 = (_e4986 - f32(_e5016));
let _e5022 = select(0f, _e5020, (_e5020 > 0f));
let _e5024 = select(1f, _e5022, (_e5022 < 1f));
if (_e5001 < 0i) {
let _e5027 = local_15;
phi_8130_ = (_e5001 + _e5027);
} else {
phi_8130_ = _e5001;
}
let _e5030 = phi_8130_;
let _e5032 = local_16;
if (_e5030 >= _e5032) {
let _e5035 = local_17;
phi_8136_ = (_e5030 - _e5035);
} else {
phi_8136_ = _e5030;
}
let _e5038 = phi_8136_;
let _e5039 = (_e5001 + 1i);
if (_e5039 < 0i) {
let _e5042 = local_18;
phi_8143_ = (_e5039 + _e5042);
} else {
phi_8143_ = _e5039;
}
let _e5045 = phi_8143_;
let _e5047 = local_19;
if (_e5045 >= _e5047) {
let _e5050 = local_20;
phi_8149_ = (_e5045 - _e5050);
} else {
phi_8149_ = _e5045;
}
let _e5053 = phi_8149_;
let _e5055 = select(_e5016, 0i, (_e5016 < 0i));
let _e5057 = local_21;
if (_e5055 >= _e5057) {
let _e5060 = local_22;
phi_8160_ = (_e5060 - 1i);
} else {
phi_8160_ = _e5055;
}
let _e5063 = phi_8160_;
let _e5064 = (_e5016 + 1i);
let _e5066 = select(_e5064, 0i, (_e5064 < 0i));
let _e5068 = local_23;
if (_e5066 >= _e5068) {
let _e5071 = local_24;
phi_8172_ = (_e5071 - 1i);
} else {
phi_8172_ = _e5066;
}
let _e5074 = phi_8172_;
let _e5076 = local_25;
let _e5079 = local_26;
let _e5080 = (_e5079 + (_e5063 * _e5076));
let _e5082 = local_27;
let _e5085 = local_28;
let _e5086 = (_e5085 + (_e5074 * _e5082));
let _e5088 = (3i * (_e5080 + _e5038));
let _e5090 = (bitcast<i32>(_e146) - 1i);
let _e5092 = select(_e5090, _e5088, (_e5088 < _e5090));
let _e5098 = global_3.member[bitcast<u32>(select(0i, _e5092, (_e5092 > 0i)))];
let _e5099 = (_e5088 + 1i);
let _e5101 = select(_e5090, _e5099, (_e5099 < _e5090));
let _e5107 = global_3.member[bitcast<u32>(select(0i, _e5101, (_e5101 > 0i)))];
let _e5108 = (_e5088 + 2i);
let _e5110 = select(_e5090, _e5108, (_e5108 < _e5090));
let _e5116 = global_3.member[bitcast<u32>(select(0i, _e5110, (_e5110 > 0i)))];
let _e5118 = (3i * (_e5080 + _e5053));
let _e5120 = select(_e5090, _e5118, (_e5118 < _e5090));
let _e5126 = global_3.member[bitcast<u32>(select(0i, _e5120, (_e5120 > 0i)))];
let _e5127 = (_e5118 + 1i);
let _e5129 = select(_e5090, _e5127, (_e5127 < _e5090));
let _e5135 = global_3.member[bitcast<u32>(select(0i, _e5129, (_e5129 > 0i)))];
let _e5136 = (_e5118 + 2i);
let _e5138 = select(_e5090, _e5136, (_e5136 < _e5090));
let _e5144 = global_3.member[bitcast<u32>(select(0i, _e5138, (_e5138 > 0i)))];
let _e5146 = (3i * (_e5086 + _e5038));
let _e5148 = select(_e5090, _e5146, (_e5146 < _e5090));
let _e5154 = global_3.member[bitcast<u32>(select(0i, _e5148, (_e5148 > 0i)))];
let _e5155 = (_e5146 + 1i);
let _e5157 = select(_e5090, _e5155, (_e5155 < _e5090));
let _e5163 = global_3.member[bitcast<u32>(select(0i, _e5157, (_e5157 > 0i)))];
let _e5164 = (_e5146 + 2i);
let _e5166 = select(_e5090, _e5164, (_e5164 < _e5090));
let _e5172 = global_3.member[bitcast<u32>(select(0i, _e5166, (_e5166 > 0i)))];
let _e5174 = (3i * (_e5086 + _e5053));
let _e5176 = select(_e5090, _e5174, (_e5174 < _e5090));
let _e5182 = global_3.member[bitcast<u32>(select(0i, _e5176, (_e5176 > 0i)))];
let _e5183 = (_e5174 + 1i);
let _e5185 = select(_e5090, _e5183, (_e5183 < _e5090));
let _e5191 = global_3.member[bitcast<u32>(select(0i, _e5185, (_e5185 > 0i)))];
let _e5192 = (_e5174 + 2i);
let _e5194 = select(_e5090, _e5192, (_e5192 < _e5090));
let _e5200 = global_3.member[bitcast<u32>(select(0i, _e5194, (_e5194 > 0i)))];
let _e5207 = (_e5098 + ((_e5126 - _e5098) * _e5018));
let _e5208 = (_e5107 + ((_e5135 - _e5107) * _e5018));
let _e5209 = (_e5116 + ((_e5144 - _e5116) * _e5018));
let _e5225 = (_e5207 + (((_e5154 + ((_e5182 - _e5154) * _e5018)) - _e5207) * _e5024));
let _e5226 = (_e5208 + (((_e5163 + ((_e5191 - _e5163) * _e5018)) - _e5208) * _e5024));
let _e5227 = (_e5209 + (((_e5172 + ((_e5200 - _e5172) * _e5018)) - _e5209) * _e5024));
phi_8408_ = 0i;
phi_8411_ = 0i;
phi_8413_ = _e4945;
phi_8415_ = _e4769;
loop {
let _e5230 = phi_8408_;
let _e5232 = phi_8411_;
let _e5234 = phi_8413_;
let _e5236 = phi_8415_;
local_29 = _e5236;
local_30 = _e5234;
local_31 = _e5236;
local_32 = _e5236;
local_33 = _e5236;
local_34 = _e5236;
local_35 = _e5236;
local_36 = _e5236;
local_37 = _e5234;
local_38 = _e5234;
local_39 = _e5234;
local_40 = _e5234;
local_41 = _e5236;
local_42 = _e5232;
local_43 = _e5236;
local_44 = _e5232;
let _e5237 = (_e5230 < (_e4840 + 1i));
if _e5237 {
if (_e5236 > 1i) {
phi_8430_ = (_e5236 >> bitcast<u32>(1i));
} else {
phi_8430_ = 1i;
}
let _e5244 = phi_8430_;
if (_e5234 > 1i) {
phi_8436_ = (_e5234 >> bitcast<u32>(1i));
} else {
phi_8436_ = 1i;
}
let _e5249 = phi_8436_;
phi_8409_ = (_e5230 + 1i);
phi_8412_ = (_e5232 + (_e5236 * _e5234));
phi_8414_ = _e5249;
phi_8416_ = _e5244;
} else {
phi_8409_ = i32();
phi_8412_ = i32();
phi_8414_ = i32();
phi_8416_ = i32();
}
let _e5252 = phi_8409_;
let _e5254 = phi_8412_;
let _e5256 = phi_8414_;
let _e5258 = phi_8416_;
continue;
continuing {
phi_8408_ = _e5252;
phi_8411_ = _e5254;
phi_8413_ = _e5256;
phi_8415_ = _e5258;
break if !(_e5237);
}
}
let _e5261 = local_29;
let _e5262 = f32(_e5261);
let _e5264 = ((_e4885 * _e5262) - 0.5f);
let _e5266 = local_30;
let _e5267 = f32(_e5266);
let _e5269 = ((_e4940 * _e5267) - 0.5f);
let _e5271 = select(-1f, _e5264, (_e5264 > -1f));
let _e5273 = select(_e5262, _e5271, (_e5271 < _e5262));
let _e5280 = select(0i, select(select(i32(_e5273), i32(-2147483648), (_e5273 < -2147483600f)), 2147483647i, (_e5273 > 2147483500f)), (_e5273 == _e5273));
let _e5284 = (_e5280 - select(0i, 1i, (_e5273 < f32(_e5280))));
let _e5286 = select(-1f, _e5269, (_e5269 > -1f));
let _e5288 = select(_e5267, _e5286, (_e5286 < _e5267));
let _e5295 = select(0i, select(select(i32(_e5288), i32(-2147483648), (_e5288 < -2147483600f)), 2147483647i, (_e5288 > 2147483500f)), (_e5288 == _e5288));
let _e5299 = (_e5295 - select(0i, 1i, (_e5288 < f32(_e5295))));
let _e5301 = (_e5264 - f32(_e5284));
let _e5303 = (_e5269 - f32(_e5299));
let _e5305 = select(0f, _e5303, (_e5303 > 0f));
let _e5307 = select(1f, _e5305, (_e5305 < 1f));
if (_e5284 < 0i) {
let _e5310 = local_31;
phi_8511_ = (_e5284 + _e5310);
} else {
phi_8511_ = _e5284;
}
let _e5313 = phi_8511_;
let _e5315 = local_32;
if (_e5313 >= _e5315) {
let _e5318 = local_33;
phi_8517_ = (_e5313 - _e5318);
} else {
phi_8517_ = _e5313;
}
let _e5321 = phi_8517_;
let _e5322 = (_e5284 + 1i);
if (_e5322 < 0i) {
let _e5325 = local_34;
phi_8524_ = (_e5322 + _e5325);
} else {
phi_8524_ = _e5322;
}
let _e5328 = phi_8524_;
let _e5330 = local_35;
if (_e5328 >= _e5330) {
let _e5333 = local_36;
phi_8530_ = (_e5328 - _e5333);
} else {
phi_8530_ = _e5328;
}
let _e5336 = phi_8530_;
let _e5338 = select(_e5299, 0i, (_e5299 < 0i));
let _e5340 = local_37;
if (_e5338 >= _e5340) {
let _e5343 = local_38;
phi_8541_ = (_e5343 - 1i);
} else {
phi_8541_ = _e5338;
}
let _e5346 = phi_8541_;
let _e5347 = (_e5299 + 1i);
let _e5349 = select(_e5347, 0i, (_e5347 < 0i));
let _e5351 = local_39;
if (_e5349 >= _e5351) {
let _e5354 = local_40;
phi_8553_ = (_e5354 - 1i);
} else {
phi_8553_ = _e5349;
}
let _e5357 = phi_8553_;
let _e5359 = local_41;
let _e5362 = local_42;
let _e5363 = (_e5362 + (_e5346 * _e5359));
let _e5365 = local_43;
let _e5368 = local_44;
let _e5369 = (_e5368 + (_e5357 * _e5365));
let _e5371 = (3i * (_e5363 + _e5321));
let _e5373 = select(_e5090, _e5371, (_e5371 < _e5090));
let _e5379 = global_3.member[bitcast<u32>(select(0i, _e5373, (_e5373 > 0i)))];
let _e5380 = (_e5371 + 1i);
let _e5382 = select(_e5090, _e5380, (_e5380 < _e5090));
let _e5388 = global_3.member[bitcast<u32>(select(0i, _e5382, (_e5382 > 0i)))];
let _e5389 = (_e5371 + 2i);
let _e5391 = select(_e5090, _e5389, (_e5389 < _e5090));
let _e5397 = global_3.member[bitcast<u32>(select(0i, _e5391, (_e5391 > 0i)))];
let _e5399 = (3i * (_e5363 + _e5336));
let _e5401 = select(_e5090, _e5399, (_e5399 < _e5090));
let _e5407 = global_3.member[bitcast<u32>(select(0i, _e5401, (_e5401 > 0i)))];
let _e5408 = (_e5399 + 1i);
let _e5410 = select(_e5090, _e5408, (_e5408 < _e5090));
let _e5416 = global_3.member[bitcast<u32>(select(0i, _e5410, (_e5410 > 0i)))];
let _e5417 = (_e5399 + 2i);
let _e5419 = select(_e5090, _e5417, (_e5417 < _e5090));
let _e5425 = global_3.member[bitcast<u32>(select(0i, _e5419, (_e5419 > 0i)))];
let _e5427 = (3i * (_e5369 + _e5321));
let _e5429 = select(_e5090, _e5427, (_e5427 < _e5090));
let _e5435 = global_3.member[bitcast<u32>(select(0i, _e5429, (_e5429 > 0i)))];
let _e5436 = (_e5427 + 1i);
let _e5438 = select(_e5090, _e5436, (_e5436 < _e5090));
let _e5444 = global_3.member[bitcast<u32>(select(0i, _e5438, (_e5438 > 0i)))];
let _e5445 = (_e5427 + 2i);
let _e5447 = select(_e5090, _e5445, (_e5445 < _e5090));
let _e5453 = global_3.member[bitcast<u32>(select(0i, _e5447, (_e5447 > 0i)))];
let _e5455 = (3i * (_e5369 + _e5336));
let _e5457 = select(_e5090, _e5455, (_e5455 < _e5090));
let _e5463 = global_3.member[bitcast<u32>(select(0i, _e5457, (_e5457 > 0i)))];
let _e5464 = (_e5455 + 1i);
let _e5466 = select(_e5090, _e5464, (_e5464 < _e5090));
let _e5472 = global_3.member[bitcast<u32>(select(0i, _e5466, (_e5466 > 0i)))];
let _e5473 = (_e5455 + 2i);
let _e5475 = select(_e5090, _e5473, (_e5473 < _e5090));
let _e5481 = global_3.member[bitcast<u32>(select(0i, _e5475, (_e5475 > 0i)))];
let _e5488 = (_e5379 + ((_e5407 - _e5379) * _e5301));
let _e5489 = (_e5388 + ((_e5416 - _e5388) * _e5301));
let _e5490 = (_e5397 + ((_e5425 - _e5397) * _e5301));
let _e5513 = (_e4822 - f32(_e4840));
let _e5515 = select(0f, _e5513, (_e5513 > 0f));
let _e5517 = select(1f, _e5515, (_e5515 < 1f));
let _e5527 = global_1.member.member_15.member_11;
phi_8808_ = vec3<f32>(((_e5225 + (((_e5488 + (((_e5435 + ((_e5463 - _e5435) * _e5301)) - _e5488) * _e5307)) - _e5225) * _e5517)) * _e5527), ((_e5226 + (((_e5489 + (((_e5444 + ((_e5472 - _e5444) * _e5301)) - _e5489) * _e5307)) - _e5226) * _e5517)) * _e5527), ((_e5227 + (((_e5490 + (((_e5453 + ((_e5481 - _e5453) * _e5301)) - _e5490) * _e5307)) - _e5227) * _e5517)) * _e5527));
}
let _e5533 = phi_8808_;
phi_8809_ = _e5533;
}
let _e5535 = phi_8809_;
phi_8810_ = _e5535;
}
let _e5537 = phi_8810_;
let _e5541 = global_1.member.member_15.member_12;
let _e5542 = select(1f, _e5541, _e636);
phi_9918_ = type_24(_e4454.member, _e4454.member_1, vec3<f32>((_e4454.member_2.x + (((_e5537.x * _e858) * _e723) * _e5542)), (_e4454.member_2.y + (((_e5537.y * _e906) * _e724) * _e5542)), (_e4454.member_2.z + (((_e5537.z * _e954) * _e725) * _e5542))), _e4454.member_3, _e4454.member_4, _e4454.member_5, _e4454.member_6, _e4454.member_7);
} else {
if _e4364 {
let _e5577 = global_1.member.member_10.member_2;
let _e5585 = global_1.member.member_10.member;
let _e5586 = (_e5585 == 0u);
if _e5586 {
let _e5590 = global_1.member.member_10.member_1;
phi_9366_ = type_26(vec3<f32>(_e5590.member, _e5590.member_1, _e5590.member_2), vec3<f32>(_e5577.member, _e5577.member_1, _e5577.member_2));
} else {
let _e5599 = global_1.member.member_10.member_3;
let _e5604 = (_e4327.member.x - _e5599.member);
let _e5606 = (_e4327.member.y - _e5599.member_1);
let _e5608 = (_e4327.member.z - _e5599.member_2);
let _e5613 = (((_e5604 * _e5604) + (_e5606 * _e5606)) + (_e5608 * _e5608));
let _e5615 = select(1e-12f, _e5613, (_e5613 > 1e-12f));
let _e5616 = (1f / _e5615);
let _e5620 = vec3<f32>((_e5577.member * _e5616), (_e5577.member_1 * _e5616), (_e5577.member_2 * _e5616));
if (_e5585 == 2u) {
let _e5625 = global_1.member.member_10.member_1;
let _e5633 = (((_e5625.member * _e5604) + (_e5625.member_1 * _e5606)) + (_e5625.member_2 * _e5608));
let _e5636 = (1f / select(1e-20f, _e5633, (_e5633 > 1e-20f)));
let _e5641 = global_1.member.member_10.member_4.member;
let _e5650 = ((((_e5641.member * _e5604) + (_e5641.member_1 * _e5606)) + (_e5641.member_2 * _e5608)) * _e5636);
let _e5655 = global_1.member.member_10.member_4.member_1;
let _e5664 = ((((_e5655.member * _e5604) + (_e5655.member_1 * _e5606)) + (_e5655.member_2 * _e5608)) * _e5636);
let _e5669 = global_1.member.member_10.member_4.member_2;
let _e5672 = ((_e5650 * _e5650) + (_e5664 * _e5664));
let _e5681 = global_1.member.member_10.member_4.member_3;
let _e5682 = ((_e5669 - sqrt(select(0f, _e5672, (_e5672 > 0f)))) * _e5681);
let _e5684 = select(0f, _e5682, (_e5682 > 0f));
let _e5686 = select(1f, _e5684, (_e5684 < 1f));
let _e5692 = select(0f, ((_e5686 * _e5686) * (3f - (2f * _e5686))), (_e5633 > 0f));
let _e5697 = global_1.member.member_10.member_4.member_5;
if ((_e5697 > 0u) && (_e5692 > 0f)) {
let _e5701 = (0.5f / _e5669);
let _e5711 = global_1.member.member_10.member_4.member_6;
let _e5712 = bitcast<i32>(_e5711);
local = bitcast<i32>(_e5697);
let _e5713 = local;
let _e5715 = f32((_e5713 - 1i));
let _e5717 = f32((_e5712 - 1i));
let _e5718 = local;
let _e5721 = (((0.5f + (_e5650 * _e5701)) * f32(_e5718)) - 0.5f);
let _e5723 = select(0f, _e5721, (_e5721 > 0f));
let _e5725 = select(_e5715, _e5723, (_e5723 < _e5715));
let _e5728 = (((0.5f - (_e5664 * _e5701)) * f32(_e5712)) - 0.5f);
let _e5730 = select(0f, _e5728, (_e5728 > 0f));
let _e5732 = select(_e5717, _e5730, (_e5730 < _e5717));
let _e5734 = select(0f, _e5725, (_e5725 > 0f));
let _e5736 = select(_e5715, _e5734, (_e5734 < _e5715));
let _e5743 = select(0i, select(select(i32(_e5736), i32(-2147483648), (_e5736 < -2147483600f)), 2147483647i, (_e5736 > 2147483500f)), (_e5736 == _e5736));
let _e5747 = (_e5743 - select(0i, 1i, (_e5736 < f32(_e5743))));
let _e5749 = select(0f, _e5732, (_e5732 > 0f));
let _e5751 = select(_e5717, _e5749, (_e5749 < _e5717));
let _e5758 = select(0i, select(select(i32(_e5751), i32(-2147483648), (_e5751 < -2147483600f)), 2147483647i, (_e5751 > 2147483500f)), (_e5751 == _e5751));
let _e5762 = (_e5758 - select(0i, 1i, (_e5751 < f32(_e5758))));
let _e5764 = (_e5725 - f32(_e5747));
let _e5766 = (_e5732 - f32(_e5762));
let _e5767 = (_e5747 + 1i);
let _e5768 = local;
let _e5770 = select(_e5747, _e5767, (_e5767 < _e5768));
let _e5771 = (_e5762 + 1i);
let _e5773 = select(_e5762, _e5771, (_e5771 < _e5712));
let _e5778 = global_1.member.member_10.member_4.member_4;
let _e5779 = bitcast<i32>(_e5778);
let _e5780 = local;
let _e5784 = (_e5779 + (3i * ((_e5762 * _e5780) + _e5747)));
let _e5786 = (bitcast<i32>(_e146) - 1i);
let _e5788 = select(_e5786, _e5784, (_e5784 < _e5786));
let _e5793 = global_3.member[bitcast<u32>(select(0i, _e5788, (_e5788 > 0i)))];
let _e5794 = (_e5784 + 1i);
let _e5796 = select(_e5786, _e5794, (_e5794 < _e5786));
let _e5801 = global_3.member[bitcast<u32>(select(0i, _e5796, (_e5796 > 0i)))];
let _e5802 = (_e5784 + 2i);
let _e5804 = select(_e5786, _e5802, (_e5802 < _e5786));
let _e5809 = global_3.member[bitcast<u32>(select(0i, _e5804, (_e5804 > 0i)))];
let _e5810 = local;
let _e5814 = (_e5779 + (3i * ((_e5762 * _e5810) + _e5770)));
let _e5816 = select(_e5786, _e5814, (_e5814 < _e5786));
let _e5821 = global_3.member[bitcast<u32>(select(0i, _e5816, (_e5816 > 0i)))];
let _e5822 = (_e5814 + 1i);
let _e5824 = select(_e5786, _e5822, (_e5822 < _e5786));
let _e5829 = global_3.member[bitcast<u32>(select(0i, _e5824, (_e5824 > 0i)))];
let _e5830 = (_e5814 + 2i);
let _e5832 = select(_e5786, _e5830, (_e5830 < _e5786));
let _e5837 = global_3.member[bitcast<u32>(select(0i, _e5832, (_e5832 > 0i)))];
let _e5838 = local;
let _e5842 = (_e5779 + (3i * ((_e5773 * _e5838) + _e5747)));
let _e5844 = select(_e5786, _e5842, (_e5842 < _e5786));
let _e5849 = global_3.member[bitcast<u32>(select(0i, _e5844, (_e5844 > 0i)))];
let _e5850 = (_e5842 + 1i);
let _e5852 = select(_e5786, _e5850, (_e5850 < _e5786));
let _e5857 = global_3.member[bitcast<u32>(select(0i, _e5852, (_e5852 > 0i)))];
let _e5858 = (_e5842 + 2i);
let _e5860 = select(_e5786, _e5858, (_e5858 < _e5786));
let _e5865 = global_3.member[bitcast<u32>(select(0i, _e5860, (_e5860 > 0i)))];
let _e5866 = local;
let _e5870 = (_e5779 + (3i * ((_e5773 * _e5866) + _e5770)));
let _e5872 = select(_e5786, _e5870, (_e5870 < _e5786));
let _e5877 = global_3.member[bitcast<u32>(select(0i, _e5872, (_e5872 > 0i)))];
let _e5878 = (_e5870 + 1i);
let _e5880 = select(_e5786, _e5878, (_e5878 < _e5786));
let _e5885 = global_3.member[bitcast<u32>(select(0i, _e5880, (_e5880 > 0i)))];
let _e5886 = (_e5870 + 2i);
let _e5888 = select(_e5786, _e5886, (_e5886 < _e5786));
let _e5893 = global_3.member[bitcast<u32>(select(0i, _e5888, (_e5888 > 0i)))];
let _e5900 = (_e5793 + ((_e5821 - _e5793) * _e5764));
let _e5901 = (_e5801 + ((_e5829 - _e5801) * _e5764));
let _e5902 = (_e5809 + ((_e5837 - _e5809) * _e5764));
phi_9350_ = vec3<f32>(((_e5900 + (((_e5849 + ((_e5877 - _e5849) * _e5764)) - _e5900) * _e5766)) * _e5692), ((_e5901 + (((_e5857 + ((_e5885 - _e5857) * _e5764)) - _e5901) * _e5766)) * _e5692), ((_e5902 + (((_e5865 + ((_e5893 - _e5865) * _e5764)) - _e5902) * _e5766)) * _e5692));
} else {
phi_9350_ = vec3(_e5692);
}
let _e5927 = phi_9350_;
phi_9353_ = (_e5620 * _e5927);
} else {
phi_9353_ = _e5620;
}
let _e5930 = phi_9353_;
let _e5934 = (1f / sqrt(select(0f, _e5615, (_e5615 > 0f))));
phi_9366_ = type_26(vec3<f32>((_e5604 * _e5934), (_e5606 * _e5934), (_e5608 * _e5934)), _e5930);
}
let _e5941 = phi_9366_;
let _e5943 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e5945 = select(_e5943, _e447, (_e447 < _e5943));
let _e5951 = global_8.member[bitcast<u32>(select(0i, _e5945, (_e5945 > 0i)))];
let _e5955 = global_1.member.member_10.member_3;
let _e5960 = (_e5955.member - _e4327.member.x);
let _e5962 = (_e5955.member_1 - _e4327.member.y);
let _e5964 = (_e5955.member_2 - _e4327.member.z);
let _e5969 = (((_e5960 * _e5960) + (_e5962 * _e5962)) + (_e5964 * _e5964));
let _e5973 = select(sqrt(select(0f, _e5969, (_e5969 > 0f))), 1e30f, _e5586);
let _e5976 = -(_e5941.member.x);
let _e5978 = -(_e5941.member.y);
let _e5980 = -(_e5941.member.z);
let _e5988 = (1f / select(_e5976, select(1e-12f, -1e-12f, (_e5976 < 0f)), (bitcast<f32>((bitcast<u32>(_e5976) & 2147483647u)) < 1e-12f)));
let _e5996 = (1f / select(_e5978, select(1e-12f, -1e-12f, (_e5978 < 0f)), (bitcast<f32>((bitcast<u32>(_e5978) & 2147483647u)) < 1e-12f)));
let _e6004 = (1f / select(_e5980, select(1e-12f, -1e-12f, (_e5980 < 0f)), (bitcast<f32>((bitcast<u32>(_e5980) & 2147483647u)) < 1e-12f)));
let _e6006 = ((_e753.member - _e4327.member.x) * _e5988);
let _e6008 = ((_e760.member - _e4327.member.x) * _e5988);
let _e6010 = ((_e753.member_1 - _e4327.member.y) * _e5996);
let _e6012 = ((_e760.member_1 - _e4327.member.y) * _e5996);
let _e6014 = ((_e753.member_2 - _e4327.member.z) * _e6004);
let _e6016 = ((_e760.member_2 - _e4327.member.z) * _e6004);
let _e6018 = select(_e6008, _e6006, (_e6006 < _e6008));
let _e6020 = select(_e6012, _e6010, (_e6010 < _e6012));
let _e6022 = select(_e6020, _e6018, (_e6018 > _e6020));
let _e6024 = select(_e6016, _e6014, (_e6014 < _e6016));
let _e6026 = select(_e6024, _e6022, (_e6022 > _e6024));
let _e6028 = select(_e6008, _e6006, (_e6006 > _e6008));
let _e6030 = select(_e6012, _e6010, (_e6010 > _e6012));
let _e6032 = select(_e6030, _e6028, (_e6028 < _e6030));
let _e6034 = select(_e6016, _e6014, (_e6014 > _e6016));
let _e6036 = select(_e6034, _e6032, (_e6032 < _e6034));
let _e6038 = select(0f, _e6026, (_e6026 > 0f));
let _e6040 = select(_e5973, _e6036, (_e6036 < _e5973));
let _e6041 = (_e6040 > _e6038);
let _e6044 = (select(0f, _e6040, _e6041) - select(0f, _e6038, _e6041));
let _e6046 = -((_e807.member * _e6044));
let _e6048 = select(-87f, _e6046, (_e6046 > -87f));
let _e6050 = select(88f, _e6048, (_e6048 < 88f));
let _e6052 = ((_e6050 * 1.442695f) + 0.5f);
let _e6054 = select(-127f, _e6052, (_e6052 > -127f));
let _e6056 = select(128f, _e6054, (_e6054 < 128f));
let _e6063 = select(0i, select(select(i32(_e6056), i32(-2147483648), (_e6056 < -2147483600f)), 2147483647i, (_e6056 > 2147483500f)), (_e6056 == _e6056));
let _e6067 = (_e6063 - select(0i, 1i, (_e6056 < f32(_e6063))));
let _e6068 = f32(_e6067);
let _e6072 = ((_e6050 - (_e6068 * 0.6933594f)) - (_e6068 * -2.1219444e-4f));
let _e6094 = -((_e807.member_1 * _e6044));
let _e6096 = select(-87f, _e6094, (_e6094 > -87f));
let _e6098 = select(88f, _e6096, (_e6096 < 88f));
let _e6100 = ((_e6098 * 1.442695f) + 0.5f);
let _e6102 = select(-127f, _e6100, (_e6100 > -127f));
let _e6104 = select(128f, _e6102, (_e6102 < 128f));
let _e6111 = select(0i, select(select(i32(_e6104), i32(-2147483648), (_e6104 < -2147483600f)), 2147483647i, (_e6104 > 2147483500f)), (_e6104 == _e6104));
let _e6115 = (_e6111 - select(0i, 1i, (_e6104 < f32(_e6111))));
let _e6116 = f32(_e6115);
let _e6120 = ((_e6098 - (_e6116 * 0.6933594f)) - (_e6116 * -2.1219444e-4f));
let _e6142 = -((_e807.member_2 * _e6044));
let _e6144 = select(-87f, _e6142, (_e6142 > -87f));
let _e6146 = select(88f, _e6144, (_e6144 < 88f));
let _e6148 = ((_e6146 * 1.442695f) + 0.5f);
let _e6150 = select(-127f, _e6148, (_e6148 > -127f));
let _e6152 = select(128f, _e6150, (_e6150 < 128f));
let _e6159 = select(0i, select(select(i32(_e6152), i32(-2147483648), (_e6152 < -2147483600f)), 2147483647i, (_e6152 > 2147483500f)), (_e6152 == _e6152));
let _e6163 = (_e6159 - select(0i, 1i, (_e6152 < f32(_e6159))));
let _e6164 = f32(_e6163);
let _e6168 = ((_e6146 - (_e6164 * 0.6933594f)) - (_e6164 * -2.1219444e-4f));
let _e6189 = (1f - _e5951);
let _e6201 = (((_e4327.member_1.x * _e466) + (_e4327.member_1.y * _e477)) + (_e4327.member_1.z * _e488));
let _e6203 = select(1f, -1f, (_e6201 > 0f));
let _e6215 = select(_e6203, -(_e6203), ((((_e4327.member_2.x * _e4327.member_1.x) + (_e4327.member_2.y * _e4327.member_1.y)) + (_e4327.member_2.z * _e4327.member_1.z)) < 0f));
let _e6216 = (_e4327.member_2.x * _e6215);
let _e6217 = (_e4327.member_2.y * _e6215);
let _e6218 = (_e4327.member_2.z * _e6215);
let _e6227 = ((((_e6216 * _e466) + (_e6217 * _e477)) + (_e6218 * _e488)) > 0f);
let _e6236 = -((((select(_e6216, (_e4327.member_1.x * _e6203), _e6227) * _e5941.member.x) + (select(_e6217, (_e4327.member_1.y * _e6203), _e6227) * _e5941.member.y)) + (select(_e6218, (_e4327.member_1.z * _e6203), _e6227) * _e5941.member.z)));
let _e6246 = -(_e6236);
let _e6251 = select((select(0f, _e6246, (_e6246 > 0f)) * _e4327.member_4), select(0f, _e6236, (_e6236 > 0f)), (((((_e4327.member_1.x * _e5941.member.x) + (_e4327.member_1.y * _e5941.member.y)) + (_e4327.member_1.z * _e5941.member.z)) * _e6201) > 0f));
let _e6265 = global_1.member.member_16;
phi_9917_ = type_24(_e4454.member, _e4454.member_1, vec3<f32>((_e4454.member_2.x + (((_e4327.member_3.x * (((_e5941.member_1.x * (((1f + (_e6072 * (1f + (_e6072 * (0.5f + (_e6072 * (0.16666667f + (_e6072 * (0.041666668f + (_e6072 * (0.008333334f + (_e6072 * (0.001388889f + (_e6072 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6067 + 127i)) << bitcast<u32>(23i)))) * _e6189)) * _e6251) + _e6265.member)) * _e858) * _e723)), (_e4454.member_2.y + (((_e4327.member_3.y * (((_e5941.member_1.y * (((1f + (_e6120 * (1f + (_e6120 * (0.5f + (_e6120 * (0.16666667f + (_e6120 * (0.041666668f + (_e6120 * (0.008333334f + (_e6120 * (0.001388889f + (_e6120 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6115 + 127i)) << bitcast<u32>(23i)))) * _e6189)) * _e6251) + _e6265.member_1)) * _e906) * _e724)), (_e4454.member_2.z + (((_e4327.member_3.z * (((_e5941.member_1.z * (((1f + (_e6168 * (1f + (_e6168 * (0.5f + (_e6168 * (0.16666667f + (_e6168 * (0.041666668f + (_e6168 * (0.008333334f + (_e6168 * (0.001388889f + (_e6168 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6163 + 127i)) << bitcast<u32>(23i)))) * _e6189)) * _e6251) + _e6265.member_2)) * _e954) * _e725))), _e4454.member_3, _e4454.member_4, _e4454.member_5, _e4454.member_6, _e4454.member_7);
} else {
phi_9917_ = _e4454;
}
let _e6303 = phi_9917_;
phi_9918_ = _e6303;
}
let _e6305 = phi_9918_;
global_6.member[_e168] = _e6305.member;
global_6.member[_e180] = _e6305.member_1;
global_6.member[_e191] = _e6305.member_2.x;
global_6.member[_e202] = _e6305.member_2.y;
global_6.member[_e213] = _e6305.member_2.z;
global_6.member[_e224] = _e6305.member_3.x;
global_6.member[_e235] = _e6305.member_3.y;
global_6.member[_e246] = _e6305.member_3.z;
global_6.member[_e257] = _e6305.member_4.x;
global_6.member[_e268] = _e6305.member_4.y;
global_6.member[_e279] = _e6305.member_4.z;
global_6.member[_e290] = _e6305.member_5.x;
global_6.member[_e301] = _e6305.member_5.y;
global_6.member[_e312] = _e6305.member_5.z;
global_6.member[_e323] = _e6305.member_6;
global_6.member[_e334] = _e6305.member_7.x;
global_6.member[_e345] = _e6305.member_7.y;
global_6.member[_e356] = _e6305.member_7.z;
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
