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
var phi_2156_: type_27;
var phi_2160_: type_27;
var phi_2277_: vec3<f32>;
var phi_2279_: i32;
var phi_2864_: vec3<f32>;
var phi_2867_: vec3<f32>;
var phi_2880_: type_26;
var phi_3874_: vec3<f32>;
var phi_3877_: vec3<f32>;
var phi_3890_: type_26;
var phi_4901_: vec3<f32>;
var phi_4904_: vec3<f32>;
var phi_4917_: type_26;
var phi_5911_: vec3<f32>;
var phi_5914_: vec3<f32>;
var phi_5927_: type_26;
var phi_2278_: vec3<f32>;
var phi_2280_: i32;
var phi_6373_: vec3<f32>;
var phi_6388_: type_24;
var phi_7123_: type_25;
var phi_7187_: bool;
var phi_7301_: type_24;
var phi_7405_: vec3<f32>;
var phi_8007_: i32;
var phi_8010_: i32;
var phi_8012_: i32;
var phi_8014_: i32;
var phi_8029_: i32;
var phi_8035_: i32;
var phi_8008_: i32;
var phi_8011_: i32;
var phi_8013_: i32;
var phi_8015_: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var phi_8110_: i32;
var local_16: i32;
var local_17: i32;
var phi_8116_: i32;
var local_18: i32;
var phi_8123_: i32;
var local_19: i32;
var local_20: i32;
var phi_8129_: i32;
var local_21: i32;
var local_22: i32;
var phi_8140_: i32;
var local_23: i32;
var local_24: i32;
var phi_8152_: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var phi_8388_: i32;
var phi_8391_: i32;
var phi_8393_: i32;
var phi_8395_: i32;
var phi_8410_: i32;
var phi_8416_: i32;
var phi_8389_: i32;
var phi_8392_: i32;
var phi_8394_: i32;
var phi_8396_: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var phi_8491_: i32;
var local_32: i32;
var local_33: i32;
var phi_8497_: i32;
var local_34: i32;
var phi_8504_: i32;
var local_35: i32;
var local_36: i32;
var phi_8510_: i32;
var local_37: i32;
var local_38: i32;
var phi_8521_: i32;
var local_39: i32;
var local_40: i32;
var phi_8533_: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var phi_8788_: vec3<f32>;
var phi_8789_: vec3<f32>;
var phi_8790_: vec3<f32>;
var phi_9330_: vec3<f32>;
var phi_9333_: vec3<f32>;
var phi_9346_: type_26;
var phi_9893_: type_24;
var phi_9894_: type_24;
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
let _e801 = select(_e797, _e799, (_e799 > _e797));
let _e802 = (_e801 - _e797);
let _e806 = global_1.member.member_13.member;
let _e811 = -((_e806.member * _e802));
let _e813 = select(-87f, _e811, (_e811 > -87f));
let _e815 = select(88f, _e813, (_e813 < 88f));
let _e817 = ((_e815 * 1.442695f) + 0.5f);
let _e819 = select(-127f, _e817, (_e817 > -127f));
let _e821 = select(128f, _e819, (_e819 < 128f));
let _e828 = select(0i, select(select(i32(_e821), i32(-2147483648), (_e821 < -2147483600f)), 2147483647i, (_e821 > 2147483500f)), (_e821 == _e821));
let _e832 = (_e828 - select(0i, 1i, (_e821 < f32(_e828))));
let _e833 = f32(_e832);
let _e837 = ((_e815 - (_e833 * 0.6933594f)) - (_e833 * -2.1219444e-4f));
let _e857 = ((1f + (_e837 * (1f + (_e837 * (0.5f + (_e837 * (0.16666667f + (_e837 * (0.041666668f + (_e837 * (0.008333334f + (_e837 * (0.001388889f + (_e837 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e832 + 127i)) << bitcast<u32>(23i))));
let _e859 = -((_e806.member_1 * _e802));
let _e861 = select(-87f, _e859, (_e859 > -87f));
let _e863 = select(88f, _e861, (_e861 < 88f));
let _e865 = ((_e863 * 1.442695f) + 0.5f);
let _e867 = select(-127f, _e865, (_e865 > -127f));
let _e869 = select(128f, _e867, (_e867 < 128f));
let _e876 = select(0i, select(select(i32(_e869), i32(-2147483648), (_e869 < -2147483600f)), 2147483647i, (_e869 > 2147483500f)), (_e869 == _e869));
let _e880 = (_e876 - select(0i, 1i, (_e869 < f32(_e876))));
let _e881 = f32(_e880);
let _e885 = ((_e863 - (_e881 * 0.6933594f)) - (_e881 * -2.1219444e-4f));
let _e905 = ((1f + (_e885 * (1f + (_e885 * (0.5f + (_e885 * (0.16666667f + (_e885 * (0.041666668f + (_e885 * (0.008333334f + (_e885 * (0.001388889f + (_e885 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e880 + 127i)) << bitcast<u32>(23i))));
let _e907 = -((_e806.member_2 * _e802));
let _e909 = select(-87f, _e907, (_e907 > -87f));
let _e911 = select(88f, _e909, (_e909 < 88f));
let _e913 = ((_e911 * 1.442695f) + 0.5f);
let _e915 = select(-127f, _e913, (_e913 > -127f));
let _e917 = select(128f, _e915, (_e915 < 128f));
let _e924 = select(0i, select(select(i32(_e917), i32(-2147483648), (_e917 < -2147483600f)), 2147483647i, (_e917 > 2147483500f)), (_e917 == _e917));
let _e928 = (_e924 - select(0i, 1i, (_e917 < f32(_e924))));
let _e929 = f32(_e928);
let _e933 = ((_e911 - (_e929 * 0.6933594f)) - (_e929 * -2.1219444e-4f));
let _e953 = ((1f + (_e933 * (1f + (_e933 * (0.5f + (_e933 * (0.16666667f + (_e933 * (0.041666668f + (_e933 * (0.008333334f + (_e933 * (0.001388889f + (_e933 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e928 + 127i)) << bitcast<u32>(23i))));
let _e956 = global_1.member.member_17;
let _e961 = (1f / 3f);
if (((_e956 & 2u) != 0u) && ((((_e723 + _e724) + _e725) * _e961) >= 0.01f)) {
local_5 = vec3<f32>(_e718, _e719, _e720);
local_6 = vec3<f32>(_e466, _e477, _e488);
local_7 = _e797;
let _e965 = local_7;
let _e970 = global_1.member.member_10.member;
if (_e970 == 2u) {
let _e972 = local_5;
let _e973 = local_6;
let _e977 = global_1.member.member_10.member_1;
let _e984 = global_1.member.member_10.member_3;
let _e989 = (_e972.x - _e984.member);
let _e991 = (_e972.y - _e984.member_1);
let _e993 = (_e972.z - _e984.member_2);
let _e998 = global_1.member.member_10.member_4.member_2;
let _e1000 = (1f + (_e998 * _e998));
let _e1005 = (((_e977.member * _e989) + (_e977.member_1 * _e991)) + (_e977.member_2 * _e993));
let _e1013 = (((_e977.member * _e973.x) + (_e977.member_1 * _e973.y)) + (_e977.member_2 * _e973.z));
let _e1014 = (_e1000 * _e1013);
let _e1016 = ((_e1014 * _e1013) - 1f);
let _e1023 = ((_e1014 * _e1005) - (((_e989 * _e973.x) + (_e991 * _e973.y)) + (_e993 * _e973.z)));
let _e1034 = ((_e1023 * _e1023) - (_e1016 * (((_e1000 * _e1005) * _e1005) - (((_e989 * _e989) + (_e991 * _e991)) + (_e993 * _e993)))));
let _e1035 = (_e1034 > 0f);
let _e1037 = sqrt(select(0f, _e1034, _e1035));
let _e1040 = (1f / select(_e1016, 1e-20f, (_e1016 == 0f)));
let _e1041 = -(_e1023);
let _e1043 = ((_e1041 - _e1037) * _e1040);
let _e1045 = ((_e1041 + _e1037) * _e1040);
let _e1047 = select(_e1045, _e1043, (_e1043 < _e1045));
let _e1049 = select(_e1045, _e1043, (_e1043 > _e1045));
if (_e1016 < 0f) {
let _e1056 = (_e1035 && ((_e1005 + (_e1013 * (0.5f * (_e1047 + _e1049)))) > 0f));
let _e1057 = select(_e801, _e1047, _e1056);
let _e1060 = select(_e965, _e1049, _e1056);
phi_2156_ = type_27(select(_e1057, _e965, (_e965 > _e1057)), select(_e1060, _e801, (_e801 < _e1060)));
} else {
let _e1067 = (-(_e1005) / select(_e1013, 1e-20f, (_e1013 == 0f)));
let _e1070 = (_e1013 > 0f);
let _e1071 = select(_e965, select(_e1067, _e1049, _e1035), _e1070);
let _e1074 = select(select(_e1067, _e1047, _e1035), _e801, _e1070);
phi_2156_ = type_27(select(_e1071, _e965, (_e965 > _e1071)), select(_e1074, _e801, (_e801 < _e1074)));
}
let _e1079 = phi_2156_;
phi_2160_ = _e1079;
} else {
phi_2160_ = type_27(_e965, _e801);
}
let _e1081 = phi_2160_;
if (_e1081.member_1 > _e1081.member) {
let _e1088 = global_1.member.member_10.member_3;
let _e1092 = local_5;
let _e1094 = (_e1088.member - _e1092.x);
let _e1096 = (_e1088.member_1 - _e1092.y);
let _e1098 = (_e1088.member_2 - _e1092.z);
let _e1099 = local_6;
let _e1107 = (((_e1094 * _e1099.x) + (_e1096 * _e1099.y)) + (_e1098 * _e1099.z));
let _e1108 = local_6;
let _e1115 = (_e1094 - (_e1108.x * _e1107));
let _e1116 = (_e1096 - (_e1108.y * _e1107));
let _e1117 = (_e1098 - (_e1108.z * _e1107));
let _e1122 = (((_e1115 * _e1115) + (_e1116 * _e1116)) + (_e1117 * _e1117));
let _e1125 = sqrt(select(0f, _e1122, (_e1122 > 0f)));
local_8.member_2 = (_e970 == 0u);
local_8.member = _e1107;
local_8.member_1 = select(1e-6f, _e1125, (_e1125 > 1e-6f));
let _e1132 = local_8.member;
let _e1134 = local_8.member_1;
let _e1135 = ((_e1081.member - _e1132) / _e1134);
let _e1136 = local_8.member_2;
let _e1138 = (1f + (_e1135 * _e1135));
let _e1144 = select((_e1135 / (1f + sqrt(select(0f, _e1138, (_e1138 > 0f))))), _e1081.member, _e1136);
let _e1145 = local_8.member;
let _e1147 = local_8.member_1;
let _e1148 = ((_e1081.member_1 - _e1145) / _e1147);
let _e1149 = local_8.member_2;
let _e1151 = (1f + (_e1148 * _e1148));
local_9 = ((select((_e1148 / (1f + sqrt(select(0f, _e1151, (_e1151 > 0f))))), _e1081.member_1, _e1149) - _e1144) * (0.5f / 6f));
phi_2277_ = vec3<f32>(0f, 0f, 0f);
phi_2279_ = 0i;
loop {
let _e1162 = phi_2277_;
let _e1164 = phi_2279_;
local_45 = _e1162;
let _e1165 = (_e1164 < 6i);
if _e1165 {
let _e1169 = local_9;
local_10 = (_e1144 + (_e1169 * ((2f * f32(_e1164)) + 1f)));
let _e1173 = local_5;
let _e1174 = local_6;
let _e1175 = local_7;
let _e1176 = local_10;
let _e1177 = local_9;
let _e1179 = (_e1176 + (_e1177 * -(0.8611363f)));
let _e1180 = (_e1179 * _e1179);
let _e1181 = (1f - _e1180);
let _e1183 = select(1e-9f, _e1181, (_e1181 > 1e-9f));
let _e1184 = local_8.member;
let _e1185 = local_8.member_1;
let _e1190 = local_8.member_1;
let _e1196 = local_8.member_2;
let _e1197 = select((_e1184 + (_e1185 * ((2f * _e1179) / _e1183))), _e1179, _e1196);
let _e1198 = local_8.member_2;
let _e1207 = (_e1173.x + (_e1174.x * _e1197));
let _e1209 = (_e1173.y + (_e1174.y * _e1197));
let _e1211 = (_e1173.z + (_e1174.z * _e1197));
let _e1214 = global_1.member.member_10.member_2;
let _e1218 = vec3<f32>(_e1214.member, _e1214.member_1, _e1214.member_2);
let _e1221 = global_1.member.member_10.member;
let _e1222 = (_e1221 == 0u);
if _e1222 {
let _e1225 = global_1.member.member_10.member_1;
phi_2880_ = type_26(vec3<f32>(_e1225.member, _e1225.member_1, _e1225.member_2), _e1218);
} else {
let _e1233 = global_1.member.member_10.member_3;
let _e1237 = (_e1207 - _e1233.member);
let _e1238 = (_e1209 - _e1233.member_1);
let _e1239 = (_e1211 - _e1233.member_2);
let _e1244 = (((_e1237 * _e1237) + (_e1238 * _e1238)) + (_e1239 * _e1239));
let _e1246 = select(1e-12f, _e1244, (_e1244 > 1e-12f));
let _e1247 = (1f / _e1246);
let _e1251 = vec3<f32>((_e1214.member * _e1247), (_e1214.member_1 * _e1247), (_e1214.member_2 * _e1247));
if (_e1221 == 2u) {
let _e1255 = global_1.member.member_10.member_1;
let _e1263 = (((_e1255.member * _e1237) + (_e1255.member_1 * _e1238)) + (_e1255.member_2 * _e1239));
let _e1266 = (1f / select(1e-20f, _e1263, (_e1263 > 1e-20f)));
let _e1270 = global_1.member.member_10.member_4.member;
let _e1279 = ((((_e1270.member * _e1237) + (_e1270.member_1 * _e1238)) + (_e1270.member_2 * _e1239)) * _e1266);
let _e1283 = global_1.member.member_10.member_4.member_1;
let _e1292 = ((((_e1283.member * _e1237) + (_e1283.member_1 * _e1238)) + (_e1283.member_2 * _e1239)) * _e1266);
let _e1296 = global_1.member.member_10.member_4.member_2;
let _e1299 = ((_e1279 * _e1279) + (_e1292 * _e1292));
let _e1307 = global_1.member.member_10.member_4.member_3;
let _e1308 = ((_e1296 - sqrt(select(0f, _e1299, (_e1299 > 0f)))) * _e1307);
let _e1310 = select(0f, _e1308, (_e1308 > 0f));
let _e1312 = select(1f, _e1310, (_e1310 < 1f));
let _e1318 = select(0f, ((_e1312 * _e1312) * (3f - (2f * _e1312))), (_e1263 > 0f));
let _e1322 = global_1.member.member_10.member_4.member_5;
if ((_e1322 > 0u) && (_e1318 > 0f)) {
let _e1326 = (0.5f / _e1296);
let _e1335 = global_1.member.member_10.member_4.member_6;
let _e1336 = bitcast<i32>(_e1335);
local_4 = bitcast<i32>(_e1322);
let _e1337 = local_4;
let _e1339 = f32((_e1337 - 1i));
let _e1341 = f32((_e1336 - 1i));
let _e1342 = local_4;
let _e1345 = (((0.5f + (_e1279 * _e1326)) * f32(_e1342)) - 0.5f);
let _e1347 = select(0f, _e1345, (_e1345 > 0f));
let _e1349 = select(_e1339, _e1347, (_e1347 < _e1339));
let _e1352 = (((0.5f - (_e1292 * _e1326)) * f32(_e1336)) - 0.5f);
let _e1354 = select(0f, _e1352, (_e1352 > 0f));
let _e1356 = select(_e1341, _e1354, (_e1354 < _e1341));
let _e1358 = select(0f, _e1349, (_e1349 > 0f));
let _e1360 = select(_e1339, _e1358, (_e1358 < _e1339));
let _e1367 = select(0i, select(select(i32(_e1360), i32(-2147483648), (_e1360 < -2147483600f)), 2147483647i, (_e1360 > 2147483500f)), (_e1360 == _e1360));
let _e1371 = (_e1367 - select(0i, 1i, (_e1360 < f32(_e1367))));
let _e1373 = select(0f, _e1356, (_e1356 > 0f));
let _e1375 = select(_e1341, _e1373, (_e1373 < _e1341));
let _e1382 = select(0i, select(select(i32(_e1375), i32(-2147483648), (_e1375 < -2147483600f)), 2147483647i, (_e1375 > 2147483500f)), (_e1375 == _e1375));
let _e1386 = (_e1382 - select(0i, 1i, (_e1375 < f32(_e1382))));
let _e1388 = (_e1349 - f32(_e1371));
let _e1390 = (_e1356 - f32(_e1386));
let _e1391 = (_e1371 + 1i);
let _e1392 = local_4;
let _e1394 = select(_e1371, _e1391, (_e1391 < _e1392));
let _e1395 = (_e1386 + 1i);
let _e1397 = select(_e1386, _e1395, (_e1395 < _e1336));
let _e1401 = global_1.member.member_10.member_4.member_4;
let _e1402 = bitcast<i32>(_e1401);
let _e1403 = local_4;
let _e1407 = (_e1402 + (3i * ((_e1386 * _e1403) + _e1371)));
let _e1409 = (bitcast<i32>(_e146) - 1i);
let _e1411 = select(_e1409, _e1407, (_e1407 < _e1409));
let _e1416 = global_3.member[bitcast<u32>(select(0i, _e1411, (_e1411 > 0i)))];
let _e1417 = (_e1407 + 1i);
let _e1419 = select(_e1409, _e1417, (_e1417 < _e1409));
let _e1424 = global_3.member[bitcast<u32>(select(0i, _e1419, (_e1419 > 0i)))];
let _e1425 = (_e1407 + 2i);
let _e1427 = select(_e1409, _e1425, (_e1425 < _e1409));
let _e1432 = global_3.member[bitcast<u32>(select(0i, _e1427, (_e1427 > 0i)))];
let _e1433 = local_4;
let _e1437 = (_e1402 + (3i * ((_e1386 * _e1433) + _e1394)));
let _e1439 = select(_e1409, _e1437, (_e1437 < _e1409));
let _e1444 = global_3.member[bitcast<u32>(select(0i, _e1439, (_e1439 > 0i)))];
let _e1445 = (_e1437 + 1i);
let _e1447 = select(_e1409, _e1445, (_e1445 < _e1409));
let _e1452 = global_3.member[bitcast<u32>(select(0i, _e1447, (_e1447 > 0i)))];
let _e1453 = (_e1437 + 2i);
let _e1455 = select(_e1409, _e1453, (_e1453 < _e1409));
let _e1460 = global_3.member[bitcast<u32>(select(0i, _e1455, (_e1455 > 0i)))];
let _e1461 = local_4;
let _e1465 = (_e1402 + (3i * ((_e1397 * _e1461) + _e1371)));
let _e1467 = select(_e1409, _e1465, (_e1465 < _e1409));
let _e1472 = global_3.member[bitcast<u32>(select(0i, _e1467, (_e1467 > 0i)))];
let _e1473 = (_e1465 + 1i);
let _e1475 = select(_e1409, _e1473, (_e1473 < _e1409));
let _e1480 = global_3.member[bitcast<u32>(select(0i, _e1475, (_e1475 > 0i)))];
let _e1481 = (_e1465 + 2i);
let _e1483 = select(_e1409, _e1481, (_e1481 < _e1409));
let _e1488 = global_3.member[bitcast<u32>(select(0i, _e1483, (_e1483 > 0i)))];
let _e1489 = local_4;
let _e1493 = (_e1402 + (3i * ((_e1397 * _e1489) + _e1394)));
let _e1495 = select(_e1409, _e1493, (_e1493 < _e1409));
let _e1500 = global_3.member[bitcast<u32>(select(0i, _e1495, (_e1495 > 0i)))];
let _e1501 = (_e1493 + 1i);
let _e1503 = select(_e1409, _e1501, (_e1501 < _e1409));
let _e1508 = global_3.member[bitcast<u32>(select(0i, _e1503, (_e1503 > 0i)))];
let _e1509 = (_e1493 + 2i);
let _e1511 = select(_e1409, _e1509, (_e1509 < _e1409));
let _e1516 = global_3.member[bitcast<u32>(select(0i, _e1511, (_e1511 > 0i)))];
let _e1523 = (_e1416 + ((_e1444 - _e1416) * _e1388));
let _e1524 = (_e1424 + ((_e1452 - _e1424) * _e1388));
let _e1525 = (_e1432 + ((_e1460 - _e1432) * _e1388));
phi_2864_ = vec3<f32>(((_e1523 + (((_e1472 + ((_e1500 - _e1472) * _e1388)) - _e1523) * _e1390)) * _e1318), ((_e1524 + (((_e1480 + ((_e1508 - _e1480) * _e1388)) - _e1524) * _e1390)) * _e1318), ((_e1525 + (((_e1488 + ((_e1516 - _e1488) * _e1388)) - _e1525) * _e1390)) * _e1318));
} else {
phi_2864_ = vec3(_e1318);
}
let _e1550 = phi_2864_;
phi_2867_ = (_e1251 * _e1550);
} else {
phi_2867_ = _e1251;
}
let _e1553 = phi_2867_;
let _e1557 = (1f / sqrt(select(0f, _e1246, (_e1246 > 0f))));
phi_2880_ = type_26(vec3<f32>((_e1237 * _e1557), (_e1238 * _e1557), (_e1239 * _e1557)), _e1553);
}
let _e1564 = phi_2880_;
let _e1567 = global_1.member.member_10.member_3;
let _e1571 = (_e1567.member - _e1207);
let _e1572 = (_e1567.member_1 - _e1209);
let _e1573 = (_e1567.member_2 - _e1211);
let _e1574 = local_8.member_2;
let _e1579 = (((_e1571 * _e1571) + (_e1572 * _e1572)) + (_e1573 * _e1573));
let _e1583 = select(sqrt(select(0f, _e1579, (_e1579 > 0f))), 1e30f, _e1574);
let _e1586 = -(_e1564.member.x);
let _e1588 = -(_e1564.member.y);
let _e1590 = -(_e1564.member.z);
let _e1598 = (1f / select(_e1586, select(1e-12f, -1e-12f, (_e1586 < 0f)), (bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u)) < 1e-12f)));
let _e1606 = (1f / select(_e1588, select(1e-12f, -1e-12f, (_e1588 < 0f)), (bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u)) < 1e-12f)));
let _e1614 = (1f / select(_e1590, select(1e-12f, -1e-12f, (_e1590 < 0f)), (bitcast<f32>((bitcast<u32>(_e1590) & 2147483647u)) < 1e-12f)));
let _e1617 = global_1.member.member_13.member_4;
let _e1623 = global_1.member.member_13.member_5;
let _e1628 = ((_e1617.member - _e1207) * _e1598);
let _e1630 = ((_e1623.member - _e1207) * _e1598);
let _e1632 = ((_e1617.member_1 - _e1209) * _e1606);
let _e1634 = ((_e1623.member_1 - _e1209) * _e1606);
let _e1636 = ((_e1617.member_2 - _e1211) * _e1614);
let _e1638 = ((_e1623.member_2 - _e1211) * _e1614);
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
let _e1662 = select(_e1583, _e1658, (_e1658 < _e1583));
let _e1666 = (_e1197 - _e1175);
let _e1669 = ((select(_e1660, _e1662, (_e1662 > _e1660)) - _e1660) + select(0f, _e1666, (_e1666 > 0f)));
let _e1672 = global_1.member.member_13.member;
let _e1677 = -((_e1672.member * _e1669));
let _e1679 = select(-87f, _e1677, (_e1677 > -87f));
let _e1681 = select(88f, _e1679, (_e1679 < 88f));
let _e1683 = ((_e1681 * 1.442695f) + 0.5f);
let _e1685 = select(-127f, _e1683, (_e1683 > -127f));
let _e1687 = select(128f, _e1685, (_e1685 < 128f));
let _e1694 = select(0i, select(select(i32(_e1687), i32(-2147483648), (_e1687 < -2147483600f)), 2147483647i, (_e1687 > 2147483500f)), (_e1687 == _e1687));
let _e1698 = (_e1694 - select(0i, 1i, (_e1687 < f32(_e1694))));
let _e1699 = f32(_e1698);
let _e1703 = ((_e1681 - (_e1699 * 0.6933594f)) - (_e1699 * -2.1219444e-4f));
let _e1725 = -((_e1672.member_1 * _e1669));
let _e1727 = select(-87f, _e1725, (_e1725 > -87f));
let _e1729 = select(88f, _e1727, (_e1727 < 88f));
let _e1731 = ((_e1729 * 1.442695f) + 0.5f);
let _e1733 = select(-127f, _e1731, (_e1731 > -127f));
let _e1735 = select(128f, _e1733, (_e1733 < 128f));
let _e1742 = select(0i, select(select(i32(_e1735), i32(-2147483648), (_e1735 < -2147483600f)), 2147483647i, (_e1735 > 2147483500f)), (_e1735 == _e1735));
let _e1746 = (_e1742 - select(0i, 1i, (_e1735 < f32(_e1742))));
let _e1747 = f32(_e1746);
let _e1751 = ((_e1729 - (_e1747 * 0.6933594f)) - (_e1747 * -2.1219444e-4f));
let _e1773 = -((_e1672.member_2 * _e1669));
let _e1775 = select(-87f, _e1773, (_e1773 > -87f));
let _e1777 = select(88f, _e1775, (_e1775 < 88f));
let _e1779 = ((_e1777 * 1.442695f) + 0.5f);
let _e1781 = select(-127f, _e1779, (_e1779 > -127f));
let _e1783 = select(128f, _e1781, (_e1781 < 128f));
let _e1790 = select(0i, select(select(i32(_e1783), i32(-2147483648), (_e1783 < -2147483600f)), 2147483647i, (_e1783 > 2147483500f)), (_e1783 == _e1783));
let _e1794 = (_e1790 - select(0i, 1i, (_e1783 < f32(_e1790))));
let _e1795 = f32(_e1794);
let _e1799 = ((_e1777 - (_e1795 * 0.6933594f)) - (_e1795 * -2.1219444e-4f));
let _e1825 = -((((_e1564.member.x * _e1174.x) + (_e1564.member.y * _e1174.y)) + (_e1564.member.z * _e1174.z)));
let _e1828 = global_1.member.member_13.member_2;
let _e1829 = (_e1828 * _e1828);
let _e1830 = (1f + _e1829);
let _e1831 = (2f * _e1828);
let _e1833 = (_e1830 - (_e1831 * _e1825));
let _e1835 = select(1e-9f, _e1833, (_e1833 > 1e-9f));
let _e1836 = (1f - _e1829);
let _e1847 = global_1.member.member_13.member_3;
let _e1848 = (_e1847 == 1u);
let _e1850 = (0.25f / 3.1415927f);
let _e1853 = ((3.1415927f * (select((_e1836 / (_e1835 * sqrt(select(0f, _e1835, (_e1835 > 0f))))), (0.75f * (1f + (_e1825 * _e1825))), _e1848) * _e1850)) * select((_e1190 * ((2f * (1f + _e1180)) / (_e1183 * _e1183))), 1f, _e1198));
let _e1863 = global_1.member.member_13.member_1;
let _e1873 = local_5;
let _e1874 = local_6;
let _e1875 = local_7;
let _e1876 = local_10;
let _e1877 = local_9;
let _e1879 = (_e1876 + (_e1877 * 0.8611363f));
let _e1880 = (_e1879 * _e1879);
let _e1881 = (1f - _e1880);
let _e1883 = select(1e-9f, _e1881, (_e1881 > 1e-9f));
let _e1884 = local_8.member;
let _e1885 = local_8.member_1;
let _e1890 = local_8.member_1;
let _e1896 = local_8.member_2;
let _e1897 = select((_e1884 + (_e1885 * ((2f * _e1879) / _e1883))), _e1879, _e1896);
let _e1898 = local_8.member_2;
let _e1907 = (_e1873.x + (_e1874.x * _e1897));
let _e1909 = (_e1873.y + (_e1874.y * _e1897));
let _e1911 = (_e1873.z + (_e1874.z * _e1897));
if _e1222 {
let _e1914 = global_1.member.member_10.member_1;
phi_3890_ = type_26(vec3<f32>(_e1914.member, _e1914.member_1, _e1914.member_2), _e1218);
} else {
let _e1920 = (_e1907 - _e1567.member);
let _e1921 = (_e1909 - _e1567.member_1);
let _e1922 = (_e1911 - _e1567.member_2);
let _e1927 = (((_e1920 * _e1920) + (_e1921 * _e1921)) + (_e1922 * _e1922));
let _e1929 = select(1e-12f, _e1927, (_e1927 > 1e-12f));
let _e1930 = (1f / _e1929);
let _e1934 = vec3<f32>((_e1214.member * _e1930), (_e1214.member_1 * _e1930), (_e1214.member_2 * _e1930));
if (_e1221 == 2u) {
let _e1938 = global_1.member.member_10.member_1;
let _e1946 = (((_e1938.member * _e1920) + (_e1938.member_1 * _e1921)) + (_e1938.member_2 * _e1922));
let _e1949 = (1f / select(1e-20f, _e1946, (_e1946 > 1e-20f)));
let _e1953 = global_1.member.member_10.member_4.member;
let _e1962 = ((((_e1953.member * _e1920) + (_e1953.member_1 * _e1921)) + (_e1953.member_2 * _e1922)) * _e1949);
let _e1966 = global_1.member.member_10.member_4.member_1;
let _e1975 = ((((_e1966.member * _e1920) + (_e1966.member_1 * _e1921)) + (_e1966.member_2 * _e1922)) * _e1949);
let _e1979 = global_1.member.member_10.member_4.member_2;
let _e1982 = ((_e1962 * _e1962) + (_e1975 * _e1975));
let _e1990 = global_1.member.member_10.member_4.member_3;
let _e1991 = ((_e1979 - sqrt(select(0f, _e1982, (_e1982 > 0f)))) * _e1990);
let _e1993 = select(0f, _e1991, (_e1991 > 0f));
let _e1995 = select(1f, _e1993, (_e1993 < 1f));
let _e2001 = select(0f, ((_e1995 * _e1995) * (3f - (2f * _e1995))), (_e1946 > 0f));
let _e2005 = global_1.member.member_10.member_4.member_5;
if ((_e2005 > 0u) && (_e2001 > 0f)) {
let _e2009 = (0.5f / _e1979);
let _e2018 = global_1.member.member_10.member_4.member_6;
let _e2019 = bitcast<i32>(_e2018);
local_3 = bitcast<i32>(_e2005);
let _e2020 = local_3;
let _e2022 = f32((_e2020 - 1i));
let _e2024 = f32((_e2019 - 1i));
let _e2025 = local_3;
let _e2028 = (((0.5f + (_e1962 * _e2009)) * f32(_e2025)) - 0.5f);
let _e2030 = select(0f, _e2028, (_e2028 > 0f));
let _e2032 = select(_e2022, _e2030, (_e2030 < _e2022));
let _e2035 = (((0.5f - (_e1975 * _e2009)) * f32(_e2019)) - 0.5f);
let _e2037 = select(0f, _e2035, (_e2035 > 0f));
let _e2039 = select(_e2024, _e2037, (_e2037 < _e2024));
let _e2041 = select(0f, _e2032, (_e2032 > 0f));
let _e2043 = select(_e2022, _e2041, (_e2041 < _e2022));
let _e2050 = select(0i, select(select(i32(_e2043), i32(-2147483648), (_e2043 < -2147483600f)), 2147483647i, (_e2043 > 2147483500f)), (_e2043 == _e2043));
let _e2054 = (_e2050 - select(0i, 1i, (_e2043 < f32(_e2050))));
let _e2056 = select(0f, _e2039, (_e2039 > 0f));
let _e2058 = select(_e2024, _e2056, (_e2056 < _e2024));
let _e2065 = select(0i, select(select(i32(_e2058), i32(-2147483648), (_e2058 < -2147483600f)), 2147483647i, (_e2058 > 2147483500f)), (_e2058 == _e2058));
let _e2069 = (_e2065 - select(0i, 1i, (_e2058 < f32(_e2065))));
let _e2071 = (_e2032 - f32(_e2054));
let _e2073 = (_e2039 - f32(_e2069));
let _e2074 = (_e2054 + 1i);
let _e2075 = local_3;
let _e2077 = select(_e2054, _e2074, (_e2074 < _e2075));
let _e2078 = (_e2069 + 1i);
let _e2080 = select(_e2069, _e2078, (_e2078 < _e2019));
let _e2084 = global_1.member.member_10.member_4.member_4;
let _e2085 = bitcast<i32>(_e2084);
let _e2086 = local_3;
let _e2090 = (_e2085 + (3i * ((_e2069 * _e2086) + _e2054)));
let _e2092 = (bitcast<i32>(_e146) - 1i);
let _e2094 = select(_e2092, _e2090, (_e2090 < _e2092));
let _e2099 = global_3.member[bitcast<u32>(select(0i, _e2094, (_e2094 > 0i)))];
let _e2100 = (_e2090 + 1i);
let _e2102 = select(_e2092, _e2100, (_e2100 < _e2092));
let _e2107 = global_3.member[bitcast<u32>(select(0i, _e2102, (_e2102 > 0i)))];
let _e2108 = (_e2090 + 2i);
let _e2110 = select(_e2092, _e2108, (_e2108 < _e2092));
let _e2115 = global_3.member[bitcast<u32>(select(0i, _e2110, (_e2110 > 0i)))];
let _e2116 = local_3;
let _e2120 = (_e2085 + (3i * ((_e2069 * _e2116) + _e2077)));
let _e2122 = select(_e2092, _e2120, (_e2120 < _e2092));
let _e2127 = global_3.member[bitcast<u32>(select(0i, _e2122, (_e2122 > 0i)))];
let _e2128 = (_e2120 + 1i);
let _e2130 = select(_e2092, _e2128, (_e2128 < _e2092));
let _e2135 = global_3.member[bitcast<u32>(select(0i, _e2130, (_e2130 > 0i)))];
let _e2136 = (_e2120 + 2i);
let _e2138 = select(_e2092, _e2136, (_e2136 < _e2092));
let _e2143 = global_3.member[bitcast<u32>(select(0i, _e2138, (_e2138 > 0i)))];
let _e2144 = local_3;
let _e2148 = (_e2085 + (3i * ((_e2080 * _e2144) + _e2054)));
let _e2150 = select(_e2092, _e2148, (_e2148 < _e2092));
let _e2155 = global_3.member[bitcast<u32>(select(0i, _e2150, (_e2150 > 0i)))];
let _e2156 = (_e2148 + 1i);
let _e2158 = select(_e2092, _e2156, (_e2156 < _e2092));
let _e2163 = global_3.member[bitcast<u32>(select(0i, _e2158, (_e2158 > 0i)))];
let _e2164 = (_e2148 + 2i);
let _e2166 = select(_e2092, _e2164, (_e2164 < _e2092));
let _e2171 = global_3.member[bitcast<u32>(select(0i, _e2166, (_e2166 > 0i)))];
let _e2172 = local_3;
let _e2176 = (_e2085 + (3i * ((_e2080 * _e2172) + _e2077)));
let _e2178 = select(_e2092, _e2176, (_e2176 < _e2092));
let _e2183 = global_3.member[bitcast<u32>(select(0i, _e2178, (_e2178 > 0i)))];
let _e2184 = (_e2176 + 1i);
let _e2186 = select(_e2092, _e2184, (_e2184 < _e2092));
let _e2191 = global_3.member[bitcast<u32>(select(0i, _e2186, (_e2186 > 0i)))];
let _e2192 = (_e2176 + 2i);
let _e2194 = select(_e2092, _e2192, (_e2192 < _e2092));
let _e2199 = global_3.member[bitcast<u32>(select(0i, _e2194, (_e2194 > 0i)))];
let _e2206 = (_e2099 + ((_e2127 - _e2099) * _e2071));
let _e2207 = (_e2107 + ((_e2135 - _e2107) * _e2071));
let _e2208 = (_e2115 + ((_e2143 - _e2115) * _e2071));
phi_3874_ = vec3<f32>(((_e2206 + (((_e2155 + ((_e2183 - _e2155) * _e2071)) - _e2206) * _e2073)) * _e2001), ((_e2207 + (((_e2163 + ((_e2191 - _e2163) * _e2071)) - _e2207) * _e2073)) * _e2001), ((_e2208 + (((_e2171 + ((_e2199 - _e2171) * _e2071)) - _e2208) * _e2073)) * _e2001));
} else {
phi_3874_ = vec3(_e2001);
}
let _e2233 = phi_3874_;
phi_3877_ = (_e1934 * _e2233);
} else {
phi_3877_ = _e1934;
}
let _e2236 = phi_3877_;
let _e2240 = (1f / sqrt(select(0f, _e1929, (_e1929 > 0f))));
phi_3890_ = type_26(vec3<f32>((_e1920 * _e2240), (_e1921 * _e2240), (_e1922 * _e2240)), _e2236);
}
let _e2247 = phi_3890_;
let _e2248 = (_e1567.member - _e1907);
let _e2249 = (_e1567.member_1 - _e1909);
let _e2250 = (_e1567.member_2 - _e1911);
let _e2251 = local_8.member_2;
let _e2256 = (((_e2248 * _e2248) + (_e2249 * _e2249)) + (_e2250 * _e2250));
let _e2260 = select(sqrt(select(0f, _e2256, (_e2256 > 0f))), 1e30f, _e2251);
let _e2263 = -(_e2247.member.x);
let _e2265 = -(_e2247.member.y);
let _e2267 = -(_e2247.member.z);
let _e2275 = (1f / select(_e2263, select(1e-12f, -1e-12f, (_e2263 < 0f)), (bitcast<f32>((bitcast<u32>(_e2263) & 2147483647u)) < 1e-12f)));
let _e2283 = (1f / select(_e2265, select(1e-12f, -1e-12f, (_e2265 < 0f)), (bitcast<f32>((bitcast<u32>(_e2265) & 2147483647u)) < 1e-12f)));
let _e2291 = (1f / select(_e2267, select(1e-12f, -1e-12f, (_e2267 < 0f)), (bitcast<f32>((bitcast<u32>(_e2267) & 2147483647u)) < 1e-12f)));
let _e2293 = ((_e1617.member - _e1907) * _e2275);
let _e2295 = ((_e1623.member - _e1907) * _e2275);
let _e2297 = ((_e1617.member_1 - _e1909) * _e2283);
let _e2299 = ((_e1623.member_1 - _e1909) * _e2283);
let _e2301 = ((_e1617.member_2 - _e1911) * _e2291);
let _e2303 = ((_e1623.member_2 - _e1911) * _e2291);
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
let _e2327 = select(_e2260, _e2323, (_e2323 < _e2260));
let _e2331 = (_e1897 - _e1875);
let _e2334 = ((select(_e2325, _e2327, (_e2327 > _e2325)) - _e2325) + select(0f, _e2331, (_e2331 > 0f)));
let _e2336 = -((_e1672.member * _e2334));
let _e2338 = select(-87f, _e2336, (_e2336 > -87f));
let _e2340 = select(88f, _e2338, (_e2338 < 88f));
let _e2342 = ((_e2340 * 1.442695f) + 0.5f);
let _e2344 = select(-127f, _e2342, (_e2342 > -127f));
let _e2346 = select(128f, _e2344, (_e2344 < 128f));
let _e2353 = select(0i, select(select(i32(_e2346), i32(-2147483648), (_e2346 < -2147483600f)), 2147483647i, (_e2346 > 2147483500f)), (_e2346 == _e2346));
let _e2357 = (_e2353 - select(0i, 1i, (_e2346 < f32(_e2353))));
let _e2358 = f32(_e2357);
let _e2362 = ((_e2340 - (_e2358 * 0.6933594f)) - (_e2358 * -2.1219444e-4f));
let _e2384 = -((_e1672.member_1 * _e2334));
let _e2386 = select(-87f, _e2384, (_e2384 > -87f));
let _e2388 = select(88f, _e2386, (_e2386 < 88f));
let _e2390 = ((_e2388 * 1.442695f) + 0.5f);
let _e2392 = select(-127f, _e2390, (_e2390 > -127f));
let _e2394 = select(128f, _e2392, (_e2392 < 128f));
let _e2401 = select(0i, select(select(i32(_e2394), i32(-2147483648), (_e2394 < -2147483600f)), 2147483647i, (_e2394 > 2147483500f)), (_e2394 == _e2394));
let _e2405 = (_e2401 - select(0i, 1i, (_e2394 < f32(_e2401))));
let _e2406 = f32(_e2405);
let _e2410 = ((_e2388 - (_e2406 * 0.6933594f)) - (_e2406 * -2.1219444e-4f));
let _e2432 = -((_e1672.member_2 * _e2334));
let _e2434 = select(-87f, _e2432, (_e2432 > -87f));
let _e2436 = select(88f, _e2434, (_e2434 < 88f));
let _e2438 = ((_e2436 * 1.442695f) + 0.5f);
let _e2440 = select(-127f, _e2438, (_e2438 > -127f));
let _e2442 = select(128f, _e2440, (_e2440 < 128f));
let _e2449 = select(0i, select(select(i32(_e2442), i32(-2147483648), (_e2442 < -2147483600f)), 2147483647i, (_e2442 > 2147483500f)), (_e2442 == _e2442));
let _e2453 = (_e2449 - select(0i, 1i, (_e2442 < f32(_e2449))));
let _e2454 = f32(_e2453);
let _e2458 = ((_e2436 - (_e2454 * 0.6933594f)) - (_e2454 * -2.1219444e-4f));
let _e2484 = -((((_e2247.member.x * _e1874.x) + (_e2247.member.y * _e1874.y)) + (_e2247.member.z * _e1874.z)));
let _e2486 = (_e1830 - (_e1831 * _e2484));
let _e2488 = select(1e-9f, _e2486, (_e2486 > 1e-9f));
let _e2500 = ((3.1415927f * (select((_e1836 / (_e2488 * sqrt(select(0f, _e2488, (_e2488 > 0f))))), (0.75f * (1f + (_e2484 * _e2484))), _e1848) * _e1850)) * select((_e1890 * ((2f * (1f + _e1880)) / (_e1883 * _e1883))), 1f, _e1898));
let _e2517 = local_9;
let _e2518 = (_e2517 * 0.34785485f);
let _e2529 = local_5;
let _e2530 = local_6;
let _e2531 = local_7;
let _e2532 = local_10;
let _e2533 = local_9;
let _e2535 = (_e2532 + (_e2533 * -(0.33998105f)));
let _e2536 = (_e2535 * _e2535);
let _e2537 = (1f - _e2536);
let _e2539 = select(1e-9f, _e2537, (_e2537 > 1e-9f));
let _e2540 = local_8.member;
let _e2541 = local_8.member_1;
let _e2546 = local_8.member_1;
let _e2552 = local_8.member_2;
let _e2553 = select((_e2540 + (_e2541 * ((2f * _e2535) / _e2539))), _e2535, _e2552);
let _e2554 = local_8.member_2;
let _e2563 = (_e2529.x + (_e2530.x * _e2553));
let _e2565 = (_e2529.y + (_e2530.y * _e2553));
let _e2567 = (_e2529.z + (_e2530.z * _e2553));
if _e1222 {
let _e2570 = global_1.member.member_10.member_1;
phi_4917_ = type_26(vec3<f32>(_e2570.member, _e2570.member_1, _e2570.member_2), _e1218);
} else {
let _e2576 = (_e2563 - _e1567.member);
let _e2577 = (_e2565 - _e1567.member_1);
let _e2578 = (_e2567 - _e1567.member_2);
let _e2583 = (((_e2576 * _e2576) + (_e2577 * _e2577)) + (_e2578 * _e2578));
let _e2585 = select(1e-12f, _e2583, (_e2583 > 1e-12f));
let _e2586 = (1f / _e2585);
let _e2590 = vec3<f32>((_e1214.member * _e2586), (_e1214.member_1 * _e2586), (_e1214.member_2 * _e2586));
if (_e1221 == 2u) {
let _e2594 = global_1.member.member_10.member_1;
let _e2602 = (((_e2594.member * _e2576) + (_e2594.member_1 * _e2577)) + (_e2594.member_2 * _e2578));
let _e2605 = (1f / select(1e-20f, _e2602, (_e2602 > 1e-20f)));
let _e2609 = global_1.member.member_10.member_4.member;
let _e2618 = ((((_e2609.member * _e2576) + (_e2609.member_1 * _e2577)) + (_e2609.member_2 * _e2578)) * _e2605);
let _e2622 = global_1.member.member_10.member_4.member_1;
let _e2631 = ((((_e2622.member * _e2576) + (_e2622.member_1 * _e2577)) + (_e2622.member_2 * _e2578)) * _e2605);
let _e2635 = global_1.member.member_10.member_4.member_2;
let _e2638 = ((_e2618 * _e2618) + (_e2631 * _e2631));
let _e2646 = global_1.member.member_10.member_4.member_3;
let _e2647 = ((_e2635 - sqrt(select(0f, _e2638, (_e2638 > 0f)))) * _e2646);
let _e2649 = select(0f, _e2647, (_e2647 > 0f));
let _e2651 = select(1f, _e2649, (_e2649 < 1f));
let _e2657 = select(0f, ((_e2651 * _e2651) * (3f - (2f * _e2651))), (_e2602 > 0f));
let _e2661 = global_1.member.member_10.member_4.member_5;
if ((_e2661 > 0u) && (_e2657 > 0f)) {
let _e2665 = (0.5f / _e2635);
let _e2674 = global_1.member.member_10.member_4.member_6;
let _e2675 = bitcast<i32>(_e2674);
local_2 = bitcast<i32>(_e2661);
let _e2676 = local_2;
let _e2678 = f32((_e2676 - 1i));
let _e2680 = f32((_e2675 - 1i));
let _e2681 = local_2;
let _e2684 = (((0.5f + (_e2618 * _e2665)) * f32(_e2681)) - 0.5f);
let _e2686 = select(0f, _e2684, (_e2684 > 0f));
let _e2688 = select(_e2678, _e2686, (_e2686 < _e2678));
let _e2691 = (((0.5f - (_e2631 * _e2665)) * f32(_e2675)) - 0.5f);
let _e2693 = select(0f, _e2691, (_e2691 > 0f));
let _e2695 = select(_e2680, _e2693, (_e2693 < _e2680));
let _e2697 = select(0f, _e2688, (_e2688 > 0f));
let _e2699 = select(_e2678, _e2697, (_e2697 < _e2678));
let _e2706 = select(0i, select(select(i32(_e2699), i32(-2147483648), (_e2699 < -2147483600f)), 2147483647i, (_e2699 > 2147483500f)), (_e2699 == _e2699));
let _e2710 = (_e2706 - select(0i, 1i, (_e2699 < f32(_e2706))));
let _e2712 = select(0f, _e2695, (_e2695 > 0f));
let _e2714 = select(_e2680, _e2712, (_e2712 < _e2680));
let _e2721 = select(0i, select(select(i32(_e2714), i32(-2147483648), (_e2714 < -2147483600f)), 2147483647i, (_e2714 > 2147483500f)), (_e2714 == _e2714));
let _e2725 = (_e2721 - select(0i, 1i, (_e2714 < f32(_e2721))));
let _e2727 = (_e2688 - f32(_e2710));
let _e2729 = (_e2695 - f32(_e2725));
let _e2730 = (_e2710 + 1i);
let _e2731 = local_2;
let _e2733 = select(_e2710, _e2730, (_e2730 < _e2731));
let _e2734 = (_e2725 + 1i);
let _e2736 = select(_e2725, _e2734, (_e2734 < _e2675));
let _e2740 = global_1.member.member_10.member_4.member_4;
let _e2741 = bitcast<i32>(_e2740);
let _e2742 = local_2;
let _e2746 = (_e2741 + (3i * ((_e2725 * _e2742) + _e2710)));
let _e2748 = (bitcast<i32>(_e146) - 1i);
let _e2750 = select(_e2748, _e2746, (_e2746 < _e2748));
let _e2755 = global_3.member[bitcast<u32>(select(0i, _e2750, (_e2750 > 0i)))];
let _e2756 = (_e2746 + 1i);
let _e2758 = select(_e2748, _e2756, (_e2756 < _e2748));
let _e2763 = global_3.member[bitcast<u32>(select(0i, _e2758, (_e2758 > 0i)))];
let _e2764 = (_e2746 + 2i);
let _e2766 = select(_e2748, _e2764, (_e2764 < _e2748));
let _e2771 = global_3.member[bitcast<u32>(select(0i, _e2766, (_e2766 > 0i)))];
let _e2772 = local_2;
let _e2776 = (_e2741 + (3i * ((_e2725 * _e2772) + _e2733)));
let _e2778 = select(_e2748, _e2776, (_e2776 < _e2748));
let _e2783 = global_3.member[bitcast<u32>(select(0i, _e2778, (_e2778 > 0i)))];
let _e2784 = (_e2776 + 1i);
let _e2786 = select(_e2748, _e2784, (_e2784 < _e2748));
let _e2791 = global_3.member[bitcast<u32>(select(0i, _e2786, (_e2786 > 0i)))];
let _e2792 = (_e2776 + 2i);
let _e2794 = select(_e2748, _e2792, (_e2792 < _e2748));
let _e2799 = global_3.member[bitcast<u32>(select(0i, _e2794, (_e2794 > 0i)))];
let _e2800 = local_2;
let _e2804 = (_e2741 + (3i * ((_e2736 * _e2800) + _e2710)));
let _e2806 = select(_e2748, _e2804, (_e2804 < _e2748));
let _e2811 = global_3.member[bitcast<u32>(select(0i, _e2806, (_e2806 > 0i)))];
let _e2812 = (_e2804 + 1i);
let _e2814 = select(_e2748, _e2812, (_e2812 < _e2748));
let _e2819 = global_3.member[bitcast<u32>(select(0i, _e2814, (_e2814 > 0i)))];
let _e2820 = (_e2804 + 2i);
let _e2822 = select(_e2748, _e2820, (_e2820 < _e2748));
let _e2827 = global_3.member[bitcast<u32>(select(0i, _e2822, (_e2822 > 0i)))];
let _e2828 = local_2;
let _e2832 = (_e2741 + (3i * ((_e2736 * _e2828) + _e2733)));
let _e2834 = select(_e2748, _e2832, (_e2832 < _e2748));
let _e2839 = global_3.member[bitcast<u32>(select(0i, _e2834, (_e2834 > 0i)))];
let _e2840 = (_e2832 + 1i);
let _e2842 = select(_e2748, _e2840, (_e2840 < _e2748));
let _e2847 = global_3.member[bitcast<u32>(select(0i, _e2842, (_e2842 > 0i)))];
let _e2848 = (_e2832 + 2i);
let _e2850 = select(_e2748, _e2848, (_e2848 < _e2748));
let _e2855 = global_3.member[bitcast<u32>(select(0i, _e2850, (_e2850 > 0i)))];
let _e2862 = (_e2755 + ((_e2783 - _e2755) * _e2727));
let _e2863 = (_e2763 + ((_e2791 - _e2763) * _e2727));
let _e2864 = (_e2771 + ((_e2799 - _e2771) * _e2727));
phi_4901_ = vec3<f32>(((_e2862 + (((_e2811 + ((_e2839 - _e2811) * _e2727)) - _e2862) * _e2729)) * _e2657), ((_e2863 + (((_e2819 + ((_e2847 - _e2819) * _e2727)) - _e2863) * _e2729)) * _e2657), ((_e2864 + (((_e2827 + ((_e2855 - _e2827) * _e2727)) - _e2864) * _e2729)) * _e2657));
} else {
phi_4901_ = vec3(_e2657);
}
let _e2889 = phi_4901_;
phi_4904_ = (_e2590 * _e2889);
} else {
phi_4904_ = _e2590;
}
let _e2892 = phi_4904_;
let _e2896 = (1f / sqrt(select(0f, _e2585, (_e2585 > 0f))));
phi_4917_ = type_26(vec3<f32>((_e2576 * _e2896), (_e2577 * _e2896), (_e2578 * _e2896)), _e2892);
}
let _e2903 = phi_4917_;
let _e2904 = (_e1567.member - _e2563);
let _e2905 = (_e1567.member_1 - _e2565);
let _e2906 = (_e1567.member_2 - _e2567);
let _e2907 = local_8.member_2;
let _e2912 = (((_e2904 * _e2904) + (_e2905 * _e2905)) + (_e2906 * _e2906));
let _e2916 = select(sqrt(select(0f, _e2912, (_e2912 > 0f))), 1e30f, _e2907);
let _e2919 = -(_e2903.member.x);
let _e2921 = -(_e2903.member.y);
let _e2923 = -(_e2903.member.z);
let _e2931 = (1f / select(_e2919, select(1e-12f, -1e-12f, (_e2919 < 0f)), (bitcast<f32>((bitcast<u32>(_e2919) & 2147483647u)) < 1e-12f)));
let _e2939 = (1f / select(_e2921, select(1e-12f, -1e-12f, (_e2921 < 0f)), (bitcast<f32>((bitcast<u32>(_e2921) & 2147483647u)) < 1e-12f)));
let _e2947 = (1f / select(_e2923, select(1e-12f, -1e-12f, (_e2923 < 0f)), (bitcast<f32>((bitcast<u32>(_e2923) & 2147483647u)) < 1e-12f)));
let _e2949 = ((_e1617.member - _e2563) * _e2931);
let _e2951 = ((_e1623.member - _e2563) * _e2931);
let _e2953 = ((_e1617.member_1 - _e2565) * _e2939);
let _e2955 = ((_e1623.member_1 - _e2565) * _e2939);
let _e2957 = ((_e1617.member_2 - _e2567) * _e2947);
let _e2959 = ((_e1623.member_2 - _e2567) * _e2947);
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
let _e2983 = select(_e2916, _e2979, (_e2979 < _e2916));
let _e2987 = (_e2553 - _e2531);
let _e2990 = ((select(_e2981, _e2983, (_e2983 > _e2981)) - _e2981) + select(0f, _e2987, (_e2987 > 0f)));
let _e2992 = -((_e1672.member * _e2990));
let _e2994 = select(-87f, _e2992, (_e2992 > -87f));
let _e2996 = select(88f, _e2994, (_e2994 < 88f));
let _e2998 = ((_e2996 * 1.442695f) + 0.5f);
let _e3000 = select(-127f, _e2998, (_e2998 > -127f));
let _e3002 = select(128f, _e3000, (_e3000 < 128f));
let _e3009 = select(0i, select(select(i32(_e3002), i32(-2147483648), (_e3002 < -2147483600f)), 2147483647i, (_e3002 > 2147483500f)), (_e3002 == _e3002));
let _e3013 = (_e3009 - select(0i, 1i, (_e3002 < f32(_e3009))));
let _e3014 = f32(_e3013);
let _e3018 = ((_e2996 - (_e3014 * 0.6933594f)) - (_e3014 * -2.1219444e-4f));
let _e3040 = -((_e1672.member_1 * _e2990));
let _e3042 = select(-87f, _e3040, (_e3040 > -87f));
let _e3044 = select(88f, _e3042, (_e3042 < 88f));
let _e3046 = ((_e3044 * 1.442695f) + 0.5f);
let _e3048 = select(-127f, _e3046, (_e3046 > -127f));
let _e3050 = select(128f, _e3048, (_e3048 < 128f));
let _e3057 = select(0i, select(select(i32(_e3050), i32(-2147483648), (_e3050 < -2147483600f)), 2147483647i, (_e3050 > 2147483500f)), (_e3050 == _e3050));
let _e3061 = (_e3057 - select(0i, 1i, (_e3050 < f32(_e3057))));
let _e3062 = f32(_e3061);
let _e3066 = ((_e3044 - (_e3062 * 0.6933594f)) - (_e3062 * -2.1219444e-4f));
let _e3088 = -((_e1672.member_2 * _e2990));
let _e3090 = select(-87f, _e3088, (_e3088 > -87f));
let _e3092 = select(88f, _e3090, (_e3090 < 88f));
let _e3094 = ((_e3092 * 1.442695f) + 0.5f);
let _e3096 = select(-127f, _e3094, (_e3094 > -127f));
let _e3098 = select(128f, _e3096, (_e3096 < 128f));
let _e3105 = select(0i, select(select(i32(_e3098), i32(-2147483648), (_e3098 < -2147483600f)), 2147483647i, (_e3098 > 2147483500f)), (_e3098 == _e3098));
let _e3109 = (_e3105 - select(0i, 1i, (_e3098 < f32(_e3105))));
let _e3110 = f32(_e3109);
let _e3114 = ((_e3092 - (_e3110 * 0.6933594f)) - (_e3110 * -2.1219444e-4f));
let _e3140 = -((((_e2903.member.x * _e2530.x) + (_e2903.member.y * _e2530.y)) + (_e2903.member.z * _e2530.z)));
let _e3142 = (_e1830 - (_e1831 * _e3140));
let _e3144 = select(1e-9f, _e3142, (_e3142 > 1e-9f));
let _e3156 = ((3.1415927f * (select((_e1836 / (_e3144 * sqrt(select(0f, _e3144, (_e3144 > 0f))))), (0.75f * (1f + (_e3140 * _e3140))), _e1848) * _e1850)) * select((_e2546 * ((2f * (1f + _e2536)) / (_e2539 * _e2539))), 1f, _e2554));
let _e3170 = local_5;
let _e3171 = local_6;
let _e3172 = local_7;
let _e3173 = local_10;
let _e3174 = local_9;
let _e3176 = (_e3173 + (_e3174 * 0.33998105f));
let _e3177 = (_e3176 * _e3176);
let _e3178 = (1f - _e3177);
let _e3180 = select(1e-9f, _e3178, (_e3178 > 1e-9f));
let _e3181 = local_8.member;
let _e3182 = local_8.member_1;
let _e3187 = local_8.member_1;
let _e3193 = local_8.member_2;
let _e3194 = select((_e3181 + (_e3182 * ((2f * _e3176) / _e3180))), _e3176, _e3193);
let _e3195 = local_8.member_2;
let _e3204 = (_e3170.x + (_e3171.x * _e3194));
let _e3206 = (_e3170.y + (_e3171.y * _e3194));
let _e3208 = (_e3170.z + (_e3171.z * _e3194));
if _e1222 {
let _e3211 = global_1.member.member_10.member_1;
phi_5927_ = type_26(vec3<f32>(_e3211.member, _e3211.member_1, _e3211.member_2), _e1218);
} else {
let _e3217 = (_e3204 - _e1567.member);
let _e3218 = (_e3206 - _e1567.member_1);
let _e3219 = (_e3208 - _e1567.member_2);
let _e3224 = (((_e3217 * _e3217) + (_e3218 * _e3218)) + (_e3219 * _e3219));
let _e3226 = select(1e-12f, _e3224, (_e3224 > 1e-12f));
let _e3227 = (1f / _e3226);
let _e3231 = vec3<f32>((_e1214.member * _e3227), (_e1214.member_1 * _e3227), (_e1214.member_2 * _e3227));
if (_e1221 == 2u) {
let _e3235 = global_1.member.member_10.member_1;
let _e3243 = (((_e3235.member * _e3217) + (_e3235.member_1 * _e3218)) + (_e3235.member_2 * _e3219));
let _e3246 = (1f / select(1e-20f, _e3243, (_e3243 > 1e-20f)));
let _e3250 = global_1.member.member_10.member_4.member;
let _e3259 = ((((_e3250.member * _e3217) + (_e3250.member_1 * _e3218)) + (_e3250.member_2 * _e3219)) * _e3246);
let _e3263 = global_1.member.member_10.member_4.member_1;
let _e3272 = ((((_e3263.member * _e3217) + (_e3263.member_1 * _e3218)) + (_e3263.member_2 * _e3219)) * _e3246);
let _e3276 = global_1.member.member_10.member_4.member_2;
let _e3279 = ((_e3259 * _e3259) + (_e3272 * _e3272));
let _e3287 = global_1.member.member_10.member_4.member_3;
let _e3288 = ((_e3276 - sqrt(select(0f, _e3279, (_e3279 > 0f)))) * _e3287);
let _e3290 = select(0f, _e3288, (_e3288 > 0f));
let _e3292 = select(1f, _e3290, (_e3290 < 1f));
let _e3298 = select(0f, ((_e3292 * _e3292) * (3f - (2f * _e3292))), (_e3243 > 0f));
let _e3302 = global_1.member.member_10.member_4.member_5;
if ((_e3302 > 0u) && (_e3298 > 0f)) {
let _e3306 = (0.5f / _e3276);
let _e3315 = global_1.member.member_10.member_4.member_6;
let _e3316 = bitcast<i32>(_e3315);
local_1 = bitcast<i32>(_e3302);
let _e3317 = local_1;
let _e3319 = f32((_e3317 - 1i));
let _e3321 = f32((_e3316 - 1i));
let _e3322 = local_1;
let _e3325 = (((0.5f + (_e3259 * _e3306)) * f32(_e3322)) - 0.5f);
let _e3327 = select(0f, _e3325, (_e3325 > 0f));
let _e3329 = select(_e3319, _e3327, (_e3327 < _e3319));
let _e3332 = (((0.5f - (_e3272 * _e3306)) * f32(_e3316)) - 0.5f);
let _e3334 = select(0f, _e3332, (_e3332 > 0f));
let _e3336 = select(_e3321, _e3334, (_e3334 < _e3321));
let _e3338 = select(0f, _e3329, (_e3329 > 0f));
let _e3340 = select(_e3319, _e3338, (_e3338 < _e3319));
let _e3347 = select(0i, select(select(i32(_e3340), i32(-2147483648), (_e3340 < -2147483600f)), 2147483647i, (_e3340 > 2147483500f)), (_e3340 == _e3340));
let _e3351 = (_e3347 - select(0i, 1i, (_e3340 < f32(_e3347))));
let _e3353 = select(0f, _e3336, (_e3336 > 0f));
let _e3355 = select(_e3321, _e3353, (_e3353 < _e3321));
let _e3362 = select(0i, select(select(i32(_e3355), i32(-2147483648), (_e3355 < -2147483600f)), 2147483647i, (_e3355 > 2147483500f)), (_e3355 == _e3355));
let _e3366 = (_e3362 - select(0i, 1i, (_e3355 < f32(_e3362))));
let _e3368 = (_e3329 - f32(_e3351));
let _e3370 = (_e3336 - f32(_e3366));
let _e3371 = (_e3351 + 1i);
let _e3372 = local_1;
let _e3374 = select(_e3351, _e3371, (_e3371 < _e3372));
let _e3375 = (_e3366 + 1i);
let _e3377 = select(_e3366, _e3375, (_e3375 < _e3316));
let _e3381 = global_1.member.member_10.member_4.member_4;
let _e3382 = bitcast<i32>(_e3381);
let _e3383 = local_1;
let _e3387 = (_e3382 + (3i * ((_e3366 * _e3383) + _e3351)));
let _e3389 = (bitcast<i32>(_e146) - 1i);
let _e3391 = select(_e3389, _e3387, (_e3387 < _e3389));
let _e3396 = global_3.member[bitcast<u32>(select(0i, _e3391, (_e3391 > 0i)))];
let _e3397 = (_e3387 + 1i);
let _e3399 = select(_e3389, _e3397, (_e3397 < _e3389));
let _e3404 = global_3.member[bitcast<u32>(select(0i, _e3399, (_e3399 > 0i)))];
let _e3405 = (_e3387 + 2i);
let _e3407 = select(_e3389, _e3405, (_e3405 < _e3389));
let _e3412 = global_3.member[bitcast<u32>(select(0i, _e3407, (_e3407 > 0i)))];
let _e3413 = local_1;
let _e3417 = (_e3382 + (3i * ((_e3366 * _e3413) + _e3374)));
let _e3419 = select(_e3389, _e3417, (_e3417 < _e3389));
let _e3424 = global_3.member[bitcast<u32>(select(0i, _e3419, (_e3419 > 0i)))];
let _e3425 = (_e3417 + 1i);
let _e3427 = select(_e3389, _e3425, (_e3425 < _e3389));
let _e3432 = global_3.member[bitcast<u32>(select(0i, _e3427, (_e3427 > 0i)))];
let _e3433 = (_e3417 + 2i);
let _e3435 = select(_e3389, _e3433, (_e3433 < _e3389));
let _e3440 = global_3.member[bitcast<u32>(select(0i, _e3435, (_e3435 > 0i)))];
let _e3441 = local_1;
let _e3445 = (_e3382 + (3i * ((_e3377 * _e3441) + _e3351)));
let _e3447 = select(_e3389, _e3445, (_e3445 < _e3389));
let _e3452 = global_3.member[bitcast<u32>(select(0i, _e3447, (_e3447 > 0i)))];
let _e3453 = (_e3445 + 1i);
let _e3455 = select(_e3389, _e3453, (_e3453 < _e3389));
let _e3460 = global_3.member[bitcast<u32>(select(0i, _e3455, (_e3455 > 0i)))];
let _e3461 = (_e3445 + 2i);
let _e3463 = select(_e3389, _e3461, (_e3461 < _e3389));
let _e3468 = global_3.member[bitcast<u32>(select(0i, _e3463, (_e3463 > 0i)))];
let _e3469 = local_1;
let _e3473 = (_e3382 + (3i * ((_e3377 * _e3469) + _e3374)));
let _e3475 = select(_e3389, _e3473, (_e3473 < _e3389));
let _e3480 = global_3.member[bitcast<u32>(select(0i, _e3475, (_e3475 > 0i)))];
let _e3481 = (_e3473 + 1i);
let _e3483 = select(_e3389, _e3481, (_e3481 < _e3389));
let _e3488 = global_3.member[bitcast<u32>(select(0i, _e3483, (_e3483 > 0i)))];
let _e3489 = (_e3473 + 2i);
let _e3491 = select(_e3389, _e3489, (_e3489 < _e3389));
let _e3496 = global_3.member[bitcast<u32>(select(0i, _e3491, (_e3491 > 0i)))];
let _e3503 = (_e3396 + ((_e3424 - _e3396) * _e3368));
let _e3504 = (_e3404 + ((_e3432 - _e3404) * _e3368));
let _e3505 = (_e3412 + ((_e3440 - _e3412) * _e3368));
phi_5911_ = vec3<f32>(((_e3503 + (((_e3452 + ((_e3480 - _e3452) * _e3368)) - _e3503) * _e3370)) * _e3298), ((_e3504 + (((_e3460 + ((_e3488 - _e3460) * _e3368)) - _e3504) * _e3370)) * _e3298), ((_e3505 + (((_e3468 + ((_e3496 - _e3468) * _e3368)) - _e3505) * _e3370)) * _e3298));
} else {
phi_5911_ = vec3(_e3298);
}
let _e3530 = phi_5911_;
phi_5914_ = (_e3231 * _e3530);
} else {
phi_5914_ = _e3231;
}
let _e3533 = phi_5914_;
let _e3537 = (1f / sqrt(select(0f, _e3226, (_e3226 > 0f))));
phi_5927_ = type_26(vec3<f32>((_e3217 * _e3537), (_e3218 * _e3537), (_e3219 * _e3537)), _e3533);
}
let _e3544 = phi_5927_;
let _e3545 = (_e1567.member - _e3204);
let _e3546 = (_e1567.member_1 - _e3206);
let _e3547 = (_e1567.member_2 - _e3208);
let _e3548 = local_8.member_2;
let _e3553 = (((_e3545 * _e3545) + (_e3546 * _e3546)) + (_e3547 * _e3547));
let _e3557 = select(sqrt(select(0f, _e3553, (_e3553 > 0f))), 1e30f, _e3548);
let _e3560 = -(_e3544.member.x);
let _e3562 = -(_e3544.member.y);
let _e3564 = -(_e3544.member.z);
let _e3572 = (1f / select(_e3560, select(1e-12f, -1e-12f, (_e3560 < 0f)), (bitcast<f32>((bitcast<u32>(_e3560) & 2147483647u)) < 1e-12f)));
let _e3580 = (1f / select(_e3562, select(1e-12f, -1e-12f, (_e3562 < 0f)), (bitcast<f32>((bitcast<u32>(_e3562) & 2147483647u)) < 1e-12f)));
let _e3588 = (1f / select(_e3564, select(1e-12f, -1e-12f, (_e3564 < 0f)), (bitcast<f32>((bitcast<u32>(_e3564) & 2147483647u)) < 1e-12f)));
let _e3590 = ((_e1617.member - _e3204) * _e3572);
let _e3592 = ((_e1623.member - _e3204) * _e3572);
let _e3594 = ((_e1617.member_1 - _e3206) * _e3580);
let _e3596 = ((_e1623.member_1 - _e3206) * _e3580);
let _e3598 = ((_e1617.member_2 - _e3208) * _e3588);
let _e3600 = ((_e1623.member_2 - _e3208) * _e3588);
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
let _e3624 = select(_e3557, _e3620, (_e3620 < _e3557));
let _e3628 = (_e3194 - _e3172);
let _e3631 = ((select(_e3622, _e3624, (_e3624 > _e3622)) - _e3622) + select(0f, _e3628, (_e3628 > 0f)));
let _e3633 = -((_e1672.member * _e3631));
let _e3635 = select(-87f, _e3633, (_e3633 > -87f));
let _e3637 = select(88f, _e3635, (_e3635 < 88f));
let _e3639 = ((_e3637 * 1.442695f) + 0.5f);
let _e3641 = select(-127f, _e3639, (_e3639 > -127f));
let _e3643 = select(128f, _e3641, (_e3641 < 128f));
let _e3650 = select(0i, select(select(i32(_e3643), i32(-2147483648), (_e3643 < -2147483600f)), 2147483647i, (_e3643 > 2147483500f)), (_e3643 == _e3643));
let _e3654 = (_e3650 - select(0i, 1i, (_e3643 < f32(_e3650))));
let _e3655 = f32(_e3654);
let _e3659 = ((_e3637 - (_e3655 * 0.6933594f)) - (_e3655 * -2.1219444e-4f));
let _e3681 = -((_e1672.member_1 * _e3631));
let _e3683 = select(-87f, _e3681, (_e3681 > -87f));
let _e3685 = select(88f, _e3683, (_e3683 < 88f));
let _e3687 = ((_e3685 * 1.442695f) + 0.5f);
let _e3689 = select(-127f, _e3687, (_e3687 > -127f));
let _e3691 = select(128f, _e3689, (_e3689 < 128f));
let _e3698 = select(0i, select(select(i32(_e3691), i32(-2147483648), (_e3691 < -2147483600f)), 2147483647i, (_e3691 > 2147483500f)), (_e3691 == _e3691));
let _e3702 = (_e3698 - select(0i, 1i, (_e3691 < f32(_e3698))));
let _e3703 = f32(_e3702);
let _e3707 = ((_e3685 - (_e3703 * 0.6933594f)) - (_e3703 * -2.1219444e-4f));
let _e3729 = -((_e1672.member_2 * _e3631));
let _e3731 = select(-87f, _e3729, (_e3729 > -87f));
let _e3733 = select(88f, _e3731, (_e3731 < 88f));
let _e3735 = ((_e3733 * 1.442695f) + 0.5f);
let _e3737 = select(-127f, _e3735, (_e3735 > -127f));
let _e3739 = select(128f, _e3737, (_e3737 < 128f));
let _e3746 = select(0i, select(select(i32(_e3739), i32(-2147483648), (_e3739 < -2147483600f)), 2147483647i, (_e3739 > 2147483500f)), (_e3739 == _e3739));
let _e3750 = (_e3746 - select(0i, 1i, (_e3739 < f32(_e3746))));
let _e3751 = f32(_e3750);
let _e3755 = ((_e3733 - (_e3751 * 0.6933594f)) - (_e3751 * -2.1219444e-4f));
let _e3781 = -((((_e3544.member.x * _e3171.x) + (_e3544.member.y * _e3171.y)) + (_e3544.member.z * _e3171.z)));
let _e3783 = (_e1830 - (_e1831 * _e3781));
let _e3785 = select(1e-9f, _e3783, (_e3783 > 1e-9f));
let _e3797 = ((3.1415927f * (select((_e1836 / (_e3785 * sqrt(select(0f, _e3785, (_e3785 > 0f))))), (0.75f * (1f + (_e3781 * _e3781))), _e1848) * _e1850)) * select((_e3187 * ((2f * (1f + _e3177)) / (_e3180 * _e3180))), 1f, _e3195));
let _e3814 = local_9;
let _e3815 = (_e3814 * 0.65214515f);
phi_2278_ = vec3<f32>(((_e1162.x + (((((_e1564.member_1.x * ((1f + (_e1703 * (1f + (_e1703 * (0.5f + (_e1703 * (0.16666667f + (_e1703 * (0.041666668f + (_e1703 * (0.008333334f + (_e1703 * (0.001388889f + (_e1703 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1698 + 127i)) << bitcast<u32>(23i))))) * _e1863.member) * _e1853) + (((_e2247.member_1.x * ((1f + (_e2362 * (1f + (_e2362 * (0.5f + (_e2362 * (0.16666667f + (_e2362 * (0.041666668f + (_e2362 * (0.008333334f + (_e2362 * (0.001388889f + (_e2362 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2357 + 127i)) << bitcast<u32>(23i))))) * _e1863.member) * _e2500)) * _e2518)) + (((((_e2903.member_1.x * ((1f + (_e3018 * (1f + (_e3018 * (0.5f + (_e3018 * (0.16666667f + (_e3018 * (0.041666668f + (_e3018 * (0.008333334f + (_e3018 * (0.001388889f + (_e3018 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3013 + 127i)) << bitcast<u32>(23i))))) * _e1863.member) * _e3156) + (((_e3544.member_1.x * ((1f + (_e3659 * (1f + (_e3659 * (0.5f + (_e3659 * (0.16666667f + (_e3659 * (0.041666668f + (_e3659 * (0.008333334f + (_e3659 * (0.001388889f + (_e3659 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3654 + 127i)) << bitcast<u32>(23i))))) * _e1863.member) * _e3797)) * _e3815)), ((_e1162.y + (((((_e1564.member_1.y * ((1f + (_e1751 * (1f + (_e1751 * (0.5f + (_e1751 * (0.16666667f + (_e1751 * (0.041666668f + (_e1751 * (0.008333334f + (_e1751 * (0.001388889f + (_e1751 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1746 + 127i)) << bitcast<u32>(23i))))) * _e1863.member_1) * _e1853) + (((_e2247.member_1.y * ((1f + (_e2410 * (1f + (_e2410 * (0.5f + (_e2410 * (0.16666667f + (_e2410 * (0.041666668f + (_e2410 * (0.008333334f + (_e2410 * (0.001388889f + (_e2410 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2405 + 127i)) << bitcast<u32>(23i))))) * _e1863.member_1) * _e2500)) * _e2518)) + (((((_e2903.member_1.y * ((1f + (_e3066 * (1f + (_e3066 * (0.5f + (_e3066 * (0.16666667f + (_e3066 * (0.041666668f + (_e3066 * (0.008333334f + (_e3066 * (0.001388889f + (_e3066 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3061 + 127i)) << bitcast<u32>(23i))))) * _e1863.member_1) * _e3156) + (((_e3544.member_1.y * ((1f + (_e3707 * (1f + (_e3707 * (0.5f + (_e3707 * (0.16666667f + (_e3707 * (0.041666668f + (_e3707 * (0.008333334f + (_e3707 * (0.001388889f + (_e3707 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3702 + 127i)) << bitcast<u32>(23i))))) * _e1863.member_1) * _e3797)) * _e3815)), ((_e1162.z + (((((_e1564.member_1.z * ((1f + (_e1799 * (1f + (_e1799 * (0.5f + (_e1799 * (0.16666667f + (_e1799 * (0.041666668f + (_e1799 * (0.008333334f + (_e1799 * (0.001388889f + (_e1799 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1794 + 127i)) << bitcast<u32>(23i))))) * _e1863.member_2) * _e1853) + (((_e2247.member_1.z * ((1f + (_e2458 * (1f + (_e2458 * (0.5f + (_e2458 * (0.16666667f + (_e2458 * (0.041666668f + (_e2458 * (0.008333334f + (_e2458 * (0.001388889f + (_e2458 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2453 + 127i)) << bitcast<u32>(23i))))) * _e1863.member_2) * _e2500)) * _e2518)) + (((((_e2903.member_1.z * ((1f + (_e3114 * (1f + (_e3114 * (0.5f + (_e3114 * (0.16666667f + (_e3114 * (0.041666668f + (_e3114 * (0.008333334f + (_e3114 * (0.001388889f + (_e3114 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3109 + 127i)) << bitcast<u32>(23i))))) * _e1863.member_2) * _e3156) + (((_e3544.member_1.z * ((1f + (_e3755 * (1f + (_e3755 * (0.5f + (_e3755 * (0.16666667f + (_e3755 * (0.041666668f + (_e3755 * (0.008333334f + (_e3755 * (0.001388889f + (_e3755 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3750 + 127i)) << bitcast<u32>(23i))))) * _e1863.member_2) * _e3797)) * _e3815)));
phi_2280_ = (_e1164 + 1i);
} else {
phi_2278_ = vec3<f32>();
phi_2280_ = i32();
}
let _e3825 = phi_2278_;
let _e3827 = phi_2280_;
continue;
continuing {
phi_2277_ = _e3825;
phi_2279_ = _e3827;
break if !(_e1165);
}
}
let _e6389 = local_45;
phi_6373_ = _e6389;
} else {
phi_6373_ = vec3<f32>(0f, 0f, 0f);
}
let _e3830 = phi_6373_;
phi_6388_ = type_24(_e426.member, _e426.member_1, _e426.member_2, vec3<f32>((_e233 + (_e3830.x * _e723)), (_e244 + (_e3830.y * _e724)), (_e255 + (_e3830.z * _e725))), _e426.member_4, _e426.member_5, _e426.member_6, _e426.member_7);
} else {
phi_6388_ = _e426;
}
let _e3850 = phi_6388_;
let _e3851 = (_e628 == -1i);
let _e3852 = select(_e722, 0f, _e3851);
let _e3856 = (_e718 + (_e466 * _e3852));
let _e3857 = (_e719 + (_e477 * _e3852));
let _e3858 = (_e720 + (_e488 * _e3852));
let _e3859 = vec3<f32>(_e3856, _e3857, _e3858);
let _e3862 = (_e628 >= 0i);
if _e3862 {
let _e3863 = (_e628 * 19i);
let _e3865 = (bitcast<i32>(_e148) - 1i);
let _e3867 = select(_e3865, _e3863, (_e3863 < _e3865));
let _e3873 = global_4.member[bitcast<u32>(select(0i, _e3867, (_e3867 > 0i)))];
let _e3874 = (_e3863 + 1i);
let _e3876 = select(_e3865, _e3874, (_e3874 < _e3865));
let _e3882 = global_4.member[bitcast<u32>(select(0i, _e3876, (_e3876 > 0i)))];
let _e3883 = (_e3863 + 2i);
let _e3885 = select(_e3865, _e3883, (_e3883 < _e3865));
let _e3891 = global_4.member[bitcast<u32>(select(0i, _e3885, (_e3885 > 0i)))];
let _e3892 = (_e3863 + 3i);
let _e3894 = select(_e3865, _e3892, (_e3892 < _e3865));
let _e3900 = global_4.member[bitcast<u32>(select(0i, _e3894, (_e3894 > 0i)))];
let _e3901 = (_e3863 + 4i);
let _e3903 = select(_e3865, _e3901, (_e3901 < _e3865));
let _e3909 = global_4.member[bitcast<u32>(select(0i, _e3903, (_e3903 > 0i)))];
let _e3910 = (_e3863 + 5i);
let _e3912 = select(_e3865, _e3910, (_e3910 < _e3865));
let _e3918 = global_4.member[bitcast<u32>(select(0i, _e3912, (_e3912 > 0i)))];
let _e3919 = (_e3863 + 6i);
let _e3921 = select(_e3865, _e3919, (_e3919 < _e3865));
let _e3927 = global_4.member[bitcast<u32>(select(0i, _e3921, (_e3921 > 0i)))];
let _e3928 = (_e3863 + 7i);
let _e3930 = select(_e3865, _e3928, (_e3928 < _e3865));
let _e3936 = global_4.member[bitcast<u32>(select(0i, _e3930, (_e3930 > 0i)))];
let _e3937 = (_e3863 + 8i);
let _e3939 = select(_e3865, _e3937, (_e3937 < _e3865));
let _e3945 = global_4.member[bitcast<u32>(select(0i, _e3939, (_e3939 > 0i)))];
let _e3946 = (_e3900 - _e3873);
let _e3947 = (_e3909 - _e3882);
let _e3948 = (_e3918 - _e3891);
let _e3949 = (_e3927 - _e3873);
let _e3950 = (_e3936 - _e3882);
let _e3951 = (_e3945 - _e3891);
let _e3954 = ((_e3947 * _e3951) - (_e3948 * _e3950));
let _e3957 = ((_e3948 * _e3949) - (_e3946 * _e3951));
let _e3960 = ((_e3946 * _e3950) - (_e3947 * _e3949));
let _e3961 = (_e3900 - _e3856);
let _e3962 = (_e3909 - _e3857);
let _e3963 = (_e3918 - _e3858);
let _e3964 = (_e3927 - _e3856);
let _e3965 = (_e3936 - _e3857);
let _e3966 = (_e3945 - _e3858);
let _e3980 = (((((_e3962 * _e3966) - (_e3963 * _e3965)) * _e3954) + (((_e3963 * _e3964) - (_e3961 * _e3966)) * _e3957)) + (((_e3961 * _e3965) - (_e3962 * _e3964)) * _e3960));
let _e3982 = select(0f, _e3980, (_e3980 > 0f));
let _e3983 = (_e3873 - _e3856);
let _e3984 = (_e3882 - _e3857);
let _e3985 = (_e3891 - _e3858);
let _e3999 = (((((_e3965 * _e3985) - (_e3966 * _e3984)) * _e3954) + (((_e3966 * _e3983) - (_e3964 * _e3985)) * _e3957)) + (((_e3964 * _e3984) - (_e3965 * _e3983)) * _e3960));
let _e4001 = select(0f, _e3999, (_e3999 > 0f));
let _e4015 = (((((_e3984 * _e3963) - (_e3985 * _e3962)) * _e3954) + (((_e3985 * _e3961) - (_e3983 * _e3963)) * _e3957)) + (((_e3983 * _e3962) - (_e3984 * _e3961)) * _e3960));
let _e4017 = select(0f, _e4015, (_e4015 > 0f));
let _e4019 = ((_e3982 + _e4001) + _e4017);
let _e4021 = select(1e-30f, _e4019, (_e4019 > 1e-30f));
let _e4022 = (_e3982 / _e4021);
let _e4023 = (_e4001 / _e4021);
let _e4024 = (_e4017 / _e4021);
let _e4029 = (((_e3954 * _e3954) + (_e3957 * _e3957)) + (_e3960 * _e3960));
let _e4032 = sqrt(select(0f, _e4029, (_e4029 > 0f)));
let _e4035 = (1f / select(1e-20f, _e4032, (_e4032 > 1e-20f)));
let _e4040 = (_e3863 + 9i);
let _e4042 = select(_e3865, _e4040, (_e4040 < _e3865));
let _e4048 = global_4.member[bitcast<u32>(select(0i, _e4042, (_e4042 > 0i)))];
let _e4049 = (_e3863 + 10i);
let _e4051 = select(_e3865, _e4049, (_e4049 < _e3865));
let _e4057 = global_4.member[bitcast<u32>(select(0i, _e4051, (_e4051 > 0i)))];
let _e4058 = (_e3863 + 11i);
let _e4060 = select(_e3865, _e4058, (_e4058 < _e3865));
let _e4066 = global_4.member[bitcast<u32>(select(0i, _e4060, (_e4060 > 0i)))];
let _e4070 = (_e3863 + 12i);
let _e4072 = select(_e3865, _e4070, (_e4070 < _e3865));
let _e4078 = global_4.member[bitcast<u32>(select(0i, _e4072, (_e4072 > 0i)))];
let _e4079 = (_e3863 + 13i);
let _e4081 = select(_e3865, _e4079, (_e4079 < _e3865));
let _e4087 = global_4.member[bitcast<u32>(select(0i, _e4081, (_e4081 > 0i)))];
let _e4088 = (_e3863 + 14i);
let _e4090 = select(_e3865, _e4088, (_e4088 < _e3865));
let _e4096 = global_4.member[bitcast<u32>(select(0i, _e4090, (_e4090 > 0i)))];
let _e4103 = (_e3863 + 15i);
let _e4105 = select(_e3865, _e4103, (_e4103 < _e3865));
let _e4111 = global_4.member[bitcast<u32>(select(0i, _e4105, (_e4105 > 0i)))];
let _e4112 = (_e3863 + 16i);
let _e4114 = select(_e3865, _e4112, (_e4112 < _e3865));
let _e4120 = global_4.member[bitcast<u32>(select(0i, _e4114, (_e4114 > 0i)))];
let _e4121 = (_e3863 + 17i);
let _e4123 = select(_e3865, _e4121, (_e4121 < _e3865));
let _e4129 = global_4.member[bitcast<u32>(select(0i, _e4123, (_e4123 > 0i)))];
let _e4133 = (((_e4048 * _e4022) + (_e4078 * _e4023)) + (_e4111 * _e4024));
let _e4134 = (((_e4057 * _e4022) + (_e4087 * _e4023)) + (_e4120 * _e4024));
let _e4135 = (((_e4066 * _e4022) + (_e4096 * _e4023)) + (_e4129 * _e4024));
let _e4140 = (((_e4133 * _e4133) + (_e4134 * _e4134)) + (_e4135 * _e4135));
let _e4143 = sqrt(select(0f, _e4140, (_e4140 > 0f)));
let _e4146 = (1f / select(1e-20f, _e4143, (_e4143 > 1e-20f)));
let _e4151 = (_e3863 + 18i);
let _e4153 = select(_e3865, _e4151, (_e4151 < _e3865));
let _e4159 = global_4.member[bitcast<u32>(select(0i, _e4153, (_e4153 > 0i)))];
let _e4168 = (select(select(0i, select(select(i32(_e4159), i32(-2147483648), (_e4159 < -2147483600f)), 2147483647i, (_e4159 > 2147483500f)), (_e4159 == _e4159)), _e628, ((_e956 & 1u) != 0u)) * 10i);
let _e4170 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e4172 = select(_e4170, _e4168, (_e4168 < _e4170));
let _e4178 = global_5.member[bitcast<u32>(select(0i, _e4172, (_e4172 > 0i)))];
let _e4179 = (_e4168 + 1i);
let _e4181 = select(_e4170, _e4179, (_e4179 < _e4170));
let _e4187 = global_5.member[bitcast<u32>(select(0i, _e4181, (_e4181 > 0i)))];
let _e4188 = (_e4168 + 2i);
let _e4190 = select(_e4170, _e4188, (_e4188 < _e4170));
let _e4196 = global_5.member[bitcast<u32>(select(0i, _e4190, (_e4190 > 0i)))];
let _e4200 = (_e4168 + 3i);
let _e4202 = select(_e4170, _e4200, (_e4200 < _e4170));
let _e4208 = global_5.member[bitcast<u32>(select(0i, _e4202, (_e4202 > 0i)))];
let _e4209 = (_e4168 + 4i);
let _e4211 = select(_e4170, _e4209, (_e4209 < _e4170));
let _e4217 = global_5.member[bitcast<u32>(select(0i, _e4211, (_e4211 > 0i)))];
let _e4218 = (_e4168 + 5i);
let _e4220 = select(_e4170, _e4218, (_e4218 < _e4170));
let _e4226 = global_5.member[bitcast<u32>(select(0i, _e4220, (_e4220 > 0i)))];
let _e4233 = (_e4168 + 6i);
let _e4235 = select(_e4170, _e4233, (_e4233 < _e4170));
let _e4241 = global_5.member[bitcast<u32>(select(0i, _e4235, (_e4235 > 0i)))];
let _e4242 = (_e4168 + 7i);
let _e4244 = select(_e4170, _e4242, (_e4242 < _e4170));
let _e4250 = global_5.member[bitcast<u32>(select(0i, _e4244, (_e4244 > 0i)))];
let _e4251 = (_e4168 + 8i);
let _e4253 = select(_e4170, _e4251, (_e4251 < _e4170));
let _e4259 = global_5.member[bitcast<u32>(select(0i, _e4253, (_e4253 > 0i)))];
let _e4267 = (_e4168 + 9i);
let _e4269 = select(_e4170, _e4267, (_e4267 < _e4170));
let _e4275 = global_5.member[bitcast<u32>(select(0i, _e4269, (_e4269 > 0i)))];
phi_7123_ = type_25(_e3859, vec3<f32>((_e3954 * _e4035), (_e3957 * _e4035), (_e3960 * _e4035)), vec3<f32>((_e4133 * _e4146), (_e4134 * _e4146), (_e4135 * _e4146)), vec3<f32>((((_e4178 * _e4022) + (_e4208 * _e4023)) + (_e4241 * _e4024)), (((_e4187 * _e4022) + (_e4217 * _e4023)) + (_e4250 * _e4024)), (((_e4196 * _e4022) + (_e4226 * _e4023)) + (_e4259 * _e4024))), _e4275, true);
} else {
let _e4277 = (_e628 == -3i);
let _e4283 = global_1.member.member_14.member_1.member.member;
let _e4288 = global_1.member.member_14.member_1.member_1;
let _e4294 = global_1.member.member_14.member.member.member;
let _e4299 = global_1.member.member_14.member.member_1;
let _e4309 = vec3<f32>(select(_e4294.member, _e4283.member, _e4277), select(_e4294.member_1, _e4283.member_1, _e4277), select(_e4294.member_2, _e4283.member_2, _e4277));
phi_7123_ = type_25(_e3859, _e4309, _e4309, vec3<f32>(select(_e4299.member, _e4288.member, _e4277), select(_e4299.member_1, _e4288.member_1, _e4277), select(_e4299.member_2, _e4288.member_2, _e4277)), 0f, false);
}
let _e4322 = phi_7123_;
let _e4325 = ((select(0i, _e628, _e3862) * 19i) + 18i);
let _e4327 = (bitcast<i32>(_e148) - 1i);
let _e4329 = select(_e4327, _e4325, (_e4325 < _e4327));
let _e4335 = global_4.member[bitcast<u32>(select(0i, _e4329, (_e4329 > 0i)))];
let _e4342 = select(0i, select(select(i32(_e4335), i32(-2147483648), (_e4335 < -2147483600f)), 2147483647i, (_e4335 > 2147483500f)), (_e4335 == _e4335));
let _e4343 = (_e4342 * 4i);
let _e4345 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e4347 = select(_e4345, _e4343, (_e4343 < _e4345));
let _e4353 = global_7.member[bitcast<u32>(select(0i, _e4347, (_e4347 > 0i)))];
if _e3862 {
phi_7187_ = (select(_e4353, 1f, (_e4342 == 16i)) == 0f);
} else {
phi_7187_ = (_e628 != -1i);
}
let _e4359 = phi_7187_;
if _e636 {
let _e4368 = type_24(select(_e722, 1e30f, _e3851), _e3850.member_1, _e3850.member_2, _e3850.member_3, _e3850.member_4, _e3850.member_5, _e3850.member_6, _e3850.member_7);
let _e4378 = type_24(_e4368.member, select(_e722, _e797, (_e797 < _e722)), _e4368.member_2, _e4368.member_3, _e4368.member_4, _e4368.member_5, _e4368.member_6, _e4368.member_7);
let _e4389 = select(1f, -1f, ((((_e4322.member_1.x * _e466) + (_e4322.member_1.y * _e477)) + (_e4322.member_1.z * _e488)) > 0f));
let _e4401 = select(_e4389, -(_e4389), ((((_e4322.member_2.x * _e4322.member_1.x) + (_e4322.member_2.y * _e4322.member_1.y)) + (_e4322.member_2.z * _e4322.member_1.z)) < 0f));
let _e4402 = (_e4322.member_2.x * _e4401);
let _e4403 = (_e4322.member_2.y * _e4401);
let _e4404 = (_e4322.member_2.z * _e4401);
let _e4413 = ((((_e4402 * _e466) + (_e4403 * _e477)) + (_e4404 * _e488)) > 0f);
let _e4428 = type_24(_e4378.member, _e4378.member_1, _e4378.member_2, _e4378.member_3, _e4378.member_4, _e4378.member_5, _e4378.member_6, vec3<f32>(select(select(_e4402, (_e4322.member_1.x * _e4389), _e4413), 0f, _e3851), select(select(_e4403, (_e4322.member_1.y * _e4389), _e4413), 0f, _e3851), select(select(_e4404, (_e4322.member_1.z * _e4389), _e4413), 0f, _e3851)));
let _e4432 = (1f - (((_e857 + _e905) + _e953) * _e961));
let _e4436 = global_1.member.member_15.member_12;
phi_7301_ = type_24(_e4428.member, _e4428.member_1, _e4428.member_2, _e4428.member_3, _e4428.member_4, _e4428.member_5, select(1f, select(_e4432, _e4436, (_e4436 > _e4432)), _e3851), _e4428.member_7);
} else {
phi_7301_ = _e3850;
}
let _e4449 = phi_7301_;
if _e3851 {
let _e4454 = (((_e499 * _e499) + (_e510 * _e510)) + (_e521 * _e521));
let _e4457 = sqrt(select(0f, _e4454, (_e4454 > 0f)));
let _e4462 = (((_e532 * _e532) + (_e543 * _e543)) + (_e554 * _e554));
let _e4465 = sqrt(select(0f, _e4462, (_e4462 > 0f)));
let _e4467 = select(_e4465, _e4457, (_e4457 > _e4465));
let _e4471 = global_1.member.member_15.member_4;
let _e4479 = (((_e4471.member * _e466) + (_e4471.member_1 * _e477)) + (_e4471.member_2 * _e488));
let _e4483 = global_1.member.member_15.member_5;
let _e4491 = (((_e4483.member * _e466) + (_e4483.member_1 * _e477)) + (_e4483.member_2 * _e488));
let _e4495 = global_1.member.member_15.member_6;
let _e4503 = (((_e4495.member * _e466) + (_e4495.member_1 * _e477)) + (_e4495.member_2 * _e488));
let _e4507 = global_1.member.member_15.member;
let _e4511 = global_1.member.member_15.member_7;
let _e4515 = vec3<f32>(_e4511.member, _e4511.member_1, _e4511.member_2);
let _e4519 = global_1.member.member_15.member_8;
if (_e4507 == 0u) {
phi_8790_ = _e4515;
} else {
if (_e4507 == 1u) {
let _e4526 = select(-1f, _e4503, (_e4503 > -1f));
let _e4528 = select(1f, _e4526, (_e4526 < 1f));
if (_e4528 > 0f) {
phi_7405_ = _e4515;
} else {
let _e4533 = global_1.member.member_15.member_9;
phi_7405_ = vec3<f32>(_e4533.member, _e4533.member_1, _e4533.member_2);
}
let _e4539 = phi_7405_;
let _e4548 = bitcast<f32>((bitcast<u32>(_e4528) & 2147483647u));
let _e4551 = sqrt(select(0f, _e4548, (_e4548 > 0f)));
phi_8789_ = vec3<f32>((_e4519.member + ((_e4539.x - _e4519.member) * _e4551)), (_e4519.member_1 + ((_e4539.y - _e4519.member_1) * _e4551)), (_e4519.member_2 + ((_e4539.z - _e4519.member_2) * _e4551)));
} else {
if (_e4507 == 2u) {
let _e4563 = global_1.member.member_15.member_10;
let _e4564 = (_e4467 / _e4563);
let _e4566 = select(1e-4f, _e4564, (_e4564 > 1e-4f));
let _e4569 = bitcast<f32>((bitcast<u32>(_e4479) & 2147483647u));
let _e4572 = bitcast<f32>((bitcast<u32>(_e4491) & 2147483647u));
let _e4576 = select(_e4572, _e4569, (_e4569 > _e4572));
let _e4579 = (select(_e4572, _e4569, (_e4569 < _e4572)) / select(1.1754944e-38f, _e4576, (_e4576 > 1.1754944e-38f)));
let _e4580 = (_e4579 > 0.41421357f);
let _e4584 = select(_e4579, ((_e4579 - 1f) / (_e4579 + 1f)), _e4580);
let _e4585 = (_e4584 * _e4584);
let _e4600 = (select(0f, 0.7853982f, _e4580) + (_e4584 + ((_e4584 * _e4585) * (-0.33333334f + (_e4585 * (0.2f + (_e4585 * (-0.14285713f + (_e4585 * (0.11111111f + (_e4585 * (-0.09090909f + (_e4585 * 0.0585f)))))))))))));
let _e4603 = select(_e4600, (1.5707964f - _e4600), (_e4572 > _e4569));
let _e4606 = select(_e4603, (3.1415927f - _e4603), (_e4479 < 0f));
let _e4612 = (1f - (_e4503 * _e4503));
let _e4615 = sqrt(select(0f, _e4612, (_e4612 > 0f)));
let _e4618 = (_e4566 / select(1e-3f, _e4615, (_e4615 > 1e-3f)));
let _e4619 = ((select(_e4606, -(_e4606), (_e4491 < 0f)) / _e4563) * 0.5f);
let _e4621 = select(-8e6f, _e4619, (_e4619 > -8e6f));
let _e4623 = select(8e6f, _e4621, (_e4621 < 8e6f));
let _e4630 = select(0i, select(select(i32(_e4623), i32(-2147483648), (_e4623 < -2147483600f)), 2147483647i, (_e4623 > 2147483500f)), (_e4623 == _e4623));
let _e4637 = ((_e4619 - f32((_e4630 - select(0i, 1i, (_e4623 < f32(_e4630)))))) * 2f);
let _e4645 = ((select(select((_e4637 - 2f), (1f - _e4637), (_e4637 < 1.5f)), _e4637, (_e4637 < 0.5f)) * 2f) / _e4618);
let _e4647 = select(-1f, _e4645, (_e4645 > -1f));
let _e4650 = (2f - _e4618);
let _e4652 = select(0f, _e4650, (_e4650 > 0f));
let _e4657 = select(-1f, _e4503, (_e4503 > -1f));
let _e4659 = select(1f, _e4657, (_e4657 < 1f));
let _e4662 = ((1f - _e4659) * (1f + _e4659));
let _e4665 = sqrt(select(0f, _e4662, (_e4662 > 0f)));
let _e4668 = bitcast<f32>((bitcast<u32>(_e4665) & 2147483647u));
let _e4671 = bitcast<f32>((bitcast<u32>(_e4659) & 2147483647u));
let _e4675 = select(_e4671, _e4668, (_e4668 > _e4671));
let _e4678 = (select(_e4671, _e4668, (_e4668 < _e4671)) / select(1.1754944e-38f, _e4675, (_e4675 > 1.1754944e-38f)));
let _e4679 = (_e4678 > 0.41421357f);
let _e4683 = select(_e4678, ((_e4678 - 1f) / (_e4678 + 1f)), _e4679);
let _e4684 = (_e4683 * _e4683);
let _e4699 = (select(0f, 0.7853982f, _e4679) + (_e4683 + ((_e4683 * _e4684) * (-0.33333334f + (_e4684 * (0.2f + (_e4684 * (-0.14285713f + (_e4684 * (0.11111111f + (_e4684 * (-0.09090909f + (_e4684 * 0.0585f)))))))))))));
let _e4702 = select(_e4699, (1.5707964f - _e4699), (_e4671 > _e4668));
let _e4705 = select(_e4702, (3.1415927f - _e4702), (_e4665 < 0f));
let _e4710 = ((select(_e4705, -(_e4705), (_e4659 < 0f)) / _e4563) * 0.5f);
let _e4712 = select(-8e6f, _e4710, (_e4710 > -8e6f));
let _e4714 = select(8e6f, _e4712, (_e4712 < 8e6f));
let _e4721 = select(0i, select(select(i32(_e4714), i32(-2147483648), (_e4714 < -2147483600f)), 2147483647i, (_e4714 > 2147483500f)), (_e4714 == _e4714));
let _e4728 = ((_e4710 - f32((_e4721 - select(0i, 1i, (_e4714 < f32(_e4721)))))) * 2f);
let _e4736 = ((select(select((_e4728 - 2f), (1f - _e4728), (_e4728 < 1.5f)), _e4728, (_e4728 < 0.5f)) * 2f) / _e4566);
let _e4738 = select(-1f, _e4736, (_e4736 > -1f));
let _e4741 = (2f - _e4566);
let _e4743 = select(0f, _e4741, (_e4741 > 0f));
let _e4749 = (0.5f + ((0.5f * (select(1f, _e4647, (_e4647 < 1f)) * select(1f, _e4652, (_e4652 < 1f)))) * (select(1f, _e4738, (_e4738 < 1f)) * select(1f, _e4743, (_e4743 < 1f)))));
phi_8788_ = vec3<f32>((_e4511.member + ((_e4519.member - _e4511.member) * _e4749)), (_e4511.member_1 + ((_e4519.member_1 - _e4511.member_1) * _e4749)), (_e4511.member_2 + ((_e4519.member_2 - _e4511.member_2) * _e4749)));
} else {
let _e4763 = global_1.member.member_15.member_1;
let _e4764 = bitcast<i32>(_e4763);
let _e4769 = global_1.member.member_15.member_3;
let _e4771 = f32(bitcast<i32>(_e4769));
let _e4773 = (2f * 3.1415927f);
let _e4774 = ((_e4467 * f32(_e4764)) / _e4773);
let _e4776 = select(1e-6f, _e4774, (_e4774 > 1e-6f));
let _e4779 = bitcast<u32>(select(1.1754944e-38f, _e4776, (_e4776 > 1.1754944e-38f)));
let _e4780 = (_e4779 & 8388607u);
let _e4782 = select(0u, 1u, (_e4780 > 3474675u));
let _e4793 = bitcast<f32>((_e4780 | ((127u - _e4782) << bitcast<u32>(23i))));
let _e4796 = ((_e4793 - 1f) / (_e4793 + 1f));
let _e4797 = (_e4796 * _e4796);
let _e4812 = (f32(((bitcast<i32>((_e4779 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e4782))) + (((2f * _e4796) + ((_e4796 * _e4797) * (0.6666667f + (_e4797 * (0.4f + (_e4797 * (0.2857143f + (_e4797 * (0.22222222f + (_e4797 * 0.18181819f)))))))))) * 1.442695f));
let _e4813 = (_e4771 - 1f);
let _e4815 = select(0f, _e4812, (_e4812 > 0f));
let _e4817 = select(_e4813, _e4815, (_e4815 < _e4813));
let _e4818 = (_e4771 - 2f);
let _e4820 = select(0f, _e4818, (_e4818 > 0f));
let _e4822 = select(0f, _e4817, (_e4817 > 0f));
let _e4824 = select(_e4820, _e4822, (_e4822 < _e4820));
let _e4831 = select(0i, select(select(i32(_e4824), i32(-2147483648), (_e4824 < -2147483600f)), 2147483647i, (_e4824 > 2147483500f)), (_e4824 == _e4824));
let _e4835 = (_e4831 - select(0i, 1i, (_e4824 < f32(_e4831))));
let _e4838 = bitcast<f32>((bitcast<u32>(_e4491) & 2147483647u));
let _e4841 = bitcast<f32>((bitcast<u32>(_e4479) & 2147483647u));
let _e4845 = select(_e4841, _e4838, (_e4838 > _e4841));
let _e4848 = (select(_e4841, _e4838, (_e4838 < _e4841)) / select(1.1754944e-38f, _e4845, (_e4845 > 1.1754944e-38f)));
let _e4849 = (_e4848 > 0.41421357f);
let _e4853 = select(_e4848, ((_e4848 - 1f) / (_e4848 + 1f)), _e4849);
let _e4854 = (_e4853 * _e4853);
let _e4869 = (select(0f, 0.7853982f, _e4849) + (_e4853 + ((_e4853 * _e4854) * (-0.33333334f + (_e4854 * (0.2f + (_e4854 * (-0.14285713f + (_e4854 * (0.11111111f + (_e4854 * (-0.09090909f + (_e4854 * 0.0585f)))))))))))));
let _e4872 = select(_e4869, (1.5707964f - _e4869), (_e4841 > _e4838));
let _e4875 = select(_e4872, (3.1415927f - _e4872), (_e4491 < 0f));
let _e4880 = (0.5f - (select(_e4875, -(_e4875), (_e4479 < 0f)) / _e4773));
let _e4882 = select(-1f, _e4503, (_e4503 > -1f));
let _e4884 = select(1f, _e4882, (_e4882 < 1f));
let _e4887 = ((1f - _e4884) * (1f + _e4884));
let _e4890 = sqrt(select(0f, _e4887, (_e4887 > 0f)));
let _e4893 = bitcast<f32>((bitcast<u32>(_e4890) & 2147483647u));
let _e4896 = bitcast<f32>((bitcast<u32>(_e4884) & 2147483647u));
let _e4900 = select(_e4896, _e4893, (_e4893 > _e4896));
let _e4903 = (select(_e4896, _e4893, (_e4893 < _e4896)) / select(1.1754944e-38f, _e4900, (_e4900 > 1.1754944e-38f)));
let _e4904 = (_e4903 > 0.41421357f);
let _e4908 = select(_e4903, ((_e4903 - 1f) / (_e4903 + 1f)), _e4904);
let _e4909 = (_e4908 * _e4908);
let _e4924 = (select(0f, 0.7853982f, _e4904) + (_e4908 + ((_e4908 * _e4909) * (-0.33333334f + (_e4909 * (0.2f + (_e4909 * (-0.14285713f + (_e4909 * (0.11111111f + (_e4909 * (-0.09090909f + (_e4909 * 0.0585f)))))))))))));
let _e4927 = select(_e4924, (1.5707964f - _e4924), (_e4896 > _e4893));
let _e4930 = select(_e4927, (3.1415927f - _e4927), (_e4890 < 0f));
let _e4935 = (0.5f - (select(_e4930, -(_e4930), (_e4884 < 0f)) / 3.1415927f));
let _e4939 = global_1.member.member_15.member_2;
let _e4940 = bitcast<i32>(_e4939);
phi_8007_ = 0i;
phi_8010_ = 0i;
phi_8012_ = _e4940;
phi_8014_ = _e4764;
loop {
let _e4942 = phi_8007_;
let _e4944 = phi_8010_;
let _e4946 = phi_8012_;
let _e4948 = phi_8014_;
local_13 = _e4948;
local_14 = _e4946;
local_15 = _e4948;
local_16 = _e4948;
local_17 = _e4948;
local_18 = _e4948;
local_19 = _e4948;
local_20 = _e4948;
local_21 = _e4946;
local_22 = _e4946;
local_23 = _e4946;
local_24 = _e4946;
local_25 = _e4948;
local_26 = _e4944;
local_27 = _e4948;
local_28 = _e4944;
let _e4949 = (_e4942 < _e4835);
if _e4949 {
if (_e4948 > 1i) {
phi_8029_ = (_e4948 >> bitcast<u32>(1i));
} else {
phi_8029_ = 1i;
}
let _e4956 = phi_8029_;
if (_e4946 > 1i) {
phi_8035_ = (_e4946 >> bitcast<u32>(1i));
} else {
phi_8035_ = 1i;
}
let _e4961 = phi_8035_;
phi_8008_ = (_e4942 + 1i);
phi_8011_ = (_e4944 + (_e4948 * _e4946));
phi_8013_ = _e4961;
phi_8015_ = _e4956;
} else {
phi_8008_ = i32();
phi_8011_ = i32();
phi_8013_ = i32();
phi_8015_ = i32();
}
let _e4964 = phi_8008_;
let _e4966 = phi_8011_;
let _e4968 = phi_8013_;
let _e4970 = phi_8015_;
continue;
continuing {
phi_8007_ = _e4964;
phi_8010_ = _e4966;
phi_8012_ = _e4968;
phi_8014_ = _e4970;
break if !(_e4949);
}
}
let _e4973 = local_13;
let _e4974 = f32(_e4973);
let _e4976 = ((_e4880 * _e4974) - 0.5f);
let _e4978 = local_14;
let _e4979 = f32(_e4978);
let _e4981 = ((_e4935 * _e4979) - 0.5f);
let _e4983 = select(-1f, _e4976, (_e4976 > -1f));
let _e4985 = select(_e4974, _e4983, (_e4983 < _e4974));
let _e4992 = select(0i, select(select(i32(_e4985), i32(-2147483648), (_e4985 < -2147483600f)), 2147483647i, (_e4985 > 2147483500f)), (_e4985 == _e4985));
let _e4996 = (_e4992 - select(0i, 1i, (_e4985 < f32(_e4992))));
let _e4998 = select(-1f, _e4981, (_e4981 > -1f));
let _e5000 = select(_e4979, _e4998, (_e4998 < _e4979));
let _e5007 = select(0i, select(select(i32(_e5000), i32(-2147483648), (_e5000 < -2147483600f)), 2147483647i, (_e5000 > 2147483500f)), (_e5000 == _e5000));
let _e5011 = (_e5007 - select(0i, 1i, (_e5000 < f32(_e5007))));
let _e5013 = (_e4976 - f32(_e4996));
let _e5015 = (_e4981 - f32(_e5011));
let _e5017 = select(0f, _e5015, (_e5015 > 0f));
let _e5019 = select(1f, _e5017, (_e5017 < 1f));
if (_e4996 < 0i) {
let _e5022 = local_15;
phi_8110_ = (_e4996 + _e5022);
} else {
phi_8110_ = _e4996;
}
let _e5025 = phi_8110_;
let _e5027 = local_16;
if (_e5025 >= _e5027) {
let _e5030 = local_17;
phi_8116_ = (_e5025 - _e5030);
} else {
phi_8116_ = _e5025;
}
let _e5033 = phi_8116_;
let _e5034 = (_e4996 + 1i);
if (_e5034 < 0i) {
let _e5037 = local_18;
phi_8123_ = (_e5034 + _e5037);
} else {
phi_8123_ = _e5034;
}
let _e5040 = phi_8123_;
let _e5042 = local_19;
if (_e5040 >= _e5042) {
let _e5045 = local_20;
phi_8129_ = (_e5040 - _e5045);
} else {
phi_8129_ = _e5040;
}
let _e5048 = phi_8129_;
let _e5050 = select(_e5011, 0i, (_e5011 < 0i));
let _e5052 = local_21;
if (_e5050 >= _e5052) {
let _e5055 = local_22;
phi_8140_ = (_e5055 - 1i);
} else {
phi_8140_ = _e5050;
}
let _e5058 = phi_8140_;
let _e5059 = (_e5011 + 1i);
let _e5061 = select(_e5059, 0i, (_e5059 < 0i));
let _e5063 = local_23;
if (_e5061 >= _e5063) {
let _e5066 = local_24;
phi_8152_ = (_e5066 - 1i);
} else {
phi_8152_ = _e5061;
}
let _e5069 = phi_8152_;
let _e5071 = local_25;
let _e5074 = local_26;
let _e5075 = (_e5074 + (_e5058 * _e5071));
let _e5077 = local_27;
let _e5080 = local_28;
let _e5081 = (_e5080 + (_e5069 * _e5077));
let _e5083 = (3i * (_e5075 + _e5033));
let _e5085 = (bitcast<i32>(_e146) - 1i);
let _e5087 = select(_e5085, _e5083, (_e5083 < _e5085));
let _e5093 = global_3.member[bitcast<u32>(select(0i, _e5087, (_e5087 > 0i)))];
let _e5094 = (_e5083 + 1i);
let _e5096 = select(_e5085, _e5094, (_e5094 < _e5085));
let _e5102 = global_3.member[bitcast<u32>(select(0i, _e5096, (_e5096 > 0i)))];
let _e5103 = (_e5083 + 2i);
let _e5105 = select(_e5085, _e5103, (_e5103 < _e5085));
let _e5111 = global_3.member[bitcast<u32>(select(0i, _e5105, (_e5105 > 0i)))];
let _e5113 = (3i * (_e5075 + _e5048));
let _e5115 = select(_e5085, _e5113, (_e5113 < _e5085));
let _e5121 = global_3.member[bitcast<u32>(select(0i, _e5115, (_e5115 > 0i)))];
let _e5122 = (_e5113 + 1i);
let _e5124 = select(_e5085, _e5122, (_e5122 < _e5085));
let _e5130 = global_3.member[bitcast<u32>(select(0i, _e5124, (_e5124 > 0i)))];
let _e5131 = (_e5113 + 2i);
let _e5133 = select(_e5085, _e5131, (_e5131 < _e5085));
let _e5139 = global_3.member[bitcast<u32>(select(0i, _e5133, (_e5133 > 0i)))];
let _e5141 = (3i * (_e5081 + _e5033));
let _e5143 = select(_e5085, _e5141, (_e5141 < _e5085));
let _e5149 = global_3.member[bitcast<u32>(select(0i, _e5143, (_e5143 > 0i)))];
let _e5150 = (_e5141 + 1i);
let _e5152 = select(_e5085, _e5150, (_e5150 < _e5085));
let _e5158 = global_3.member[bitcast<u32>(select(0i, _e5152, (_e5152 > 0i)))];
let _e5159 = (_e5141 + 2i);
let _e5161 = select(_e5085, _e5159, (_e5159 < _e5085));
let _e5167 = global_3.member[bitcast<u32>(select(0i, _e5161, (_e5161 > 0i)))];
let _e5169 = (3i * (_e5081 + _e5048));
let _e5171 = select(_e5085, _e5169, (_e5169 < _e5085));
let _e5177 = global_3.member[bitcast<u32>(select(0i, _e5171, (_e5171 > 0i)))];
let _e5178 = (_e5169 + 1i);
let _e5180 = select(_e5085, _e5178, (_e5178 < _e5085));
let _e5186 = global_3.member[bitcast<u32>(select(0i, _e5180, (_e5180 > 0i)))];
let _e5187 = (_e5169 + 2i);
let _e5189 = select(_e5085, _e5187, (_e5187 < _e5085));
let _e5195 = global_3.member[bitcast<u32>(select(0i, _e5189, (_e5189 > 0i)))];
let _e5202 = (_e5093 + ((_e5121 - _e5093) * _e5013));
let _e5203 = (_e5102 + ((_e5130 - _e5102) * _e5013));
let _e5204 = (_e5111 + ((_e5139 - _e5111) * _e5013));
let _e5220 = (_e5202 + (((_e5149 + ((_e5177 - _e5149) * _e5013)) - _e5202) * _e5019));
let _e5221 = (_e5203 + (((_e5158 + ((_e5186 - _e5158) * _e5013)) - _e5203) * _e5019));
let _e5222 = (_e5204 + (((_e5167 + ((_e5195 - _e5167) * _e5013)) - _e5204) * _e5019));
phi_8388_ = 0i;
phi_8391_ = 0i;
phi_8393_ = _e4940;
phi_8395_ = _e4764;
loop {
let _e5225 = phi_8388_;
let _e5227 = phi_8391_;
let _e5229 = phi_8393_;
let _e5231 = phi_8395_;
local_29 = _e5231;
local_30 = _e5229;
local_31 = _e5231;
local_32 = _e5231;
local_33 = _e5231;
local_34 = _e5231;
local_35 = _e5231;
local_36 = _e5231;
local_37 = _e5229;
local_38 = _e5229;
local_39 = _e5229;
local_40 = _e5229;
local_41 = _e5231;
local_42 = _e5227;
local_43 = _e5231;
local_44 = _e5227;
let _e5232 = (_e5225 < (_e4835 + 1i));
if _e5232 {
if (_e5231 > 1i) {
phi_8410_ = (_e5231 >> bitcast<u32>(1i));
} else {
phi_8410_ = 1i;
}
let _e5239 = phi_8410_;
if (_e5229 > 1i) {
phi_8416_ = (_e5229 >> bitcast<u32>(1i));
} else {
phi_8416_ = 1i;
}
let _e5244 = phi_8416_;
phi_8389_ = (_e5225 + 1i);
phi_8392_ = (_e5227 + (_e5231 * _e5229));
phi_8394_ = _e5244;
phi_8396_ = _e5239;
} else {
phi_8389_ = i32();
phi_8392_ = i32();
phi_8394_ = i32();
phi_8396_ = i32();
}
let _e5247 = phi_8389_;
let _e5249 = phi_8392_;
let _e5251 = phi_8394_;
let _e5253 = phi_8396_;
continue;
continuing {
phi_8388_ = _e5247;
phi_8391_ = _e5249;
phi_8393_ = _e5251;
phi_8395_ = _e5253;
break if !(_e5232);
}
}
let _e5256 = local_29;
let _e5257 = f32(_e5256);
let _e5259 = ((_e4880 * _e5257) - 0.5f);
let _e5261 = local_30;
let _e5262 = f32(_e5261);
let _e5264 = ((_e4935 * _e5262) - 0.5f);
let _e5266 = select(-1f, _e5259, (_e5259 > -1f));
let _e5268 = select(_e5257, _e5266, (_e5266 < _e5257));
let _e5275 = select(0i, select(select(i32(_e5268), i32(-2147483648), (_e5268 < -2147483600f)), 2147483647i, (_e5268 > 2147483500f)), (_e5268 == _e5268));
let _e5279 = (_e5275 - select(0i, 1i, (_e5268 < f32(_e5275))));
let _e5281 = select(-1f, _e5264, (_e5264 > -1f));
let _e5283 = select(_e5262, _e5281, (_e5281 < _e5262));
let _e5290 = select(0i, select(select(i32(_e5283), i32(-2147483648), (_e5283 < -2147483600f)), 2147483647i, (_e5283 > 2147483500f)), (_e5283 == _e5283));
let _e5294 = (_e5290 - select(0i, 1i, (_e5283 < f32(_e5290))));
let _e5296 = (_e5259 - f32(_e5279));
let _e5298 = (_e5264 - f32(_e5294));
let _e5300 = select(0f, _e5298, (_e5298 > 0f));
let _e5302 = select(1f, _e5300, (_e5300 < 1f));
if (_e5279 < 0i) {
let _e5305 = local_31;
phi_8491_ = (_e5279 + _e5305);
} else {
phi_8491_ = _e5279;
}
let _e5308 = phi_8491_;
let _e5310 = local_32;
if (_e5308 >= _e5310) {
let _e5313 = local_33;
phi_8497_ = (_e5308 - _e5313);
} else {
phi_8497_ = _e5308;
}
let _e5316 = phi_8497_;
let _e5317 = (_e5279 + 1i);
if (_e5317 < 0i) {
let _e5320 = local_34;
phi_8504_ = (_e5317 + _e5320);
} else {
phi_8504_ = _e5317;
}
let _e5323 = phi_8504_;
let _e5325 = local_35;
if (_e5323 >= _e5325) {
let _e5328 = local_36;
phi_8510_ = (_e5323 - _e5328);
} else {
phi_8510_ = _e5323;
}
let _e5331 = phi_8510_;
let _e5333 = select(_e5294, 0i, (_e5294 < 0i));
let _e5335 = local_37;
if (_e5333 >= _e5335) {
let _e5338 = local_38;
phi_8521_ = (_e5338 - 1i);
} else {
phi_8521_ = _e5333;
}
let _e5341 = phi_8521_;
let _e5342 = (_e5294 + 1i);
let _e5344 = select(_e5342, 0i, (_e5342 < 0i));
let _e5346 = local_39;
if (_e5344 >= _e5346) {
let _e5349 = local_40;
phi_8533_ = (_e5349 - 1i);
} else {
phi_8533_ = _e5344;
}
let _e5352 = phi_8533_;
let _e5354 = local_41;
let _e5357 = local_42;
let _e5358 = (_e5357 + (_e5341 * _e5354));
let _e5360 = local_43;
let _e5363 = local_44;
let _e5364 = (_e5363 + (_e5352 * _e5360));
let _e5366 = (3i * (_e5358 + _e5316));
let _e5368 = select(_e5085, _e5366, (_e5366 < _e5085));
let _e5374 = global_3.member[bitcast<u32>(select(0i, _e5368, (_e5368 > 0i)))];
let _e5375 = (_e5366 + 1i);
let _e5377 = select(_e5085, _e5375, (_e5375 < _e5085));
let _e5383 = global_3.member[bitcast<u32>(select(0i, _e5377, (_e5377 > 0i)))];
let _e5384 = (_e5366 + 2i);
let _e5386 = select(_e5085, _e5384, (_e5384 < _e5085));
let _e5392 = global_3.member[bitcast<u32>(select(0i, _e5386, (_e5386 > 0i)))];
let _e5394 = (3i * (_e5358 + _e5331));
let _e5396 = select(_e5085, _e5394, (_e5394 < _e5085));
let _e5402 = global_3.member[bitcast<u32>(select(0i, _e5396, (_e5396 > 0i)))];
let _e5403 = (_e5394 + 1i);
let _e5405 = select(_e5085, _e5403, (_e5403 < _e5085));
let _e5411 = global_3.member[bitcast<u32>(select(0i, _e5405, (_e5405 > 0i)))];
let _e5412 = (_e5394 + 2i);
let _e5414 = select(_e5085, _e5412, (_e5412 < _e5085));
let _e5420 = global_3.member[bitcast<u32>(select(0i, _e5414, (_e5414 > 0i)))];
let _e5422 = (3i * (_e5364 + _e5316));
let _e5424 = select(_e5085, _e5422, (_e5422 < _e5085));
let _e5430 = global_3.member[bitcast<u32>(select(0i, _e5424, (_e5424 > 0i)))];
let _e5431 = (_e5422 + 1i);
let _e5433 = select(_e5085, _e5431, (_e5431 < _e5085));
let _e5439 = global_3.member[bitcast<u32>(select(0i, _e5433, (_e5433 > 0i)))];
let _e5440 = (_e5422 + 2i);
let _e5442 = select(_e5085, _e5440, (_e5440 < _e5085));
let _e5448 = global_3.member[bitcast<u32>(select(0i, _e5442, (_e5442 > 0i)))];
let _e5450 = (3i * (_e5364 + _e5331));
let _e5452 = select(_e5085, _e5450, (_e5450 < _e5085));
let _e5458 = global_3.member[bitcast<u32>(select(0i, _e5452, (_e5452 > 0i)))];
let _e5459 = (_e5450 + 1i);
let _e5461 = select(_e5085, _e5459, (_e5459 < _e5085));
let _e5467 = global_3.member[bitcast<u32>(select(0i, _e5461, (_e5461 > 0i)))];
let _e5468 = (_e5450 + 2i);
let _e5470 = select(_e5085, _e5468, (_e5468 < _e5085));
let _e5476 = global_3.member[bitcast<u32>(select(0i, _e5470, (_e5470 > 0i)))];
let _e5483 = (_e5374 + ((_e5402 - _e5374) * _e5296));
let _e5484 = (_e5383 + ((_e5411 - _e5383) * _e5296));
let _e5485 = (_e5392 + ((_e5420 - _e5392) * _e5296));
let _e5508 = (_e4817 - f32(_e4835));
let _e5510 = select(0f, _e5508, (_e5508 > 0f));
let _e5512 = select(1f, _e5510, (_e5510 < 1f));
let _e5522 = global_1.member.member_15.member_11;
phi_8788_ = vec3<f32>(((_e5220 + (((_e5483 + (((_e5430 + ((_e5458 - _e5430) * _e5296)) - _e5483) * _e5302)) - _e5220) * _e5512)) * _e5522), ((_e5221 + (((_e5484 + (((_e5439 + ((_e5467 - _e5439) * _e5296)) - _e5484) * _e5302)) - _e5221) * _e5512)) * _e5522), ((_e5222 + (((_e5485 + (((_e5448 + ((_e5476 - _e5448) * _e5296)) - _e5485) * _e5302)) - _e5222) * _e5512)) * _e5522));
}
let _e5528 = phi_8788_;
phi_8789_ = _e5528;
}
let _e5530 = phi_8789_;
phi_8790_ = _e5530;
}
let _e5532 = phi_8790_;
let _e5536 = global_1.member.member_15.member_12;
let _e5537 = select(1f, _e5536, _e636);
phi_9894_ = type_24(_e4449.member, _e4449.member_1, vec3<f32>((_e4449.member_2.x + (((_e5532.x * _e857) * _e723) * _e5537)), (_e4449.member_2.y + (((_e5532.y * _e905) * _e724) * _e5537)), (_e4449.member_2.z + (((_e5532.z * _e953) * _e725) * _e5537))), _e4449.member_3, _e4449.member_4, _e4449.member_5, _e4449.member_6, _e4449.member_7);
} else {
if _e4359 {
let _e5572 = global_1.member.member_10.member_2;
let _e5580 = global_1.member.member_10.member;
let _e5581 = (_e5580 == 0u);
if _e5581 {
let _e5585 = global_1.member.member_10.member_1;
phi_9346_ = type_26(vec3<f32>(_e5585.member, _e5585.member_1, _e5585.member_2), vec3<f32>(_e5572.member, _e5572.member_1, _e5572.member_2));
} else {
let _e5594 = global_1.member.member_10.member_3;
let _e5599 = (_e4322.member.x - _e5594.member);
let _e5601 = (_e4322.member.y - _e5594.member_1);
let _e5603 = (_e4322.member.z - _e5594.member_2);
let _e5608 = (((_e5599 * _e5599) + (_e5601 * _e5601)) + (_e5603 * _e5603));
let _e5610 = select(1e-12f, _e5608, (_e5608 > 1e-12f));
let _e5611 = (1f / _e5610);
let _e5615 = vec3<f32>((_e5572.member * _e5611), (_e5572.member_1 * _e5611), (_e5572.member_2 * _e5611));
if (_e5580 == 2u) {
let _e5620 = global_1.member.member_10.member_1;
let _e5628 = (((_e5620.member * _e5599) + (_e5620.member_1 * _e5601)) + (_e5620.member_2 * _e5603));
let _e5631 = (1f / select(1e-20f, _e5628, (_e5628 > 1e-20f)));
let _e5636 = global_1.member.member_10.member_4.member;
let _e5645 = ((((_e5636.member * _e5599) + (_e5636.member_1 * _e5601)) + (_e5636.member_2 * _e5603)) * _e5631);
let _e5650 = global_1.member.member_10.member_4.member_1;
let _e5659 = ((((_e5650.member * _e5599) + (_e5650.member_1 * _e5601)) + (_e5650.member_2 * _e5603)) * _e5631);
let _e5664 = global_1.member.member_10.member_4.member_2;
let _e5667 = ((_e5645 * _e5645) + (_e5659 * _e5659));
let _e5676 = global_1.member.member_10.member_4.member_3;
let _e5677 = ((_e5664 - sqrt(select(0f, _e5667, (_e5667 > 0f)))) * _e5676);
let _e5679 = select(0f, _e5677, (_e5677 > 0f));
let _e5681 = select(1f, _e5679, (_e5679 < 1f));
let _e5687 = select(0f, ((_e5681 * _e5681) * (3f - (2f * _e5681))), (_e5628 > 0f));
let _e5692 = global_1.member.member_10.member_4.member_5;
if ((_e5692 > 0u) && (_e5687 > 0f)) {
let _e5696 = (0.5f / _e5664);
let _e5706 = global_1.member.member_10.member_4.member_6;
let _e5707 = bitcast<i32>(_e5706);
local = bitcast<i32>(_e5692);
let _e5708 = local;
let _e5710 = f32((_e5708 - 1i));
let _e5712 = f32((_e5707 - 1i));
let _e5713 = local;
let _e5716 = (((0.5f + (_e5645 * _e5696)) * f32(_e5713)) - 0.5f);
let _e5718 = select(0f, _e5716, (_e5716 > 0f));
let _e5720 = select(_e5710, _e5718, (_e5718 < _e5710));
let _e5723 = (((0.5f - (_e5659 * _e5696)) * f32(_e5707)) - 0.5f);
let _e5725 = select(0f, _e5723, (_e5723 > 0f));
let _e5727 = select(_e5712, _e5725, (_e5725 < _e5712));
let _e5729 = select(0f, _e5720, (_e5720 > 0f));
let _e5731 = select(_e5710, _e5729, (_e5729 < _e5710));
let _e5738 = select(0i, select(select(i32(_e5731), i32(-2147483648), (_e5731 < -2147483600f)), 2147483647i, (_e5731 > 2147483500f)), (_e5731 == _e5731));
let _e5742 = (_e5738 - select(0i, 1i, (_e5731 < f32(_e5738))));
let _e5744 = select(0f, _e5727, (_e5727 > 0f));
let _e5746 = select(_e5712, _e5744, (_e5744 < _e5712));
let _e5753 = select(0i, select(select(i32(_e5746), i32(-2147483648), (_e5746 < -2147483600f)), 2147483647i, (_e5746 > 2147483500f)), (_e5746 == _e5746));
let _e5757 = (_e5753 - select(0i, 1i, (_e5746 < f32(_e5753))));
let _e5759 = (_e5720 - f32(_e5742));
let _e5761 = (_e5727 - f32(_e5757));
let _e5762 = (_e5742 + 1i);
let _e5763 = local;
let _e5765 = select(_e5742, _e5762, (_e5762 < _e5763));
let _e5766 = (_e5757 + 1i);
let _e5768 = select(_e5757, _e5766, (_e5766 < _e5707));
let _e5773 = global_1.member.member_10.member_4.member_4;
let _e5774 = bitcast<i32>(_e5773);
let _e5775 = local;
let _e5779 = (_e5774 + (3i * ((_e5757 * _e5775) + _e5742)));
let _e5781 = (bitcast<i32>(_e146) - 1i);
let _e5783 = select(_e5781, _e5779, (_e5779 < _e5781));
let _e5788 = global_3.member[bitcast<u32>(select(0i, _e5783, (_e5783 > 0i)))];
let _e5789 = (_e5779 + 1i);
let _e5791 = select(_e5781, _e5789, (_e5789 < _e5781));
let _e5796 = global_3.member[bitcast<u32>(select(0i, _e5791, (_e5791 > 0i)))];
let _e5797 = (_e5779 + 2i);
let _e5799 = select(_e5781, _e5797, (_e5797 < _e5781));
let _e5804 = global_3.member[bitcast<u32>(select(0i, _e5799, (_e5799 > 0i)))];
let _e5805 = local;
let _e5809 = (_e5774 + (3i * ((_e5757 * _e5805) + _e5765)));
let _e5811 = select(_e5781, _e5809, (_e5809 < _e5781));
let _e5816 = global_3.member[bitcast<u32>(select(0i, _e5811, (_e5811 > 0i)))];
let _e5817 = (_e5809 + 1i);
let _e5819 = select(_e5781, _e5817, (_e5817 < _e5781));
let _e5824 = global_3.member[bitcast<u32>(select(0i, _e5819, (_e5819 > 0i)))];
let _e5825 = (_e5809 + 2i);
let _e5827 = select(_e5781, _e5825, (_e5825 < _e5781));
let _e5832 = global_3.member[bitcast<u32>(select(0i, _e5827, (_e5827 > 0i)))];
let _e5833 = local;
let _e5837 = (_e5774 + (3i * ((_e5768 * _e5833) + _e5742)));
let _e5839 = select(_e5781, _e5837, (_e5837 < _e5781));
let _e5844 = global_3.member[bitcast<u32>(select(0i, _e5839, (_e5839 > 0i)))];
let _e5845 = (_e5837 + 1i);
let _e5847 = select(_e5781, _e5845, (_e5845 < _e5781));
let _e5852 = global_3.member[bitcast<u32>(select(0i, _e5847, (_e5847 > 0i)))];
let _e5853 = (_e5837 + 2i);
let _e5855 = select(_e5781, _e5853, (_e5853 < _e5781));
let _e5860 = global_3.member[bitcast<u32>(select(0i, _e5855, (_e5855 > 0i)))];
let _e5861 = local;
let _e5865 = (_e5774 + (3i * ((_e5768 * _e5861) + _e5765)));
let _e5867 = select(_e5781, _e5865, (_e5865 < _e5781));
let _e5872 = global_3.member[bitcast<u32>(select(0i, _e5867, (_e5867 > 0i)))];
let _e5873 = (_e5865 + 1i);
let _e5875 = select(_e5781, _e5873, (_e5873 < _e5781));
let _e5880 = global_3.member[bitcast<u32>(select(0i, _e5875, (_e5875 > 0i)))];
let _e5881 = (_e5865 + 2i);
let _e5883 = select(_e5781, _e5881, (_e5881 < _e5781));
let _e5888 = global_3.member[bitcast<u32>(select(0i, _e5883, (_e5883 > 0i)))];
let _e5895 = (_e5788 + ((_e5816 - _e5788) * _e5759));
let _e5896 = (_e5796 + ((_e5824 - _e5796) * _e5759));
let _e5897 = (_e5804 + ((_e5832 - _e5804) * _e5759));
phi_9330_ = vec3<f32>(((_e5895 + (((_e5844 + ((_e5872 - _e5844) * _e5759)) - _e5895) * _e5761)) * _e5687), ((_e5896 + (((_e5852 + ((_e5880 - _e5852) * _e5759)) - _e5896) * _e5761)) * _e5687), ((_e5897 + (((_e5860 + ((_e5888 - _e5860) * _e5759)) - _e5897) * _e5761)) * _e5687));
} else {
phi_9330_ = vec3(_e5687);
}
let _e5922 = phi_9330_;
phi_9333_ = (_e5615 * _e5922);
} else {
phi_9333_ = _e5615;
}
let _e5925 = phi_9333_;
let _e5929 = (1f / sqrt(select(0f, _e5610, (_e5610 > 0f))));
phi_9346_ = type_26(vec3<f32>((_e5599 * _e5929), (_e5601 * _e5929), (_e5603 * _e5929)), _e5925);
}
let _e5936 = phi_9346_;
let _e5938 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e5940 = select(_e5938, _e447, (_e447 < _e5938));
let _e5946 = global_8.member[bitcast<u32>(select(0i, _e5940, (_e5940 > 0i)))];
let _e5950 = global_1.member.member_10.member_3;
let _e5955 = (_e5950.member - _e4322.member.x);
let _e5957 = (_e5950.member_1 - _e4322.member.y);
let _e5959 = (_e5950.member_2 - _e4322.member.z);
let _e5964 = (((_e5955 * _e5955) + (_e5957 * _e5957)) + (_e5959 * _e5959));
let _e5968 = select(sqrt(select(0f, _e5964, (_e5964 > 0f))), 1e30f, _e5581);
let _e5971 = -(_e5936.member.x);
let _e5973 = -(_e5936.member.y);
let _e5975 = -(_e5936.member.z);
let _e5983 = (1f / select(_e5971, select(1e-12f, -1e-12f, (_e5971 < 0f)), (bitcast<f32>((bitcast<u32>(_e5971) & 2147483647u)) < 1e-12f)));
let _e5991 = (1f / select(_e5973, select(1e-12f, -1e-12f, (_e5973 < 0f)), (bitcast<f32>((bitcast<u32>(_e5973) & 2147483647u)) < 1e-12f)));
let _e5999 = (1f / select(_e5975, select(1e-12f, -1e-12f, (_e5975 < 0f)), (bitcast<f32>((bitcast<u32>(_e5975) & 2147483647u)) < 1e-12f)));
let _e6001 = ((_e753.member - _e4322.member.x) * _e5983);
let _e6003 = ((_e760.member - _e4322.member.x) * _e5983);
let _e6005 = ((_e753.member_1 - _e4322.member.y) * _e5991);
let _e6007 = ((_e760.member_1 - _e4322.member.y) * _e5991);
let _e6009 = ((_e753.member_2 - _e4322.member.z) * _e5999);
let _e6011 = ((_e760.member_2 - _e4322.member.z) * _e5999);
let _e6013 = select(_e6003, _e6001, (_e6001 < _e6003));
let _e6015 = select(_e6007, _e6005, (_e6005 < _e6007));
let _e6017 = select(_e6015, _e6013, (_e6013 > _e6015));
let _e6019 = select(_e6011, _e6009, (_e6009 < _e6011));
let _e6021 = select(_e6019, _e6017, (_e6017 > _e6019));
let _e6023 = select(_e6003, _e6001, (_e6001 > _e6003));
let _e6025 = select(_e6007, _e6005, (_e6005 > _e6007));
let _e6027 = select(_e6025, _e6023, (_e6023 < _e6025));
let _e6029 = select(_e6011, _e6009, (_e6009 > _e6011));
let _e6031 = select(_e6029, _e6027, (_e6027 < _e6029));
let _e6033 = select(0f, _e6021, (_e6021 > 0f));
let _e6035 = select(_e5968, _e6031, (_e6031 < _e5968));
let _e6038 = (select(_e6033, _e6035, (_e6035 > _e6033)) - _e6033);
let _e6040 = -((_e806.member * _e6038));
let _e6042 = select(-87f, _e6040, (_e6040 > -87f));
let _e6044 = select(88f, _e6042, (_e6042 < 88f));
let _e6046 = ((_e6044 * 1.442695f) + 0.5f);
let _e6048 = select(-127f, _e6046, (_e6046 > -127f));
let _e6050 = select(128f, _e6048, (_e6048 < 128f));
let _e6057 = select(0i, select(select(i32(_e6050), i32(-2147483648), (_e6050 < -2147483600f)), 2147483647i, (_e6050 > 2147483500f)), (_e6050 == _e6050));
let _e6061 = (_e6057 - select(0i, 1i, (_e6050 < f32(_e6057))));
let _e6062 = f32(_e6061);
let _e6066 = ((_e6044 - (_e6062 * 0.6933594f)) - (_e6062 * -2.1219444e-4f));
let _e6088 = -((_e806.member_1 * _e6038));
let _e6090 = select(-87f, _e6088, (_e6088 > -87f));
let _e6092 = select(88f, _e6090, (_e6090 < 88f));
let _e6094 = ((_e6092 * 1.442695f) + 0.5f);
let _e6096 = select(-127f, _e6094, (_e6094 > -127f));
let _e6098 = select(128f, _e6096, (_e6096 < 128f));
let _e6105 = select(0i, select(select(i32(_e6098), i32(-2147483648), (_e6098 < -2147483600f)), 2147483647i, (_e6098 > 2147483500f)), (_e6098 == _e6098));
let _e6109 = (_e6105 - select(0i, 1i, (_e6098 < f32(_e6105))));
let _e6110 = f32(_e6109);
let _e6114 = ((_e6092 - (_e6110 * 0.6933594f)) - (_e6110 * -2.1219444e-4f));
let _e6136 = -((_e806.member_2 * _e6038));
let _e6138 = select(-87f, _e6136, (_e6136 > -87f));
let _e6140 = select(88f, _e6138, (_e6138 < 88f));
let _e6142 = ((_e6140 * 1.442695f) + 0.5f);
let _e6144 = select(-127f, _e6142, (_e6142 > -127f));
let _e6146 = select(128f, _e6144, (_e6144 < 128f));
let _e6153 = select(0i, select(select(i32(_e6146), i32(-2147483648), (_e6146 < -2147483600f)), 2147483647i, (_e6146 > 2147483500f)), (_e6146 == _e6146));
let _e6157 = (_e6153 - select(0i, 1i, (_e6146 < f32(_e6153))));
let _e6158 = f32(_e6157);
let _e6162 = ((_e6140 - (_e6158 * 0.6933594f)) - (_e6158 * -2.1219444e-4f));
let _e6183 = (1f - _e5946);
let _e6195 = (((_e4322.member_1.x * _e466) + (_e4322.member_1.y * _e477)) + (_e4322.member_1.z * _e488));
let _e6197 = select(1f, -1f, (_e6195 > 0f));
let _e6209 = select(_e6197, -(_e6197), ((((_e4322.member_2.x * _e4322.member_1.x) + (_e4322.member_2.y * _e4322.member_1.y)) + (_e4322.member_2.z * _e4322.member_1.z)) < 0f));
let _e6210 = (_e4322.member_2.x * _e6209);
let _e6211 = (_e4322.member_2.y * _e6209);
let _e6212 = (_e4322.member_2.z * _e6209);
let _e6221 = ((((_e6210 * _e466) + (_e6211 * _e477)) + (_e6212 * _e488)) > 0f);
let _e6230 = -((((select(_e6210, (_e4322.member_1.x * _e6197), _e6221) * _e5936.member.x) + (select(_e6211, (_e4322.member_1.y * _e6197), _e6221) * _e5936.member.y)) + (select(_e6212, (_e4322.member_1.z * _e6197), _e6221) * _e5936.member.z)));
let _e6240 = -(_e6230);
let _e6245 = select((select(0f, _e6240, (_e6240 > 0f)) * _e4322.member_4), select(0f, _e6230, (_e6230 > 0f)), (((((_e4322.member_1.x * _e5936.member.x) + (_e4322.member_1.y * _e5936.member.y)) + (_e4322.member_1.z * _e5936.member.z)) * _e6195) > 0f));
let _e6259 = global_1.member.member_16;
phi_9893_ = type_24(_e4449.member, _e4449.member_1, vec3<f32>((_e4449.member_2.x + (((_e4322.member_3.x * (((_e5936.member_1.x * (((1f + (_e6066 * (1f + (_e6066 * (0.5f + (_e6066 * (0.16666667f + (_e6066 * (0.041666668f + (_e6066 * (0.008333334f + (_e6066 * (0.001388889f + (_e6066 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6061 + 127i)) << bitcast<u32>(23i)))) * _e6183)) * _e6245) + _e6259.member)) * _e857) * _e723)), (_e4449.member_2.y + (((_e4322.member_3.y * (((_e5936.member_1.y * (((1f + (_e6114 * (1f + (_e6114 * (0.5f + (_e6114 * (0.16666667f + (_e6114 * (0.041666668f + (_e6114 * (0.008333334f + (_e6114 * (0.001388889f + (_e6114 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6109 + 127i)) << bitcast<u32>(23i)))) * _e6183)) * _e6245) + _e6259.member_1)) * _e905) * _e724)), (_e4449.member_2.z + (((_e4322.member_3.z * (((_e5936.member_1.z * (((1f + (_e6162 * (1f + (_e6162 * (0.5f + (_e6162 * (0.16666667f + (_e6162 * (0.041666668f + (_e6162 * (0.008333334f + (_e6162 * (0.001388889f + (_e6162 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6157 + 127i)) << bitcast<u32>(23i)))) * _e6183)) * _e6245) + _e6259.member_2)) * _e953) * _e725))), _e4449.member_3, _e4449.member_4, _e4449.member_5, _e4449.member_6, _e4449.member_7);
} else {
phi_9893_ = _e4449;
}
let _e6297 = phi_9893_;
phi_9894_ = _e6297;
}
let _e6299 = phi_9894_;
global_6.member[_e168] = _e6299.member;
global_6.member[_e180] = _e6299.member_1;
global_6.member[_e191] = _e6299.member_2.x;
global_6.member[_e202] = _e6299.member_2.y;
global_6.member[_e213] = _e6299.member_2.z;
global_6.member[_e224] = _e6299.member_3.x;
global_6.member[_e235] = _e6299.member_3.y;
global_6.member[_e246] = _e6299.member_3.z;
global_6.member[_e257] = _e6299.member_4.x;
global_6.member[_e268] = _e6299.member_4.y;
global_6.member[_e279] = _e6299.member_4.z;
global_6.member[_e290] = _e6299.member_5.x;
global_6.member[_e301] = _e6299.member_5.y;
global_6.member[_e312] = _e6299.member_5.z;
global_6.member[_e323] = _e6299.member_6;
global_6.member[_e334] = _e6299.member_7.x;
global_6.member[_e345] = _e6299.member_7.y;
global_6.member[_e356] = _e6299.member_7.z;
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
