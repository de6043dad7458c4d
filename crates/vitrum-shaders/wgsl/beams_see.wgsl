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
var phi_2159_: type_27;
var phi_2163_: type_27;
var phi_2280_: vec3<f32>;
var phi_2282_: i32;
var phi_2867_: vec3<f32>;
var phi_2870_: vec3<f32>;
var phi_2883_: type_26;
var phi_3882_: vec3<f32>;
var phi_3885_: vec3<f32>;
var phi_3898_: type_26;
var phi_4914_: vec3<f32>;
var phi_4917_: vec3<f32>;
var phi_4930_: type_26;
var phi_5929_: vec3<f32>;
var phi_5932_: vec3<f32>;
var phi_5945_: type_26;
var phi_2281_: vec3<f32>;
var phi_2283_: i32;
var phi_6396_: vec3<f32>;
var phi_6411_: type_24;
var phi_7146_: type_25;
var phi_7210_: bool;
var phi_7324_: type_24;
var phi_7428_: vec3<f32>;
var phi_8030_: i32;
var phi_8033_: i32;
var phi_8035_: i32;
var phi_8037_: i32;
var phi_8052_: i32;
var phi_8058_: i32;
var phi_8031_: i32;
var phi_8034_: i32;
var phi_8036_: i32;
var phi_8038_: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var phi_8133_: i32;
var local_16: i32;
var local_17: i32;
var phi_8139_: i32;
var local_18: i32;
var phi_8146_: i32;
var local_19: i32;
var local_20: i32;
var phi_8152_: i32;
var local_21: i32;
var local_22: i32;
var phi_8163_: i32;
var local_23: i32;
var local_24: i32;
var phi_8175_: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var phi_8411_: i32;
var phi_8414_: i32;
var phi_8416_: i32;
var phi_8418_: i32;
var phi_8433_: i32;
var phi_8439_: i32;
var phi_8412_: i32;
var phi_8415_: i32;
var phi_8417_: i32;
var phi_8419_: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var phi_8514_: i32;
var local_32: i32;
var local_33: i32;
var phi_8520_: i32;
var local_34: i32;
var phi_8527_: i32;
var local_35: i32;
var local_36: i32;
var phi_8533_: i32;
var local_37: i32;
var local_38: i32;
var phi_8544_: i32;
var local_39: i32;
var local_40: i32;
var phi_8556_: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var phi_8811_: vec3<f32>;
var phi_8812_: vec3<f32>;
var phi_8813_: vec3<f32>;
var phi_9353_: vec3<f32>;
var phi_9356_: vec3<f32>;
var phi_9369_: type_26;
var phi_9918_: type_24;
var phi_9919_: type_24;
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
phi_2159_ = type_27(select(_e1058, _e966, (_e966 > _e1058)), select(_e1061, _e802, (_e802 < _e1061)));
} else {
let _e1068 = (-(_e1006) / select(_e1014, 1e-20f, (_e1014 == 0f)));
let _e1071 = (_e1014 > 0f);
let _e1072 = select(_e966, select(_e1068, _e1050, _e1036), _e1071);
let _e1075 = select(select(_e1068, _e1048, _e1036), _e802, _e1071);
phi_2159_ = type_27(select(_e1072, _e966, (_e966 > _e1072)), select(_e1075, _e802, (_e802 < _e1075)));
}
let _e1080 = phi_2159_;
phi_2163_ = _e1080;
} else {
phi_2163_ = type_27(_e966, _e802);
}
let _e1082 = phi_2163_;
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
phi_2280_ = vec3<f32>(0f, 0f, 0f);
phi_2282_ = 0i;
loop {
let _e1163 = phi_2280_;
let _e1165 = phi_2282_;
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
phi_2883_ = type_26(vec3<f32>(_e1226.member, _e1226.member_1, _e1226.member_2), _e1219);
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
phi_2867_ = vec3<f32>(((_e1524 + (((_e1473 + ((_e1501 - _e1473) * _e1389)) - _e1524) * _e1391)) * _e1319), ((_e1525 + (((_e1481 + ((_e1509 - _e1481) * _e1389)) - _e1525) * _e1391)) * _e1319), ((_e1526 + (((_e1489 + ((_e1517 - _e1489) * _e1389)) - _e1526) * _e1391)) * _e1319));
} else {
phi_2867_ = vec3(_e1319);
}
let _e1551 = phi_2867_;
phi_2870_ = (_e1252 * _e1551);
} else {
phi_2870_ = _e1252;
}
let _e1554 = phi_2870_;
let _e1558 = (1f / sqrt(select(0f, _e1247, (_e1247 > 0f))));
phi_2883_ = type_26(vec3<f32>((_e1238 * _e1558), (_e1239 * _e1558), (_e1240 * _e1558)), _e1554);
}
let _e1565 = phi_2883_;
let _e1569 = global_1.member.member_10.member_3;
let _e1573 = (_e1569.member - _e1208);
let _e1574 = (_e1569.member_1 - _e1210);
let _e1575 = (_e1569.member_2 - _e1212);
let _e1580 = (((_e1573 * _e1573) + (_e1574 * _e1574)) + (_e1575 * _e1575));
let _e1584 = select(sqrt(select(0f, _e1580, (_e1580 > 0f))), 1e30f, _e1223);
let _e1586 = -(_e1565.member.x);
let _e1588 = -(_e1565.member.y);
let _e1590 = -(_e1565.member.z);
let _e1598 = (1f / select(_e1586, select(1e-12f, -1e-12f, (_e1586 < 0f)), (bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u)) < 1e-12f)));
let _e1606 = (1f / select(_e1588, select(1e-12f, -1e-12f, (_e1588 < 0f)), (bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u)) < 1e-12f)));
let _e1614 = (1f / select(_e1590, select(1e-12f, -1e-12f, (_e1590 < 0f)), (bitcast<f32>((bitcast<u32>(_e1590) & 2147483647u)) < 1e-12f)));
let _e1617 = global_1.member.member_13.member_4;
let _e1623 = global_1.member.member_13.member_5;
let _e1628 = ((_e1617.member - _e1208) * _e1598);
let _e1630 = ((_e1623.member - _e1208) * _e1598);
let _e1632 = ((_e1617.member_1 - _e1210) * _e1606);
let _e1634 = ((_e1623.member_1 - _e1210) * _e1606);
let _e1636 = ((_e1617.member_2 - _e1212) * _e1614);
let _e1638 = ((_e1623.member_2 - _e1212) * _e1614);
let _e1640 = select(_e1630, _e1628, (_e1628 < _e1630));
let _e1642 = select(_e1634, _e1632, (_e1632 < _e1634));
let _e1644 = select(_e1642, _e1640, (_e1640 > _e1642));
let _e1646 = select(_e1638, _e1636, (_e1636 < _e1638));
let _e1648 = select(_e1646, _e1644, (_e1644 > _e1646));
let _e1650 = select(_e1630, _e1628, (_e1628 > _e1630));
let _e1652 = select(_e1634, _e1632, (_e1632 > _e1634));
let _e1654 = select(_e1652, _e1650, (_e1650 < _e1652));
let _e1656 = select(_e1638, _e1636, (_e1636 > _e1638));
let _e1658 = select(_e1656, _e1654, (_e1654 < _e1656));
let _e1660 = select(0f, _e1648, (_e1648 > 0f));
let _e1662 = select(_e1584, _e1658, (_e1658 < _e1584));
let _e1663 = (_e1662 > _e1660);
let _e1667 = (_e1198 - _e1176);
let _e1670 = ((select(0f, _e1662, _e1663) - select(0f, _e1660, _e1663)) + select(0f, _e1667, (_e1667 > 0f)));
let _e1673 = global_1.member.member_13.member;
let _e1678 = -((_e1673.member * _e1670));
let _e1680 = select(-87f, _e1678, (_e1678 > -87f));
let _e1682 = select(88f, _e1680, (_e1680 < 88f));
let _e1684 = ((_e1682 * 1.442695f) + 0.5f);
let _e1686 = select(-127f, _e1684, (_e1684 > -127f));
let _e1688 = select(128f, _e1686, (_e1686 < 128f));
let _e1695 = select(0i, select(select(i32(_e1688), i32(-2147483648), (_e1688 < -2147483600f)), 2147483647i, (_e1688 > 2147483500f)), (_e1688 == _e1688));
let _e1699 = (_e1695 - select(0i, 1i, (_e1688 < f32(_e1695))));
let _e1700 = f32(_e1699);
let _e1704 = ((_e1682 - (_e1700 * 0.6933594f)) - (_e1700 * -2.1219444e-4f));
let _e1726 = -((_e1673.member_1 * _e1670));
let _e1728 = select(-87f, _e1726, (_e1726 > -87f));
let _e1730 = select(88f, _e1728, (_e1728 < 88f));
let _e1732 = ((_e1730 * 1.442695f) + 0.5f);
let _e1734 = select(-127f, _e1732, (_e1732 > -127f));
let _e1736 = select(128f, _e1734, (_e1734 < 128f));
let _e1743 = select(0i, select(select(i32(_e1736), i32(-2147483648), (_e1736 < -2147483600f)), 2147483647i, (_e1736 > 2147483500f)), (_e1736 == _e1736));
let _e1747 = (_e1743 - select(0i, 1i, (_e1736 < f32(_e1743))));
let _e1748 = f32(_e1747);
let _e1752 = ((_e1730 - (_e1748 * 0.6933594f)) - (_e1748 * -2.1219444e-4f));
let _e1774 = -((_e1673.member_2 * _e1670));
let _e1776 = select(-87f, _e1774, (_e1774 > -87f));
let _e1778 = select(88f, _e1776, (_e1776 < 88f));
let _e1780 = ((_e1778 * 1.442695f) + 0.5f);
let _e1782 = select(-127f, _e1780, (_e1780 > -127f));
let _e1784 = select(128f, _e1782, (_e1782 < 128f));
let _e1791 = select(0i, select(select(i32(_e1784), i32(-2147483648), (_e1784 < -2147483600f)), 2147483647i, (_e1784 > 2147483500f)), (_e1784 == _e1784));
let _e1795 = (_e1791 - select(0i, 1i, (_e1784 < f32(_e1791))));
let _e1796 = f32(_e1795);
let _e1800 = ((_e1778 - (_e1796 * 0.6933594f)) - (_e1796 * -2.1219444e-4f));
let _e1826 = -((((_e1565.member.x * _e1175.x) + (_e1565.member.y * _e1175.y)) + (_e1565.member.z * _e1175.z)));
let _e1829 = global_1.member.member_13.member_2;
let _e1830 = (_e1829 * _e1829);
let _e1831 = (1f + _e1830);
let _e1832 = (2f * _e1829);
let _e1834 = (_e1831 - (_e1832 * _e1826));
let _e1836 = select(1e-9f, _e1834, (_e1834 > 1e-9f));
let _e1837 = (1f - _e1830);
let _e1848 = global_1.member.member_13.member_3;
let _e1849 = (_e1848 == 1u);
let _e1851 = (0.25f / 3.1415927f);
let _e1854 = ((3.1415927f * (select((_e1837 / (_e1836 * sqrt(select(0f, _e1836, (_e1836 > 0f))))), (0.75f * (1f + (_e1826 * _e1826))), _e1849) * _e1851)) * select((_e1191 * ((2f * (1f + _e1181)) / (_e1184 * _e1184))), 1f, _e1199));
let _e1864 = global_1.member.member_13.member_1;
let _e1874 = local_5;
let _e1875 = local_6;
let _e1876 = local_7;
let _e1877 = local_10;
let _e1878 = local_9;
let _e1880 = (_e1877 + (_e1878 * 0.8611363f));
let _e1881 = (_e1880 * _e1880);
let _e1882 = (1f - _e1881);
let _e1884 = select(1e-9f, _e1882, (_e1882 > 1e-9f));
let _e1885 = local_8.member;
let _e1886 = local_8.member_1;
let _e1891 = local_8.member_1;
let _e1897 = local_8.member_2;
let _e1898 = select((_e1885 + (_e1886 * ((2f * _e1880) / _e1884))), _e1880, _e1897);
let _e1899 = local_8.member_2;
let _e1908 = (_e1874.x + (_e1875.x * _e1898));
let _e1910 = (_e1874.y + (_e1875.y * _e1898));
let _e1912 = (_e1874.z + (_e1875.z * _e1898));
if _e1223 {
let _e1915 = global_1.member.member_10.member_1;
phi_3898_ = type_26(vec3<f32>(_e1915.member, _e1915.member_1, _e1915.member_2), _e1219);
} else {
let _e1921 = (_e1908 - _e1569.member);
let _e1922 = (_e1910 - _e1569.member_1);
let _e1923 = (_e1912 - _e1569.member_2);
let _e1928 = (((_e1921 * _e1921) + (_e1922 * _e1922)) + (_e1923 * _e1923));
let _e1930 = select(1e-12f, _e1928, (_e1928 > 1e-12f));
let _e1931 = (1f / _e1930);
let _e1935 = vec3<f32>((_e1215.member * _e1931), (_e1215.member_1 * _e1931), (_e1215.member_2 * _e1931));
if (_e1222 == 2u) {
let _e1939 = global_1.member.member_10.member_1;
let _e1947 = (((_e1939.member * _e1921) + (_e1939.member_1 * _e1922)) + (_e1939.member_2 * _e1923));
let _e1950 = (1f / select(1e-20f, _e1947, (_e1947 > 1e-20f)));
let _e1954 = global_1.member.member_10.member_4.member;
let _e1963 = ((((_e1954.member * _e1921) + (_e1954.member_1 * _e1922)) + (_e1954.member_2 * _e1923)) * _e1950);
let _e1967 = global_1.member.member_10.member_4.member_1;
let _e1976 = ((((_e1967.member * _e1921) + (_e1967.member_1 * _e1922)) + (_e1967.member_2 * _e1923)) * _e1950);
let _e1980 = global_1.member.member_10.member_4.member_2;
let _e1983 = ((_e1963 * _e1963) + (_e1976 * _e1976));
let _e1991 = global_1.member.member_10.member_4.member_3;
let _e1992 = ((_e1980 - sqrt(select(0f, _e1983, (_e1983 > 0f)))) * _e1991);
let _e1994 = select(0f, _e1992, (_e1992 > 0f));
let _e1996 = select(1f, _e1994, (_e1994 < 1f));
let _e2002 = select(0f, ((_e1996 * _e1996) * (3f - (2f * _e1996))), (_e1947 > 0f));
let _e2006 = global_1.member.member_10.member_4.member_5;
if ((_e2006 > 0u) && (_e2002 > 0f)) {
let _e2010 = (0.5f / _e1980);
let _e2019 = global_1.member.member_10.member_4.member_6;
let _e2020 = bitcast<i32>(_e2019);
local_3 = bitcast<i32>(_e2006);
let _e2021 = local_3;
let _e2023 = f32((_e2021 - 1i));
let _e2025 = f32((_e2020 - 1i));
let _e2026 = local_3;
let _e2029 = (((0.5f + (_e1963 * _e2010)) * f32(_e2026)) - 0.5f);
let _e2031 = select(0f, _e2029, (_e2029 > 0f));
let _e2033 = select(_e2023, _e2031, (_e2031 < _e2023));
let _e2036 = (((0.5f - (_e1976 * _e2010)) * f32(_e2020)) - 0.5f);
let _e2038 = select(0f, _e2036, (_e2036 > 0f));
let _e2040 = select(_e2025, _e2038, (_e2038 < _e2025));
let _e2042 = select(0f, _e2033, (_e2033 > 0f));
let _e2044 = select(_e2023, _e2042, (_e2042 < _e2023));
let _e2051 = select(0i, select(select(i32(_e2044), i32(-2147483648), (_e2044 < -2147483600f)), 2147483647i, (_e2044 > 2147483500f)), (_e2044 == _e2044));
let _e2055 = (_e2051 - select(0i, 1i, (_e2044 < f32(_e2051))));
let _e2057 = select(0f, _e2040, (_e2040 > 0f));
let _e2059 = select(_e2025, _e2057, (_e2057 < _e2025));
let _e2066 = select(0i, select(select(i32(_e2059), i32(-2147483648), (_e2059 < -2147483600f)), 2147483647i, (_e2059 > 2147483500f)), (_e2059 == _e2059));
let _e2070 = (_e2066 - select(0i, 1i, (_e2059 < f32(_e2066))));
let _e2072 = (_e2033 - f32(_e2055));
let _e2074 = (_e2040 - f32(_e2070));
let _e2075 = (_e2055 + 1i);
let _e2076 = local_3;
let _e2078 = select(_e2055, _e2075, (_e2075 < _e2076));
let _e2079 = (_e2070 + 1i);
let _e2081 = select(_e2070, _e2079, (_e2079 < _e2020));
let _e2085 = global_1.member.member_10.member_4.member_4;
let _e2086 = bitcast<i32>(_e2085);
let _e2087 = local_3;
let _e2091 = (_e2086 + (3i * ((_e2070 * _e2087) + _e2055)));
let _e2093 = (bitcast<i32>(_e146) - 1i);
let _e2095 = select(_e2093, _e2091, (_e2091 < _e2093));
let _e2100 = global_3.member[bitcast<u32>(select(0i, _e2095, (_e2095 > 0i)))];
let _e2101 = (_e2091 + 1i);
let _e2103 = select(_e2093, _e2101, (_e2101 < _e2093));
let _e2108 = global_3.member[bitcast<u32>(select(0i, _e2103, (_e2103 > 0i)))];
let _e2109 = (_e2091 + 2i);
let _e2111 = select(_e2093, _e2109, (_e2109 < _e2093));
let _e2116 = global_3.member[bitcast<u32>(select(0i, _e2111, (_e2111 > 0i)))];
let _e2117 = local_3;
let _e2121 = (_e2086 + (3i * ((_e2070 * _e2117) + _e2078)));
let _e2123 = select(_e2093, _e2121, (_e2121 < _e2093));
let _e2128 = global_3.member[bitcast<u32>(select(0i, _e2123, (_e2123 > 0i)))];
let _e2129 = (_e2121 + 1i);
let _e2131 = select(_e2093, _e2129, (_e2129 < _e2093));
let _e2136 = global_3.member[bitcast<u32>(select(0i, _e2131, (_e2131 > 0i)))];
let _e2137 = (_e2121 + 2i);
let _e2139 = select(_e2093, _e2137, (_e2137 < _e2093));
let _e2144 = global_3.member[bitcast<u32>(select(0i, _e2139, (_e2139 > 0i)))];
let _e2145 = local_3;
let _e2149 = (_e2086 + (3i * ((_e2081 * _e2145) + _e2055)));
let _e2151 = select(_e2093, _e2149, (_e2149 < _e2093));
let _e2156 = global_3.member[bitcast<u32>(select(0i, _e2151, (_e2151 > 0i)))];
let _e2157 = (_e2149 + 1i);
let _e2159 = select(_e2093, _e2157, (_e2157 < _e2093));
let _e2164 = global_3.member[bitcast<u32>(select(0i, _e2159, (_e2159 > 0i)))];
let _e2165 = (_e2149 + 2i);
let _e2167 = select(_e2093, _e2165, (_e2165 < _e2093));
let _e2172 = global_3.member[bitcast<u32>(select(0i, _e2167, (_e2167 > 0i)))];
let _e2173 = local_3;
let _e2177 = (_e2086 + (3i * ((_e2081 * _e2173) + _e2078)));
let _e2179 = select(_e2093, _e2177, (_e2177 < _e2093));
let _e2184 = global_3.member[bitcast<u32>(select(0i, _e2179, (_e2179 > 0i)))];
let _e2185 = (_e2177 + 1i);
let _e2187 = select(_e2093, _e2185, (_e2185 < _e2093));
let _e2192 = global_3.member[bitcast<u32>(select(0i, _e2187, (_e2187 > 0i)))];
let _e2193 = (_e2177 + 2i);
let _e2195 = select(_e2093, _e2193, (_e2193 < _e2093));
let _e2200 = global_3.member[bitcast<u32>(select(0i, _e2195, (_e2195 > 0i)))];
let _e2207 = (_e2100 + ((_e2128 - _e2100) * _e2072));
let _e2208 = (_e2108 + ((_e2136 - _e2108) * _e2072));
let _e2209 = (_e2116 + ((_e2144 - _e2116) * _e2072));
phi_3882_ = vec3<f32>(((_e2207 + (((_e2156 + ((_e2184 - _e2156) * _e2072)) - _e2207) * _e2074)) * _e2002), ((_e2208 + (((_e2164 + ((_e2192 - _e2164) * _e2072)) - _e2208) * _e2074)) * _e2002), ((_e2209 + (((_e2172 + ((_e2200 - _e2172) * _e2072)) - _e2209) * _e2074)) * _e2002));
} else {
phi_3882_ = vec3(_e2002);
}
let _e2234 = phi_3882_;
phi_3885_ = (_e1935 * _e2234);
} else {
phi_3885_ = _e1935;
}
let _e2237 = phi_3885_;
let _e2241 = (1f / sqrt(select(0f, _e1930, (_e1930 > 0f))));
phi_3898_ = type_26(vec3<f32>((_e1921 * _e2241), (_e1922 * _e2241), (_e1923 * _e2241)), _e2237);
}
let _e2248 = phi_3898_;
let _e2250 = (_e1569.member - _e1908);
let _e2251 = (_e1569.member_1 - _e1910);
let _e2252 = (_e1569.member_2 - _e1912);
let _e2257 = (((_e2250 * _e2250) + (_e2251 * _e2251)) + (_e2252 * _e2252));
let _e2261 = select(sqrt(select(0f, _e2257, (_e2257 > 0f))), 1e30f, _e1223);
let _e2263 = -(_e2248.member.x);
let _e2265 = -(_e2248.member.y);
let _e2267 = -(_e2248.member.z);
let _e2275 = (1f / select(_e2263, select(1e-12f, -1e-12f, (_e2263 < 0f)), (bitcast<f32>((bitcast<u32>(_e2263) & 2147483647u)) < 1e-12f)));
let _e2283 = (1f / select(_e2265, select(1e-12f, -1e-12f, (_e2265 < 0f)), (bitcast<f32>((bitcast<u32>(_e2265) & 2147483647u)) < 1e-12f)));
let _e2291 = (1f / select(_e2267, select(1e-12f, -1e-12f, (_e2267 < 0f)), (bitcast<f32>((bitcast<u32>(_e2267) & 2147483647u)) < 1e-12f)));
let _e2293 = ((_e1617.member - _e1908) * _e2275);
let _e2295 = ((_e1623.member - _e1908) * _e2275);
let _e2297 = ((_e1617.member_1 - _e1910) * _e2283);
let _e2299 = ((_e1623.member_1 - _e1910) * _e2283);
let _e2301 = ((_e1617.member_2 - _e1912) * _e2291);
let _e2303 = ((_e1623.member_2 - _e1912) * _e2291);
let _e2305 = select(_e2295, _e2293, (_e2293 < _e2295));
let _e2307 = select(_e2299, _e2297, (_e2297 < _e2299));
let _e2309 = select(_e2307, _e2305, (_e2305 > _e2307));
let _e2311 = select(_e2303, _e2301, (_e2301 < _e2303));
let _e2313 = select(_e2311, _e2309, (_e2309 > _e2311));
let _e2315 = select(_e2295, _e2293, (_e2293 > _e2295));
let _e2317 = select(_e2299, _e2297, (_e2297 > _e2299));
let _e2319 = select(_e2317, _e2315, (_e2315 < _e2317));
let _e2321 = select(_e2303, _e2301, (_e2301 > _e2303));
let _e2323 = select(_e2321, _e2319, (_e2319 < _e2321));
let _e2325 = select(0f, _e2313, (_e2313 > 0f));
let _e2327 = select(_e2261, _e2323, (_e2323 < _e2261));
let _e2328 = (_e2327 > _e2325);
let _e2332 = (_e1898 - _e1876);
let _e2335 = ((select(0f, _e2327, _e2328) - select(0f, _e2325, _e2328)) + select(0f, _e2332, (_e2332 > 0f)));
let _e2337 = -((_e1673.member * _e2335));
let _e2339 = select(-87f, _e2337, (_e2337 > -87f));
let _e2341 = select(88f, _e2339, (_e2339 < 88f));
let _e2343 = ((_e2341 * 1.442695f) + 0.5f);
let _e2345 = select(-127f, _e2343, (_e2343 > -127f));
let _e2347 = select(128f, _e2345, (_e2345 < 128f));
let _e2354 = select(0i, select(select(i32(_e2347), i32(-2147483648), (_e2347 < -2147483600f)), 2147483647i, (_e2347 > 2147483500f)), (_e2347 == _e2347));
let _e2358 = (_e2354 - select(0i, 1i, (_e2347 < f32(_e2354))));
let _e2359 = f32(_e2358);
let _e2363 = ((_e2341 - (_e2359 * 0.6933594f)) - (_e2359 * -2.1219444e-4f));
let _e2385 = -((_e1673.member_1 * _e2335));
let _e2387 = select(-87f, _e2385, (_e2385 > -87f));
let _e2389 = select(88f, _e2387, (_e2387 < 88f));
let _e2391 = ((_e2389 * 1.442695f) + 0.5f);
let _e2393 = select(-127f, _e2391, (_e2391 > -127f));
let _e2395 = select(128f, _e2393, (_e2393 < 128f));
let _e2402 = select(0i, select(select(i32(_e2395), i32(-2147483648), (_e2395 < -2147483600f)), 2147483647i, (_e2395 > 2147483500f)), (_e2395 == _e2395));
let _e2406 = (_e2402 - select(0i, 1i, (_e2395 < f32(_e2402))));
let _e2407 = f32(_e2406);
let _e2411 = ((_e2389 - (_e2407 * 0.6933594f)) - (_e2407 * -2.1219444e-4f));
let _e2433 = -((_e1673.member_2 * _e2335));
let _e2435 = select(-87f, _e2433, (_e2433 > -87f));
let _e2437 = select(88f, _e2435, (_e2435 < 88f));
let _e2439 = ((_e2437 * 1.442695f) + 0.5f);
let _e2441 = select(-127f, _e2439, (_e2439 > -127f));
let _e2443 = select(128f, _e2441, (_e2441 < 128f));
let _e2450 = select(0i, select(select(i32(_e2443), i32(-2147483648), (_e2443 < -2147483600f)), 2147483647i, (_e2443 > 2147483500f)), (_e2443 == _e2443));
let _e2454 = (_e2450 - select(0i, 1i, (_e2443 < f32(_e2450))));
let _e2455 = f32(_e2454);
let _e2459 = ((_e2437 - (_e2455 * 0.6933594f)) - (_e2455 * -2.1219444e-4f));
let _e2485 = -((((_e2248.member.x * _e1875.x) + (_e2248.member.y * _e1875.y)) + (_e2248.member.z * _e1875.z)));
let _e2487 = (_e1831 - (_e1832 * _e2485));
let _e2489 = select(1e-9f, _e2487, (_e2487 > 1e-9f));
let _e2501 = ((3.1415927f * (select((_e1837 / (_e2489 * sqrt(select(0f, _e2489, (_e2489 > 0f))))), (0.75f * (1f + (_e2485 * _e2485))), _e1849) * _e1851)) * select((_e1891 * ((2f * (1f + _e1881)) / (_e1884 * _e1884))), 1f, _e1899));
let _e2518 = local_9;
let _e2519 = (_e2518 * 0.34785485f);
let _e2530 = local_5;
let _e2531 = local_6;
let _e2532 = local_7;
let _e2533 = local_10;
let _e2534 = local_9;
let _e2536 = (_e2533 + (_e2534 * -(0.33998105f)));
let _e2537 = (_e2536 * _e2536);
let _e2538 = (1f - _e2537);
let _e2540 = select(1e-9f, _e2538, (_e2538 > 1e-9f));
let _e2541 = local_8.member;
let _e2542 = local_8.member_1;
let _e2547 = local_8.member_1;
let _e2553 = local_8.member_2;
let _e2554 = select((_e2541 + (_e2542 * ((2f * _e2536) / _e2540))), _e2536, _e2553);
let _e2555 = local_8.member_2;
let _e2564 = (_e2530.x + (_e2531.x * _e2554));
let _e2566 = (_e2530.y + (_e2531.y * _e2554));
let _e2568 = (_e2530.z + (_e2531.z * _e2554));
if _e1223 {
let _e2571 = global_1.member.member_10.member_1;
phi_4930_ = type_26(vec3<f32>(_e2571.member, _e2571.member_1, _e2571.member_2), _e1219);
} else {
let _e2577 = (_e2564 - _e1569.member);
let _e2578 = (_e2566 - _e1569.member_1);
let _e2579 = (_e2568 - _e1569.member_2);
let _e2584 = (((_e2577 * _e2577) + (_e2578 * _e2578)) + (_e2579 * _e2579));
let _e2586 = select(1e-12f, _e2584, (_e2584 > 1e-12f));
let _e2587 = (1f / _e2586);
let _e2591 = vec3<f32>((_e1215.member * _e2587), (_e1215.member_1 * _e2587), (_e1215.member_2 * _e2587));
if (_e1222 == 2u) {
let _e2595 = global_1.member.member_10.member_1;
let _e2603 = (((_e2595.member * _e2577) + (_e2595.member_1 * _e2578)) + (_e2595.member_2 * _e2579));
let _e2606 = (1f / select(1e-20f, _e2603, (_e2603 > 1e-20f)));
let _e2610 = global_1.member.member_10.member_4.member;
let _e2619 = ((((_e2610.member * _e2577) + (_e2610.member_1 * _e2578)) + (_e2610.member_2 * _e2579)) * _e2606);
let _e2623 = global_1.member.member_10.member_4.member_1;
let _e2632 = ((((_e2623.member * _e2577) + (_e2623.member_1 * _e2578)) + (_e2623.member_2 * _e2579)) * _e2606);
let _e2636 = global_1.member.member_10.member_4.member_2;
let _e2639 = ((_e2619 * _e2619) + (_e2632 * _e2632));
let _e2647 = global_1.member.member_10.member_4.member_3;
let _e2648 = ((_e2636 - sqrt(select(0f, _e2639, (_e2639 > 0f)))) * _e2647);
let _e2650 = select(0f, _e2648, (_e2648 > 0f));
let _e2652 = select(1f, _e2650, (_e2650 < 1f));
let _e2658 = select(0f, ((_e2652 * _e2652) * (3f - (2f * _e2652))), (_e2603 > 0f));
let _e2662 = global_1.member.member_10.member_4.member_5;
if ((_e2662 > 0u) && (_e2658 > 0f)) {
let _e2666 = (0.5f / _e2636);
let _e2675 = global_1.member.member_10.member_4.member_6;
let _e2676 = bitcast<i32>(_e2675);
local_2 = bitcast<i32>(_e2662);
let _e2677 = local_2;
let _e2679 = f32((_e2677 - 1i));
let _e2681 = f32((_e2676 - 1i));
let _e2682 = local_2;
let _e2685 = (((0.5f + (_e2619 * _e2666)) * f32(_e2682)) - 0.5f);
let _e2687 = select(0f, _e2685, (_e2685 > 0f));
let _e2689 = select(_e2679, _e2687, (_e2687 < _e2679));
let _e2692 = (((0.5f - (_e2632 * _e2666)) * f32(_e2676)) - 0.5f);
let _e2694 = select(0f, _e2692, (_e2692 > 0f));
let _e2696 = select(_e2681, _e2694, (_e2694 < _e2681));
let _e2698 = select(0f, _e2689, (_e2689 > 0f));
let _e2700 = select(_e2679, _e2698, (_e2698 < _e2679));
let _e2707 = select(0i, select(select(i32(_e2700), i32(-2147483648), (_e2700 < -2147483600f)), 2147483647i, (_e2700 > 2147483500f)), (_e2700 == _e2700));
let _e2711 = (_e2707 - select(0i, 1i, (_e2700 < f32(_e2707))));
let _e2713 = select(0f, _e2696, (_e2696 > 0f));
let _e2715 = select(_e2681, _e2713, (_e2713 < _e2681));
let _e2722 = select(0i, select(select(i32(_e2715), i32(-2147483648), (_e2715 < -2147483600f)), 2147483647i, (_e2715 > 2147483500f)), (_e2715 == _e2715));
let _e2726 = (_e2722 - select(0i, 1i, (_e2715 < f32(_e2722))));
let _e2728 = (_e2689 - f32(_e2711));
let _e2730 = (_e2696 - f32(_e2726));
let _e2731 = (_e2711 + 1i);
let _e2732 = local_2;
let _e2734 = select(_e2711, _e2731, (_e2731 < _e2732));
let _e2735 = (_e2726 + 1i);
let _e2737 = select(_e2726, _e2735, (_e2735 < _e2676));
let _e2741 = global_1.member.member_10.member_4.member_4;
let _e2742 = bitcast<i32>(_e2741);
let _e2743 = local_2;
let _e2747 = (_e2742 + (3i * ((_e2726 * _e2743) + _e2711)));
let _e2749 = (bitcast<i32>(_e146) - 1i);
let _e2751 = select(_e2749, _e2747, (_e2747 < _e2749));
let _e2756 = global_3.member[bitcast<u32>(select(0i, _e2751, (_e2751 > 0i)))];
let _e2757 = (_e2747 + 1i);
let _e2759 = select(_e2749, _e2757, (_e2757 < _e2749));
let _e2764 = global_3.member[bitcast<u32>(select(0i, _e2759, (_e2759 > 0i)))];
let _e2765 = (_e2747 + 2i);
let _e2767 = select(_e2749, _e2765, (_e2765 < _e2749));
let _e2772 = global_3.member[bitcast<u32>(select(0i, _e2767, (_e2767 > 0i)))];
let _e2773 = local_2;
let _e2777 = (_e2742 + (3i * ((_e2726 * _e2773) + _e2734)));
let _e2779 = select(_e2749, _e2777, (_e2777 < _e2749));
let _e2784 = global_3.member[bitcast<u32>(select(0i, _e2779, (_e2779 > 0i)))];
let _e2785 = (_e2777 + 1i);
let _e2787 = select(_e2749, _e2785, (_e2785 < _e2749));
let _e2792 = global_3.member[bitcast<u32>(select(0i, _e2787, (_e2787 > 0i)))];
let _e2793 = (_e2777 + 2i);
let _e2795 = select(_e2749, _e2793, (_e2793 < _e2749));
let _e2800 = global_3.member[bitcast<u32>(select(0i, _e2795, (_e2795 > 0i)))];
let _e2801 = local_2;
let _e2805 = (_e2742 + (3i * ((_e2737 * _e2801) + _e2711)));
let _e2807 = select(_e2749, _e2805, (_e2805 < _e2749));
let _e2812 = global_3.member[bitcast<u32>(select(0i, _e2807, (_e2807 > 0i)))];
let _e2813 = (_e2805 + 1i);
let _e2815 = select(_e2749, _e2813, (_e2813 < _e2749));
let _e2820 = global_3.member[bitcast<u32>(select(0i, _e2815, (_e2815 > 0i)))];
let _e2821 = (_e2805 + 2i);
let _e2823 = select(_e2749, _e2821, (_e2821 < _e2749));
let _e2828 = global_3.member[bitcast<u32>(select(0i, _e2823, (_e2823 > 0i)))];
let _e2829 = local_2;
let _e2833 = (_e2742 + (3i * ((_e2737 * _e2829) + _e2734)));
let _e2835 = select(_e2749, _e2833, (_e2833 < _e2749));
let _e2840 = global_3.member[bitcast<u32>(select(0i, _e2835, (_e2835 > 0i)))];
let _e2841 = (_e2833 + 1i);
let _e2843 = select(_e2749, _e2841, (_e2841 < _e2749));
let _e2848 = global_3.member[bitcast<u32>(select(0i, _e2843, (_e2843 > 0i)))];
let _e2849 = (_e2833 + 2i);
let _e2851 = select(_e2749, _e2849, (_e2849 < _e2749));
let _e2856 = global_3.member[bitcast<u32>(select(0i, _e2851, (_e2851 > 0i)))];
let _e2863 = (_e2756 + ((_e2784 - _e2756) * _e2728));
let _e2864 = (_e2764 + ((_e2792 - _e2764) * _e2728));
let _e2865 = (_e2772 + ((_e2800 - _e2772) * _e2728));
phi_4914_ = vec3<f32>(((_e2863 + (((_e2812 + ((_e2840 - _e2812) * _e2728)) - _e2863) * _e2730)) * _e2658), ((_e2864 + (((_e2820 + ((_e2848 - _e2820) * _e2728)) - _e2864) * _e2730)) * _e2658), ((_e2865 + (((_e2828 + ((_e2856 - _e2828) * _e2728)) - _e2865) * _e2730)) * _e2658));
} else {
phi_4914_ = vec3(_e2658);
}
let _e2890 = phi_4914_;
phi_4917_ = (_e2591 * _e2890);
} else {
phi_4917_ = _e2591;
}
let _e2893 = phi_4917_;
let _e2897 = (1f / sqrt(select(0f, _e2586, (_e2586 > 0f))));
phi_4930_ = type_26(vec3<f32>((_e2577 * _e2897), (_e2578 * _e2897), (_e2579 * _e2897)), _e2893);
}
let _e2904 = phi_4930_;
let _e2906 = (_e1569.member - _e2564);
let _e2907 = (_e1569.member_1 - _e2566);
let _e2908 = (_e1569.member_2 - _e2568);
let _e2913 = (((_e2906 * _e2906) + (_e2907 * _e2907)) + (_e2908 * _e2908));
let _e2917 = select(sqrt(select(0f, _e2913, (_e2913 > 0f))), 1e30f, _e1223);
let _e2919 = -(_e2904.member.x);
let _e2921 = -(_e2904.member.y);
let _e2923 = -(_e2904.member.z);
let _e2931 = (1f / select(_e2919, select(1e-12f, -1e-12f, (_e2919 < 0f)), (bitcast<f32>((bitcast<u32>(_e2919) & 2147483647u)) < 1e-12f)));
let _e2939 = (1f / select(_e2921, select(1e-12f, -1e-12f, (_e2921 < 0f)), (bitcast<f32>((bitcast<u32>(_e2921) & 2147483647u)) < 1e-12f)));
let _e2947 = (1f / select(_e2923, select(1e-12f, -1e-12f, (_e2923 < 0f)), (bitcast<f32>((bitcast<u32>(_e2923) & 2147483647u)) < 1e-12f)));
let _e2949 = ((_e1617.member - _e2564) * _e2931);
let _e2951 = ((_e1623.member - _e2564) * _e2931);
let _e2953 = ((_e1617.member_1 - _e2566) * _e2939);
let _e2955 = ((_e1623.member_1 - _e2566) * _e2939);
let _e2957 = ((_e1617.member_2 - _e2568) * _e2947);
let _e2959 = ((_e1623.member_2 - _e2568) * _e2947);
let _e2961 = select(_e2951, _e2949, (_e2949 < _e2951));
let _e2963 = select(_e2955, _e2953, (_e2953 < _e2955));
let _e2965 = select(_e2963, _e2961, (_e2961 > _e2963));
let _e2967 = select(_e2959, _e2957, (_e2957 < _e2959));
let _e2969 = select(_e2967, _e2965, (_e2965 > _e2967));
let _e2971 = select(_e2951, _e2949, (_e2949 > _e2951));
let _e2973 = select(_e2955, _e2953, (_e2953 > _e2955));
let _e2975 = select(_e2973, _e2971, (_e2971 < _e2973));
let _e2977 = select(_e2959, _e2957, (_e2957 > _e2959));
let _e2979 = select(_e2977, _e2975, (_e2975 < _e2977));
let _e2981 = select(0f, _e2969, (_e2969 > 0f));
let _e2983 = select(_e2917, _e2979, (_e2979 < _e2917));
let _e2984 = (_e2983 > _e2981);
let _e2988 = (_e2554 - _e2532);
let _e2991 = ((select(0f, _e2983, _e2984) - select(0f, _e2981, _e2984)) + select(0f, _e2988, (_e2988 > 0f)));
let _e2993 = -((_e1673.member * _e2991));
let _e2995 = select(-87f, _e2993, (_e2993 > -87f));
let _e2997 = select(88f, _e2995, (_e2995 < 88f));
let _e2999 = ((_e2997 * 1.442695f) + 0.5f);
let _e3001 = select(-127f, _e2999, (_e2999 > -127f));
let _e3003 = select(128f, _e3001, (_e3001 < 128f));
let _e3010 = select(0i, select(select(i32(_e3003), i32(-2147483648), (_e3003 < -2147483600f)), 2147483647i, (_e3003 > 2147483500f)), (_e3003 == _e3003));
let _e3014 = (_e3010 - select(0i, 1i, (_e3003 < f32(_e3010))));
let _e3015 = f32(_e3014);
let _e3019 = ((_e2997 - (_e3015 * 0.6933594f)) - (_e3015 * -2.1219444e-4f));
let _e3041 = -((_e1673.member_1 * _e2991));
let _e3043 = select(-87f, _e3041, (_e3041 > -87f));
let _e3045 = select(88f, _e3043, (_e3043 < 88f));
let _e3047 = ((_e3045 * 1.442695f) + 0.5f);
let _e3049 = select(-127f, _e3047, (_e3047 > -127f));
let _e3051 = select(128f, _e3049, (_e3049 < 128f));
let _e3058 = select(0i, select(select(i32(_e3051), i32(-2147483648), (_e3051 < -2147483600f)), 2147483647i, (_e3051 > 2147483500f)), (_e3051 == _e3051));
let _e3062 = (_e3058 - select(0i, 1i, (_e3051 < f32(_e3058))));
let _e3063 = f32(_e3062);
let _e3067 = ((_e3045 - (_e3063 * 0.6933594f)) - (_e3063 * -2.1219444e-4f));
let _e3089 = -((_e1673.member_2 * _e2991));
let _e3091 = select(-87f, _e3089, (_e3089 > -87f));
let _e3093 = select(88f, _e3091, (_e3091 < 88f));
let _e3095 = ((_e3093 * 1.442695f) + 0.5f);
let _e3097 = select(-127f, _e3095, (_e3095 > -127f));
let _e3099 = select(128f, _e3097, (_e3097 < 128f));
let _e3106 = select(0i, select(select(i32(_e3099), i32(-2147483648), (_e3099 < -2147483600f)), 2147483647i, (_e3099 > 2147483500f)), (_e3099 == _e3099));
let _e3110 = (_e3106 - select(0i, 1i, (_e3099 < f32(_e3106))));
let _e3111 = f32(_e3110);
let _e3115 = ((_e3093 - (_e3111 * 0.6933594f)) - (_e3111 * -2.1219444e-4f));
let _e3141 = -((((_e2904.member.x * _e2531.x) + (_e2904.member.y * _e2531.y)) + (_e2904.member.z * _e2531.z)));
let _e3143 = (_e1831 - (_e1832 * _e3141));
let _e3145 = select(1e-9f, _e3143, (_e3143 > 1e-9f));
let _e3157 = ((3.1415927f * (select((_e1837 / (_e3145 * sqrt(select(0f, _e3145, (_e3145 > 0f))))), (0.75f * (1f + (_e3141 * _e3141))), _e1849) * _e1851)) * select((_e2547 * ((2f * (1f + _e2537)) / (_e2540 * _e2540))), 1f, _e2555));
let _e3171 = local_5;
let _e3172 = local_6;
let _e3173 = local_7;
let _e3174 = local_10;
let _e3175 = local_9;
let _e3177 = (_e3174 + (_e3175 * 0.33998105f));
let _e3178 = (_e3177 * _e3177);
let _e3179 = (1f - _e3178);
let _e3181 = select(1e-9f, _e3179, (_e3179 > 1e-9f));
let _e3182 = local_8.member;
let _e3183 = local_8.member_1;
let _e3188 = local_8.member_1;
let _e3194 = local_8.member_2;
let _e3195 = select((_e3182 + (_e3183 * ((2f * _e3177) / _e3181))), _e3177, _e3194);
let _e3196 = local_8.member_2;
let _e3205 = (_e3171.x + (_e3172.x * _e3195));
let _e3207 = (_e3171.y + (_e3172.y * _e3195));
let _e3209 = (_e3171.z + (_e3172.z * _e3195));
if _e1223 {
let _e3212 = global_1.member.member_10.member_1;
phi_5945_ = type_26(vec3<f32>(_e3212.member, _e3212.member_1, _e3212.member_2), _e1219);
} else {
let _e3218 = (_e3205 - _e1569.member);
let _e3219 = (_e3207 - _e1569.member_1);
let _e3220 = (_e3209 - _e1569.member_2);
let _e3225 = (((_e3218 * _e3218) + (_e3219 * _e3219)) + (_e3220 * _e3220));
let _e3227 = select(1e-12f, _e3225, (_e3225 > 1e-12f));
let _e3228 = (1f / _e3227);
let _e3232 = vec3<f32>((_e1215.member * _e3228), (_e1215.member_1 * _e3228), (_e1215.member_2 * _e3228));
if (_e1222 == 2u) {
let _e3236 = global_1.member.member_10.member_1;
let _e3244 = (((_e3236.member * _e3218) + (_e3236.member_1 * _e3219)) + (_e3236.member_2 * _e3220));
let _e3247 = (1f / select(1e-20f, _e3244, (_e3244 > 1e-20f)));
let _e3251 = global_1.member.member_10.member_4.member;
let _e3260 = ((((_e3251.member * _e3218) + (_e3251.member_1 * _e3219)) + (_e3251.member_2 * _e3220)) * _e3247);
let _e3264 = global_1.member.member_10.member_4.member_1;
let _e3273 = ((((_e3264.member * _e3218) + (_e3264.member_1 * _e3219)) + (_e3264.member_2 * _e3220)) * _e3247);
let _e3277 = global_1.member.member_10.member_4.member_2;
let _e3280 = ((_e3260 * _e3260) + (_e3273 * _e3273));
let _e3288 = global_1.member.member_10.member_4.member_3;
let _e3289 = ((_e3277 - sqrt(select(0f, _e3280, (_e3280 > 0f)))) * _e3288);
let _e3291 = select(0f, _e3289, (_e3289 > 0f));
let _e3293 = select(1f, _e3291, (_e3291 < 1f));
let _e3299 = select(0f, ((_e3293 * _e3293) * (3f - (2f * _e3293))), (_e3244 > 0f));
let _e3303 = global_1.member.member_10.member_4.member_5;
if ((_e3303 > 0u) && (_e3299 > 0f)) {
let _e3307 = (0.5f / _e3277);
let _e3316 = global_1.member.member_10.member_4.member_6;
let _e3317 = bitcast<i32>(_e3316);
local_1 = bitcast<i32>(_e3303);
let _e3318 = local_1;
let _e3320 = f32((_e3318 - 1i));
let _e3322 = f32((_e3317 - 1i));
let _e3323 = local_1;
let _e3326 = (((0.5f + (_e3260 * _e3307)) * f32(_e3323)) - 0.5f);
let _e3328 = select(0f, _e3326, (_e3326 > 0f));
let _e3330 = select(_e3320, _e3328, (_e3328 < _e3320));
let _e3333 = (((0.5f - (_e3273 * _e3307)) * f32(_e3317)) - 0.5f);
let _e3335 = select(0f, _e3333, (_e3333 > 0f));
let _e3337 = select(_e3322, _e3335, (_e3335 < _e3322));
let _e3339 = select(0f, _e3330, (_e3330 > 0f));
let _e3341 = select(_e3320, _e3339, (_e3339 < _e3320));
let _e3348 = select(0i, select(select(i32(_e3341), i32(-2147483648), (_e3341 < -2147483600f)), 2147483647i, (_e3341 > 2147483500f)), (_e3341 == _e3341));
let _e3352 = (_e3348 - select(0i, 1i, (_e3341 < f32(_e3348))));
let _e3354 = select(0f, _e3337, (_e3337 > 0f));
let _e3356 = select(_e3322, _e3354, (_e3354 < _e3322));
let _e3363 = select(0i, select(select(i32(_e3356), i32(-2147483648), (_e3356 < -2147483600f)), 2147483647i, (_e3356 > 2147483500f)), (_e3356 == _e3356));
let _e3367 = (_e3363 - select(0i, 1i, (_e3356 < f32(_e3363))));
let _e3369 = (_e3330 - f32(_e3352));
let _e3371 = (_e3337 - f32(_e3367));
let _e3372 = (_e3352 + 1i);
let _e3373 = local_1;
let _e3375 = select(_e3352, _e3372, (_e3372 < _e3373));
let _e3376 = (_e3367 + 1i);
let _e3378 = select(_e3367, _e3376, (_e3376 < _e3317));
let _e3382 = global_1.member.member_10.member_4.member_4;
let _e3383 = bitcast<i32>(_e3382);
let _e3384 = local_1;
let _e3388 = (_e3383 + (3i * ((_e3367 * _e3384) + _e3352)));
let _e3390 = (bitcast<i32>(_e146) - 1i);
let _e3392 = select(_e3390, _e3388, (_e3388 < _e3390));
let _e3397 = global_3.member[bitcast<u32>(select(0i, _e3392, (_e3392 > 0i)))];
let _e3398 = (_e3388 + 1i);
let _e3400 = select(_e3390, _e3398, (_e3398 < _e3390));
let _e3405 = global_3.member[bitcast<u32>(select(0i, _e3400, (_e3400 > 0i)))];
let _e3406 = (_e3388 + 2i);
let _e3408 = select(_e3390, _e3406, (_e3406 < _e3390));
let _e3413 = global_3.member[bitcast<u32>(select(0i, _e3408, (_e3408 > 0i)))];
let _e3414 = local_1;
let _e3418 = (_e3383 + (3i * ((_e3367 * _e3414) + _e3375)));
let _e3420 = select(_e3390, _e3418, (_e3418 < _e3390));
let _e3425 = global_3.member[bitcast<u32>(select(0i, _e3420, (_e3420 > 0i)))];
let _e3426 = (_e3418 + 1i);
let _e3428 = select(_e3390, _e3426, (_e3426 < _e3390));
let _e3433 = global_3.member[bitcast<u32>(select(0i, _e3428, (_e3428 > 0i)))];
let _e3434 = (_e3418 + 2i);
let _e3436 = select(_e3390, _e3434, (_e3434 < _e3390));
let _e3441 = global_3.member[bitcast<u32>(select(0i, _e3436, (_e3436 > 0i)))];
let _e3442 = local_1;
let _e3446 = (_e3383 + (3i * ((_e3378 * _e3442) + _e3352)));
let _e3448 = select(_e3390, _e3446, (_e3446 < _e3390));
let _e3453 = global_3.member[bitcast<u32>(select(0i, _e3448, (_e3448 > 0i)))];
let _e3454 = (_e3446 + 1i);
let _e3456 = select(_e3390, _e3454, (_e3454 < _e3390));
let _e3461 = global_3.member[bitcast<u32>(select(0i, _e3456, (_e3456 > 0i)))];
let _e3462 = (_e3446 + 2i);
let _e3464 = select(_e3390, _e3462, (_e3462 < _e3390));
let _e3469 = global_3.member[bitcast<u32>(select(0i, _e3464, (_e3464 > 0i)))];
let _e3470 = local_1;
let _e3474 = (_e3383 + (3i * ((_e3378 * _e3470) + _e3375)));
let _e3476 = select(_e3390, _e3474, (_e3474 < _e3390));
let _e3481 = global_3.member[bitcast<u32>(select(0i, _e3476, (_e3476 > 0i)))];
let _e3482 = (_e3474 + 1i);
let _e3484 = select(_e3390, _e3482, (_e3482 < _e3390));
let _e3489 = global_3.member[bitcast<u32>(select(0i, _e3484, (_e3484 > 0i)))];
let _e3490 = (_e3474 + 2i);
let _e3492 = select(_e3390, _e3490, (_e3490 < _e3390));
let _e3497 = global_3.member[bitcast<u32>(select(0i, _e3492, (_e3492 > 0i)))];
let _e3504 = (_e3397 + ((_e3425 - _e3397) * _e3369));
let _e3505 = (_e3405 + ((_e3433 - _e3405) * _e3369));
let _e3506 = (_e3413 + ((_e3441 - _e3413) * _e3369));
phi_5929_ = vec3<f32>(((_e3504 + (((_e3453 + ((_e3481 - _e3453) * _e3369)) - _e3504) * _e3371)) * _e3299), ((_e3505 + (((_e3461 + ((_e3489 - _e3461) * _e3369)) - _e3505) * _e3371)) * _e3299), ((_e3506 + (((_e3469 + ((_e3497 - _e3469) * _e3369)) - _e3506) * _e3371)) * _e3299));
} else {
phi_5929_ = vec3(_e3299);
}
let _e3531 = phi_5929_;
phi_5932_ = (_e3232 * _e3531);
} else {
phi_5932_ = _e3232;
}
let _e3534 = phi_5932_;
let _e3538 = (1f / sqrt(select(0f, _e3227, (_e3227 > 0f))));
phi_5945_ = type_26(vec3<f32>((_e3218 * _e3538), (_e3219 * _e3538), (_e3220 * _e3538)), _e3534);
}
let _e3545 = phi_5945_;
let _e3547 = (_e1569.member - _e3205);
let _e3548 = (_e1569.member_1 - _e3207);
let _e3549 = (_e1569.member_2 - _e3209);
let _e3554 = (((_e3547 * _e3547) + (_e3548 * _e3548)) + (_e3549 * _e3549));
let _e3558 = select(sqrt(select(0f, _e3554, (_e3554 > 0f))), 1e30f, _e1223);
let _e3560 = -(_e3545.member.x);
let _e3562 = -(_e3545.member.y);
let _e3564 = -(_e3545.member.z);
let _e3572 = (1f / select(_e3560, select(1e-12f, -1e-12f, (_e3560 < 0f)), (bitcast<f32>((bitcast<u32>(_e3560) & 2147483647u)) < 1e-12f)));
let _e3580 = (1f / select(_e3562, select(1e-12f, -1e-12f, (_e3562 < 0f)), (bitcast<f32>((bitcast<u32>(_e3562) & 2147483647u)) < 1e-12f)));
let _e3588 = (1f / select(_e3564, select(1e-12f, -1e-12f, (_e3564 < 0f)), (bitcast<f32>((bitcast<u32>(_e3564) & 2147483647u)) < 1e-12f)));
let _e3590 = ((_e1617.member - _e3205) * _e3572);
let _e3592 = ((_e1623.member - _e3205) * _e3572);
let _e3594 = ((_e1617.member_1 - _e3207) * _e3580);
let _e3596 = ((_e1623.member_1 - _e3207) * _e3580);
let _e3598 = ((_e1617.member_2 - _e3209) * _e3588);
let _e3600 = ((_e1623.member_2 - _e3209) * _e3588);
let _e3602 = select(_e3592, _e3590, (_e3590 < _e3592));
let _e3604 = select(_e3596, _e3594, (_e3594 < _e3596));
let _e3606 = select(_e3604, _e3602, (_e3602 > _e3604));
let _e3608 = select(_e3600, _e3598, (_e3598 < _e3600));
let _e3610 = select(_e3608, _e3606, (_e3606 > _e3608));
let _e3612 = select(_e3592, _e3590, (_e3590 > _e3592));
let _e3614 = select(_e3596, _e3594, (_e3594 > _e3596));
let _e3616 = select(_e3614, _e3612, (_e3612 < _e3614));
let _e3618 = select(_e3600, _e3598, (_e3598 > _e3600));
let _e3620 = select(_e3618, _e3616, (_e3616 < _e3618));
let _e3622 = select(0f, _e3610, (_e3610 > 0f));
let _e3624 = select(_e3558, _e3620, (_e3620 < _e3558));
let _e3625 = (_e3624 > _e3622);
let _e3629 = (_e3195 - _e3173);
let _e3632 = ((select(0f, _e3624, _e3625) - select(0f, _e3622, _e3625)) + select(0f, _e3629, (_e3629 > 0f)));
let _e3634 = -((_e1673.member * _e3632));
let _e3636 = select(-87f, _e3634, (_e3634 > -87f));
let _e3638 = select(88f, _e3636, (_e3636 < 88f));
let _e3640 = ((_e3638 * 1.442695f) + 0.5f);
let _e3642 = select(-127f, _e3640, (_e3640 > -127f));
let _e3644 = select(128f, _e3642, (_e3642 < 128f));
let _e3651 = select(0i, select(select(i32(_e3644), i32(-2147483648), (_e3644 < -2147483600f)), 2147483647i, (_e3644 > 2147483500f)), (_e3644 == _e3644));
let _e3655 = (_e3651 - select(0i, 1i, (_e3644 < f32(_e3651))));
let _e3656 = f32(_e3655);
let _e3660 = ((_e3638 - (_e3656 * 0.6933594f)) - (_e3656 * -2.1219444e-4f));
let _e3682 = -((_e1673.member_1 * _e3632));
let _e3684 = select(-87f, _e3682, (_e3682 > -87f));
let _e3686 = select(88f, _e3684, (_e3684 < 88f));
let _e3688 = ((_e3686 * 1.442695f) + 0.5f);
let _e3690 = select(-127f, _e3688, (_e3688 > -127f));
let _e3692 = select(128f, _e3690, (_e3690 < 128f));
let _e3699 = select(0i, select(select(i32(_e3692), i32(-2147483648), (_e3692 < -2147483600f)), 2147483647i, (_e3692 > 2147483500f)), (_e3692 == _e3692));
let _e3703 = (_e3699 - select(0i, 1i, (_e3692 < f32(_e3699))));
let _e3704 = f32(_e3703);
let _e3708 = ((_e3686 - (_e3704 * 0.6933594f)) - (_e3704 * -2.1219444e-4f));
let _e3730 = -((_e1673.member_2 * _e3632));
let _e3732 = select(-87f, _e3730, (_e3730 > -87f));
let _e3734 = select(88f, _e3732, (_e3732 < 88f));
let _e3736 = ((_e3734 * 1.442695f) + 0.5f);
let _e3738 = select(-127f, _e3736, (_e3736 > -127f));
let _e3740 = select(128f, _e3738, (_e3738 < 128f));
let _e3747 = select(0i, select(select(i32(_e3740), i32(-2147483648), (_e3740 < -2147483600f)), 2147483647i, (_e3740 > 2147483500f)), (_e3740 == _e3740));
let _e3751 = (_e3747 - select(0i, 1i, (_e3740 < f32(_e3747))));
let _e3752 = f32(_e3751);
let _e3756 = ((_e3734 - (_e3752 * 0.6933594f)) - (_e3752 * -2.1219444e-4f));
let _e3782 = -((((_e3545.member.x * _e3172.x) + (_e3545.member.y * _e3172.y)) + (_e3545.member.z * _e3172.z)));
let _e3784 = (_e1831 - (_e1832 * _e3782));
let _e3786 = select(1e-9f, _e3784, (_e3784 > 1e-9f));
let _e3798 = ((3.1415927f * (select((_e1837 / (_e3786 * sqrt(select(0f, _e3786, (_e3786 > 0f))))), (0.75f * (1f + (_e3782 * _e3782))), _e1849) * _e1851)) * select((_e3188 * ((2f * (1f + _e3178)) / (_e3181 * _e3181))), 1f, _e3196));
let _e3815 = local_9;
let _e3816 = (_e3815 * 0.65214515f);
phi_2281_ = vec3<f32>(((_e1163.x + (((((_e1565.member_1.x * ((1f + (_e1704 * (1f + (_e1704 * (0.5f + (_e1704 * (0.16666667f + (_e1704 * (0.041666668f + (_e1704 * (0.008333334f + (_e1704 * (0.001388889f + (_e1704 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1699 + 127i)) << bitcast<u32>(23i))))) * _e1864.member) * _e1854) + (((_e2248.member_1.x * ((1f + (_e2363 * (1f + (_e2363 * (0.5f + (_e2363 * (0.16666667f + (_e2363 * (0.041666668f + (_e2363 * (0.008333334f + (_e2363 * (0.001388889f + (_e2363 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2358 + 127i)) << bitcast<u32>(23i))))) * _e1864.member) * _e2501)) * _e2519)) + (((((_e2904.member_1.x * ((1f + (_e3019 * (1f + (_e3019 * (0.5f + (_e3019 * (0.16666667f + (_e3019 * (0.041666668f + (_e3019 * (0.008333334f + (_e3019 * (0.001388889f + (_e3019 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3014 + 127i)) << bitcast<u32>(23i))))) * _e1864.member) * _e3157) + (((_e3545.member_1.x * ((1f + (_e3660 * (1f + (_e3660 * (0.5f + (_e3660 * (0.16666667f + (_e3660 * (0.041666668f + (_e3660 * (0.008333334f + (_e3660 * (0.001388889f + (_e3660 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3655 + 127i)) << bitcast<u32>(23i))))) * _e1864.member) * _e3798)) * _e3816)), ((_e1163.y + (((((_e1565.member_1.y * ((1f + (_e1752 * (1f + (_e1752 * (0.5f + (_e1752 * (0.16666667f + (_e1752 * (0.041666668f + (_e1752 * (0.008333334f + (_e1752 * (0.001388889f + (_e1752 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1747 + 127i)) << bitcast<u32>(23i))))) * _e1864.member_1) * _e1854) + (((_e2248.member_1.y * ((1f + (_e2411 * (1f + (_e2411 * (0.5f + (_e2411 * (0.16666667f + (_e2411 * (0.041666668f + (_e2411 * (0.008333334f + (_e2411 * (0.001388889f + (_e2411 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2406 + 127i)) << bitcast<u32>(23i))))) * _e1864.member_1) * _e2501)) * _e2519)) + (((((_e2904.member_1.y * ((1f + (_e3067 * (1f + (_e3067 * (0.5f + (_e3067 * (0.16666667f + (_e3067 * (0.041666668f + (_e3067 * (0.008333334f + (_e3067 * (0.001388889f + (_e3067 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3062 + 127i)) << bitcast<u32>(23i))))) * _e1864.member_1) * _e3157) + (((_e3545.member_1.y * ((1f + (_e3708 * (1f + (_e3708 * (0.5f + (_e3708 * (0.16666667f + (_e3708 * (0.041666668f + (_e3708 * (0.008333334f + (_e3708 * (0.001388889f + (_e3708 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3703 + 127i)) << bitcast<u32>(23i))))) * _e1864.member_1) * _e3798)) * _e3816)), ((_e1163.z + (((((_e1565.member_1.z * ((1f + (_e1800 * (1f + (_e1800 * (0.5f + (_e1800 * (0.16666667f + (_e1800 * (0.041666668f + (_e1800 * (0.008333334f + (_e1800 * (0.001388889f + (_e1800 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1795 + 127i)) << bitcast<u32>(23i))))) * _e1864.member_2) * _e1854) + (((_e2248.member_1.z * ((1f + (_e2459 * (1f + (_e2459 * (0.5f + (_e2459 * (0.16666667f + (_e2459 * (0.041666668f + (_e2459 * (0.008333334f + (_e2459 * (0.001388889f + (_e2459 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2454 + 127i)) << bitcast<u32>(23i))))) * _e1864.member_2) * _e2501)) * _e2519)) + (((((_e2904.member_1.z * ((1f + (_e3115 * (1f + (_e3115 * (0.5f + (_e3115 * (0.16666667f + (_e3115 * (0.041666668f + (_e3115 * (0.008333334f + (_e3115 * (0.001388889f + (_e3115 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3110 + 127i)) << bitcast<u32>(23i))))) * _e1864.member_2) * _e3157) + (((_e3545.member_1.z * ((1f + (_e3756 * (1f + (_e3756 * (0.5f + (_e3756 * (0.16666667f + (_e3756 * (0.041666668f + (_e3756 * (0.008333334f + (_e3756 * (0.001388889f + (_e3756 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3751 + 127i)) << bitcast<u32>(23i))))) * _e1864.member_2) * _e3798)) * _e3816)));
phi_2283_ = (_e1165 + 1i);
} else {
phi_2281_ = vec3<f32>();
phi_2283_ = i32();
}
let _e3826 = phi_2281_;
let _e3828 = phi_2283_;
continue;
continuing {
phi_2280_ = _e3826;
phi_2282_ = _e3828;
break if !(_e1166);
}
}
let _e6391 = local_45;
phi_6396_ = _e6391;
} else {
phi_6396_ = vec3<f32>(0f, 0f, 0f);
}
let _e3831 = phi_6396_;
phi_6411_ = type_24(_e426.member, _e426.member_1, _e426.member_2, vec3<f32>((_e233 + (_e3831.x * _e723)), (_e244 + (_e3831.y * _e724)), (_e255 + (_e3831.z * _e725))), _e426.member_4, _e426.member_5, _e426.member_6, _e426.member_7);
} else {
phi_6411_ = _e426;
}
let _e3851 = phi_6411_;
let _e3852 = (_e628 == -1i);
let _e3853 = select(_e722, 0f, _e3852);
let _e3857 = (_e718 + (_e466 * _e3853));
let _e3858 = (_e719 + (_e477 * _e3853));
let _e3859 = (_e720 + (_e488 * _e3853));
let _e3860 = vec3<f32>(_e3857, _e3858, _e3859);
let _e3863 = (_e628 >= 0i);
if _e3863 {
let _e3864 = (_e628 * 19i);
let _e3866 = (bitcast<i32>(_e148) - 1i);
let _e3868 = select(_e3866, _e3864, (_e3864 < _e3866));
let _e3874 = global_4.member[bitcast<u32>(select(0i, _e3868, (_e3868 > 0i)))];
let _e3875 = (_e3864 + 1i);
let _e3877 = select(_e3866, _e3875, (_e3875 < _e3866));
let _e3883 = global_4.member[bitcast<u32>(select(0i, _e3877, (_e3877 > 0i)))];
let _e3884 = (_e3864 + 2i);
let _e3886 = select(_e3866, _e3884, (_e3884 < _e3866));
let _e3892 = global_4.member[bitcast<u32>(select(0i, _e3886, (_e3886 > 0i)))];
let _e3893 = (_e3864 + 3i);
let _e3895 = select(_e3866, _e3893, (_e3893 < _e3866));
let _e3901 = global_4.member[bitcast<u32>(select(0i, _e3895, (_e3895 > 0i)))];
let _e3902 = (_e3864 + 4i);
let _e3904 = select(_e3866, _e3902, (_e3902 < _e3866));
let _e3910 = global_4.member[bitcast<u32>(select(0i, _e3904, (_e3904 > 0i)))];
let _e3911 = (_e3864 + 5i);
let _e3913 = select(_e3866, _e3911, (_e3911 < _e3866));
let _e3919 = global_4.member[bitcast<u32>(select(0i, _e3913, (_e3913 > 0i)))];
let _e3920 = (_e3864 + 6i);
let _e3922 = select(_e3866, _e3920, (_e3920 < _e3866));
let _e3928 = global_4.member[bitcast<u32>(select(0i, _e3922, (_e3922 > 0i)))];
let _e3929 = (_e3864 + 7i);
let _e3931 = select(_e3866, _e3929, (_e3929 < _e3866));
let _e3937 = global_4.member[bitcast<u32>(select(0i, _e3931, (_e3931 > 0i)))];
let _e3938 = (_e3864 + 8i);
let _e3940 = select(_e3866, _e3938, (_e3938 < _e3866));
let _e3946 = global_4.member[bitcast<u32>(select(0i, _e3940, (_e3940 > 0i)))];
let _e3947 = (_e3901 - _e3874);
let _e3948 = (_e3910 - _e3883);
let _e3949 = (_e3919 - _e3892);
let _e3950 = (_e3928 - _e3874);
let _e3951 = (_e3937 - _e3883);
let _e3952 = (_e3946 - _e3892);
let _e3955 = ((_e3948 * _e3952) - (_e3949 * _e3951));
let _e3958 = ((_e3949 * _e3950) - (_e3947 * _e3952));
let _e3961 = ((_e3947 * _e3951) - (_e3948 * _e3950));
let _e3962 = (_e3901 - _e3857);
let _e3963 = (_e3910 - _e3858);
let _e3964 = (_e3919 - _e3859);
let _e3965 = (_e3928 - _e3857);
let _e3966 = (_e3937 - _e3858);
let _e3967 = (_e3946 - _e3859);
let _e3981 = (((((_e3963 * _e3967) - (_e3964 * _e3966)) * _e3955) + (((_e3964 * _e3965) - (_e3962 * _e3967)) * _e3958)) + (((_e3962 * _e3966) - (_e3963 * _e3965)) * _e3961));
let _e3983 = select(0f, _e3981, (_e3981 > 0f));
let _e3984 = (_e3874 - _e3857);
let _e3985 = (_e3883 - _e3858);
let _e3986 = (_e3892 - _e3859);
let _e4000 = (((((_e3966 * _e3986) - (_e3967 * _e3985)) * _e3955) + (((_e3967 * _e3984) - (_e3965 * _e3986)) * _e3958)) + (((_e3965 * _e3985) - (_e3966 * _e3984)) * _e3961));
let _e4002 = select(0f, _e4000, (_e4000 > 0f));
let _e4016 = (((((_e3985 * _e3964) - (_e3986 * _e3963)) * _e3955) + (((_e3986 * _e3962) - (_e3984 * _e3964)) * _e3958)) + (((_e3984 * _e3963) - (_e3985 * _e3962)) * _e3961));
let _e4018 = select(0f, _e4016, (_e4016 > 0f));
let _e4020 = ((_e3983 + _e4002) + _e4018);
let _e4022 = select(1e-30f, _e4020, (_e4020 > 1e-30f));
let _e4023 = (_e3983 / _e4022);
let _e4024 = (_e4002 / _e4022);
let _e4025 = (_e4018 / _e4022);
let _e4030 = (((_e3955 * _e3955) + (_e3958 * _e3958)) + (_e3961 * _e3961));
let _e4033 = sqrt(select(0f, _e4030, (_e4030 > 0f)));
let _e4036 = (1f / select(1e-20f, _e4033, (_e4033 > 1e-20f)));
let _e4041 = (_e3864 + 9i);
let _e4043 = select(_e3866, _e4041, (_e4041 < _e3866));
let _e4049 = global_4.member[bitcast<u32>(select(0i, _e4043, (_e4043 > 0i)))];
let _e4050 = (_e3864 + 10i);
let _e4052 = select(_e3866, _e4050, (_e4050 < _e3866));
let _e4058 = global_4.member[bitcast<u32>(select(0i, _e4052, (_e4052 > 0i)))];
let _e4059 = (_e3864 + 11i);
let _e4061 = select(_e3866, _e4059, (_e4059 < _e3866));
let _e4067 = global_4.member[bitcast<u32>(select(0i, _e4061, (_e4061 > 0i)))];
let _e4071 = (_e3864 + 12i);
let _e4073 = select(_e3866, _e4071, (_e4071 < _e3866));
let _e4079 = global_4.member[bitcast<u32>(select(0i, _e4073, (_e4073 > 0i)))];
let _e4080 = (_e3864 + 13i);
let _e4082 = select(_e3866, _e4080, (_e4080 < _e3866));
let _e4088 = global_4.member[bitcast<u32>(select(0i, _e4082, (_e4082 > 0i)))];
let _e4089 = (_e3864 + 14i);
let _e4091 = select(_e3866, _e4089, (_e4089 < _e3866));
let _e4097 = global_4.member[bitcast<u32>(select(0i, _e4091, (_e4091 > 0i)))];
let _e4104 = (_e3864 + 15i);
let _e4106 = select(_e3866, _e4104, (_e4104 < _e3866));
let _e4112 = global_4.member[bitcast<u32>(select(0i, _e4106, (_e4106 > 0i)))];
let _e4113 = (_e3864 + 16i);
let _e4115 = select(_e3866, _e4113, (_e4113 < _e3866));
let _e4121 = global_4.member[bitcast<u32>(select(0i, _e4115, (_e4115 > 0i)))];
let _e4122 = (_e3864 + 17i);
let _e4124 = select(_e3866, _e4122, (_e4122 < _e3866));
let _e4130 = global_4.member[bitcast<u32>(select(0i, _e4124, (_e4124 > 0i)))];
let _e4134 = (((_e4049 * _e4023) + (_e4079 * _e4024)) + (_e4112 * _e4025));
let _e4135 = (((_e4058 * _e4023) + (_e4088 * _e4024)) + (_e4121 * _e4025));
let _e4136 = (((_e4067 * _e4023) + (_e4097 * _e4024)) + (_e4130 * _e4025));
let _e4141 = (((_e4134 * _e4134) + (_e4135 * _e4135)) + (_e4136 * _e4136));
let _e4144 = sqrt(select(0f, _e4141, (_e4141 > 0f)));
let _e4147 = (1f / select(1e-20f, _e4144, (_e4144 > 1e-20f)));
let _e4152 = (_e3864 + 18i);
let _e4154 = select(_e3866, _e4152, (_e4152 < _e3866));
let _e4160 = global_4.member[bitcast<u32>(select(0i, _e4154, (_e4154 > 0i)))];
let _e4169 = (select(select(0i, select(select(i32(_e4160), i32(-2147483648), (_e4160 < -2147483600f)), 2147483647i, (_e4160 > 2147483500f)), (_e4160 == _e4160)), _e628, ((_e957 & 1u) != 0u)) * 10i);
let _e4171 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e4173 = select(_e4171, _e4169, (_e4169 < _e4171));
let _e4179 = global_5.member[bitcast<u32>(select(0i, _e4173, (_e4173 > 0i)))];
let _e4180 = (_e4169 + 1i);
let _e4182 = select(_e4171, _e4180, (_e4180 < _e4171));
let _e4188 = global_5.member[bitcast<u32>(select(0i, _e4182, (_e4182 > 0i)))];
let _e4189 = (_e4169 + 2i);
let _e4191 = select(_e4171, _e4189, (_e4189 < _e4171));
let _e4197 = global_5.member[bitcast<u32>(select(0i, _e4191, (_e4191 > 0i)))];
let _e4201 = (_e4169 + 3i);
let _e4203 = select(_e4171, _e4201, (_e4201 < _e4171));
let _e4209 = global_5.member[bitcast<u32>(select(0i, _e4203, (_e4203 > 0i)))];
let _e4210 = (_e4169 + 4i);
let _e4212 = select(_e4171, _e4210, (_e4210 < _e4171));
let _e4218 = global_5.member[bitcast<u32>(select(0i, _e4212, (_e4212 > 0i)))];
let _e4219 = (_e4169 + 5i);
let _e4221 = select(_e4171, _e4219, (_e4219 < _e4171));
let _e4227 = global_5.member[bitcast<u32>(select(0i, _e4221, (_e4221 > 0i)))];
let _e4234 = (_e4169 + 6i);
let _e4236 = select(_e4171, _e4234, (_e4234 < _e4171));
let _e4242 = global_5.member[bitcast<u32>(select(0i, _e4236, (_e4236 > 0i)))];
let _e4243 = (_e4169 + 7i);
let _e4245 = select(_e4171, _e4243, (_e4243 < _e4171));
let _e4251 = global_5.member[bitcast<u32>(select(0i, _e4245, (_e4245 > 0i)))];
let _e4252 = (_e4169 + 8i);
let _e4254 = select(_e4171, _e4252, (_e4252 < _e4171));
let _e4260 = global_5.member[bitcast<u32>(select(0i, _e4254, (_e4254 > 0i)))];
let _e4268 = (_e4169 + 9i);
let _e4270 = select(_e4171, _e4268, (_e4268 < _e4171));
let _e4276 = global_5.member[bitcast<u32>(select(0i, _e4270, (_e4270 > 0i)))];
phi_7146_ = type_25(_e3860, vec3<f32>((_e3955 * _e4036), (_e3958 * _e4036), (_e3961 * _e4036)), vec3<f32>((_e4134 * _e4147), (_e4135 * _e4147), (_e4136 * _e4147)), vec3<f32>((((_e4179 * _e4023) + (_e4209 * _e4024)) + (_e4242 * _e4025)), (((_e4188 * _e4023) + (_e4218 * _e4024)) + (_e4251 * _e4025)), (((_e4197 * _e4023) + (_e4227 * _e4024)) + (_e4260 * _e4025))), _e4276, true);
} else {
let _e4278 = (_e628 == -3i);
let _e4284 = global_1.member.member_14.member_1.member.member;
let _e4289 = global_1.member.member_14.member_1.member_1;
let _e4295 = global_1.member.member_14.member.member.member;
let _e4300 = global_1.member.member_14.member.member_1;
let _e4310 = vec3<f32>(select(_e4295.member, _e4284.member, _e4278), select(_e4295.member_1, _e4284.member_1, _e4278), select(_e4295.member_2, _e4284.member_2, _e4278));
phi_7146_ = type_25(_e3860, _e4310, _e4310, vec3<f32>(select(_e4300.member, _e4289.member, _e4278), select(_e4300.member_1, _e4289.member_1, _e4278), select(_e4300.member_2, _e4289.member_2, _e4278)), 0f, false);
}
let _e4323 = phi_7146_;
let _e4326 = ((select(0i, _e628, _e3863) * 19i) + 18i);
let _e4328 = (bitcast<i32>(_e148) - 1i);
let _e4330 = select(_e4328, _e4326, (_e4326 < _e4328));
let _e4336 = global_4.member[bitcast<u32>(select(0i, _e4330, (_e4330 > 0i)))];
let _e4343 = select(0i, select(select(i32(_e4336), i32(-2147483648), (_e4336 < -2147483600f)), 2147483647i, (_e4336 > 2147483500f)), (_e4336 == _e4336));
let _e4344 = (_e4343 * 4i);
let _e4346 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e4348 = select(_e4346, _e4344, (_e4344 < _e4346));
let _e4354 = global_7.member[bitcast<u32>(select(0i, _e4348, (_e4348 > 0i)))];
if _e3863 {
phi_7210_ = (select(_e4354, 1f, (_e4343 == 16i)) == 0f);
} else {
phi_7210_ = (_e628 != -1i);
}
let _e4360 = phi_7210_;
if _e636 {
let _e4369 = type_24(select(_e722, 1e30f, _e3852), _e3851.member_1, _e3851.member_2, _e3851.member_3, _e3851.member_4, _e3851.member_5, _e3851.member_6, _e3851.member_7);
let _e4379 = type_24(_e4369.member, select(_e722, _e801, (_e801 < _e722)), _e4369.member_2, _e4369.member_3, _e4369.member_4, _e4369.member_5, _e4369.member_6, _e4369.member_7);
let _e4390 = select(1f, -1f, ((((_e4323.member_1.x * _e466) + (_e4323.member_1.y * _e477)) + (_e4323.member_1.z * _e488)) > 0f));
let _e4402 = select(_e4390, -(_e4390), ((((_e4323.member_2.x * _e4323.member_1.x) + (_e4323.member_2.y * _e4323.member_1.y)) + (_e4323.member_2.z * _e4323.member_1.z)) < 0f));
let _e4403 = (_e4323.member_2.x * _e4402);
let _e4404 = (_e4323.member_2.y * _e4402);
let _e4405 = (_e4323.member_2.z * _e4402);
let _e4414 = ((((_e4403 * _e466) + (_e4404 * _e477)) + (_e4405 * _e488)) > 0f);
let _e4429 = type_24(_e4379.member, _e4379.member_1, _e4379.member_2, _e4379.member_3, _e4379.member_4, _e4379.member_5, _e4379.member_6, vec3<f32>(select(select(_e4403, (_e4323.member_1.x * _e4390), _e4414), 0f, _e3852), select(select(_e4404, (_e4323.member_1.y * _e4390), _e4414), 0f, _e3852), select(select(_e4405, (_e4323.member_1.z * _e4390), _e4414), 0f, _e3852)));
let _e4433 = (1f - (((_e858 + _e906) + _e954) * _e962));
let _e4437 = global_1.member.member_15.member_12;
phi_7324_ = type_24(_e4429.member, _e4429.member_1, _e4429.member_2, _e4429.member_3, _e4429.member_4, _e4429.member_5, select(1f, select(_e4433, _e4437, (_e4437 > _e4433)), _e3852), _e4429.member_7);
} else {
phi_7324_ = _e3851;
}
let _e4450 = phi_7324_;
if _e3852 {
let _e4455 = (((_e499 * _e499) + (_e510 * _e510)) + (_e521 * _e521));
let _e4458 = sqrt(select(0f, _e4455, (_e4455 > 0f)));
let _e4463 = (((_e532 * _e532) + (_e543 * _e543)) + (_e554 * _e554));
let _e4466 = sqrt(select(0f, _e4463, (_e4463 > 0f)));
let _e4468 = select(_e4466, _e4458, (_e4458 > _e4466));
let _e4472 = global_1.member.member_15.member_4;
let _e4480 = (((_e4472.member * _e466) + (_e4472.member_1 * _e477)) + (_e4472.member_2 * _e488));
let _e4484 = global_1.member.member_15.member_5;
let _e4492 = (((_e4484.member * _e466) + (_e4484.member_1 * _e477)) + (_e4484.member_2 * _e488));
let _e4496 = global_1.member.member_15.member_6;
let _e4504 = (((_e4496.member * _e466) + (_e4496.member_1 * _e477)) + (_e4496.member_2 * _e488));
let _e4508 = global_1.member.member_15.member;
let _e4512 = global_1.member.member_15.member_7;
let _e4516 = vec3<f32>(_e4512.member, _e4512.member_1, _e4512.member_2);
let _e4520 = global_1.member.member_15.member_8;
if (_e4508 == 0u) {
phi_8813_ = _e4516;
} else {
if (_e4508 == 1u) {
let _e4527 = select(-1f, _e4504, (_e4504 > -1f));
let _e4529 = select(1f, _e4527, (_e4527 < 1f));
if (_e4529 > 0f) {
phi_7428_ = _e4516;
} else {
let _e4534 = global_1.member.member_15.member_9;
phi_7428_ = vec3<f32>(_e4534.member, _e4534.member_1, _e4534.member_2);
}
let _e4540 = phi_7428_;
let _e4549 = bitcast<f32>((bitcast<u32>(_e4529) & 2147483647u));
let _e4552 = sqrt(select(0f, _e4549, (_e4549 > 0f)));
phi_8812_ = vec3<f32>((_e4520.member + ((_e4540.x - _e4520.member) * _e4552)), (_e4520.member_1 + ((_e4540.y - _e4520.member_1) * _e4552)), (_e4520.member_2 + ((_e4540.z - _e4520.member_2) * _e4552)));
} else {
if (_e4508 == 2u) {
let _e4564 = global_1.member.member_15.member_10;
let _e4565 = (_e4468 / _e4564);
let _e4567 = select(1e-4f, _e4565, (_e4565 > 1e-4f));
let _e4570 = bitcast<f32>((bitcast<u32>(_e4480) & 2147483647u));
let _e4573 = bitcast<f32>((bitcast<u32>(_e4492) & 2147483647u));
let _e4577 = select(_e4573, _e4570, (_e4570 > _e4573));
let _e4580 = (select(_e4573, _e4570, (_e4570 < _e4573)) / select(1.1754944e-38f, _e4577, (_e4577 > 1.1754944e-38f)));
let _e4581 = (_e4580 > 0.41421357f);
let _e4585 = select(_e4580, ((_e4580 - 1f) / (_e4580 + 1f)), _e4581);
let _e4586 = (_e4585 * _e4585);
let _e4601 = (select(0f, 0.7853982f, _e4581) + (_e4585 + ((_e4585 * _e4586) * (-0.33333334f + (_e4586 * (0.2f + (_e4586 * (-0.14285713f + (_e4586 * (0.11111111f + (_e4586 * (-0.09090909f + (_e4586 * 0.0585f)))))))))))));
let _e4604 = select(_e4601, (1.5707964f - _e4601), (_e4573 > _e4570));
let _e4607 = select(_e4604, (3.1415927f - _e4604), (_e4480 < 0f));
let _e4613 = (1f - (_e4504 * _e4504));
let _e4616 = sqrt(select(0f, _e4613, (_e4613 > 0f)));
let _e4619 = (_e4567 / select(1e-3f, _e4616, (_e4616 > 1e-3f)));
let _e4620 = ((select(_e4607, -(_e4607), (_e4492 < 0f)) / _e4564) * 0.5f);
let _e4622 = select(-8e6f, _e4620, (_e4620 > -8e6f));
let _e4624 = select(8e6f, _e4622, (_e4622 < 8e6f));
let _e4631 = select(0i, select(select(i32(_e4624), i32(-2147483648), (_e4624 < -2147483600f)), 2147483647i, (_e4624 > 2147483500f)), (_e4624 == _e4624));
let _e4638 = ((_e4620 - f32((_e4631 - select(0i, 1i, (_e4624 < f32(_e4631)))))) * 2f);
let _e4646 = ((select(select((_e4638 - 2f), (1f - _e4638), (_e4638 < 1.5f)), _e4638, (_e4638 < 0.5f)) * 2f) / _e4619);
let _e4648 = select(-1f, _e4646, (_e4646 > -1f));
let _e4651 = (2f - _e4619);
let _e4653 = select(0f, _e4651, (_e4651 > 0f));
let _e4658 = select(-1f, _e4504, (_e4504 > -1f));
let _e4660 = select(1f, _e4658, (_e4658 < 1f));
let _e4663 = ((1f - _e4660) * (1f + _e4660));
let _e4666 = sqrt(select(0f, _e4663, (_e4663 > 0f)));
let _e4669 = bitcast<f32>((bitcast<u32>(_e4666) & 2147483647u));
let _e4672 = bitcast<f32>((bitcast<u32>(_e4660) & 2147483647u));
let _e4676 = select(_e4672, _e4669, (_e4669 > _e4672));
let _e4679 = (select(_e4672, _e4669, (_e4669 < _e4672)) / select(1.1754944e-38f, _e4676, (_e4676 > 1.1754944e-38f)));
let _e4680 = (_e4679 > 0.41421357f);
let _e4684 = select(_e4679, ((_e4679 - 1f) / (_e4679 + 1f)), _e4680);
let _e4685 = (_e4684 * _e4684);
let _e4700 = (select(0f, 0.7853982f, _e4680) + (_e4684 + ((_e4684 * _e4685) * (-0.33333334f + (_e4685 * (0.2f + (_e4685 * (-0.14285713f + (_e4685 * (0.11111111f + (_e4685 * (-0.09090909f + (_e4685 * 0.0585f)))))))))))));
let _e4703 = select(_e4700, (1.5707964f - _e4700), (_e4672 > _e4669));
let _e4706 = select(_e4703, (3.1415927f - _e4703), (_e4666 < 0f));
let _e4711 = ((select(_e4706, -(_e4706), (_e4660 < 0f)) / _e4564) * 0.5f);
let _e4713 = select(-8e6f, _e4711, (_e4711 > -8e6f));
let _e4715 = select(8e6f, _e4713, (_e4713 < 8e6f));
let _e4722 = select(0i, select(select(i32(_e4715), i32(-2147483648), (_e4715 < -2147483600f)), 2147483647i, (_e4715 > 2147483500f)), (_e4715 == _e4715));
let _e4729 = ((_e4711 - f32((_e4722 - select(0i, 1i, (_e4715 < f32(_e4722)))))) * 2f);
let _e4737 = ((select(select((_e4729 - 2f), (1f - _e4729), (_e4729 < 1.5f)), _e4729, (_e4729 < 0.5f)) * 2f) / _e4567);
let _e4739 = select(-1f, _e4737, (_e4737 > -1f));
let _e4742 = (2f - _e4567);
let _e4744 = select(0f, _e4742, (_e4742 > 0f));
let _e4750 = (0.5f + ((0.5f * (select(1f, _e4648, (_e4648 < 1f)) * select(1f, _e4653, (_e4653 < 1f)))) * (select(1f, _e4739, (_e4739 < 1f)) * select(1f, _e4744, (_e4744 < 1f)))));
phi_8811_ = vec3<f32>((_e4512.member + ((_e4520.member - _e4512.member) * _e4750)), (_e4512.member_1 + ((_e4520.member_1 - _e4512.member_1) * _e4750)), (_e4512.member_2 + ((_e4520.member_2 - _e4512.member_2) * _e4750)));
} else {
let _e4764 = global_1.member.member_15.member_1;
let _e4765 = bitcast<i32>(_e4764);
let _e4770 = global_1.member.member_15.member_3;
let _e4772 = f32(bitcast<i32>(_e4770));
let _e4774 = (2f * 3.1415927f);
let _e4775 = ((_e4468 * f32(_e4765)) / _e4774);
let _e4777 = select(1e-6f, _e4775, (_e4775 > 1e-6f));
let _e4780 = bitcast<u32>(select(1.1754944e-38f, _e4777, (_e4777 > 1.1754944e-38f)));
let _e4781 = (_e4780 & 8388607u);
let _e4783 = select(0u, 1u, (_e4781 > 3474675u));
let _e4794 = bitcast<f32>((_e4781 | ((127u - _e4783) << bitcast<u32>(23i))));
let _e4797 = ((_e4794 - 1f) / (_e4794 + 1f));
let _e4798 = (_e4797 * _e4797);
let _e4813 = (f32(((bitcast<i32>((_e4780 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e4783))) + (((2f * _e4797) + ((_e4797 * _e4798) * (0.6666667f + (_e4798 * (0.4f + (_e4798 * (0.2857143f + (_e4798 * (0.22222222f + (_e4798 * 0.18181819f)))))))))) * 1.442695f));
let _e4814 = (_e4772 - 1f);
let _e4816 = select(0f, _e4813, (_e4813 > 0f));
let _e4818 = select(_e4814, _e4816, (_e4816 < _e4814));
let _e4819 = (_e4772 - 2f);
let _e4821 = select(0f, _e4819, (_e4819 > 0f));
let _e4823 = select(0f, _e4818, (_e4818 > 0f));
let _e4825 = select(_e4821, _e4823, (_e4823 < _e4821));
let _e4832 = select(0i, select(select(i32(_e4825), i32(-2147483648), (_e4825 < -2147483600f)), 2147483647i, (_e4825 > 2147483500f)), (_e4825 == _e4825));
let _e4836 = (_e4832 - select(0i, 1i, (_e4825 < f32(_e4832))));
let _e4839 = bitcast<f32>((bitcast<u32>(_e4492) & 2147483647u));
let _e4842 = bitcast<f32>((bitcast<u32>(_e4480) & 2147483647u));
let _e4846 = select(_e4842, _e4839, (_e4839 > _e4842));
let _e4849 = (select(_e4842, _e4839, (_e4839 < _e4842)) / select(1.1754944e-38f, _e4846, (_e4846 > 1.1754944e-38f)));
let _e4850 = (_e4849 > 0.41421357f);
let _e4854 = select(_e4849, ((_e4849 - 1f) / (_e4849 + 1f)), _e4850);
let _e4855 = (_e4854 * _e4854);
let _e4870 = (select(0f, 0.7853982f, _e4850) + (_e4854 + ((_e4854 * _e4855) * (-0.33333334f + (_e4855 * (0.2f + (_e4855 * (-0.14285713f + (_e4855 * (0.11111111f + (_e4855 * (-0.09090909f + (_e4855 * 0.0585f)))))))))))));
let _e4873 = select(_e4870, (1.5707964f - _e4870), (_e4842 > _e4839));
let _e4876 = select(_e4873, (3.1415927f - _e4873), (_e4492 < 0f));
let _e4881 = (0.5f - (select(_e4876, -(_e4876), (_e4480 < 0f)) / _e4774));
let _e4883 = select(-1f, _e4504, (_e4504 > -1f));
let _e4885 = select(1f, _e4883, (_e4883 < 1f));
let _e4888 = ((1f - _e4885) * (1f + _e4885));
let _e4891 = sqrt(select(0f, _e4888, (_e4888 > 0f)));
let _e4894 = bitcast<f32>((bitcast<u32>(_e4891) & 2147483647u));
let _e4897 = bitcast<f32>((bitcast<u32>(_e4885) & 2147483647u));
let _e4901 = select(_e4897, _e4894, (_e4894 > _e4897));
let _e4904 = (select(_e4897, _e4894, (_e4894 < _e4897)) / select(1.1754944e-38f, _e4901, (_e4901 > 1.1754944e-38f)));
let _e4905 = (_e4904 > 0.41421357f);
let _e4909 = select(_e4904, ((_e4904 - 1f) / (_e4904 + 1f)), _e4905);
let _e4910 = (_e4909 * _e4909);
let _e4925 = (select(0f, 0.7853982f, _e4905) + (_e4909 + ((_e4909 * _e4910) * (-0.33333334f + (_e4910 * (0.2f + (_e4910 * (-0.14285713f + (_e4910 * (0.11111111f + (_e4910 * (-0.09090909f + (_e4910 * 0.0585f)))))))))))));
let _e4928 = select(_e4925, (1.5707964f - _e4925), (_e4897 > _e4894));
let _e4931 = select(_e4928, (3.1415927f - _e4928), (_e4891 < 0f));
let _e4936 = (0.5f - (select(_e4931, -(_e4931), (_e4885 < 0f)) / 3.1415927f));
let _e4940 = global_1.member.member_15.member_2;
let _e4941 = bitcast<i32>(_e4940);
phi_8030_ = 0i;
phi_8033_ = 0i;
phi_8035_ = _e4941;
phi_8037_ = _e4765;
loop {
let _e4943 = phi_8030_;
let _e4945 = phi_8033_;
let _e4947 = phi_8035_;
let _e4949 = phi_8037_;
local_13 = _e4949;
local_14 = _e4947;
local_15 = _e4949;
local_16 = _e4949;
local_17 = _e4949;
local_18 = _e4949;
local_19 = _e4949;
local_20 = _e4949;
local_21 = _e4947;
local_22 = _e4947;
local_23 = _e4947;
local_24 = _e4947;
local_25 = _e4949;
local_26 = _e4945;
local_27 = _e4949;
local_28 = _e4945;
let _e4950 = (_e4943 < _e4836);
if _e4950 {
if (_e4949 > 1i) {
phi_8052_ = (_e4949 >> bitcast<u32>(1i));
} else {
phi_8052_ = 1i;
}
let _e4957 = phi_8052_;
if (_e4947 > 1i) {
phi_8058_ = (_e4947 >> bitcast<u32>(1i));
} else {
phi_8058_ = 1i;
}
let _e4962 = phi_8058_;
phi_8031_ = (_e4943 + 1i);
phi_8034_ = (_e4945 + (_e4949 * _e4947));
phi_8036_ = _e4962;
phi_8038_ = _e4957;
} else {
phi_8031_ = i32();
phi_8034_ = i32();
phi_8036_ = i32();
phi_8038_ = i32();
}
let _e4965 = phi_8031_;
let _e4967 = phi_8034_;
let _e4969 = phi_8036_;
let _e4971 = phi_8038_;
continue;
continuing {
phi_8030_ = _e4965;
phi_8033_ = _e4967;
phi_8035_ = _e4969;
phi_8037_ = _e4971;
break if !(_e4950);
}
}
let _e4974 = local_13;
let _e4975 = f32(_e4974);
let _e4977 = ((_e4881 * _e4975) - 0.5f);
let _e4979 = local_14;
let _e4980 = f32(_e4979);
let _e4982 = ((_e4936 * _e4980) - 0.5f);
let _e4984 = select(-1f, _e4977, (_e4977 > -1f));
let _e4986 = select(_e4975, _e4984, (_e4984 < _e4975));
let _e4993 = select(0i, select(select(i32(_e4986), i32(-2147483648), (_e4986 < -2147483600f)), 2147483647i, (_e4986 > 2147483500f)), (_e4986 == _e4986));
let _e4997 = (_e4993 - select(0i, 1i, (_e4986 < f32(_e4993))));
let _e4999 = select(-1f, _e4982, (_e4982 > -1f));
let _e5001 = select(_e4980, _e4999, (_e4999 < _e4980));
let _e5008 = select(0i, select(select(i32(_e5001), i32(-2147483648), (_e5001 < -2147483600f)), 2147483647i, (_e5001 > 2147483500f)), (_e5001 == _e5001));
let _e5012 = (_e5008 - select(0i, 1i, (_e5001 < f32(_e5008))));
let _e5014 = (_e4977 - f32(_e4997));
let _e5016 = (_e4982 - f32(_e5012));
let _e5018 = select(0f, _e5016, (_e5016 > 0f));
let _e5020 = select(1f, _e5018, (_e5018 < 1f));
if (_e4997 < 0i) {
let _e5023 = local_15;
phi_8133_ = (_e4997 + _e5023);
} else {
phi_8133_ = _e4997;
}
let _e5026 = phi_8133_;
let _e5028 = local_16;
if (_e5026 >= _e5028) {
let _e5031 = local_17;
phi_8139_ = (_e5026 - _e5031);
} else {
phi_8139_ = _e5026;
}
let _e5034 = phi_8139_;
let _e5035 = (_e4997 + 1i);
if (_e5035 < 0i) {
let _e5038 = local_18;
phi_8146_ = (_e5035 + _e5038);
} else {
phi_8146_ = _e5035;
}
let _e5041 = phi_8146_;
let _e5043 = local_19;
if (_e5041 >= _e5043) {
let _e5046 = local_20;
phi_8152_ = (_e5041 - _e5046);
} else {
phi_8152_ = _e5041;
}
let _e5049 = phi_8152_;
let _e5051 = select(_e5012, 0i, (_e5012 < 0i));
let _e5053 = local_21;
if (_e5051 >= _e5053) {
let _e5056 = local_22;
phi_8163_ = (_e5056 - 1i);
} else {
phi_8163_ = _e5051;
}
let _e5059 = phi_8163_;
let _e5060 = (_e5012 + 1i);
let _e5062 = select(_e5060, 0i, (_e5060 < 0i));
let _e5064 = local_23;
if (_e5062 >= _e5064) {
let _e5067 = local_24;
phi_8175_ = (_e5067 - 1i);
} else {
phi_8175_ = _e5062;
}
let _e5070 = phi_8175_;
let _e5072 = local_25;
let _e5075 = local_26;
let _e5076 = (_e5075 + (_e5059 * _e5072));
let _e5078 = local_27;
let _e5081 = local_28;
let _e5082 = (_e5081 + (_e5070 * _e5078));
let _e5084 = (3i * (_e5076 + _e5034));
let _e5086 = (bitcast<i32>(_e146) - 1i);
let _e5088 = select(_e5086, _e5084, (_e5084 < _e5086));
let _e5094 = global_3.member[bitcast<u32>(select(0i, _e5088, (_e5088 > 0i)))];
let _e5095 = (_e5084 + 1i);
let _e5097 = select(_e5086, _e5095, (_e5095 < _e5086));
let _e5103 = global_3.member[bitcast<u32>(select(0i, _e5097, (_e5097 > 0i)))];
let _e5104 = (_e5084 + 2i);
let _e5106 = select(_e5086, _e5104, (_e5104 < _e5086));
let _e5112 = global_3.member[bitcast<u32>(select(0i, _e5106, (_e5106 > 0i)))];
let _e5114 = (3i * (_e5076 + _e5049));
let _e5116 = select(_e5086, _e5114, (_e5114 < _e5086));
let _e5122 = global_3.member[bitcast<u32>(select(0i, _e5116, (_e5116 > 0i)))];
let _e5123 = (_e5114 + 1i);
let _e5125 = select(_e5086, _e5123, (_e5123 < _e5086));
let _e5131 = global_3.member[bitcast<u32>(select(0i, _e5125, (_e5125 > 0i)))];
let _e5132 = (_e5114 + 2i);
let _e5134 = select(_e5086, _e5132, (_e5132 < _e5086));
let _e5140 = global_3.member[bitcast<u32>(select(0i, _e5134, (_e5134 > 0i)))];
let _e5142 = (3i * (_e5082 + _e5034));
let _e5144 = select(_e5086, _e5142, (_e5142 < _e5086));
let _e5150 = global_3.member[bitcast<u32>(select(0i, _e5144, (_e5144 > 0i)))];
let _e5151 = (_e5142 + 1i);
let _e5153 = select(_e5086, _e5151, (_e5151 < _e5086));
let _e5159 = global_3.member[bitcast<u32>(select(0i, _e5153, (_e5153 > 0i)))];
let _e5160 = (_e5142 + 2i);
let _e5162 = select(_e5086, _e5160, (_e5160 < _e5086));
let _e5168 = global_3.member[bitcast<u32>(select(0i, _e5162, (_e5162 > 0i)))];
let _e5170 = (3i * (_e5082 + _e5049));
let _e5172 = select(_e5086, _e5170, (_e5170 < _e5086));
let _e5178 = global_3.member[bitcast<u32>(select(0i, _e5172, (_e5172 > 0i)))];
let _e5179 = (_e5170 + 1i);
let _e5181 = select(_e5086, _e5179, (_e5179 < _e5086));
let _e5187 = global_3.member[bitcast<u32>(select(0i, _e5181, (_e5181 > 0i)))];
let _e5188 = (_e5170 + 2i);
let _e5190 = select(_e5086, _e5188, (_e5188 < _e5086));
let _e5196 = global_3.member[bitcast<u32>(select(0i, _e5190, (_e5190 > 0i)))];
let _e5203 = (_e5094 + ((_e5122 - _e5094) * _e5014));
let _e5204 = (_e5103 + ((_e5131 - _e5103) * _e5014));
let _e5205 = (_e5112 + ((_e5140 - _e5112) * _e5014));
let _e5221 = (_e5203 + (((_e5150 + ((_e5178 - _e5150) * _e5014)) - _e5203) * _e5020));
let _e5222 = (_e5204 + (((_e5159 + ((_e5187 - _e5159) * _e5014)) - _e5204) * _e5020));
let _e5223 = (_e5205 + (((_e5168 + ((_e5196 - _e5168) * _e5014)) - _e5205) * _e5020));
phi_8411_ = 0i;
phi_8414_ = 0i;
phi_8416_ = _e4941;
phi_8418_ = _e4765;
loop {
let _e5226 = phi_8411_;
let _e5228 = phi_8414_;
let _e5230 = phi_8416_;
let _e5232 = phi_8418_;
local_29 = _e5232;
local_30 = _e5230;
local_31 = _e5232;
local_32 = _e5232;
local_33 = _e5232;
local_34 = _e5232;
local_35 = _e5232;
local_36 = _e5232;
local_37 = _e5230;
local_38 = _e5230;
local_39 = _e5230;
local_40 = _e5230;
local_41 = _e5232;
local_42 = _e5228;
local_43 = _e5232;
local_44 = _e5228;
let _e5233 = (_e5226 < (_e4836 + 1i));
if _e5233 {
if (_e5232 > 1i) {
phi_8433_ = (_e5232 >> bitcast<u32>(1i));
} else {
phi_8433_ = 1i;
}
let _e5240 = phi_8433_;
if (_e5230 > 1i) {
phi_8439_ = (_e5230 >> bitcast<u32>(1i));
} else {
phi_8439_ = 1i;
}
let _e5245 = phi_8439_;
phi_8412_ = (_e5226 + 1i);
phi_8415_ = (_e5228 + (_e5232 * _e5230));
phi_8417_ = _e5245;
phi_8419_ = _e5240;
} else {
phi_8412_ = i32();
phi_8415_ = i32();
phi_8417_ = i32();
phi_8419_ = i32();
}
let _e5248 = phi_8412_;
let _e5250 = phi_8415_;
let _e5252 = phi_8417_;
let _e5254 = phi_8419_;
continue;
continuing {
phi_8411_ = _e5248;
phi_8414_ = _e5250;
phi_8416_ = _e5252;
phi_8418_ = _e5254;
break if !(_e5233);
}
}
let _e5257 = local_29;
let _e5258 = f32(_e5257);
let _e5260 = ((_e4881 * _e5258) - 0.5f);
let _e5262 = local_30;
let _e5263 = f32(_e5262);
let _e5265 = ((_e4936 * _e5263) - 0.5f);
let _e5267 = select(-1f, _e5260, (_e5260 > -1f));
let _e5269 = select(_e5258, _e5267, (_e5267 < _e5258));
let _e5276 = select(0i, select(select(i32(_e5269), i32(-2147483648), (_e5269 < -2147483600f)), 2147483647i, (_e5269 > 2147483500f)), (_e5269 == _e5269));
let _e5280 = (_e5276 - select(0i, 1i, (_e5269 < f32(_e5276))));
let _e5282 = select(-1f, _e5265, (_e5265 > -1f));
let _e5284 = select(_e5263, _e5282, (_e5282 < _e5263));
let _e5291 = select(0i, select(select(i32(_e5284), i32(-2147483648), (_e5284 < -2147483600f)), 2147483647i, (_e5284 > 2147483500f)), (_e5284 == _e5284));
let _e5295 = (_e5291 - select(0i, 1i, (_e5284 < f32(_e5291))));
let _e5297 = (_e5260 - f32(_e5280));
let _e5299 = (_e5265 - f32(_e5295));
let _e5301 = select(0f, _e5299, (_e5299 > 0f));
let _e5303 = select(1f, _e5301, (_e5301 < 1f));
if (_e5280 < 0i) {
let _e5306 = local_31;
phi_8514_ = (_e5280 + _e5306);
} else {
phi_8514_ = _e5280;
}
let _e5309 = phi_8514_;
let _e5311 = local_32;
if (_e5309 >= _e5311) {
let _e5314 = local_33;
phi_8520_ = (_e5309 - _e5314);
} else {
phi_8520_ = _e5309;
}
let _e5317 = phi_8520_;
let _e5318 = (_e5280 + 1i);
if (_e5318 < 0i) {
let _e5321 = local_34;
phi_8527_ = (_e5318 + _e5321);
} else {
phi_8527_ = _e5318;
}
let _e5324 = phi_8527_;
let _e5326 = local_35;
if (_e5324 >= _e5326) {
let _e5329 = local_36;
phi_8533_ = (_e5324 - _e5329);
} else {
phi_8533_ = _e5324;
}
let _e5332 = phi_8533_;
let _e5334 = select(_e5295, 0i, (_e5295 < 0i));
let _e5336 = local_37;
if (_e5334 >= _e5336) {
let _e5339 = local_38;
phi_8544_ = (_e5339 - 1i);
} else {
phi_8544_ = _e5334;
}
let _e5342 = phi_8544_;
let _e5343 = (_e5295 + 1i);
let _e5345 = select(_e5343, 0i, (_e5343 < 0i));
let _e5347 = local_39;
if (_e5345 >= _e5347) {
let _e5350 = local_40;
phi_8556_ = (_e5350 - 1i);
} else {
phi_8556_ = _e5345;
}
let _e5353 = phi_8556_;
let _e5355 = local_41;
let _e5358 = local_42;
let _e5359 = (_e5358 + (_e5342 * _e5355));
let _e5361 = local_43;
let _e5364 = local_44;
let _e5365 = (_e5364 + (_e5353 * _e5361));
let _e5367 = (3i * (_e5359 + _e5317));
let _e5369 = select(_e5086, _e5367, (_e5367 < _e5086));
let _e5375 = global_3.member[bitcast<u32>(select(0i, _e5369, (_e5369 > 0i)))];
let _e5376 = (_e5367 + 1i);
let _e5378 = select(_e5086, _e5376, (_e5376 < _e5086));
let _e5384 = global_3.member[bitcast<u32>(select(0i, _e5378, (_e5378 > 0i)))];
let _e5385 = (_e5367 + 2i);
let _e5387 = select(_e5086, _e5385, (_e5385 < _e5086));
let _e5393 = global_3.member[bitcast<u32>(select(0i, _e5387, (_e5387 > 0i)))];
let _e5395 = (3i * (_e5359 + _e5332));
let _e5397 = select(_e5086, _e5395, (_e5395 < _e5086));
let _e5403 = global_3.member[bitcast<u32>(select(0i, _e5397, (_e5397 > 0i)))];
let _e5404 = (_e5395 + 1i);
let _e5406 = select(_e5086, _e5404, (_e5404 < _e5086));
let _e5412 = global_3.member[bitcast<u32>(select(0i, _e5406, (_e5406 > 0i)))];
let _e5413 = (_e5395 + 2i);
let _e5415 = select(_e5086, _e5413, (_e5413 < _e5086));
let _e5421 = global_3.member[bitcast<u32>(select(0i, _e5415, (_e5415 > 0i)))];
let _e5423 = (3i * (_e5365 + _e5317));
let _e5425 = select(_e5086, _e5423, (_e5423 < _e5086));
let _e5431 = global_3.member[bitcast<u32>(select(0i, _e5425, (_e5425 > 0i)))];
let _e5432 = (_e5423 + 1i);
let _e5434 = select(_e5086, _e5432, (_e5432 < _e5086));
let _e5440 = global_3.member[bitcast<u32>(select(0i, _e5434, (_e5434 > 0i)))];
let _e5441 = (_e5423 + 2i);
let _e5443 = select(_e5086, _e5441, (_e5441 < _e5086));
let _e5449 = global_3.member[bitcast<u32>(select(0i, _e5443, (_e5443 > 0i)))];
let _e5451 = (3i * (_e5365 + _e5332));
let _e5453 = select(_e5086, _e5451, (_e5451 < _e5086));
let _e5459 = global_3.member[bitcast<u32>(select(0i, _e5453, (_e5453 > 0i)))];
let _e5460 = (_e5451 + 1i);
let _e5462 = select(_e5086, _e5460, (_e5460 < _e5086));
let _e5468 = global_3.member[bitcast<u32>(select(0i, _e5462, (_e5462 > 0i)))];
let _e5469 = (_e5451 + 2i);
let _e5471 = select(_e5086, _e5469, (_e5469 < _e5086));
let _e5477 = global_3.member[bitcast<u32>(select(0i, _e5471, (_e5471 > 0i)))];
let _e5484 = (_e5375 + ((_e5403 - _e5375) * _e5297));
let _e5485 = (_e5384 + ((_e5412 - _e5384) * _e5297));
let _e5486 = (_e5393 + ((_e5421 - _e5393) * _e5297));
let _e5509 = (_e4818 - f32(_e4836));
let _e5511 = select(0f, _e5509, (_e5509 > 0f));
let _e5513 = select(1f, _e5511, (_e5511 < 1f));
let _e5523 = global_1.member.member_15.member_11;
phi_8811_ = vec3<f32>(((_e5221 + (((_e5484 + (((_e5431 + ((_e5459 - _e5431) * _e5297)) - _e5484) * _e5303)) - _e5221) * _e5513)) * _e5523), ((_e5222 + (((_e5485 + (((_e5440 + ((_e5468 - _e5440) * _e5297)) - _e5485) * _e5303)) - _e5222) * _e5513)) * _e5523), ((_e5223 + (((_e5486 + (((_e5449 + ((_e5477 - _e5449) * _e5297)) - _e5486) * _e5303)) - _e5223) * _e5513)) * _e5523));
}
let _e5529 = phi_8811_;
phi_8812_ = _e5529;
}
let _e5531 = phi_8812_;
phi_8813_ = _e5531;
}
let _e5533 = phi_8813_;
let _e5537 = global_1.member.member_15.member_12;
let _e5538 = select(1f, _e5537, _e636);
phi_9919_ = type_24(_e4450.member, _e4450.member_1, vec3<f32>((_e4450.member_2.x + (((_e5533.x * _e858) * _e723) * _e5538)), (_e4450.member_2.y + (((_e5533.y * _e906) * _e724) * _e5538)), (_e4450.member_2.z + (((_e5533.z * _e954) * _e725) * _e5538))), _e4450.member_3, _e4450.member_4, _e4450.member_5, _e4450.member_6, _e4450.member_7);
} else {
if _e4360 {
let _e5573 = global_1.member.member_10.member_2;
let _e5581 = global_1.member.member_10.member;
let _e5582 = (_e5581 == 0u);
if _e5582 {
let _e5586 = global_1.member.member_10.member_1;
phi_9369_ = type_26(vec3<f32>(_e5586.member, _e5586.member_1, _e5586.member_2), vec3<f32>(_e5573.member, _e5573.member_1, _e5573.member_2));
} else {
let _e5595 = global_1.member.member_10.member_3;
let _e5600 = (_e4323.member.x - _e5595.member);
let _e5602 = (_e4323.member.y - _e5595.member_1);
let _e5604 = (_e4323.member.z - _e5595.member_2);
let _e5609 = (((_e5600 * _e5600) + (_e5602 * _e5602)) + (_e5604 * _e5604));
let _e5611 = select(1e-12f, _e5609, (_e5609 > 1e-12f));
let _e5612 = (1f / _e5611);
let _e5616 = vec3<f32>((_e5573.member * _e5612), (_e5573.member_1 * _e5612), (_e5573.member_2 * _e5612));
if (_e5581 == 2u) {
let _e5621 = global_1.member.member_10.member_1;
let _e5629 = (((_e5621.member * _e5600) + (_e5621.member_1 * _e5602)) + (_e5621.member_2 * _e5604));
let _e5632 = (1f / select(1e-20f, _e5629, (_e5629 > 1e-20f)));
let _e5637 = global_1.member.member_10.member_4.member;
let _e5646 = ((((_e5637.member * _e5600) + (_e5637.member_1 * _e5602)) + (_e5637.member_2 * _e5604)) * _e5632);
let _e5651 = global_1.member.member_10.member_4.member_1;
let _e5660 = ((((_e5651.member * _e5600) + (_e5651.member_1 * _e5602)) + (_e5651.member_2 * _e5604)) * _e5632);
let _e5665 = global_1.member.member_10.member_4.member_2;
let _e5668 = ((_e5646 * _e5646) + (_e5660 * _e5660));
let _e5677 = global_1.member.member_10.member_4.member_3;
let _e5678 = ((_e5665 - sqrt(select(0f, _e5668, (_e5668 > 0f)))) * _e5677);
let _e5680 = select(0f, _e5678, (_e5678 > 0f));
let _e5682 = select(1f, _e5680, (_e5680 < 1f));
let _e5688 = select(0f, ((_e5682 * _e5682) * (3f - (2f * _e5682))), (_e5629 > 0f));
let _e5693 = global_1.member.member_10.member_4.member_5;
if ((_e5693 > 0u) && (_e5688 > 0f)) {
let _e5697 = (0.5f / _e5665);
let _e5707 = global_1.member.member_10.member_4.member_6;
let _e5708 = bitcast<i32>(_e5707);
local = bitcast<i32>(_e5693);
let _e5709 = local;
let _e5711 = f32((_e5709 - 1i));
let _e5713 = f32((_e5708 - 1i));
let _e5714 = local;
let _e5717 = (((0.5f + (_e5646 * _e5697)) * f32(_e5714)) - 0.5f);
let _e5719 = select(0f, _e5717, (_e5717 > 0f));
let _e5721 = select(_e5711, _e5719, (_e5719 < _e5711));
let _e5724 = (((0.5f - (_e5660 * _e5697)) * f32(_e5708)) - 0.5f);
let _e5726 = select(0f, _e5724, (_e5724 > 0f));
let _e5728 = select(_e5713, _e5726, (_e5726 < _e5713));
let _e5730 = select(0f, _e5721, (_e5721 > 0f));
let _e5732 = select(_e5711, _e5730, (_e5730 < _e5711));
let _e5739 = select(0i, select(select(i32(_e5732), i32(-2147483648), (_e5732 < -2147483600f)), 2147483647i, (_e5732 > 2147483500f)), (_e5732 == _e5732));
let _e5743 = (_e5739 - select(0i, 1i, (_e5732 < f32(_e5739))));
let _e5745 = select(0f, _e5728, (_e5728 > 0f));
let _e5747 = select(_e5713, _e5745, (_e5745 < _e5713));
let _e5754 = select(0i, select(select(i32(_e5747), i32(-2147483648), (_e5747 < -2147483600f)), 2147483647i, (_e5747 > 2147483500f)), (_e5747 == _e5747));
let _e5758 = (_e5754 - select(0i, 1i, (_e5747 < f32(_e5754))));
let _e5760 = (_e5721 - f32(_e5743));
let _e5762 = (_e5728 - f32(_e5758));
let _e5763 = (_e5743 + 1i);
let _e5764 = local;
let _e5766 = select(_e5743, _e5763, (_e5763 < _e5764));
let _e5767 = (_e5758 + 1i);
let _e5769 = select(_e5758, _e5767, (_e5767 < _e5708));
let _e5774 = global_1.member.member_10.member_4.member_4;
let _e5775 = bitcast<i32>(_e5774);
let _e5776 = local;
let _e5780 = (_e5775 + (3i * ((_e5758 * _e5776) + _e5743)));
let _e5782 = (bitcast<i32>(_e146) - 1i);
let _e5784 = select(_e5782, _e5780, (_e5780 < _e5782));
let _e5789 = global_3.member[bitcast<u32>(select(0i, _e5784, (_e5784 > 0i)))];
let _e5790 = (_e5780 + 1i);
let _e5792 = select(_e5782, _e5790, (_e5790 < _e5782));
let _e5797 = global_3.member[bitcast<u32>(select(0i, _e5792, (_e5792 > 0i)))];
let _e5798 = (_e5780 + 2i);
let _e5800 = select(_e5782, _e5798, (_e5798 < _e5782));
let _e5805 = global_3.member[bitcast<u32>(select(0i, _e5800, (_e5800 > 0i)))];
let _e5806 = local;
let _e5810 = (_e5775 + (3i * ((_e5758 * _e5806) + _e5766)));
let _e5812 = select(_e5782, _e5810, (_e5810 < _e5782));
let _e5817 = global_3.member[bitcast<u32>(select(0i, _e5812, (_e5812 > 0i)))];
let _e5818 = (_e5810 + 1i);
let _e5820 = select(_e5782, _e5818, (_e5818 < _e5782));
let _e5825 = global_3.member[bitcast<u32>(select(0i, _e5820, (_e5820 > 0i)))];
let _e5826 = (_e5810 + 2i);
let _e5828 = select(_e5782, _e5826, (_e5826 < _e5782));
let _e5833 = global_3.member[bitcast<u32>(select(0i, _e5828, (_e5828 > 0i)))];
let _e5834 = local;
let _e5838 = (_e5775 + (3i * ((_e5769 * _e5834) + _e5743)));
let _e5840 = select(_e5782, _e5838, (_e5838 < _e5782));
let _e5845 = global_3.member[bitcast<u32>(select(0i, _e5840, (_e5840 > 0i)))];
let _e5846 = (_e5838 + 1i);
let _e5848 = select(_e5782, _e5846, (_e5846 < _e5782));
let _e5853 = global_3.member[bitcast<u32>(select(0i, _e5848, (_e5848 > 0i)))];
let _e5854 = (_e5838 + 2i);
let _e5856 = select(_e5782, _e5854, (_e5854 < _e5782));
let _e5861 = global_3.member[bitcast<u32>(select(0i, _e5856, (_e5856 > 0i)))];
let _e5862 = local;
let _e5866 = (_e5775 + (3i * ((_e5769 * _e5862) + _e5766)));
let _e5868 = select(_e5782, _e5866, (_e5866 < _e5782));
let _e5873 = global_3.member[bitcast<u32>(select(0i, _e5868, (_e5868 > 0i)))];
let _e5874 = (_e5866 + 1i);
let _e5876 = select(_e5782, _e5874, (_e5874 < _e5782));
let _e5881 = global_3.member[bitcast<u32>(select(0i, _e5876, (_e5876 > 0i)))];
let _e5882 = (_e5866 + 2i);
let _e5884 = select(_e5782, _e5882, (_e5882 < _e5782));
let _e5889 = global_3.member[bitcast<u32>(select(0i, _e5884, (_e5884 > 0i)))];
let _e5896 = (_e5789 + ((_e5817 - _e5789) * _e5760));
let _e5897 = (_e5797 + ((_e5825 - _e5797) * _e5760));
let _e5898 = (_e5805 + ((_e5833 - _e5805) * _e5760));
phi_9353_ = vec3<f32>(((_e5896 + (((_e5845 + ((_e5873 - _e5845) * _e5760)) - _e5896) * _e5762)) * _e5688), ((_e5897 + (((_e5853 + ((_e5881 - _e5853) * _e5760)) - _e5897) * _e5762)) * _e5688), ((_e5898 + (((_e5861 + ((_e5889 - _e5861) * _e5760)) - _e5898) * _e5762)) * _e5688));
} else {
phi_9353_ = vec3(_e5688);
}
let _e5923 = phi_9353_;
phi_9356_ = (_e5616 * _e5923);
} else {
phi_9356_ = _e5616;
}
let _e5926 = phi_9356_;
let _e5930 = (1f / sqrt(select(0f, _e5611, (_e5611 > 0f))));
phi_9369_ = type_26(vec3<f32>((_e5600 * _e5930), (_e5602 * _e5930), (_e5604 * _e5930)), _e5926);
}
let _e5937 = phi_9369_;
let _e5939 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e5941 = select(_e5939, _e447, (_e447 < _e5939));
let _e5947 = global_8.member[bitcast<u32>(select(0i, _e5941, (_e5941 > 0i)))];
let _e5952 = global_1.member.member_10.member_3;
let _e5957 = (_e5952.member - _e4323.member.x);
let _e5959 = (_e5952.member_1 - _e4323.member.y);
let _e5961 = (_e5952.member_2 - _e4323.member.z);
let _e5966 = (((_e5957 * _e5957) + (_e5959 * _e5959)) + (_e5961 * _e5961));
let _e5970 = select(sqrt(select(0f, _e5966, (_e5966 > 0f))), 1e30f, _e5582);
let _e5972 = -(_e5937.member.x);
let _e5974 = -(_e5937.member.y);
let _e5976 = -(_e5937.member.z);
let _e5984 = (1f / select(_e5972, select(1e-12f, -1e-12f, (_e5972 < 0f)), (bitcast<f32>((bitcast<u32>(_e5972) & 2147483647u)) < 1e-12f)));
let _e5992 = (1f / select(_e5974, select(1e-12f, -1e-12f, (_e5974 < 0f)), (bitcast<f32>((bitcast<u32>(_e5974) & 2147483647u)) < 1e-12f)));
let _e6000 = (1f / select(_e5976, select(1e-12f, -1e-12f, (_e5976 < 0f)), (bitcast<f32>((bitcast<u32>(_e5976) & 2147483647u)) < 1e-12f)));
let _e6002 = ((_e753.member - _e4323.member.x) * _e5984);
let _e6004 = ((_e760.member - _e4323.member.x) * _e5984);
let _e6006 = ((_e753.member_1 - _e4323.member.y) * _e5992);
let _e6008 = ((_e760.member_1 - _e4323.member.y) * _e5992);
let _e6010 = ((_e753.member_2 - _e4323.member.z) * _e6000);
let _e6012 = ((_e760.member_2 - _e4323.member.z) * _e6000);
let _e6014 = select(_e6004, _e6002, (_e6002 < _e6004));
let _e6016 = select(_e6008, _e6006, (_e6006 < _e6008));
let _e6018 = select(_e6016, _e6014, (_e6014 > _e6016));
let _e6020 = select(_e6012, _e6010, (_e6010 < _e6012));
let _e6022 = select(_e6020, _e6018, (_e6018 > _e6020));
let _e6024 = select(_e6004, _e6002, (_e6002 > _e6004));
let _e6026 = select(_e6008, _e6006, (_e6006 > _e6008));
let _e6028 = select(_e6026, _e6024, (_e6024 < _e6026));
let _e6030 = select(_e6012, _e6010, (_e6010 > _e6012));
let _e6032 = select(_e6030, _e6028, (_e6028 < _e6030));
let _e6034 = select(0f, _e6022, (_e6022 > 0f));
let _e6036 = select(_e5970, _e6032, (_e6032 < _e5970));
let _e6037 = (_e6036 > _e6034);
let _e6040 = (select(0f, _e6036, _e6037) - select(0f, _e6034, _e6037));
let _e6042 = -((_e807.member * _e6040));
let _e6044 = select(-87f, _e6042, (_e6042 > -87f));
let _e6046 = select(88f, _e6044, (_e6044 < 88f));
let _e6048 = ((_e6046 * 1.442695f) + 0.5f);
let _e6050 = select(-127f, _e6048, (_e6048 > -127f));
let _e6052 = select(128f, _e6050, (_e6050 < 128f));
let _e6059 = select(0i, select(select(i32(_e6052), i32(-2147483648), (_e6052 < -2147483600f)), 2147483647i, (_e6052 > 2147483500f)), (_e6052 == _e6052));
let _e6063 = (_e6059 - select(0i, 1i, (_e6052 < f32(_e6059))));
let _e6064 = f32(_e6063);
let _e6068 = ((_e6046 - (_e6064 * 0.6933594f)) - (_e6064 * -2.1219444e-4f));
let _e6090 = -((_e807.member_1 * _e6040));
let _e6092 = select(-87f, _e6090, (_e6090 > -87f));
let _e6094 = select(88f, _e6092, (_e6092 < 88f));
let _e6096 = ((_e6094 * 1.442695f) + 0.5f);
let _e6098 = select(-127f, _e6096, (_e6096 > -127f));
let _e6100 = select(128f, _e6098, (_e6098 < 128f));
let _e6107 = select(0i, select(select(i32(_e6100), i32(-2147483648), (_e6100 < -2147483600f)), 2147483647i, (_e6100 > 2147483500f)), (_e6100 == _e6100));
let _e6111 = (_e6107 - select(0i, 1i, (_e6100 < f32(_e6107))));
let _e6112 = f32(_e6111);
let _e6116 = ((_e6094 - (_e6112 * 0.6933594f)) - (_e6112 * -2.1219444e-4f));
let _e6138 = -((_e807.member_2 * _e6040));
let _e6140 = select(-87f, _e6138, (_e6138 > -87f));
let _e6142 = select(88f, _e6140, (_e6140 < 88f));
let _e6144 = ((_e6142 * 1.442695f) + 0.5f);
let _e6146 = select(-127f, _e6144, (_e6144 > -127f));
let _e6148 = select(128f, _e6146, (_e6146 < 128f));
let _e6155 = select(0i, select(select(i32(_e6148), i32(-2147483648), (_e6148 < -2147483600f)), 2147483647i, (_e6148 > 2147483500f)), (_e6148 == _e6148));
let _e6159 = (_e6155 - select(0i, 1i, (_e6148 < f32(_e6155))));
let _e6160 = f32(_e6159);
let _e6164 = ((_e6142 - (_e6160 * 0.6933594f)) - (_e6160 * -2.1219444e-4f));
let _e6185 = (1f - _e5947);
let _e6197 = (((_e4323.member_1.x * _e466) + (_e4323.member_1.y * _e477)) + (_e4323.member_1.z * _e488));
let _e6199 = select(1f, -1f, (_e6197 > 0f));
let _e6211 = select(_e6199, -(_e6199), ((((_e4323.member_2.x * _e4323.member_1.x) + (_e4323.member_2.y * _e4323.member_1.y)) + (_e4323.member_2.z * _e4323.member_1.z)) < 0f));
let _e6212 = (_e4323.member_2.x * _e6211);
let _e6213 = (_e4323.member_2.y * _e6211);
let _e6214 = (_e4323.member_2.z * _e6211);
let _e6223 = ((((_e6212 * _e466) + (_e6213 * _e477)) + (_e6214 * _e488)) > 0f);
let _e6232 = -((((select(_e6212, (_e4323.member_1.x * _e6199), _e6223) * _e5937.member.x) + (select(_e6213, (_e4323.member_1.y * _e6199), _e6223) * _e5937.member.y)) + (select(_e6214, (_e4323.member_1.z * _e6199), _e6223) * _e5937.member.z)));
let _e6242 = -(_e6232);
let _e6247 = select((select(0f, _e6242, (_e6242 > 0f)) * _e4323.member_4), select(0f, _e6232, (_e6232 > 0f)), (((((_e4323.member_1.x * _e5937.member.x) + (_e4323.member_1.y * _e5937.member.y)) + (_e4323.member_1.z * _e5937.member.z)) * _e6197) > 0f));
let _e6261 = global_1.member.member_16;
phi_9918_ = type_24(_e4450.member, _e4450.member_1, vec3<f32>((_e4450.member_2.x + (((_e4323.member_3.x * (((_e5937.member_1.x * (((1f + (_e6068 * (1f + (_e6068 * (0.5f + (_e6068 * (0.16666667f + (_e6068 * (0.041666668f + (_e6068 * (0.008333334f + (_e6068 * (0.001388889f + (_e6068 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6063 + 127i)) << bitcast<u32>(23i)))) * _e6185)) * _e6247) + _e6261.member)) * _e858) * _e723)), (_e4450.member_2.y + (((_e4323.member_3.y * (((_e5937.member_1.y * (((1f + (_e6116 * (1f + (_e6116 * (0.5f + (_e6116 * (0.16666667f + (_e6116 * (0.041666668f + (_e6116 * (0.008333334f + (_e6116 * (0.001388889f + (_e6116 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6111 + 127i)) << bitcast<u32>(23i)))) * _e6185)) * _e6247) + _e6261.member_1)) * _e906) * _e724)), (_e4450.member_2.z + (((_e4323.member_3.z * (((_e5937.member_1.z * (((1f + (_e6164 * (1f + (_e6164 * (0.5f + (_e6164 * (0.16666667f + (_e6164 * (0.041666668f + (_e6164 * (0.008333334f + (_e6164 * (0.001388889f + (_e6164 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6159 + 127i)) << bitcast<u32>(23i)))) * _e6185)) * _e6247) + _e6261.member_2)) * _e954) * _e725))), _e4450.member_3, _e4450.member_4, _e4450.member_5, _e4450.member_6, _e4450.member_7);
} else {
phi_9918_ = _e4450;
}
let _e6299 = phi_9918_;
phi_9919_ = _e6299;
}
let _e6301 = phi_9919_;
global_6.member[_e168] = _e6301.member;
global_6.member[_e180] = _e6301.member_1;
global_6.member[_e191] = _e6301.member_2.x;
global_6.member[_e202] = _e6301.member_2.y;
global_6.member[_e213] = _e6301.member_2.z;
global_6.member[_e224] = _e6301.member_3.x;
global_6.member[_e235] = _e6301.member_3.y;
global_6.member[_e246] = _e6301.member_3.z;
global_6.member[_e257] = _e6301.member_4.x;
global_6.member[_e268] = _e6301.member_4.y;
global_6.member[_e279] = _e6301.member_4.z;
global_6.member[_e290] = _e6301.member_5.x;
global_6.member[_e301] = _e6301.member_5.y;
global_6.member[_e312] = _e6301.member_5.z;
global_6.member[_e323] = _e6301.member_6;
global_6.member[_e334] = _e6301.member_7.x;
global_6.member[_e345] = _e6301.member_7.y;
global_6.member[_e356] = _e6301.member_7.z;
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
