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
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_5,
member_18: type_9,
member_19: type_11,
member_20: type_5,
member_21: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_21 {
member: array<u32>,
}
struct type_22 {
member: vec3<f32>,
member_1: vec3<f32>,
}
struct type_23 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(2)
var<storage> global_3: type_16;
@group(0) @binding(3)
var<storage> global_4: type_16;
@group(0) @binding(4)
var<storage> global_5: type_16;
@group(0) @binding(5)
var<storage> global_6: type_21;
@group(0) @binding(6)
var<storage, read_write> global_7: type_16;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
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
var local_19: i32;
var local_20: i32;
var local_21: i32;
var local_22: i32;
var local_23: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var local_32: i32;
var local_33: i32;
var local_34: i32;
var local_35: i32;
var local_36: i32;
var phi_2683_: vec3<f32>;
var phi_3285_: i32;
var phi_3288_: i32;
var phi_3290_: i32;
var phi_3292_: i32;
var phi_3307_: i32;
var phi_3313_: i32;
var phi_3286_: i32;
var phi_3289_: i32;
var phi_3291_: i32;
var phi_3293_: i32;
var local_37: i32;
var local_38: i32;
var local_39: i32;
var phi_3388_: i32;
var local_40: i32;
var local_41: i32;
var phi_3394_: i32;
var local_42: i32;
var phi_3401_: i32;
var local_43: i32;
var local_44: i32;
var phi_3407_: i32;
var local_45: i32;
var local_46: i32;
var phi_3418_: i32;
var local_47: i32;
var local_48: i32;
var phi_3430_: i32;
var local_49: i32;
var local_50: i32;
var local_51: i32;
var local_52: i32;
var phi_3666_: i32;
var phi_3669_: i32;
var phi_3671_: i32;
var phi_3673_: i32;
var phi_3688_: i32;
var phi_3694_: i32;
var phi_3667_: i32;
var phi_3670_: i32;
var phi_3672_: i32;
var phi_3674_: i32;
var local_53: i32;
var local_54: i32;
var local_55: i32;
var phi_3769_: i32;
var local_56: i32;
var local_57: i32;
var phi_3775_: i32;
var local_58: i32;
var phi_3782_: i32;
var local_59: i32;
var local_60: i32;
var phi_3788_: i32;
var local_61: i32;
var local_62: i32;
var phi_3799_: i32;
var local_63: i32;
var local_64: i32;
var phi_3811_: i32;
var local_65: i32;
var local_66: i32;
var local_67: i32;
var local_68: i32;
var phi_4066_: vec3<f32>;
var phi_4067_: vec3<f32>;
var phi_4068_: vec3<f32>;
var phi_4930_: type_23;
var phi_5504_: vec3<f32>;
var phi_5507_: vec3<f32>;
var phi_5520_: type_22;
var phi_5987_: f32;
var phi_5990_: vec3<f32>;
var phi_5992_: i32;
var phi_6007_: i32;
var phi_6010_: f32;
var phi_6012_: vec3<f32>;
var phi_6245_: vec3<f32>;
var phi_6255_: vec3<f32>;
var phi_6008_: i32;
var phi_6011_: f32;
var phi_6013_: vec3<f32>;
var phi_5988_: f32;
var phi_5991_: vec3<f32>;
var phi_5993_: i32;
var local_69: f32;
var local_70: f32;
var local_71: vec3<f32>;
var local_72: vec3<f32>;
var local_73: vec3<f32>;
var phi_6337_: vec3<f32>;
var local_74: f32;
var local_75: vec3<f32>;
let _e140 = global;
let _e146 = arrayLength((&global_3.member));
let _e157 = global_1.member.member;
if (_e140.x < _e157.member) {
if (_e140.y < _e157.member_1) {
let _e164 = (_e157.member * _e157.member_1);
let _e166 = ((_e140.y * _e157.member) + _e140.x);
let _e167 = bitcast<i32>(_e166);
let _e169 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e171 = select(_e169, _e167, (_e167 < _e169));
let _e177 = global_7.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e178 = (_e164 + _e166);
let _e179 = bitcast<i32>(_e178);
let _e181 = select(_e169, _e179, (_e179 < _e169));
let _e187 = global_7.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e189 = ((2u * _e164) + _e166);
let _e190 = bitcast<i32>(_e189);
let _e192 = select(_e169, _e190, (_e190 < _e169));
let _e198 = global_7.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e200 = ((3u * _e164) + _e166);
let _e201 = bitcast<i32>(_e200);
let _e203 = select(_e169, _e201, (_e201 < _e169));
let _e209 = global_7.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e211 = ((4u * _e164) + _e166);
let _e212 = bitcast<i32>(_e211);
let _e214 = select(_e169, _e212, (_e212 < _e169));
let _e220 = global_7.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e222 = ((5u * _e164) + _e166);
let _e223 = bitcast<i32>(_e222);
let _e225 = select(_e169, _e223, (_e223 < _e169));
let _e231 = global_7.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e233 = ((6u * _e164) + _e166);
let _e234 = bitcast<i32>(_e233);
let _e236 = select(_e169, _e234, (_e234 < _e169));
let _e242 = global_7.member[bitcast<u32>(select(0i, _e236, (_e236 > 0i)))];
let _e244 = ((7u * _e164) + _e166);
let _e245 = bitcast<i32>(_e244);
let _e247 = select(_e169, _e245, (_e245 < _e169));
let _e253 = global_7.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e255 = ((8u * _e164) + _e166);
let _e256 = bitcast<i32>(_e255);
let _e258 = select(_e169, _e256, (_e256 < _e169));
let _e264 = global_7.member[bitcast<u32>(select(0i, _e258, (_e258 > 0i)))];
let _e266 = ((9u * _e164) + _e166);
let _e267 = bitcast<i32>(_e266);
let _e269 = select(_e169, _e267, (_e267 < _e169));
let _e275 = global_7.member[bitcast<u32>(select(0i, _e269, (_e269 > 0i)))];
let _e277 = ((10u * _e164) + _e166);
let _e278 = bitcast<i32>(_e277);
let _e280 = select(_e169, _e278, (_e278 < _e169));
let _e286 = global_7.member[bitcast<u32>(select(0i, _e280, (_e280 > 0i)))];
let _e288 = ((11u * _e164) + _e166);
let _e289 = bitcast<i32>(_e288);
let _e291 = select(_e169, _e289, (_e289 < _e169));
let _e297 = global_7.member[bitcast<u32>(select(0i, _e291, (_e291 > 0i)))];
let _e299 = ((12u * _e164) + _e166);
let _e300 = bitcast<i32>(_e299);
let _e302 = select(_e169, _e300, (_e300 < _e169));
let _e308 = global_7.member[bitcast<u32>(select(0i, _e302, (_e302 > 0i)))];
let _e310 = ((13u * _e164) + _e166);
let _e311 = bitcast<i32>(_e310);
let _e313 = select(_e169, _e311, (_e311 < _e169));
let _e319 = global_7.member[bitcast<u32>(select(0i, _e313, (_e313 > 0i)))];
let _e321 = ((14u * _e164) + _e166);
let _e322 = bitcast<i32>(_e321);
let _e324 = select(_e169, _e322, (_e322 < _e169));
let _e330 = global_7.member[bitcast<u32>(select(0i, _e324, (_e324 > 0i)))];
let _e332 = ((15u * _e164) + _e166);
let _e333 = bitcast<i32>(_e332);
let _e335 = select(_e169, _e333, (_e333 < _e169));
let _e341 = global_7.member[bitcast<u32>(select(0i, _e335, (_e335 > 0i)))];
let _e343 = ((16u * _e164) + _e166);
let _e344 = bitcast<i32>(_e343);
let _e346 = select(_e169, _e344, (_e344 < _e169));
let _e352 = global_7.member[bitcast<u32>(select(0i, _e346, (_e346 > 0i)))];
let _e354 = ((17u * _e164) + _e166);
let _e355 = bitcast<i32>(_e354);
let _e357 = select(_e169, _e355, (_e355 < _e169));
let _e363 = global_7.member[bitcast<u32>(select(0i, _e357, (_e357 > 0i)))];
let _e367 = global_1.member.member.member;
let _e370 = bitcast<i32>(((_e140.y * _e367) + _e140.x));
local_35 = _e370;
let _e374 = global_1.member.member.member_1;
let _e376 = bitcast<i32>((_e367 * _e374));
local_36 = _e376;
let _e377 = local_36;
let _e379 = local_35;
let _e380 = ((6i * _e377) + _e379);
let _e382 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e384 = select(_e382, _e380, (_e380 < _e382));
let _e389 = global_2.member[bitcast<u32>(select(0i, _e384, (_e384 > 0i)))];
let _e390 = local_36;
let _e392 = local_35;
let _e393 = ((7i * _e390) + _e392);
let _e395 = select(_e382, _e393, (_e393 < _e382));
let _e400 = global_2.member[bitcast<u32>(select(0i, _e395, (_e395 > 0i)))];
let _e401 = local_36;
let _e403 = local_35;
let _e404 = ((8i * _e401) + _e403);
let _e406 = select(_e382, _e404, (_e404 < _e382));
let _e411 = global_2.member[bitcast<u32>(select(0i, _e406, (_e406 > 0i)))];
local_33 = _e370;
local_34 = _e376;
let _e414 = local_34;
let _e416 = local_33;
let _e417 = ((22i * _e414) + _e416);
let _e419 = select(_e382, _e417, (_e417 < _e382));
let _e424 = global_2.member[bitcast<u32>(select(0i, _e419, (_e419 > 0i)))];
let _e425 = local_34;
let _e427 = local_33;
let _e428 = ((23i * _e425) + _e427);
let _e430 = select(_e382, _e428, (_e428 < _e382));
let _e435 = global_2.member[bitcast<u32>(select(0i, _e430, (_e430 > 0i)))];
let _e436 = local_34;
let _e438 = local_33;
let _e439 = ((24i * _e436) + _e438);
let _e441 = select(_e382, _e439, (_e439 < _e382));
let _e446 = global_2.member[bitcast<u32>(select(0i, _e441, (_e441 > 0i)))];
if (select(0u, 3u, ((((_e389 + _e400) + _e411) + ((_e424 + _e435) + _e446)) > 0f)) > 1u) {
local_31 = _e370;
local_32 = _e376;
let _e454 = bitcast<i32>(_e140.x);
let _e455 = bitcast<i32>(_e140.y);
let _e456 = local_32;
let _e458 = local_31;
let _e459 = ((18i * _e456) + _e458);
let _e461 = select(_e382, _e459, (_e459 < _e382));
let _e466 = global_2.member[bitcast<u32>(select(0i, _e461, (_e461 > 0i)))];
let _e467 = local_32;
let _e469 = local_31;
let _e470 = ((16i * _e467) + _e469);
let _e472 = select(_e382, _e470, (_e470 < _e382));
let _e477 = global_2.member[bitcast<u32>(select(0i, _e472, (_e472 > 0i)))];
let _e478 = (_e454 - 1i);
let _e479 = bitcast<i32>(_e367);
let _e480 = bitcast<i32>(_e374);
local_28 = _e479;
local_29 = _e480;
let _e482 = local_28;
let _e485 = (_e455 >= 0i);
let _e487 = local_29;
let _e489 = ((((_e478 >= 0i) && (_e478 < _e482)) && _e485) && (_e455 < _e487));
if _e489 {
let _e490 = local_28;
local_30 = ((_e455 * _e490) + _e478);
} else {
local_30 = 0i;
}
let _e493 = local_28;
let _e494 = local_29;
let _e497 = local_30;
let _e498 = ((18i * (_e493 * _e494)) + _e497);
let _e500 = select(_e382, _e498, (_e498 < _e382));
let _e505 = global_2.member[bitcast<u32>(select(0i, _e500, (_e500 > 0i)))];
let _e508 = local_28;
let _e509 = local_29;
let _e512 = local_30;
let _e513 = ((16i * (_e508 * _e509)) + _e512);
let _e515 = select(_e382, _e513, (_e513 < _e382));
let _e520 = global_2.member[bitcast<u32>(select(0i, _e515, (_e515 > 0i)))];
let _e522 = ((_e489 && (_e505 == _e466)) && (_e520 == _e477));
let _e523 = local_30;
local_26 = _e523;
local_27 = _e376;
let _e524 = local_27;
let _e526 = local_26;
let _e527 = ((3i * _e524) + _e526);
let _e529 = select(_e382, _e527, (_e527 < _e382));
let _e534 = global_2.member[bitcast<u32>(select(0i, _e529, (_e529 > 0i)))];
let _e535 = local_27;
let _e537 = local_26;
let _e538 = ((4i * _e535) + _e537);
let _e540 = select(_e382, _e538, (_e538 < _e382));
let _e545 = global_2.member[bitcast<u32>(select(0i, _e540, (_e540 > 0i)))];
let _e546 = local_27;
let _e548 = local_26;
let _e549 = ((5i * _e546) + _e548);
let _e551 = select(_e382, _e549, (_e549 < _e382));
let _e556 = global_2.member[bitcast<u32>(select(0i, _e551, (_e551 > 0i)))];
let _e557 = (_e454 + 1i);
local_23 = _e479;
local_24 = _e480;
let _e559 = local_23;
let _e563 = local_24;
let _e565 = ((((_e557 >= 0i) && (_e557 < _e559)) && _e485) && (_e455 < _e563));
if _e565 {
let _e566 = local_23;
local_25 = ((_e455 * _e566) + _e557);
} else {
local_25 = 0i;
}
let _e569 = local_23;
let _e570 = local_24;
let _e573 = local_25;
let _e574 = ((18i * (_e569 * _e570)) + _e573);
let _e576 = select(_e382, _e574, (_e574 < _e382));
let _e581 = global_2.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e584 = local_23;
let _e585 = local_24;
let _e588 = local_25;
let _e589 = ((16i * (_e584 * _e585)) + _e588);
let _e591 = select(_e382, _e589, (_e589 < _e382));
let _e596 = global_2.member[bitcast<u32>(select(0i, _e591, (_e591 > 0i)))];
let _e598 = ((_e565 && (_e581 == _e466)) && (_e596 == _e477));
let _e599 = local_25;
local_21 = _e599;
local_22 = _e376;
let _e600 = local_22;
let _e602 = local_21;
let _e603 = ((3i * _e600) + _e602);
let _e605 = select(_e382, _e603, (_e603 < _e382));
let _e610 = global_2.member[bitcast<u32>(select(0i, _e605, (_e605 > 0i)))];
let _e611 = local_22;
let _e613 = local_21;
let _e614 = ((4i * _e611) + _e613);
let _e616 = select(_e382, _e614, (_e614 < _e382));
let _e621 = global_2.member[bitcast<u32>(select(0i, _e616, (_e616 > 0i)))];
let _e622 = local_22;
let _e624 = local_21;
let _e625 = ((5i * _e622) + _e624);
let _e627 = select(_e382, _e625, (_e625 < _e382));
let _e632 = global_2.member[bitcast<u32>(select(0i, _e627, (_e627 > 0i)))];
let _e633 = (_e455 - 1i);
local_18 = _e479;
local_19 = _e480;
let _e634 = (_e454 >= 0i);
let _e635 = local_18;
let _e640 = local_19;
let _e642 = (((_e634 && (_e454 < _e635)) && (_e633 >= 0i)) && (_e633 < _e640));
if _e642 {
let _e643 = local_18;
local_20 = ((_e633 * _e643) + _e454);
} else {
local_20 = 0i;
}
let _e646 = local_18;
let _e647 = local_19;
let _e650 = local_20;
let _e651 = ((18i * (_e646 * _e647)) + _e650);
let _e653 = select(_e382, _e651, (_e651 < _e382));
let _e658 = global_2.member[bitcast<u32>(select(0i, _e653, (_e653 > 0i)))];
let _e661 = local_18;
let _e662 = local_19;
let _e665 = local_20;
let _e666 = ((16i * (_e661 * _e662)) + _e665);
let _e668 = select(_e382, _e666, (_e666 < _e382));
let _e673 = global_2.member[bitcast<u32>(select(0i, _e668, (_e668 > 0i)))];
let _e675 = ((_e642 && (_e658 == _e466)) && (_e673 == _e477));
let _e676 = local_20;
local_16 = _e676;
local_17 = _e376;
let _e677 = local_17;
let _e679 = local_16;
let _e680 = ((3i * _e677) + _e679);
let _e682 = select(_e382, _e680, (_e680 < _e382));
let _e687 = global_2.member[bitcast<u32>(select(0i, _e682, (_e682 > 0i)))];
let _e688 = local_17;
let _e690 = local_16;
let _e691 = ((4i * _e688) + _e690);
let _e693 = select(_e382, _e691, (_e691 < _e382));
let _e698 = global_2.member[bitcast<u32>(select(0i, _e693, (_e693 > 0i)))];
let _e699 = local_17;
let _e701 = local_16;
let _e702 = ((5i * _e699) + _e701);
let _e704 = select(_e382, _e702, (_e702 < _e382));
let _e709 = global_2.member[bitcast<u32>(select(0i, _e704, (_e704 > 0i)))];
let _e710 = (_e455 + 1i);
local_13 = _e479;
local_14 = _e480;
let _e711 = local_13;
let _e716 = local_14;
let _e718 = (((_e634 && (_e454 < _e711)) && (_e710 >= 0i)) && (_e710 < _e716));
if _e718 {
let _e719 = local_13;
local_15 = ((_e710 * _e719) + _e454);
} else {
local_15 = 0i;
}
let _e722 = local_13;
let _e723 = local_14;
let _e726 = local_15;
let _e727 = ((18i * (_e722 * _e723)) + _e726);
let _e729 = select(_e382, _e727, (_e727 < _e382));
let _e734 = global_2.member[bitcast<u32>(select(0i, _e729, (_e729 > 0i)))];
let _e737 = local_13;
let _e738 = local_14;
let _e741 = local_15;
let _e742 = ((16i * (_e737 * _e738)) + _e741);
let _e744 = select(_e382, _e742, (_e742 < _e382));
let _e749 = global_2.member[bitcast<u32>(select(0i, _e744, (_e744 > 0i)))];
let _e751 = ((_e718 && (_e734 == _e466)) && (_e749 == _e477));
let _e752 = local_15;
local_11 = _e752;
local_12 = _e376;
let _e753 = local_12;
let _e755 = local_11;
let _e756 = ((3i * _e753) + _e755);
let _e758 = select(_e382, _e756, (_e756 < _e382));
let _e763 = global_2.member[bitcast<u32>(select(0i, _e758, (_e758 > 0i)))];
let _e764 = local_12;
let _e766 = local_11;
let _e767 = ((4i * _e764) + _e766);
let _e769 = select(_e382, _e767, (_e767 < _e382));
let _e774 = global_2.member[bitcast<u32>(select(0i, _e769, (_e769 > 0i)))];
let _e775 = local_12;
let _e777 = local_11;
let _e778 = ((5i * _e775) + _e777);
let _e780 = select(_e382, _e778, (_e778 < _e382));
let _e785 = global_2.member[bitcast<u32>(select(0i, _e780, (_e780 > 0i)))];
let _e786 = f32(_e479);
let _e796 = global_1.member.member_6.member;
let _e797 = (((((f32(_e557) + 0.5f) / _e786) * 2f) - 1f) * _e796);
let _e806 = global_1.member.member_6.member_1;
let _e807 = ((1f - (((f32(_e455) + 0.5f) / f32(_e480)) * 2f)) * _e806);
let _e810 = global_1.member.member_7;
let _e819 = global_1.member.member_8;
let _e823 = (_e819.member * _e807);
let _e824 = (_e819.member_1 * _e807);
let _e825 = (_e819.member_2 * _e807);
let _e832 = global_1.member.member_6.member_3;
let _e834 = select(1f, 0f, (_e832 != 0u));
let _e837 = global_1.member.member_9;
let _e844 = (_e837.member + (((_e810.member * _e797) + _e823) * _e834));
let _e845 = (_e837.member_1 + (((_e810.member_1 * _e797) + _e824) * _e834));
let _e846 = (_e837.member_2 + (((_e810.member_2 * _e797) + _e825) * _e834));
let _e851 = (((_e844 * _e844) + (_e845 * _e845)) + (_e846 * _e846));
let _e854 = sqrt(select(0f, _e851, (_e851 > 0f)));
let _e857 = (1f / select(1e-20f, _e854, (_e854 > 1e-20f)));
let _e866 = (((((f32(_e454) + 0.5f) / _e786) * 2f) - 1f) * _e796);
let _e876 = (_e837.member + (((_e810.member * _e866) + _e823) * _e834));
let _e877 = (_e837.member_1 + (((_e810.member_1 * _e866) + _e824) * _e834));
let _e878 = (_e837.member_2 + (((_e810.member_2 * _e866) + _e825) * _e834));
let _e883 = (((_e876 * _e876) + (_e877 * _e877)) + (_e878 * _e878));
let _e886 = sqrt(select(0f, _e883, (_e883 > 0f)));
let _e889 = (1f / select(1e-20f, _e886, (_e886 > 1e-20f)));
let _e893 = ((_e844 * _e857) - (_e876 * _e889));
let _e894 = ((_e845 * _e857) - (_e877 * _e889));
let _e895 = ((_e846 * _e857) - (_e878 * _e889));
let _e900 = (((_e893 * _e893) + (_e894 * _e894)) + (_e895 * _e895));
let _e903 = sqrt(select(0f, _e900, (_e900 > 0f)));
let _e904 = local_31;
local_7 = _e904;
local_8 = _e376;
let _e905 = local_7;
local_9 = _e905;
local_10 = _e376;
let _e906 = local_10;
let _e908 = local_9;
let _e909 = ((3i * _e906) + _e908);
let _e911 = select(_e382, _e909, (_e909 < _e382));
let _e916 = global_2.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e917 = local_10;
let _e919 = local_9;
let _e920 = ((4i * _e917) + _e919);
let _e922 = select(_e382, _e920, (_e920 < _e382));
let _e927 = global_2.member[bitcast<u32>(select(0i, _e922, (_e922 > 0i)))];
let _e928 = local_10;
let _e930 = local_9;
let _e931 = ((5i * _e928) + _e930);
let _e933 = select(_e382, _e931, (_e931 < _e382));
let _e938 = global_2.member[bitcast<u32>(select(0i, _e933, (_e933 > 0i)))];
let _e939 = local_8;
let _e941 = local_7;
let _e942 = ((18i * _e939) + _e941);
let _e944 = select(_e382, _e942, (_e942 < _e382));
let _e949 = global_2.member[bitcast<u32>(select(0i, _e944, (_e944 > 0i)))];
let _e951 = (_e610 - _e534);
let _e952 = (_e621 - _e545);
let _e953 = (_e632 - _e556);
let _e958 = (((_e951 * _e951) + (_e952 * _e952)) + (_e953 * _e953));
let _e963 = (_e610 - _e916);
let _e964 = (_e621 - _e927);
let _e965 = (_e632 - _e938);
let _e970 = (((_e963 * _e963) + (_e964 * _e964)) + (_e965 * _e965));
let _e974 = (_e916 - _e534);
let _e975 = (_e927 - _e545);
let _e976 = (_e938 - _e556);
let _e981 = (((_e974 * _e974) + (_e975 * _e975)) + (_e976 * _e976));
let _e989 = select(select(_e903, select(sqrt(select(0f, _e981, (_e981 > 0f))), sqrt(select(0f, _e970, (_e970 > 0f))), _e598), (_e522 || _e598)), (0.5f * sqrt(select(0f, _e958, (_e958 > 0f)))), (_e522 && _e598));
let _e990 = (_e763 - _e687);
let _e991 = (_e774 - _e698);
let _e992 = (_e785 - _e709);
let _e997 = (((_e990 * _e990) + (_e991 * _e991)) + (_e992 * _e992));
let _e1002 = (_e763 - _e916);
let _e1003 = (_e774 - _e927);
let _e1004 = (_e785 - _e938);
let _e1009 = (((_e1002 * _e1002) + (_e1003 * _e1003)) + (_e1004 * _e1004));
let _e1013 = (_e916 - _e687);
let _e1014 = (_e927 - _e698);
let _e1015 = (_e938 - _e709);
let _e1020 = (((_e1013 * _e1013) + (_e1014 * _e1014)) + (_e1015 * _e1015));
let _e1028 = select(select(_e903, select(sqrt(select(0f, _e1020, (_e1020 > 0f))), sqrt(select(0f, _e1009, (_e1009 > 0f))), _e751), (_e675 || _e751)), (0.5f * sqrt(select(0f, _e997, (_e997 > 0f)))), (_e675 && _e751));
let _e1031 = select(_e903, select(_e1028, _e989, (_e989 > _e1028)), (_e949 > 0f));
let _e1035 = global_1.member.member_16.member_4;
let _e1043 = (((_e1035.member * _e916) + (_e1035.member_1 * _e927)) + (_e1035.member_2 * _e938));
let _e1047 = global_1.member.member_16.member_5;
let _e1055 = (((_e1047.member * _e916) + (_e1047.member_1 * _e927)) + (_e1047.member_2 * _e938));
let _e1059 = global_1.member.member_16.member_6;
let _e1067 = (((_e1059.member * _e916) + (_e1059.member_1 * _e927)) + (_e1059.member_2 * _e938));
let _e1071 = global_1.member.member_16.member;
let _e1075 = global_1.member.member_16.member_7;
let _e1079 = vec3<f32>(_e1075.member, _e1075.member_1, _e1075.member_2);
let _e1083 = global_1.member.member_16.member_8;
if (_e1071 == 0u) {
phi_4068_ = _e1079;
} else {
if (_e1071 == 1u) {
let _e1090 = select(-1f, _e1067, (_e1067 > -1f));
let _e1092 = select(1f, _e1090, (_e1090 < 1f));
if (_e1092 > 0f) {
phi_2683_ = _e1079;
} else {
let _e1097 = global_1.member.member_16.member_9;
phi_2683_ = vec3<f32>(_e1097.member, _e1097.member_1, _e1097.member_2);
}
let _e1103 = phi_2683_;
let _e1112 = bitcast<f32>((bitcast<u32>(_e1092) & 2147483647u));
let _e1115 = sqrt(select(0f, _e1112, (_e1112 > 0f)));
phi_4067_ = vec3<f32>((_e1083.member + ((_e1103.x - _e1083.member) * _e1115)), (_e1083.member_1 + ((_e1103.y - _e1083.member_1) * _e1115)), (_e1083.member_2 + ((_e1103.z - _e1083.member_2) * _e1115)));
} else {
if (_e1071 == 2u) {
let _e1127 = global_1.member.member_16.member_10;
let _e1128 = (_e1031 / _e1127);
let _e1130 = select(1e-4f, _e1128, (_e1128 > 1e-4f));
let _e1133 = bitcast<f32>((bitcast<u32>(_e1043) & 2147483647u));
let _e1136 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
let _e1140 = select(_e1136, _e1133, (_e1133 > _e1136));
let _e1143 = (select(_e1136, _e1133, (_e1133 < _e1136)) / select(1.1754944e-38f, _e1140, (_e1140 > 1.1754944e-38f)));
let _e1144 = (_e1143 > 0.41421357f);
let _e1148 = select(_e1143, ((_e1143 - 1f) / (_e1143 + 1f)), _e1144);
let _e1149 = (_e1148 * _e1148);
let _e1164 = (select(0f, 0.7853982f, _e1144) + (_e1148 + ((_e1148 * _e1149) * (-0.33333334f + (_e1149 * (0.2f + (_e1149 * (-0.14285713f + (_e1149 * (0.11111111f + (_e1149 * (-0.09090909f + (_e1149 * 0.0585f)))))))))))));
let _e1167 = select(_e1164, (1.5707964f - _e1164), (_e1136 > _e1133));
let _e1170 = select(_e1167, (3.1415927f - _e1167), (_e1043 < 0f));
let _e1176 = (1f - (_e1067 * _e1067));
let _e1179 = sqrt(select(0f, _e1176, (_e1176 > 0f)));
let _e1182 = (_e1130 / select(1e-3f, _e1179, (_e1179 > 1e-3f)));
let _e1183 = ((select(_e1170, -(_e1170), (_e1055 < 0f)) / _e1127) * 0.5f);
let _e1185 = select(-8e6f, _e1183, (_e1183 > -8e6f));
let _e1187 = select(8e6f, _e1185, (_e1185 < 8e6f));
let _e1194 = select(0i, select(select(i32(_e1187), i32(-2147483648), (_e1187 < -2147483600f)), 2147483647i, (_e1187 > 2147483500f)), (_e1187 == _e1187));
let _e1201 = ((_e1183 - f32((_e1194 - select(0i, 1i, (_e1187 < f32(_e1194)))))) * 2f);
let _e1209 = ((select(select((_e1201 - 2f), (1f - _e1201), (_e1201 < 1.5f)), _e1201, (_e1201 < 0.5f)) * 2f) / _e1182);
let _e1211 = select(-1f, _e1209, (_e1209 > -1f));
let _e1214 = (2f - _e1182);
let _e1216 = select(0f, _e1214, (_e1214 > 0f));
let _e1221 = select(-1f, _e1067, (_e1067 > -1f));
let _e1223 = select(1f, _e1221, (_e1221 < 1f));
let _e1226 = ((1f - _e1223) * (1f + _e1223));
let _e1229 = sqrt(select(0f, _e1226, (_e1226 > 0f)));
let _e1232 = bitcast<f32>((bitcast<u32>(_e1229) & 2147483647u));
let _e1235 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
let _e1239 = select(_e1235, _e1232, (_e1232 > _e1235));
let _e1242 = (select(_e1235, _e1232, (_e1232 < _e1235)) / select(1.1754944e-38f, _e1239, (_e1239 > 1.1754944e-38f)));
let _e1243 = (_e1242 > 0.41421357f);
let _e1247 = select(_e1242, ((_e1242 - 1f) / (_e1242 + 1f)), _e1243);
let _e1248 = (_e1247 * _e1247);
let _e1263 = (select(0f, 0.7853982f, _e1243) + (_e1247 + ((_e1247 * _e1248) * (-0.33333334f + (_e1248 * (0.2f + (_e1248 * (-0.14285713f + (_e1248 * (0.11111111f + (_e1248 * (-0.09090909f + (_e1248 * 0.0585f)))))))))))));
let _e1266 = select(_e1263, (1.5707964f - _e1263), (_e1235 > _e1232));
let _e1269 = select(_e1266, (3.1415927f - _e1266), (_e1229 < 0f));
let _e1274 = ((select(_e1269, -(_e1269), (_e1223 < 0f)) / _e1127) * 0.5f);
let _e1276 = select(-8e6f, _e1274, (_e1274 > -8e6f));
let _e1278 = select(8e6f, _e1276, (_e1276 < 8e6f));
let _e1285 = select(0i, select(select(i32(_e1278), i32(-2147483648), (_e1278 < -2147483600f)), 2147483647i, (_e1278 > 2147483500f)), (_e1278 == _e1278));
let _e1292 = ((_e1274 - f32((_e1285 - select(0i, 1i, (_e1278 < f32(_e1285)))))) * 2f);
let _e1300 = ((select(select((_e1292 - 2f), (1f - _e1292), (_e1292 < 1.5f)), _e1292, (_e1292 < 0.5f)) * 2f) / _e1130);
let _e1302 = select(-1f, _e1300, (_e1300 > -1f));
let _e1305 = (2f - _e1130);
let _e1307 = select(0f, _e1305, (_e1305 > 0f));
let _e1313 = (0.5f + ((0.5f * (select(1f, _e1211, (_e1211 < 1f)) * select(1f, _e1216, (_e1216 < 1f)))) * (select(1f, _e1302, (_e1302 < 1f)) * select(1f, _e1307, (_e1307 < 1f)))));
phi_4066_ = vec3<f32>((_e1075.member + ((_e1083.member - _e1075.member) * _e1313)), (_e1075.member_1 + ((_e1083.member_1 - _e1075.member_1) * _e1313)), (_e1075.member_2 + ((_e1083.member_2 - _e1075.member_2) * _e1313)));
} else {
let _e1327 = global_1.member.member_16.member_1;
let _e1328 = bitcast<i32>(_e1327);
let _e1333 = global_1.member.member_16.member_3;
let _e1335 = f32(bitcast<i32>(_e1333));
let _e1337 = (2f * 3.1415927f);
let _e1338 = ((_e1031 * f32(_e1328)) / _e1337);
let _e1340 = select(1e-6f, _e1338, (_e1338 > 1e-6f));
let _e1343 = bitcast<u32>(select(1.1754944e-38f, _e1340, (_e1340 > 1.1754944e-38f)));
let _e1344 = (_e1343 & 8388607u);
let _e1346 = select(0u, 1u, (_e1344 > 3474675u));
let _e1357 = bitcast<f32>((_e1344 | ((127u - _e1346) << bitcast<u32>(23i))));
let _e1360 = ((_e1357 - 1f) / (_e1357 + 1f));
let _e1361 = (_e1360 * _e1360);
let _e1376 = (f32(((bitcast<i32>((_e1343 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1346))) + (((2f * _e1360) + ((_e1360 * _e1361) * (0.6666667f + (_e1361 * (0.4f + (_e1361 * (0.2857143f + (_e1361 * (0.22222222f + (_e1361 * 0.18181819f)))))))))) * 1.442695f));
let _e1377 = (_e1335 - 1f);
let _e1379 = select(0f, _e1376, (_e1376 > 0f));
let _e1381 = select(_e1377, _e1379, (_e1379 < _e1377));
let _e1382 = (_e1335 - 2f);
let _e1384 = select(0f, _e1382, (_e1382 > 0f));
let _e1386 = select(0f, _e1381, (_e1381 > 0f));
let _e1388 = select(_e1384, _e1386, (_e1386 < _e1384));
let _e1395 = select(0i, select(select(i32(_e1388), i32(-2147483648), (_e1388 < -2147483600f)), 2147483647i, (_e1388 > 2147483500f)), (_e1388 == _e1388));
let _e1399 = (_e1395 - select(0i, 1i, (_e1388 < f32(_e1395))));
let _e1402 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
let _e1405 = bitcast<f32>((bitcast<u32>(_e1043) & 2147483647u));
let _e1409 = select(_e1405, _e1402, (_e1402 > _e1405));
let _e1412 = (select(_e1405, _e1402, (_e1402 < _e1405)) / select(1.1754944e-38f, _e1409, (_e1409 > 1.1754944e-38f)));
let _e1413 = (_e1412 > 0.41421357f);
let _e1417 = select(_e1412, ((_e1412 - 1f) / (_e1412 + 1f)), _e1413);
let _e1418 = (_e1417 * _e1417);
let _e1433 = (select(0f, 0.7853982f, _e1413) + (_e1417 + ((_e1417 * _e1418) * (-0.33333334f + (_e1418 * (0.2f + (_e1418 * (-0.14285713f + (_e1418 * (0.11111111f + (_e1418 * (-0.09090909f + (_e1418 * 0.0585f)))))))))))));
let _e1436 = select(_e1433, (1.5707964f - _e1433), (_e1405 > _e1402));
let _e1439 = select(_e1436, (3.1415927f - _e1436), (_e1055 < 0f));
let _e1444 = (0.5f - (select(_e1439, -(_e1439), (_e1043 < 0f)) / _e1337));
let _e1446 = select(-1f, _e1067, (_e1067 > -1f));
let _e1448 = select(1f, _e1446, (_e1446 < 1f));
let _e1451 = ((1f - _e1448) * (1f + _e1448));
let _e1454 = sqrt(select(0f, _e1451, (_e1451 > 0f)));
let _e1457 = bitcast<f32>((bitcast<u32>(_e1454) & 2147483647u));
let _e1460 = bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u));
let _e1464 = select(_e1460, _e1457, (_e1457 > _e1460));
let _e1467 = (select(_e1460, _e1457, (_e1457 < _e1460)) / select(1.1754944e-38f, _e1464, (_e1464 > 1.1754944e-38f)));
let _e1468 = (_e1467 > 0.41421357f);
let _e1472 = select(_e1467, ((_e1467 - 1f) / (_e1467 + 1f)), _e1468);
let _e1473 = (_e1472 * _e1472);
let _e1488 = (select(0f, 0.7853982f, _e1468) + (_e1472 + ((_e1472 * _e1473) * (-0.33333334f + (_e1473 * (0.2f + (_e1473 * (-0.14285713f + (_e1473 * (0.11111111f + (_e1473 * (-0.09090909f + (_e1473 * 0.0585f)))))))))))));
let _e1491 = select(_e1488, (1.5707964f - _e1488), (_e1460 > _e1457));
let _e1494 = select(_e1491, (3.1415927f - _e1491), (_e1454 < 0f));
let _e1499 = (0.5f - (select(_e1494, -(_e1494), (_e1448 < 0f)) / 3.1415927f));
let _e1503 = global_1.member.member_16.member_2;
let _e1504 = bitcast<i32>(_e1503);
phi_3285_ = 0i;
phi_3288_ = 0i;
phi_3290_ = _e1504;
phi_3292_ = _e1328;
loop {
let _e1506 = phi_3285_;
let _e1508 = phi_3288_;
let _e1510 = phi_3290_;
let _e1512 = phi_3292_;
local_37 = _e1512;
local_38 = _e1510;
local_39 = _e1512;
local_40 = _e1512;
local_41 = _e1512;
local_42 = _e1512;
local_43 = _e1512;
local_44 = _e1512;
local_45 = _e1510;
local_46 = _e1510;
local_47 = _e1510;
local_48 = _e1510;
local_49 = _e1512;
local_50 = _e1508;
local_51 = _e1512;
local_52 = _e1508;
let _e1513 = (_e1506 < _e1399);
if _e1513 {
if (_e1512 > 1i) {
phi_3307_ = (_e1512 >> bitcast<u32>(1i));
} else {
phi_3307_ = 1i;
}
let _e1520 = phi_3307_;
if (_e1510 > 1i) {
phi_3313_ = (_e1510 >> bitcast<u32>(1i));
} else {
phi_3313_ = 1i;
}
let _e1525 = phi_3313_;
phi_3286_ = (_e1506 + 1i);
phi_3289_ = (_e1508 + (_e1512 * _e1510));
phi_3291_ = _e1525;
phi_3293_ = _e1520;
} else {
phi_3286_ = i32();
phi_3289_ = i32();
phi_3291_ = i32();
phi_3293_ = i32();
}
let _e1528 = phi_3286_;
let _e1530 = phi_3289_;
let _e1532 = phi_3291_;
let _e1534 = phi_3293_;
continue;
continuing {
phi_3285_ = _e1528;
phi_3288_ = _e1530;
phi_3290_ = _e1532;
phi_3292_ = _e1534;
break if !(_e1513);
}
}
let _e1537 = local_37;
let _e1538 = f32(_e1537);
let _e1540 = ((_e1444 * _e1538) - 0.5f);
let _e1542 = local_38;
let _e1543 = f32(_e1542);
let _e1545 = ((_e1499 * _e1543) - 0.5f);
let _e1547 = select(-1f, _e1540, (_e1540 > -1f));
let _e1549 = select(_e1538, _e1547, (_e1547 < _e1538));
let _e1556 = select(0i, select(select(i32(_e1549), i32(-2147483648), (_e1549 < -2147483600f)), 2147483647i, (_e1549 > 2147483500f)), (_e1549 == _e1549));
let _e1560 = (_e1556 - select(0i, 1i, (_e1549 < f32(_e1556))));
let _e1562 = select(-1f, _e1545, (_e1545 > -1f));
let _e1564 = select(_e1543, _e1562, (_e1562 < _e1543));
let _e1571 = select(0i, select(select(i32(_e1564), i32(-2147483648), (_e1564 < -2147483600f)), 2147483647i, (_e1564 > 2147483500f)), (_e1564 == _e1564));
let _e1575 = (_e1571 - select(0i, 1i, (_e1564 < f32(_e1571))));
let _e1577 = (_e1540 - f32(_e1560));
let _e1579 = (_e1545 - f32(_e1575));
let _e1581 = select(0f, _e1579, (_e1579 > 0f));
let _e1583 = select(1f, _e1581, (_e1581 < 1f));
if (_e1560 < 0i) {
let _e1586 = local_39;
phi_3388_ = (_e1560 + _e1586);
} else {
phi_3388_ = _e1560;
}
let _e1589 = phi_3388_;
let _e1591 = local_40;
if (_e1589 >= _e1591) {
let _e1594 = local_41;
phi_3394_ = (_e1589 - _e1594);
} else {
phi_3394_ = _e1589;
}
let _e1597 = phi_3394_;
let _e1598 = (_e1560 + 1i);
if (_e1598 < 0i) {
let _e1601 = local_42;
phi_3401_ = (_e1598 + _e1601);
} else {
phi_3401_ = _e1598;
}
let _e1604 = phi_3401_;
let _e1606 = local_43;
if (_e1604 >= _e1606) {
let _e1609 = local_44;
phi_3407_ = (_e1604 - _e1609);
} else {
phi_3407_ = _e1604;
}
let _e1612 = phi_3407_;
let _e1614 = select(_e1575, 0i, (_e1575 < 0i));
let _e1616 = local_45;
if (_e1614 >= _e1616) {
let _e1619 = local_46;
phi_3418_ = (_e1619 - 1i);
} else {
phi_3418_ = _e1614;
}
let _e1622 = phi_3418_;
let _e1623 = (_e1575 + 1i);
let _e1625 = select(_e1623, 0i, (_e1623 < 0i));
let _e1627 = local_47;
if (_e1625 >= _e1627) {
let _e1630 = local_48;
phi_3430_ = (_e1630 - 1i);
} else {
phi_3430_ = _e1625;
}
let _e1633 = phi_3430_;
let _e1635 = local_49;
let _e1638 = local_50;
let _e1639 = (_e1638 + (_e1622 * _e1635));
let _e1641 = local_51;
let _e1644 = local_52;
let _e1645 = (_e1644 + (_e1633 * _e1641));
let _e1647 = (3i * (_e1639 + _e1597));
let _e1649 = (bitcast<i32>(_e146) - 1i);
let _e1651 = select(_e1649, _e1647, (_e1647 < _e1649));
let _e1657 = global_3.member[bitcast<u32>(select(0i, _e1651, (_e1651 > 0i)))];
let _e1658 = (_e1647 + 1i);
let _e1660 = select(_e1649, _e1658, (_e1658 < _e1649));
let _e1666 = global_3.member[bitcast<u32>(select(0i, _e1660, (_e1660 > 0i)))];
let _e1667 = (_e1647 + 2i);
let _e1669 = select(_e1649, _e1667, (_e1667 < _e1649));
let _e1675 = global_3.member[bitcast<u32>(select(0i, _e1669, (_e1669 > 0i)))];
let _e1677 = (3i * (_e1639 + _e1612));
let _e1679 = select(_e1649, _e1677, (_e1677 < _e1649));
let _e1685 = global_3.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1686 = (_e1677 + 1i);
let _e1688 = select(_e1649, _e1686, (_e1686 < _e1649));
let _e1694 = global_3.member[bitcast<u32>(select(0i, _e1688, (_e1688 > 0i)))];
let _e1695 = (_e1677 + 2i);
let _e1697 = select(_e1649, _e1695, (_e1695 < _e1649));
let _e1703 = global_3.member[bitcast<u32>(select(0i, _e1697, (_e1697 > 0i)))];
let _e1705 = (3i * (_e1645 + _e1597));
let _e1707 = select(_e1649, _e1705, (_e1705 < _e1649));
let _e1713 = global_3.member[bitcast<u32>(select(0i, _e1707, (_e1707 > 0i)))];
let _e1714 = (_e1705 + 1i);
let _e1716 = select(_e1649, _e1714, (_e1714 < _e1649));
let _e1722 = global_3.member[bitcast<u32>(select(0i, _e1716, (_e1716 > 0i)))];
let _e1723 = (_e1705 + 2i);
let _e1725 = select(_e1649, _e1723, (_e1723 < _e1649));
let _e1731 = global_3.member[bitcast<u32>(select(0i, _e1725, (_e1725 > 0i)))];
let _e1733 = (3i * (_e1645 + _e1612));
let _e1735 = select(_e1649, _e1733, (_e1733 < _e1649));
let _e1741 = global_3.member[bitcast<u32>(select(0i, _e1735, (_e1735 > 0i)))];
let _e1742 = (_e1733 + 1i);
let _e1744 = select(_e1649, _e1742, (_e1742 < _e1649));
let _e1750 = global_3.member[bitcast<u32>(select(0i, _e1744, (_e1744 > 0i)))];
let _e1751 = (_e1733 + 2i);
let _e1753 = select(_e1649, _e1751, (_e1751 < _e1649));
let _e1759 = global_3.member[bitcast<u32>(select(0i, _e1753, (_e1753 > 0i)))];
let _e1766 = (_e1657 + ((_e1685 - _e1657) * _e1577));
let _e1767 = (_e1666 + ((_e1694 - _e1666) * _e1577));
let _e1768 = (_e1675 + ((_e1703 - _e1675) * _e1577));
let _e1784 = (_e1766 + (((_e1713 + ((_e1741 - _e1713) * _e1577)) - _e1766) * _e1583));
let _e1785 = (_e1767 + (((_e1722 + ((_e1750 - _e1722) * _e1577)) - _e1767) * _e1583));
let _e1786 = (_e1768 + (((_e1731 + ((_e1759 - _e1731) * _e1577)) - _e1768) * _e1583));
phi_3666_ = 0i;
phi_3669_ = 0i;
phi_3671_ = _e1504;
phi_3673_ = _e1328;
loop {
let _e1789 = phi_3666_;
let _e1791 = phi_3669_;
let _e1793 = phi_3671_;
let _e1795 = phi_3673_;
local_53 = _e1795;
local_54 = _e1793;
local_55 = _e1795;
local_56 = _e1795;
local_57 = _e1795;
local_58 = _e1795;
local_59 = _e1795;
local_60 = _e1795;
local_61 = _e1793;
local_62 = _e1793;
local_63 = _e1793;
local_64 = _e1793;
local_65 = _e1795;
local_66 = _e1791;
local_67 = _e1795;
local_68 = _e1791;
let _e1796 = (_e1789 < (_e1399 + 1i));
if _e1796 {
if (_e1795 > 1i) {
phi_3688_ = (_e1795 >> bitcast<u32>(1i));
} else {
phi_3688_ = 1i;
}
let _e1803 = phi_3688_;
if (_e1793 > 1i) {
phi_3694_ = (_e1793 >> bitcast<u32>(1i));
} else {
phi_3694_ = 1i;
}
let _e1808 = phi_3694_;
phi_3667_ = (_e1789 + 1i);
phi_3670_ = (_e1791 + (_e1795 * _e1793));
phi_3672_ = _e1808;
phi_3674_ = _e1803;
} else {
phi_3667_ = i32();
phi_3670_ = i32();
phi_3672_ = i32();
phi_3674_ = i32();
}
let _e1811 = phi_3667_;
let _e1813 = phi_3670_;
let _e1815 = phi_3672_;
let _e1817 = phi_3674_;
continue;
continuing {
phi_3666_ = _e1811;
phi_3669_ = _e1813;
phi_3671_ = _e1815;
phi_3673_ = _e1817;
break if !(_e1796);
}
}
let _e1820 = local_53;
let _e1821 = f32(_e1820);
let _e1823 = ((_e1444 * _e1821) - 0.5f);
let _e1825 = local_54;
let _e1826 = f32(_e1825);
let _e1828 = ((_e1499 * _e1826) - 0.5f);
let _e1830 = select(-1f, _e1823, (_e1823 > -1f));
let _e1832 = select(_e1821, _e1830, (_e1830 < _e1821));
let _e1839 = select(0i, select(select(i32(_e1832), i32(-2147483648), (_e1832 < -2147483600f)), 2147483647i, (_e1832 > 2147483500f)), (_e1832 == _e1832));
let _e1843 = (_e1839 - select(0i, 1i, (_e1832 < f32(_e1839))));
let _e1845 = select(-1f, _e1828, (_e1828 > -1f));
let _e1847 = select(_e1826, _e1845, (_e1845 < _e1826));
let _e1854 = select(0i, select(select(i32(_e1847), i32(-2147483648), (_e1847 < -2147483600f)), 2147483647i, (_e1847 > 2147483500f)), (_e1847 == _e1847));
let _e1858 = (_e1854 - select(0i, 1i, (_e1847 < f32(_e1854))));
let _e1860 = (_e1823 - f32(_e1843));
let _e1862 = (_e1828 - f32(_e1858));
let _e1864 = select(0f, _e1862, (_e1862 > 0f));
let _e1866 = select(1f, _e1864, (_e1864 < 1f));
if (_e1843 < 0i) {
let _e1869 = local_55;
phi_3769_ = (_e1843 + _e1869);
} else {
phi_3769_ = _e1843;
}
let _e1872 = phi_3769_;
let _e1874 = local_56;
if (_e1872 >= _e1874) {
let _e1877 = local_57;
phi_3775_ = (_e1872 - _e1877);
} else {
phi_3775_ = _e1872;
}
let _e1880 = phi_3775_;
let _e1881 = (_e1843 + 1i);
if (_e1881 < 0i) {
let _e1884 = local_58;
phi_3782_ = (_e1881 + _e1884);
} else {
phi_3782_ = _e1881;
}
let _e1887 = phi_3782_;
let _e1889 = local_59;
if (_e1887 >= _e1889) {
let _e1892 = local_60;
phi_3788_ = (_e1887 - _e1892);
} else {
phi_3788_ = _e1887;
}
let _e1895 = phi_3788_;
let _e1897 = select(_e1858, 0i, (_e1858 < 0i));
let _e1899 = local_61;
if (_e1897 >= _e1899) {
let _e1902 = local_62;
phi_3799_ = (_e1902 - 1i);
} else {
phi_3799_ = _e1897;
}
let _e1905 = phi_3799_;
let _e1906 = (_e1858 + 1i);
let _e1908 = select(_e1906, 0i, (_e1906 < 0i));
let _e1910 = local_63;
if (_e1908 >= _e1910) {
let _e1913 = local_64;
phi_3811_ = (_e1913 - 1i);
} else {
phi_3811_ = _e1908;
}
let _e1916 = phi_3811_;
let _e1918 = local_65;
let _e1921 = local_66;
let _e1922 = (_e1921 + (_e1905 * _e1918));
let _e1924 = local_67;
let _e1927 = local_68;
let _e1928 = (_e1927 + (_e1916 * _e1924));
let _e1930 = (3i * (_e1922 + _e1880));
let _e1932 = select(_e1649, _e1930, (_e1930 < _e1649));
let _e1938 = global_3.member[bitcast<u32>(select(0i, _e1932, (_e1932 > 0i)))];
let _e1939 = (_e1930 + 1i);
let _e1941 = select(_e1649, _e1939, (_e1939 < _e1649));
let _e1947 = global_3.member[bitcast<u32>(select(0i, _e1941, (_e1941 > 0i)))];
let _e1948 = (_e1930 + 2i);
let _e1950 = select(_e1649, _e1948, (_e1948 < _e1649));
let _e1956 = global_3.member[bitcast<u32>(select(0i, _e1950, (_e1950 > 0i)))];
let _e1958 = (3i * (_e1922 + _e1895));
let _e1960 = select(_e1649, _e1958, (_e1958 < _e1649));
let _e1966 = global_3.member[bitcast<u32>(select(0i, _e1960, (_e1960 > 0i)))];
let _e1967 = (_e1958 + 1i);
let _e1969 = select(_e1649, _e1967, (_e1967 < _e1649));
let _e1975 = global_3.member[bitcast<u32>(select(0i, _e1969, (_e1969 > 0i)))];
let _e1976 = (_e1958 + 2i);
let _e1978 = select(_e1649, _e1976, (_e1976 < _e1649));
let _e1984 = global_3.member[bitcast<u32>(select(0i, _e1978, (_e1978 > 0i)))];
let _e1986 = (3i * (_e1928 + _e1880));
let _e1988 = select(_e1649, _e1986, (_e1986 < _e1649));
let _e1994 = global_3.member[bitcast<u32>(select(0i, _e1988, (_e1988 > 0i)))];
let _e1995 = (_e1986 + 1i);
let _e1997 = select(_e1649, _e1995, (_e1995 < _e1649));
let _e2003 = global_3.member[bitcast<u32>(select(0i, _e1997, (_e1997 > 0i)))];
let _e2004 = (_e1986 + 2i);
let _e2006 = select(_e1649, _e2004, (_e2004 < _e1649));
let _e2012 = global_3.member[bitcast<u32>(select(0i, _e2006, (_e2006 > 0i)))];
let _e2014 = (3i * (_e1928 + _e1895));
let _e2016 = select(_e1649, _e2014, (_e2014 < _e1649));
let _e2022 = global_3.member[bitcast<u32>(select(0i, _e2016, (_e2016 > 0i)))];
let _e2023 = (_e2014 + 1i);
let _e2025 = select(_e1649, _e2023, (_e2023 < _e1649));
let _e2031 = global_3.member[bitcast<u32>(select(0i, _e2025, (_e2025 > 0i)))];
let _e2032 = (_e2014 + 2i);
let _e2034 = select(_e1649, _e2032, (_e2032 < _e1649));
let _e2040 = global_3.member[bitcast<u32>(select(0i, _e2034, (_e2034 > 0i)))];
let _e2047 = (_e1938 + ((_e1966 - _e1938) * _e1860));
let _e2048 = (_e1947 + ((_e1975 - _e1947) * _e1860));
let _e2049 = (_e1956 + ((_e1984 - _e1956) * _e1860));
let _e2072 = (_e1381 - f32(_e1399));
let _e2074 = select(0f, _e2072, (_e2072 > 0f));
let _e2076 = select(1f, _e2074, (_e2074 < 1f));
let _e2086 = global_1.member.member_16.member_11;
phi_4066_ = vec3<f32>(((_e1784 + (((_e2047 + (((_e1994 + ((_e2022 - _e1994) * _e1860)) - _e2047) * _e1866)) - _e1784) * _e2076)) * _e2086), ((_e1785 + (((_e2048 + (((_e2003 + ((_e2031 - _e2003) * _e1860)) - _e2048) * _e1866)) - _e1785) * _e2076)) * _e2086), ((_e1786 + (((_e2049 + (((_e2012 + ((_e2040 - _e2012) * _e1860)) - _e2049) * _e1866)) - _e1786) * _e2076)) * _e2086));
}
let _e2092 = phi_4066_;
phi_4067_ = _e2092;
}
let _e2094 = phi_4067_;
phi_4068_ = _e2094;
}
let _e2096 = phi_4068_;
let _e2098 = local_8;
let _e2100 = local_7;
let _e2101 = ((16i * _e2098) + _e2100);
let _e2103 = select(_e382, _e2101, (_e2101 < _e382));
let _e2108 = global_2.member[bitcast<u32>(select(0i, _e2103, (_e2103 > 0i)))];
if ((_e157.member_2 == 1u) && (_e2108 == 3f)) {
let _e2111 = local_8;
let _e2113 = local_7;
let _e2114 = ((30i * _e2111) + _e2113);
let _e2116 = select(_e382, _e2114, (_e2114 < _e382));
let _e2121 = global_2.member[bitcast<u32>(select(0i, _e2116, (_e2116 > 0i)))];
let _e2128 = select(0i, select(select(i32(_e2121), i32(-2147483648), (_e2121 < -2147483600f)), 2147483647i, (_e2121 > 2147483500f)), (_e2121 == _e2121));
let _e2129 = local_7;
local_5 = _e2129;
local_6 = _e376;
let _e2130 = local_5;
let _e2132 = select(_e382, _e2130, (_e2130 < _e382));
let _e2137 = global_2.member[bitcast<u32>(select(0i, _e2132, (_e2132 > 0i)))];
let _e2138 = local_6;
let _e2139 = local_5;
let _e2140 = (_e2138 + _e2139);
let _e2142 = select(_e382, _e2140, (_e2140 < _e382));
let _e2147 = global_2.member[bitcast<u32>(select(0i, _e2142, (_e2142 > 0i)))];
let _e2148 = local_6;
let _e2150 = local_5;
let _e2151 = ((2i * _e2148) + _e2150);
let _e2153 = select(_e382, _e2151, (_e2151 < _e382));
let _e2158 = global_2.member[bitcast<u32>(select(0i, _e2153, (_e2153 > 0i)))];
let _e2159 = vec3<f32>(_e2137, _e2147, _e2158);
if (_e2128 < 0i) {
let _e2161 = (_e2128 == -3i);
let _e2167 = global_1.member.member_18.member_1.member.member;
let _e2172 = global_1.member.member_18.member_1.member_1;
let _e2178 = global_1.member.member_18.member.member.member;
let _e2183 = global_1.member.member_18.member.member_1;
let _e2193 = vec3<f32>(select(_e2178.member, _e2167.member, _e2161), select(_e2178.member_1, _e2167.member_1, _e2161), select(_e2178.member_2, _e2167.member_2, _e2161));
phi_4930_ = type_23(_e2159, _e2193, _e2193, vec3<f32>(select(_e2183.member, _e2172.member, _e2161), select(_e2183.member_1, _e2172.member_1, _e2161), select(_e2183.member_2, _e2172.member_2, _e2161)), 0f, false);
} else {
let _e2207 = global_1.member.member_1;
let _e2210 = (_e2128 * 19i);
let _e2212 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e2214 = select(_e2212, _e2210, (_e2210 < _e2212));
let _e2220 = global_4.member[bitcast<u32>(select(0i, _e2214, (_e2214 > 0i)))];
let _e2221 = (_e2210 + 1i);
let _e2223 = select(_e2212, _e2221, (_e2221 < _e2212));
let _e2229 = global_4.member[bitcast<u32>(select(0i, _e2223, (_e2223 > 0i)))];
let _e2230 = (_e2210 + 2i);
let _e2232 = select(_e2212, _e2230, (_e2230 < _e2212));
let _e2238 = global_4.member[bitcast<u32>(select(0i, _e2232, (_e2232 > 0i)))];
let _e2239 = (_e2210 + 3i);
let _e2241 = select(_e2212, _e2239, (_e2239 < _e2212));
let _e2247 = global_4.member[bitcast<u32>(select(0i, _e2241, (_e2241 > 0i)))];
let _e2248 = (_e2210 + 4i);
let _e2250 = select(_e2212, _e2248, (_e2248 < _e2212));
let _e2256 = global_4.member[bitcast<u32>(select(0i, _e2250, (_e2250 > 0i)))];
let _e2257 = (_e2210 + 5i);
let _e2259 = select(_e2212, _e2257, (_e2257 < _e2212));
let _e2265 = global_4.member[bitcast<u32>(select(0i, _e2259, (_e2259 > 0i)))];
let _e2266 = (_e2210 + 6i);
let _e2268 = select(_e2212, _e2266, (_e2266 < _e2212));
let _e2274 = global_4.member[bitcast<u32>(select(0i, _e2268, (_e2268 > 0i)))];
let _e2275 = (_e2210 + 7i);
let _e2277 = select(_e2212, _e2275, (_e2275 < _e2212));
let _e2283 = global_4.member[bitcast<u32>(select(0i, _e2277, (_e2277 > 0i)))];
let _e2284 = (_e2210 + 8i);
let _e2286 = select(_e2212, _e2284, (_e2284 < _e2212));
let _e2292 = global_4.member[bitcast<u32>(select(0i, _e2286, (_e2286 > 0i)))];
let _e2293 = (_e2247 - _e2220);
let _e2294 = (_e2256 - _e2229);
let _e2295 = (_e2265 - _e2238);
let _e2296 = (_e2274 - _e2220);
let _e2297 = (_e2283 - _e2229);
let _e2298 = (_e2292 - _e2238);
let _e2301 = ((_e2294 * _e2298) - (_e2295 * _e2297));
let _e2304 = ((_e2295 * _e2296) - (_e2293 * _e2298));
let _e2307 = ((_e2293 * _e2297) - (_e2294 * _e2296));
let _e2308 = (_e2247 - _e2137);
let _e2309 = (_e2256 - _e2147);
let _e2310 = (_e2265 - _e2158);
let _e2311 = (_e2274 - _e2137);
let _e2312 = (_e2283 - _e2147);
let _e2313 = (_e2292 - _e2158);
let _e2327 = (((((_e2309 * _e2313) - (_e2310 * _e2312)) * _e2301) + (((_e2310 * _e2311) - (_e2308 * _e2313)) * _e2304)) + (((_e2308 * _e2312) - (_e2309 * _e2311)) * _e2307));
let _e2329 = select(0f, _e2327, (_e2327 > 0f));
let _e2330 = (_e2220 - _e2137);
let _e2331 = (_e2229 - _e2147);
let _e2332 = (_e2238 - _e2158);
let _e2346 = (((((_e2312 * _e2332) - (_e2313 * _e2331)) * _e2301) + (((_e2313 * _e2330) - (_e2311 * _e2332)) * _e2304)) + (((_e2311 * _e2331) - (_e2312 * _e2330)) * _e2307));
let _e2348 = select(0f, _e2346, (_e2346 > 0f));
let _e2362 = (((((_e2331 * _e2310) - (_e2332 * _e2309)) * _e2301) + (((_e2332 * _e2308) - (_e2330 * _e2310)) * _e2304)) + (((_e2330 * _e2309) - (_e2331 * _e2308)) * _e2307));
let _e2364 = select(0f, _e2362, (_e2362 > 0f));
let _e2366 = ((_e2329 + _e2348) + _e2364);
let _e2368 = select(1e-30f, _e2366, (_e2366 > 1e-30f));
let _e2369 = (_e2329 / _e2368);
let _e2370 = (_e2348 / _e2368);
let _e2371 = (_e2364 / _e2368);
let _e2376 = (((_e2301 * _e2301) + (_e2304 * _e2304)) + (_e2307 * _e2307));
let _e2379 = sqrt(select(0f, _e2376, (_e2376 > 0f)));
let _e2382 = (1f / select(1e-20f, _e2379, (_e2379 > 1e-20f)));
let _e2387 = (_e2210 + 9i);
let _e2389 = select(_e2212, _e2387, (_e2387 < _e2212));
let _e2395 = global_4.member[bitcast<u32>(select(0i, _e2389, (_e2389 > 0i)))];
let _e2396 = (_e2210 + 10i);
let _e2398 = select(_e2212, _e2396, (_e2396 < _e2212));
let _e2404 = global_4.member[bitcast<u32>(select(0i, _e2398, (_e2398 > 0i)))];
let _e2405 = (_e2210 + 11i);
let _e2407 = select(_e2212, _e2405, (_e2405 < _e2212));
let _e2413 = global_4.member[bitcast<u32>(select(0i, _e2407, (_e2407 > 0i)))];
let _e2417 = (_e2210 + 12i);
let _e2419 = select(_e2212, _e2417, (_e2417 < _e2212));
let _e2425 = global_4.member[bitcast<u32>(select(0i, _e2419, (_e2419 > 0i)))];
let _e2426 = (_e2210 + 13i);
let _e2428 = select(_e2212, _e2426, (_e2426 < _e2212));
let _e2434 = global_4.member[bitcast<u32>(select(0i, _e2428, (_e2428 > 0i)))];
let _e2435 = (_e2210 + 14i);
let _e2437 = select(_e2212, _e2435, (_e2435 < _e2212));
let _e2443 = global_4.member[bitcast<u32>(select(0i, _e2437, (_e2437 > 0i)))];
let _e2450 = (_e2210 + 15i);
let _e2452 = select(_e2212, _e2450, (_e2450 < _e2212));
let _e2458 = global_4.member[bitcast<u32>(select(0i, _e2452, (_e2452 > 0i)))];
let _e2459 = (_e2210 + 16i);
let _e2461 = select(_e2212, _e2459, (_e2459 < _e2212));
let _e2467 = global_4.member[bitcast<u32>(select(0i, _e2461, (_e2461 > 0i)))];
let _e2468 = (_e2210 + 17i);
let _e2470 = select(_e2212, _e2468, (_e2468 < _e2212));
let _e2476 = global_4.member[bitcast<u32>(select(0i, _e2470, (_e2470 > 0i)))];
let _e2480 = (((_e2395 * _e2369) + (_e2425 * _e2370)) + (_e2458 * _e2371));
let _e2481 = (((_e2404 * _e2369) + (_e2434 * _e2370)) + (_e2467 * _e2371));
let _e2482 = (((_e2413 * _e2369) + (_e2443 * _e2370)) + (_e2476 * _e2371));
let _e2487 = (((_e2480 * _e2480) + (_e2481 * _e2481)) + (_e2482 * _e2482));
let _e2490 = sqrt(select(0f, _e2487, (_e2487 > 0f)));
let _e2493 = (1f / select(1e-20f, _e2490, (_e2490 > 1e-20f)));
let _e2498 = (_e2210 + 18i);
let _e2500 = select(_e2212, _e2498, (_e2498 < _e2212));
let _e2506 = global_4.member[bitcast<u32>(select(0i, _e2500, (_e2500 > 0i)))];
let _e2515 = (select(select(0i, select(select(i32(_e2506), i32(-2147483648), (_e2506 < -2147483600f)), 2147483647i, (_e2506 > 2147483500f)), (_e2506 == _e2506)), _e2128, ((_e2207 & 4u) != 0u)) * 10i);
let _e2517 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e2519 = select(_e2517, _e2515, (_e2515 < _e2517));
let _e2525 = global_5.member[bitcast<u32>(select(0i, _e2519, (_e2519 > 0i)))];
let _e2526 = (_e2515 + 1i);
let _e2528 = select(_e2517, _e2526, (_e2526 < _e2517));
let _e2534 = global_5.member[bitcast<u32>(select(0i, _e2528, (_e2528 > 0i)))];
let _e2535 = (_e2515 + 2i);
let _e2537 = select(_e2517, _e2535, (_e2535 < _e2517));
let _e2543 = global_5.member[bitcast<u32>(select(0i, _e2537, (_e2537 > 0i)))];
let _e2547 = (_e2515 + 3i);
let _e2549 = select(_e2517, _e2547, (_e2547 < _e2517));
let _e2555 = global_5.member[bitcast<u32>(select(0i, _e2549, (_e2549 > 0i)))];
let _e2556 = (_e2515 + 4i);
let _e2558 = select(_e2517, _e2556, (_e2556 < _e2517));
let _e2564 = global_5.member[bitcast<u32>(select(0i, _e2558, (_e2558 > 0i)))];
let _e2565 = (_e2515 + 5i);
let _e2567 = select(_e2517, _e2565, (_e2565 < _e2517));
let _e2573 = global_5.member[bitcast<u32>(select(0i, _e2567, (_e2567 > 0i)))];
let _e2580 = (_e2515 + 6i);
let _e2582 = select(_e2517, _e2580, (_e2580 < _e2517));
let _e2588 = global_5.member[bitcast<u32>(select(0i, _e2582, (_e2582 > 0i)))];
let _e2589 = (_e2515 + 7i);
let _e2591 = select(_e2517, _e2589, (_e2589 < _e2517));
let _e2597 = global_5.member[bitcast<u32>(select(0i, _e2591, (_e2591 > 0i)))];
let _e2598 = (_e2515 + 8i);
let _e2600 = select(_e2517, _e2598, (_e2598 < _e2517));
let _e2606 = global_5.member[bitcast<u32>(select(0i, _e2600, (_e2600 > 0i)))];
let _e2614 = (_e2515 + 9i);
let _e2616 = select(_e2517, _e2614, (_e2614 < _e2517));
let _e2622 = global_5.member[bitcast<u32>(select(0i, _e2616, (_e2616 > 0i)))];
phi_4930_ = type_23(_e2159, vec3<f32>((_e2301 * _e2382), (_e2304 * _e2382), (_e2307 * _e2382)), vec3<f32>((_e2480 * _e2493), (_e2481 * _e2493), (_e2482 * _e2493)), vec3<f32>((((_e2525 * _e2369) + (_e2555 * _e2370)) + (_e2588 * _e2371)), (((_e2534 * _e2369) + (_e2564 * _e2370)) + (_e2597 * _e2371)), (((_e2543 * _e2369) + (_e2573 * _e2370)) + (_e2606 * _e2371))), _e2622, true);
}
let _e2625 = phi_4930_;
let _e2634 = (((_e2625.member_1.x * _e916) + (_e2625.member_1.y * _e927)) + (_e2625.member_1.z * _e938));
let _e2636 = select(1f, -1f, (_e2634 > 0f));
let _e2648 = select(_e2636, -(_e2636), ((((_e2625.member_2.x * _e2625.member_1.x) + (_e2625.member_2.y * _e2625.member_1.y)) + (_e2625.member_2.z * _e2625.member_1.z)) < 0f));
let _e2649 = (_e2625.member_2.x * _e2648);
let _e2650 = (_e2625.member_2.y * _e2648);
let _e2651 = (_e2625.member_2.z * _e2648);
let _e2660 = ((((_e2649 * _e916) + (_e2650 * _e927)) + (_e2651 * _e938)) > 0f);
let _e2668 = global_1.member.member_19.member_2;
let _e2676 = global_1.member.member_19.member;
if (_e2676 == 0u) {
let _e2681 = global_1.member.member_19.member_1;
phi_5520_ = type_22(vec3<f32>(_e2681.member, _e2681.member_1, _e2681.member_2), vec3<f32>(_e2668.member, _e2668.member_1, _e2668.member_2));
} else {
let _e2690 = global_1.member.member_19.member_3;
let _e2695 = (_e2625.member.x - _e2690.member);
let _e2697 = (_e2625.member.y - _e2690.member_1);
let _e2699 = (_e2625.member.z - _e2690.member_2);
let _e2704 = (((_e2695 * _e2695) + (_e2697 * _e2697)) + (_e2699 * _e2699));
let _e2706 = select(1e-12f, _e2704, (_e2704 > 1e-12f));
let _e2707 = (1f / _e2706);
let _e2711 = vec3<f32>((_e2668.member * _e2707), (_e2668.member_1 * _e2707), (_e2668.member_2 * _e2707));
if (_e2676 == 2u) {
let _e2716 = global_1.member.member_19.member_1;
let _e2724 = (((_e2716.member * _e2695) + (_e2716.member_1 * _e2697)) + (_e2716.member_2 * _e2699));
let _e2727 = (1f / select(1e-20f, _e2724, (_e2724 > 1e-20f)));
let _e2732 = global_1.member.member_19.member_4.member;
let _e2741 = ((((_e2732.member * _e2695) + (_e2732.member_1 * _e2697)) + (_e2732.member_2 * _e2699)) * _e2727);
let _e2746 = global_1.member.member_19.member_4.member_1;
let _e2755 = ((((_e2746.member * _e2695) + (_e2746.member_1 * _e2697)) + (_e2746.member_2 * _e2699)) * _e2727);
let _e2760 = global_1.member.member_19.member_4.member_2;
let _e2763 = ((_e2741 * _e2741) + (_e2755 * _e2755));
let _e2772 = global_1.member.member_19.member_4.member_3;
let _e2773 = ((_e2760 - sqrt(select(0f, _e2763, (_e2763 > 0f)))) * _e2772);
let _e2775 = select(0f, _e2773, (_e2773 > 0f));
let _e2777 = select(1f, _e2775, (_e2775 < 1f));
let _e2783 = select(0f, ((_e2777 * _e2777) * (3f - (2f * _e2777))), (_e2724 > 0f));
let _e2788 = global_1.member.member_19.member_4.member_5;
if ((_e2788 > 0u) && (_e2783 > 0f)) {
let _e2792 = (0.5f / _e2760);
let _e2802 = global_1.member.member_19.member_4.member_6;
let _e2803 = bitcast<i32>(_e2802);
local_4 = bitcast<i32>(_e2788);
let _e2804 = local_4;
let _e2806 = f32((_e2804 - 1i));
let _e2808 = f32((_e2803 - 1i));
let _e2809 = local_4;
let _e2812 = (((0.5f + (_e2741 * _e2792)) * f32(_e2809)) - 0.5f);
let _e2814 = select(0f, _e2812, (_e2812 > 0f));
let _e2816 = select(_e2806, _e2814, (_e2814 < _e2806));
let _e2819 = (((0.5f - (_e2755 * _e2792)) * f32(_e2803)) - 0.5f);
let _e2821 = select(0f, _e2819, (_e2819 > 0f));
let _e2823 = select(_e2808, _e2821, (_e2821 < _e2808));
let _e2825 = select(0f, _e2816, (_e2816 > 0f));
let _e2827 = select(_e2806, _e2825, (_e2825 < _e2806));
let _e2834 = select(0i, select(select(i32(_e2827), i32(-2147483648), (_e2827 < -2147483600f)), 2147483647i, (_e2827 > 2147483500f)), (_e2827 == _e2827));
let _e2838 = (_e2834 - select(0i, 1i, (_e2827 < f32(_e2834))));
let _e2840 = select(0f, _e2823, (_e2823 > 0f));
let _e2842 = select(_e2808, _e2840, (_e2840 < _e2808));
let _e2849 = select(0i, select(select(i32(_e2842), i32(-2147483648), (_e2842 < -2147483600f)), 2147483647i, (_e2842 > 2147483500f)), (_e2842 == _e2842));
let _e2853 = (_e2849 - select(0i, 1i, (_e2842 < f32(_e2849))));
let _e2855 = (_e2816 - f32(_e2838));
let _e2857 = (_e2823 - f32(_e2853));
let _e2858 = (_e2838 + 1i);
let _e2859 = local_4;
let _e2861 = select(_e2838, _e2858, (_e2858 < _e2859));
let _e2862 = (_e2853 + 1i);
let _e2864 = select(_e2853, _e2862, (_e2862 < _e2803));
let _e2869 = global_1.member.member_19.member_4.member_4;
let _e2870 = bitcast<i32>(_e2869);
let _e2871 = local_4;
let _e2875 = (_e2870 + (3i * ((_e2853 * _e2871) + _e2838)));
let _e2877 = (bitcast<i32>(_e146) - 1i);
let _e2879 = select(_e2877, _e2875, (_e2875 < _e2877));
let _e2884 = global_3.member[bitcast<u32>(select(0i, _e2879, (_e2879 > 0i)))];
let _e2885 = (_e2875 + 1i);
let _e2887 = select(_e2877, _e2885, (_e2885 < _e2877));
let _e2892 = global_3.member[bitcast<u32>(select(0i, _e2887, (_e2887 > 0i)))];
let _e2893 = (_e2875 + 2i);
let _e2895 = select(_e2877, _e2893, (_e2893 < _e2877));
let _e2900 = global_3.member[bitcast<u32>(select(0i, _e2895, (_e2895 > 0i)))];
let _e2901 = local_4;
let _e2905 = (_e2870 + (3i * ((_e2853 * _e2901) + _e2861)));
let _e2907 = select(_e2877, _e2905, (_e2905 < _e2877));
let _e2912 = global_3.member[bitcast<u32>(select(0i, _e2907, (_e2907 > 0i)))];
let _e2913 = (_e2905 + 1i);
let _e2915 = select(_e2877, _e2913, (_e2913 < _e2877));
let _e2920 = global_3.member[bitcast<u32>(select(0i, _e2915, (_e2915 > 0i)))];
let _e2921 = (_e2905 + 2i);
let _e2923 = select(_e2877, _e2921, (_e2921 < _e2877));
let _e2928 = global_3.member[bitcast<u32>(select(0i, _e2923, (_e2923 > 0i)))];
let _e2929 = local_4;
let _e2933 = (_e2870 + (3i * ((_e2864 * _e2929) + _e2838)));
let _e2935 = select(_e2877, _e2933, (_e2933 < _e2877));
let _e2940 = global_3.member[bitcast<u32>(select(0i, _e2935, (_e2935 > 0i)))];
let _e2941 = (_e2933 + 1i);
let _e2943 = select(_e2877, _e2941, (_e2941 < _e2877));
let _e2948 = global_3.member[bitcast<u32>(select(0i, _e2943, (_e2943 > 0i)))];
let _e2949 = (_e2933 + 2i);
let _e2951 = select(_e2877, _e2949, (_e2949 < _e2877));
let _e2956 = global_3.member[bitcast<u32>(select(0i, _e2951, (_e2951 > 0i)))];
let _e2957 = local_4;
let _e2961 = (_e2870 + (3i * ((_e2864 * _e2957) + _e2861)));
let _e2963 = select(_e2877, _e2961, (_e2961 < _e2877));
let _e2968 = global_3.member[bitcast<u32>(select(0i, _e2963, (_e2963 > 0i)))];
let _e2969 = (_e2961 + 1i);
let _e2971 = select(_e2877, _e2969, (_e2969 < _e2877));
let _e2976 = global_3.member[bitcast<u32>(select(0i, _e2971, (_e2971 > 0i)))];
let _e2977 = (_e2961 + 2i);
let _e2979 = select(_e2877, _e2977, (_e2977 < _e2877));
let _e2984 = global_3.member[bitcast<u32>(select(0i, _e2979, (_e2979 > 0i)))];
let _e2991 = (_e2884 + ((_e2912 - _e2884) * _e2855));
let _e2992 = (_e2892 + ((_e2920 - _e2892) * _e2855));
let _e2993 = (_e2900 + ((_e2928 - _e2900) * _e2855));
phi_5504_ = vec3<f32>(((_e2991 + (((_e2940 + ((_e2968 - _e2940) * _e2855)) - _e2991) * _e2857)) * _e2783), ((_e2992 + (((_e2948 + ((_e2976 - _e2948) * _e2855)) - _e2992) * _e2857)) * _e2783), ((_e2993 + (((_e2956 + ((_e2984 - _e2956) * _e2855)) - _e2993) * _e2857)) * _e2783));
} else {
phi_5504_ = vec3(_e2783);
}
let _e3018 = phi_5504_;
phi_5507_ = (_e2711 * _e3018);
} else {
phi_5507_ = _e2711;
}
let _e3021 = phi_5507_;
let _e3025 = (1f / sqrt(select(0f, _e2706, (_e2706 > 0f))));
phi_5520_ = type_22(vec3<f32>((_e2695 * _e3025), (_e2697 * _e3025), (_e2699 * _e3025)), _e3021);
}
let _e3032 = phi_5520_;
let _e3043 = -((((select(_e2649, (_e2625.member_1.x * _e2636), _e2660) * _e3032.member.x) + (select(_e2650, (_e2625.member_1.y * _e2636), _e2660) * _e3032.member.y)) + (select(_e2651, (_e2625.member_1.z * _e2636), _e2660) * _e3032.member.z)));
let _e3048 = (((_e2625.member_1.x * _e3032.member.x) + (_e2625.member_1.y * _e3032.member.y)) + (_e2625.member_1.z * _e3032.member.z));
let _e3053 = -(_e3043);
let _e3058 = select((select(0f, _e3053, (_e3053 > 0f)) * _e2625.member_4), select(0f, _e3043, (_e3043 > 0f)), ((_e3048 * _e2634) > 0f));
let _e3059 = -(_e3048);
let _e3060 = -(_e3059);
let _e3062 = select(_e3060, _e3059, (_e3059 > _e3060));
let _e3068 = global_1.member.member_21.member_6;
let _e3082 = ((((_e3068.member.member * _e2625.member.x) + (_e3068.member.member_1 * _e2625.member.y)) + (_e3068.member.member_2 * _e2625.member.z)) + _e3068.member_1);
let _e3084 = select(1f, _e3082, (_e3082 > 1e-6f));
let _e3088 = global_1.member.member_21.member_4;
let _e3104 = global_1.member.member_21.member_5;
let _e3120 = global_1.member.member_21.member_2;
let _e3129 = -((((_e2625.member_1.x * _e3120.member) + (_e2625.member_1.y * _e3120.member_1)) + (_e2625.member_1.z * _e3120.member_2)));
let _e3130 = -(_e3129);
let _e3132 = select(_e3130, _e3129, (_e3129 > _e3130));
let _e3134 = select(1f, _e3132, (_e3132 < 1f));
let _e3136 = (1f - (_e3134 * _e3134));
let _e3143 = global_1.member.member_21.member_8;
let _e3151 = global_1.member.member_21.member_7.member;
let _e3156 = global_1.member.member_21.member_7.member_2;
let _e3158 = (_e3151 + (_e3156 * (((((_e3088.member.member * _e2625.member.x) + (_e3088.member.member_1 * _e2625.member.y)) + (_e3088.member.member_2 * _e2625.member.z)) + _e3088.member_1) / _e3084)));
let _e3163 = global_1.member.member_21.member_7.member_1;
let _e3165 = (_e3163 + (_e3156 * (((((_e3104.member.member * _e2625.member.x) + (_e3104.member.member_1 * _e2625.member.y)) + (_e3104.member.member_2 * _e2625.member.z)) + _e3104.member_1) / _e3084)));
let _e3169 = ((1f + (_e3158 * _e3158)) + (_e3165 * _e3165));
let _e3178 = global_1.member.member_21.member_9;
let _e3182 = (select(1f, -1f, (_e3059 < 0f)) * (((((1.4142135f * _e3143) * sqrt(select(0f, _e3136, (_e3136 > 0f)))) * _e3082) + (select(1f, _e3062, (_e3062 < 1f)) * sqrt(select(0f, _e3169, (_e3169 > 0f))))) * _e3178));
let _e3187 = select(0f, 1f, _e2625.member_5);
let _e3191 = (_e2625.member.x + ((_e2625.member_1.x * _e3182) * _e3187));
let _e3192 = (_e2625.member.y + ((_e2625.member_1.y * _e3182) * _e3187));
let _e3193 = (_e2625.member.z + ((_e2625.member_1.z * _e3182) * _e3187));
let _e3198 = global_1.member.member_21.member.member;
let _e3199 = bitcast<i32>(_e3198);
let _e3204 = global_1.member.member_21.member.member_1;
let _e3205 = bitcast<i32>(_e3204);
let _e3210 = global_1.member.member_21.member.member_2;
let _e3211 = bitcast<i32>(_e3210);
let _e3215 = global_1.member.member_21.member_1;
let _e3216 = bitcast<i32>(_e3215);
let _e3222 = ((((_e3068.member.member * _e3191) + (_e3068.member.member_1 * _e3192)) + (_e3068.member.member_2 * _e3193)) + _e3068.member_1);
let _e3224 = select(1f, _e3222, (_e3222 > 1e-6f));
let _e3228 = global_1.member.member_21.member_3;
let _e3239 = ((((_e3228.member.member * _e3191) + (_e3228.member.member_1 * _e3192)) + (_e3228.member.member_2 * _e3193)) + _e3228.member_1);
let _e3254 = ((((((_e3088.member.member * _e3191) + (_e3088.member.member_1 * _e3192)) + (_e3088.member.member_2 * _e3193)) + _e3088.member_1) / _e3224) - 0.5f);
let _e3255 = ((((((_e3104.member.member * _e3191) + (_e3104.member.member_1 * _e3192)) + (_e3104.member.member_2 * _e3193)) + _e3104.member_1) / _e3224) - 0.5f);
let _e3257 = f32((_e3199 - 1i));
let _e3259 = select(0f, _e3239, (_e3239 > 0f));
let _e3261 = select(_e3257, _e3259, (_e3259 < _e3257));
let _e3268 = select(0i, select(select(i32(_e3261), i32(-2147483648), (_e3261 < -2147483600f)), 2147483647i, (_e3261 > 2147483500f)), (_e3261 == _e3261));
let _e3272 = (_e3268 - select(0i, 1i, (_e3261 < f32(_e3268))));
let _e3276 = (_e3239 - f32(_e3272));
let _e3279 = select(1f, select(0f, _e3276, (_e3276 > 0f)), (_e3239 < f32(_e3199)));
let _e3280 = (_e3254 - _e3143);
let _e3281 = -(16f);
let _e3282 = f32(_e3205);
let _e3284 = select(_e3281, _e3280, (_e3280 > _e3281));
let _e3286 = select(_e3282, _e3284, (_e3284 < _e3282));
let _e3293 = select(0i, select(select(i32(_e3286), i32(-2147483648), (_e3286 < -2147483600f)), 2147483647i, (_e3286 > 2147483500f)), (_e3286 == _e3286));
let _e3299 = (_e3254 + _e3143);
let _e3302 = (f32((_e3205 - 1i)) + 16f);
let _e3304 = select(-1f, _e3299, (_e3299 > -1f));
let _e3306 = select(_e3302, _e3304, (_e3304 < _e3302));
let _e3313 = select(0i, select(select(i32(_e3306), i32(-2147483648), (_e3306 < -2147483600f)), 2147483647i, (_e3306 > 2147483500f)), (_e3306 == _e3306));
let _e3318 = (_e3255 - _e3143);
let _e3319 = f32(_e3211);
let _e3321 = select(_e3281, _e3318, (_e3318 > _e3281));
let _e3323 = select(_e3319, _e3321, (_e3321 < _e3319));
let _e3330 = select(0i, select(select(i32(_e3323), i32(-2147483648), (_e3323 < -2147483600f)), 2147483647i, (_e3323 > 2147483500f)), (_e3323 == _e3323));
let _e3336 = (_e3255 + _e3143);
let _e3339 = (f32((_e3211 - 1i)) + 16f);
let _e3341 = select(-1f, _e3336, (_e3336 > -1f));
let _e3343 = select(_e3339, _e3341, (_e3341 < _e3339));
let _e3350 = select(0i, select(select(i32(_e3343), i32(-2147483648), (_e3343 < -2147483600f)), 2147483647i, (_e3343 > 2147483500f)), (_e3343 == _e3343));
let _e3358 = bitcast<i32>(((_e3198 + 2u) >> bitcast<u32>(1i)));
let _e3360 = ((_e3205 * _e3211) * _e3358);
phi_5987_ = 0f;
phi_5990_ = vec3<f32>(0f, 0f, 0f);
phi_5992_ = ((_e3330 - select(0i, 1i, (_e3323 < f32(_e3330)))) + 1i);
loop {
let _e3362 = phi_5987_;
let _e3364 = phi_5990_;
let _e3366 = phi_5992_;
local_69 = _e3362;
local_70 = _e3362;
local_71 = _e3364;
local_72 = _e3364;
local_73 = _e3364;
let _e3367 = (_e3366 <= (_e3350 - select(0i, 1i, (_e3343 < f32(_e3350)))));
if _e3367 {
let _e3373 = (_e3143 - bitcast<f32>((bitcast<u32>((f32(_e3366) - _e3255)) & 2147483647u)));
phi_6007_ = ((_e3293 - select(0i, 1i, (_e3286 < f32(_e3293)))) + 1i);
phi_6010_ = _e3362;
phi_6012_ = _e3364;
loop {
let _e3375 = phi_6007_;
let _e3377 = phi_6010_;
let _e3379 = phi_6012_;
local_74 = _e3377;
local_75 = _e3379;
let _e3380 = (_e3375 <= (_e3313 - select(0i, 1i, (_e3306 < f32(_e3313)))));
if _e3380 {
let _e3386 = (_e3143 - bitcast<f32>((bitcast<u32>((f32(_e3375) - _e3254)) & 2147483647u)));
let _e3391 = (select(0f, _e3386, (_e3386 > 0f)) * select(0f, _e3373, (_e3373 > 0f)));
if ((((_e3375 >= 0i) && (_e3375 < _e3205)) && (_e3366 >= 0i)) && (_e3366 < _e3211)) {
let _e3401 = (((_e3366 * _e3205) + _e3375) * _e3358);
let _e3403 = (2i * _e3272);
let _e3404 = ((4i * _e3401) + _e3403);
let _e3406 = (_e3404 >> bitcast<u32>(2i));
let _e3409 = bitcast<u32>(((_e3404 & 3i) * 8i));
let _e3411 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e3413 = select(_e3411, _e3406, (_e3406 < _e3411));
let _e3419 = global_6.member[bitcast<u32>(select(0i, _e3413, (_e3413 > 0i)))];
let _e3423 = (_e3406 + 1i);
let _e3425 = select(_e3411, _e3423, (_e3423 < _e3411));
let _e3431 = global_6.member[bitcast<u32>(select(0i, _e3425, (_e3425 > 0i)))];
let _e3438 = ((_e3419 >> bitcast<u32>((_e3409 & 31u))) | ((_e3431 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3409) & 31u))));
let _e3441 = f32(bitcast<i32>((_e3438 & 65535u)));
let _e3449 = (1f / 65535f);
let _e3451 = (_e3391 * ((_e3441 + ((f32(bitcast<i32>((_e3438 >> bitcast<u32>(16i)))) - _e3441) * _e3279)) * _e3449));
let _e3453 = (_e3379.x + _e3451);
if (_e3216 > 1i) {
let _e3457 = ((4i * (_e3401 + _e3360)) + _e3403);
let _e3459 = (_e3457 >> bitcast<u32>(2i));
let _e3462 = bitcast<u32>(((_e3457 & 3i) * 8i));
let _e3464 = select(_e3411, _e3459, (_e3459 < _e3411));
let _e3470 = global_6.member[bitcast<u32>(select(0i, _e3464, (_e3464 > 0i)))];
let _e3474 = (_e3459 + 1i);
let _e3476 = select(_e3411, _e3474, (_e3474 < _e3411));
let _e3482 = global_6.member[bitcast<u32>(select(0i, _e3476, (_e3476 > 0i)))];
let _e3489 = ((_e3470 >> bitcast<u32>((_e3462 & 31u))) | ((_e3482 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3462) & 31u))));
let _e3492 = f32(bitcast<i32>((_e3489 & 65535u)));
let _e3507 = ((4i * (_e3401 + (2i * _e3360))) + _e3403);
let _e3509 = (_e3507 >> bitcast<u32>(2i));
let _e3512 = bitcast<u32>(((_e3507 & 3i) * 8i));
let _e3514 = select(_e3411, _e3509, (_e3509 < _e3411));
let _e3520 = global_6.member[bitcast<u32>(select(0i, _e3514, (_e3514 > 0i)))];
let _e3524 = (_e3509 + 1i);
let _e3526 = select(_e3411, _e3524, (_e3524 < _e3411));
let _e3532 = global_6.member[bitcast<u32>(select(0i, _e3526, (_e3526 > 0i)))];
let _e3539 = ((_e3520 >> bitcast<u32>((_e3512 & 31u))) | ((_e3532 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3512) & 31u))));
let _e3542 = f32(bitcast<i32>((_e3539 & 65535u)));
phi_6245_ = vec3<f32>(_e3453, (_e3379.y + (_e3391 * ((_e3492 + ((f32(bitcast<i32>((_e3489 >> bitcast<u32>(16i)))) - _e3492) * _e3279)) * _e3449))), (_e3379.z + (_e3391 * ((_e3542 + ((f32(bitcast<i32>((_e3539 >> bitcast<u32>(16i)))) - _e3542) * _e3279)) * _e3449))));
} else {
phi_6245_ = vec3<f32>(_e3453, (_e3379.y + _e3451), (_e3379.z + _e3451));
}
let _e3561 = phi_6245_;
phi_6255_ = _e3561;
} else {
phi_6255_ = vec3<f32>((_e3379.x + _e3391), (_e3379.y + _e3391), (_e3379.z + _e3391));
}
let _e3570 = phi_6255_;
phi_6008_ = (_e3375 + 1i);
phi_6011_ = (_e3377 + _e3391);
phi_6013_ = _e3570;
} else {
phi_6008_ = i32();
phi_6011_ = f32();
phi_6013_ = vec3<f32>();
}
let _e3574 = phi_6008_;
let _e3576 = phi_6011_;
let _e3578 = phi_6013_;
continue;
continuing {
phi_6007_ = _e3574;
phi_6010_ = _e3576;
phi_6012_ = _e3578;
break if !(_e3380);
}
}
let _e3847 = local_74;
phi_5988_ = _e3847;
let _e3850 = local_75;
phi_5991_ = _e3850;
phi_5993_ = (_e3366 + 1i);
} else {
phi_5988_ = f32();
phi_5991_ = vec3<f32>();
phi_5993_ = i32();
}
let _e3582 = phi_5988_;
let _e3584 = phi_5991_;
let _e3586 = phi_5993_;
continue;
continuing {
phi_5987_ = _e3582;
phi_5990_ = _e3584;
phi_5992_ = _e3586;
break if !(_e3367);
}
}
let _e3590 = local_69;
let _e3594 = (((_e3216 == 0i) || (_e3590 <= 0f)) || (_e3222 <= 1e-6f));
let _e3596 = local_70;
let _e3598 = (1f / select(_e3596, 1f, _e3594));
let _e3600 = local_71;
let _e3605 = local_72;
let _e3610 = local_73;
let _e3626 = global_1.member.member_20;
phi_6337_ = (_e2625.member_3 * vec3<f32>(((_e3032.member_1.x * (select((_e3600.x * _e3598), 1f, _e3594) * _e3058)) + _e3626.member), ((_e3032.member_1.y * (select((_e3605.y * _e3598), 1f, _e3594) * _e3058)) + _e3626.member_1), ((_e3032.member_1.z * (select((_e3610.z * _e3598), 1f, _e3594) * _e3058)) + _e3626.member_2)));
} else {
phi_6337_ = _e2096;
}
let _e3636 = phi_6337_;
let _e3637 = local_7;
local_2 = _e3637;
local_3 = _e376;
let _e3638 = local_3;
let _e3640 = local_2;
let _e3641 = ((22i * _e3638) + _e3640);
let _e3643 = select(_e382, _e3641, (_e3641 < _e382));
let _e3648 = global_2.member[bitcast<u32>(select(0i, _e3643, (_e3643 > 0i)))];
let _e3649 = local_3;
let _e3651 = local_2;
let _e3652 = ((23i * _e3649) + _e3651);
let _e3654 = select(_e382, _e3652, (_e3652 < _e382));
let _e3659 = global_2.member[bitcast<u32>(select(0i, _e3654, (_e3654 > 0i)))];
let _e3660 = local_3;
let _e3662 = local_2;
let _e3663 = ((24i * _e3660) + _e3662);
let _e3665 = select(_e382, _e3663, (_e3663 < _e382));
let _e3670 = global_2.member[bitcast<u32>(select(0i, _e3665, (_e3665 > 0i)))];
let _e3673 = global_1.member.member_17;
let _e3680 = local_7;
local = _e3680;
local_1 = _e376;
let _e3681 = local_1;
let _e3683 = local;
let _e3684 = ((6i * _e3681) + _e3683);
let _e3686 = select(_e382, _e3684, (_e3684 < _e382));
let _e3691 = global_2.member[bitcast<u32>(select(0i, _e3686, (_e3686 > 0i)))];
let _e3692 = local_1;
let _e3694 = local;
let _e3695 = ((7i * _e3692) + _e3694);
let _e3697 = select(_e382, _e3695, (_e3695 < _e382));
let _e3702 = global_2.member[bitcast<u32>(select(0i, _e3697, (_e3697 > 0i)))];
let _e3703 = local_1;
let _e3705 = local;
let _e3706 = ((8i * _e3703) + _e3705);
let _e3708 = select(_e382, _e3706, (_e3706 < _e382));
let _e3713 = global_2.member[bitcast<u32>(select(0i, _e3708, (_e3708 > 0i)))];
global_7.member[_e166] = (_e177 + ((_e3636.x * _e3691) + (_e3648 * _e3673.member)));
global_7.member[_e178] = (_e187 + ((_e3636.y * _e3702) + (_e3659 * _e3673.member_1)));
global_7.member[_e189] = (_e198 + ((_e3636.z * _e3713) + (_e3670 * _e3673.member_2)));
global_7.member[_e200] = _e209;
global_7.member[_e211] = _e220;
global_7.member[_e222] = _e231;
global_7.member[_e233] = _e242;
global_7.member[_e244] = _e253;
global_7.member[_e255] = _e264;
global_7.member[_e266] = _e275;
global_7.member[_e277] = _e286;
global_7.member[_e288] = _e297;
global_7.member[_e299] = _e308;
global_7.member[_e310] = _e319;
global_7.member[_e321] = _e330;
global_7.member[_e332] = _e341;
global_7.member[_e343] = _e352;
global_7.member[_e354] = _e363;
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
