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
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_21,
member_19: type_22,
}
struct type_24 {
member: type_23,
}
struct type_25 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(3)
var<storage> global_1: type_15;
@group(0) @binding(4)
var<storage, read_write> global_2: type_15;
@group(0) @binding(0)
var<storage> global_3: type_24;
@group(0) @binding(1)
var<storage> global_4: type_15;
@group(0) @binding(2)
var<storage> global_5: type_15;
fn function_() {
var local: i32;
var local_1: f32;
var local_2: i32;
var local_3: f32;
var local_4: i32;
var phi_1476_: u32;
var phi_1479_: f32;
var phi_1614_: i32;
var phi_1627_: i32;
var phi_1641_: i32;
var phi_1957_: i32;
var phi_1970_: i32;
var phi_1984_: i32;
var phi_1477_: u32;
var phi_1480_: f32;
var phi_2189_: f32;
var phi_2936_: vec3<f32>;
var phi_2939_: vec3<f32>;
var phi_2952_: type_25;
var phi_2959_: vec3<f32>;
var local_5: f32;
let _e78 = global;
let _e89 = global_3.member.member;
if (_e78.x < _e89.member) {
if (_e78.y < _e89.member_1) {
let _e96 = (_e89.member * _e89.member_1);
let _e98 = ((_e78.y * _e89.member) + _e78.x);
let _e103 = global_3.member.member.member;
let _e107 = global_3.member.member.member_1;
let _e108 = (_e103 * _e107);
let _e110 = ((_e78.y * _e103) + _e78.x);
let _e111 = bitcast<i32>(_e110);
let _e113 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e115 = select(_e113, _e111, (_e111 < _e113));
let _e121 = global_4.member[bitcast<u32>(select(0i, _e115, (_e115 > 0i)))];
let _e123 = bitcast<i32>((_e108 + _e110));
let _e125 = select(_e113, _e123, (_e123 < _e113));
let _e131 = global_4.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e134 = bitcast<i32>(((2u * _e108) + _e110));
let _e136 = select(_e113, _e134, (_e134 < _e113));
let _e142 = global_4.member[bitcast<u32>(select(0i, _e136, (_e136 > 0i)))];
let _e145 = bitcast<i32>(((3u * _e108) + _e110));
let _e147 = select(_e113, _e145, (_e145 < _e113));
let _e153 = global_4.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e156 = bitcast<i32>(((4u * _e108) + _e110));
let _e158 = select(_e113, _e156, (_e156 < _e113));
let _e164 = global_4.member[bitcast<u32>(select(0i, _e158, (_e158 > 0i)))];
let _e167 = bitcast<i32>(((5u * _e108) + _e110));
let _e169 = select(_e113, _e167, (_e167 < _e113));
let _e175 = global_4.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e178 = bitcast<i32>(((6u * _e108) + _e110));
let _e180 = select(_e113, _e178, (_e178 < _e113));
let _e186 = global_4.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e189 = bitcast<i32>(((7u * _e108) + _e110));
let _e191 = select(_e113, _e189, (_e189 < _e113));
let _e197 = global_4.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
let _e200 = bitcast<i32>(((8u * _e108) + _e110));
let _e202 = select(_e113, _e200, (_e200 < _e113));
let _e208 = global_4.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e211 = bitcast<i32>(((9u * _e108) + _e110));
let _e213 = select(_e113, _e211, (_e211 < _e113));
let _e219 = global_4.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e222 = bitcast<i32>(((10u * _e108) + _e110));
let _e224 = select(_e113, _e222, (_e222 < _e113));
let _e230 = global_4.member[bitcast<u32>(select(0i, _e224, (_e224 > 0i)))];
let _e233 = bitcast<i32>(((11u * _e108) + _e110));
let _e235 = select(_e113, _e233, (_e233 < _e113));
let _e241 = global_4.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e244 = bitcast<i32>(((12u * _e108) + _e110));
let _e246 = select(_e113, _e244, (_e244 < _e113));
let _e252 = global_4.member[bitcast<u32>(select(0i, _e246, (_e246 > 0i)))];
let _e255 = bitcast<i32>(((13u * _e108) + _e110));
let _e257 = select(_e113, _e255, (_e255 < _e113));
let _e263 = global_4.member[bitcast<u32>(select(0i, _e257, (_e257 > 0i)))];
let _e266 = bitcast<i32>(((14u * _e108) + _e110));
let _e268 = select(_e113, _e266, (_e266 < _e113));
let _e274 = global_4.member[bitcast<u32>(select(0i, _e268, (_e268 > 0i)))];
let _e277 = bitcast<i32>(((15u * _e108) + _e110));
let _e279 = select(_e113, _e277, (_e277 < _e113));
let _e285 = global_4.member[bitcast<u32>(select(0i, _e279, (_e279 > 0i)))];
let _e288 = bitcast<i32>(((16u * _e108) + _e110));
let _e290 = select(_e113, _e288, (_e288 < _e113));
let _e296 = global_4.member[bitcast<u32>(select(0i, _e290, (_e290 > 0i)))];
let _e299 = bitcast<i32>(((17u * _e108) + _e110));
let _e301 = select(_e113, _e299, (_e299 < _e113));
let _e307 = global_4.member[bitcast<u32>(select(0i, _e301, (_e301 > 0i)))];
let _e310 = bitcast<i32>(((18u * _e108) + _e110));
let _e312 = select(_e113, _e310, (_e310 < _e113));
let _e318 = global_4.member[bitcast<u32>(select(0i, _e312, (_e312 > 0i)))];
let _e321 = bitcast<i32>(((19u * _e108) + _e110));
let _e323 = select(_e113, _e321, (_e321 < _e113));
let _e329 = global_4.member[bitcast<u32>(select(0i, _e323, (_e323 > 0i)))];
let _e332 = bitcast<i32>(((20u * _e108) + _e110));
let _e334 = select(_e113, _e332, (_e332 < _e113));
let _e340 = global_4.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e343 = bitcast<i32>(((23u * _e108) + _e110));
let _e345 = select(_e113, _e343, (_e343 < _e113));
let _e351 = global_4.member[bitcast<u32>(select(0i, _e345, (_e345 > 0i)))];
let _e354 = bitcast<i32>(((24u * _e108) + _e110));
let _e356 = select(_e113, _e354, (_e354 < _e113));
let _e362 = global_4.member[bitcast<u32>(select(0i, _e356, (_e356 > 0i)))];
let _e365 = bitcast<i32>(((29u * _e108) + _e110));
let _e367 = select(_e113, _e365, (_e365 < _e113));
let _e373 = global_4.member[bitcast<u32>(select(0i, _e367, (_e367 > 0i)))];
let _e376 = bitcast<i32>(((30u * _e108) + _e110));
let _e378 = select(_e113, _e376, (_e376 < _e113));
let _e384 = global_4.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e387 = bitcast<i32>(((36u * _e108) + _e110));
let _e389 = select(_e113, _e387, (_e387 < _e113));
let _e395 = global_4.member[bitcast<u32>(select(0i, _e389, (_e389 > 0i)))];
let _e402 = select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < -2147483600f)), 2147483647i, (_e351 > 2147483500f)), (_e351 == _e351));
let _e418 = (_e89.member_2 == 1u);
let _e423 = global_3.member.member_12.member_4;
let _e433 = ((((_e373 == 2f) && (select(0i, select(select(i32(_e395), i32(-2147483648), (_e395 < -2147483600f)), 2147483647i, (_e395 > 2147483500f)), (_e395 == _e395)) == (bitcast<i32>(_e423) + 1i))) && ((select(0i, select(select(i32(_e384), i32(-2147483648), (_e384 < -2147483600f)), 2147483647i, (_e384 > 2147483500f)), (_e384 == _e384)) == 0i) == _e418)) && (!(_e418) || (_e402 >= 0i)));
let _e434 = select(0f, _e362, _e418);
let _e435 = select(_e362, 1e30f, _e418);
let _e443 = (1f / select(_e153, select(1e-12f, -1e-12f, (_e153 < 0f)), (bitcast<f32>((bitcast<u32>(_e153) & 2147483647u)) < 1e-12f)));
let _e451 = (1f / select(_e164, select(1e-12f, -1e-12f, (_e164 < 0f)), (bitcast<f32>((bitcast<u32>(_e164) & 2147483647u)) < 1e-12f)));
let _e459 = (1f / select(_e175, select(1e-12f, -1e-12f, (_e175 < 0f)), (bitcast<f32>((bitcast<u32>(_e175) & 2147483647u)) < 1e-12f)));
let _e463 = global_3.member.member_13.member_4;
let _e470 = global_3.member.member_13.member_5;
let _e475 = ((_e463.member - _e121) * _e443);
let _e477 = ((_e470.member - _e121) * _e443);
let _e479 = ((_e463.member_1 - _e131) * _e451);
let _e481 = ((_e470.member_1 - _e131) * _e451);
let _e483 = ((_e463.member_2 - _e142) * _e459);
let _e485 = ((_e470.member_2 - _e142) * _e459);
let _e487 = select(_e477, _e475, (_e475 < _e477));
let _e489 = select(_e481, _e479, (_e479 < _e481));
let _e491 = select(_e489, _e487, (_e487 > _e489));
let _e493 = select(_e485, _e483, (_e483 < _e485));
let _e495 = select(_e493, _e491, (_e491 > _e493));
let _e497 = select(_e477, _e475, (_e475 > _e477));
let _e499 = select(_e481, _e479, (_e479 > _e481));
let _e501 = select(_e499, _e497, (_e497 < _e499));
let _e503 = select(_e485, _e483, (_e483 > _e485));
let _e505 = select(_e503, _e501, (_e501 < _e503));
let _e507 = select(_e434, _e495, (_e495 > _e434));
let _e509 = select(_e435, _e505, (_e505 < _e435));
let _e510 = (_e509 > _e507);
let _e511 = select(_e434, _e507, _e510);
let _e517 = (((_e252 * _e252) + (_e263 * _e263)) + (_e274 * _e274));
let _e520 = sqrt(select(0f, _e517, (_e517 > 0f)));
let _e523 = (0.5f / select(1e-20f, _e520, (_e520 > 1e-20f)));
let _e525 = select(_e523, 1f, (1f < _e523));
let _e526 = (_e252 * _e525);
let _e527 = (_e263 * _e525);
let _e528 = (_e274 * _e525);
let _e533 = (((_e285 * _e285) + (_e296 * _e296)) + (_e307 * _e307));
let _e536 = sqrt(select(0f, _e533, (_e533 > 0f)));
let _e539 = (0.5f / select(1e-20f, _e536, (_e536 > 1e-20f)));
let _e541 = select(_e539, 1f, (1f < _e539));
let _e542 = (_e285 * _e541);
let _e543 = (_e296 * _e541);
let _e544 = (_e307 * _e541);
let _e548 = (_e186 + (_e526 * _e511));
let _e549 = (_e197 + (_e527 * _e511));
let _e550 = (_e208 + (_e528 * _e511));
let _e554 = (_e219 + (_e542 * _e511));
let _e555 = (_e230 + (_e543 * _e511));
let _e556 = (_e241 + (_e544 * _e511));
let _e562 = global_3.member.member_11.member_2;
let _e569 = global_3.member.member_11.member_3;
let _e576 = global_3.member.member_11.member_5;
let _e582 = global_3.member.member_11.member_7;
let _e584 = (_e576 + ((f32(bitcast<i32>(_e78.x)) + 0.5f) * _e582));
let _e588 = global_3.member.member_11.member_6;
let _e594 = global_3.member.member_11.member_8;
let _e596 = (_e588 + ((f32(bitcast<i32>(_e78.y)) + 0.5f) * _e594));
let _e609 = global_3.member.member_11.member_1;
let _e616 = global_3.member.member_10.member;
let _e617 = (_e616 == 0u);
let _e618 = (_e609.member + ((_e562.member * _e584) + (_e569.member * _e596)));
let _e619 = (_e609.member_1 + ((_e562.member_1 * _e584) + (_e569.member_1 * _e596)));
let _e620 = (_e609.member_2 + ((_e562.member_2 * _e584) + (_e569.member_2 * _e596)));
let _e625 = (((_e618 * _e618) + (_e619 * _e619)) + (_e620 * _e620));
let _e629 = (1f / sqrt(select(0f, _e625, (_e625 > 0f))));
let _e633 = select((_e618 * _e629), _e609.member, _e617);
let _e634 = select((_e619 * _e629), _e609.member_1, _e617);
let _e635 = select((_e620 * _e629), _e609.member_2, _e617);
let _e637 = select(0f, _e495, (_e495 > 0f));
let _e639 = select(_e511, _e505, (_e505 < _e511));
let _e640 = (_e639 > _e637);
let _e641 = select(0f, _e637, _e640);
let _e643 = (select(0f, _e639, _e640) - _e641);
let _e647 = global_3.member.member_13.member_6;
if (_e647 == 0u) {
phi_2189_ = _e643;
} else {
let _e650 = (_e643 / f32(_e647));
phi_1476_ = 0u;
phi_1479_ = 0f;
loop {
let _e652 = phi_1476_;
let _e654 = phi_1479_;
local_5 = _e654;
let _e657 = ((_e652 < _e647) && (_e643 > 0f));
if _e657 {
let _e660 = (_e641 + (_e650 * f32(_e652)));
let _e661 = (_e660 + _e650);
let _e663 = (0.5f * (_e660 + _e661));
let _e664 = (_e661 - _e660);
let _e665 = (0.28867513f * _e664);
let _e666 = (_e663 - _e665);
let _e676 = global_3.member.member_13.member_7;
let _e677 = bitcast<i32>(_e676);
let _e681 = global_3.member.member_13.member_8;
let _e682 = bitcast<i32>(_e681);
let _e686 = global_3.member.member_13.member_9;
let _e687 = bitcast<i32>(_e686);
let _e688 = f32(_e677);
let _e690 = (_e470.member - _e463.member);
let _e693 = (((((_e121 + (_e153 * _e666)) - _e463.member) / _e690) * _e688) - 0.5f);
let _e694 = (_e688 - 1f);
let _e696 = select(0f, _e693, (_e693 > 0f));
let _e698 = select(_e694, _e696, (_e696 < _e694));
let _e699 = f32(_e682);
let _e701 = (_e470.member_1 - _e463.member_1);
let _e704 = (((((_e131 + (_e164 * _e666)) - _e463.member_1) / _e701) * _e699) - 0.5f);
let _e705 = (_e699 - 1f);
let _e707 = select(0f, _e704, (_e704 > 0f));
let _e709 = select(_e705, _e707, (_e707 < _e705));
let _e710 = f32(_e687);
let _e712 = (_e470.member_2 - _e463.member_2);
let _e715 = (((((_e142 + (_e175 * _e666)) - _e463.member_2) / _e712) * _e710) - 0.5f);
let _e716 = (_e710 - 1f);
let _e718 = select(0f, _e715, (_e715 > 0f));
let _e720 = select(_e716, _e718, (_e718 < _e716));
let _e722 = select(0f, _e698, (_e698 > 0f));
let _e724 = select(1e6f, _e722, (_e722 < 1e6f));
let _e731 = select(0i, select(select(i32(_e724), i32(-2147483648), (_e724 < -2147483600f)), 2147483647i, (_e724 > 2147483500f)), (_e724 == _e724));
let _e735 = (_e731 - select(0i, 1i, (_e724 < f32(_e731))));
let _e737 = select(0f, _e709, (_e709 > 0f));
let _e739 = select(1e6f, _e737, (_e737 < 1e6f));
let _e746 = select(0i, select(select(i32(_e739), i32(-2147483648), (_e739 < -2147483600f)), 2147483647i, (_e739 > 2147483500f)), (_e739 == _e739));
let _e750 = (_e746 - select(0i, 1i, (_e739 < f32(_e746))));
let _e752 = select(0f, _e720, (_e720 > 0f));
let _e754 = select(1e6f, _e752, (_e752 < 1e6f));
let _e761 = select(0i, select(select(i32(_e754), i32(-2147483648), (_e754 < -2147483600f)), 2147483647i, (_e754 > 2147483500f)), (_e754 == _e754));
let _e765 = (_e761 - select(0i, 1i, (_e754 < f32(_e761))));
let _e769 = (_e709 - f32(_e750));
let _e771 = (_e720 - f32(_e765));
local_3 = (_e698 - f32(_e735));
let _e772 = (_e735 + 1i);
let _e774 = select(_e772, 0i, (_e772 < 0i));
if (_e774 >= _e677) {
phi_1614_ = (_e677 - 1i);
} else {
phi_1614_ = _e774;
}
let _e778 = phi_1614_;
local_4 = (_e778 - _e735);
let _e780 = (_e750 + 1i);
let _e782 = select(_e780, 0i, (_e780 < 0i));
if (_e782 >= _e682) {
phi_1627_ = (_e682 - 1i);
} else {
phi_1627_ = _e782;
}
let _e786 = phi_1627_;
let _e788 = ((_e786 - _e750) * _e677);
let _e789 = (_e765 + 1i);
let _e791 = select(_e789, 0i, (_e789 < 0i));
if (_e791 >= _e687) {
phi_1641_ = (_e687 - 1i);
} else {
phi_1641_ = _e791;
}
let _e795 = phi_1641_;
let _e802 = global_3.member.member_13.member_10;
let _e803 = bitcast<i32>(_e802);
let _e808 = ((_e803 + (((_e765 * _e682) + _e750) * _e677)) + _e735);
let _e810 = (bitcast<i32>(arrayLength((&global_1.member))) - 1i);
let _e812 = select(_e810, _e808, (_e808 < _e810));
let _e817 = global_1.member[bitcast<u32>(select(0i, _e812, (_e812 > 0i)))];
let _e818 = local_3;
let _e821 = local_4;
let _e822 = (_e808 + _e821);
let _e824 = select(_e810, _e822, (_e822 < _e810));
let _e829 = global_1.member[bitcast<u32>(select(0i, _e824, (_e824 > 0i)))];
let _e830 = local_3;
let _e833 = (1f - _e769);
let _e835 = (_e808 + _e788);
let _e837 = select(_e810, _e835, (_e835 < _e810));
let _e842 = global_1.member[bitcast<u32>(select(0i, _e837, (_e837 > 0i)))];
let _e843 = local_3;
let _e846 = local_4;
let _e847 = (_e835 + _e846);
let _e849 = select(_e810, _e847, (_e847 < _e810));
let _e854 = global_1.member[bitcast<u32>(select(0i, _e849, (_e849 > 0i)))];
let _e855 = local_3;
let _e860 = (_e808 + (((_e795 - _e765) * _e677) * _e682));
let _e862 = select(_e810, _e860, (_e860 < _e810));
let _e867 = global_1.member[bitcast<u32>(select(0i, _e862, (_e862 > 0i)))];
let _e868 = local_3;
let _e871 = local_4;
let _e872 = (_e860 + _e871);
let _e874 = select(_e810, _e872, (_e872 < _e810));
let _e879 = global_1.member[bitcast<u32>(select(0i, _e874, (_e874 > 0i)))];
let _e880 = local_3;
let _e884 = (_e860 + _e788);
let _e886 = select(_e810, _e884, (_e884 < _e810));
let _e891 = global_1.member[bitcast<u32>(select(0i, _e886, (_e886 > 0i)))];
let _e892 = local_3;
let _e895 = local_4;
let _e896 = (_e884 + _e895);
let _e898 = select(_e810, _e896, (_e896 < _e810));
let _e903 = global_1.member[bitcast<u32>(select(0i, _e898, (_e898 > 0i)))];
let _e904 = local_3;
let _e913 = (_e663 + _e665);
let _e923 = (((((_e121 + (_e153 * _e913)) - _e463.member) / _e690) * _e688) - 0.5f);
let _e925 = select(0f, _e923, (_e923 > 0f));
let _e927 = select(_e694, _e925, (_e925 < _e694));
let _e931 = (((((_e131 + (_e164 * _e913)) - _e463.member_1) / _e701) * _e699) - 0.5f);
let _e933 = select(0f, _e931, (_e931 > 0f));
let _e935 = select(_e705, _e933, (_e933 < _e705));
let _e939 = (((((_e142 + (_e175 * _e913)) - _e463.member_2) / _e712) * _e710) - 0.5f);
let _e941 = select(0f, _e939, (_e939 > 0f));
let _e943 = select(_e716, _e941, (_e941 < _e716));
let _e945 = select(0f, _e927, (_e927 > 0f));
let _e947 = select(1e6f, _e945, (_e945 < 1e6f));
let _e954 = select(0i, select(select(i32(_e947), i32(-2147483648), (_e947 < -2147483600f)), 2147483647i, (_e947 > 2147483500f)), (_e947 == _e947));
let _e958 = (_e954 - select(0i, 1i, (_e947 < f32(_e954))));
let _e960 = select(0f, _e935, (_e935 > 0f));
let _e962 = select(1e6f, _e960, (_e960 < 1e6f));
let _e969 = select(0i, select(select(i32(_e962), i32(-2147483648), (_e962 < -2147483600f)), 2147483647i, (_e962 > 2147483500f)), (_e962 == _e962));
let _e973 = (_e969 - select(0i, 1i, (_e962 < f32(_e969))));
let _e975 = select(0f, _e943, (_e943 > 0f));
let _e977 = select(1e6f, _e975, (_e975 < 1e6f));
let _e984 = select(0i, select(select(i32(_e977), i32(-2147483648), (_e977 < -2147483600f)), 2147483647i, (_e977 > 2147483500f)), (_e977 == _e977));
let _e988 = (_e984 - select(0i, 1i, (_e977 < f32(_e984))));
let _e992 = (_e935 - f32(_e973));
let _e994 = (_e943 - f32(_e988));
local_1 = (_e927 - f32(_e958));
let _e995 = (_e958 + 1i);
let _e997 = select(_e995, 0i, (_e995 < 0i));
if (_e997 >= _e677) {
phi_1957_ = (_e677 - 1i);
} else {
phi_1957_ = _e997;
}
let _e1001 = phi_1957_;
local_2 = (_e1001 - _e958);
let _e1003 = (_e973 + 1i);
let _e1005 = select(_e1003, 0i, (_e1003 < 0i));
if (_e1005 >= _e682) {
phi_1970_ = (_e682 - 1i);
} else {
phi_1970_ = _e1005;
}
let _e1009 = phi_1970_;
let _e1011 = ((_e1009 - _e973) * _e677);
let _e1012 = (_e988 + 1i);
let _e1014 = select(_e1012, 0i, (_e1012 < 0i));
if (_e1014 >= _e687) {
phi_1984_ = (_e687 - 1i);
} else {
phi_1984_ = _e1014;
}
let _e1018 = phi_1984_;
let _e1026 = ((_e803 + (((_e988 * _e682) + _e973) * _e677)) + _e958);
let _e1028 = select(_e810, _e1026, (_e1026 < _e810));
let _e1033 = global_1.member[bitcast<u32>(select(0i, _e1028, (_e1028 > 0i)))];
let _e1034 = local_1;
let _e1037 = local_2;
let _e1038 = (_e1026 + _e1037);
let _e1040 = select(_e810, _e1038, (_e1038 < _e810));
let _e1045 = global_1.member[bitcast<u32>(select(0i, _e1040, (_e1040 > 0i)))];
let _e1046 = local_1;
let _e1049 = (1f - _e992);
let _e1051 = (_e1026 + _e1011);
let _e1053 = select(_e810, _e1051, (_e1051 < _e810));
let _e1058 = global_1.member[bitcast<u32>(select(0i, _e1053, (_e1053 > 0i)))];
let _e1059 = local_1;
let _e1062 = local_2;
let _e1063 = (_e1051 + _e1062);
let _e1065 = select(_e810, _e1063, (_e1063 < _e810));
let _e1070 = global_1.member[bitcast<u32>(select(0i, _e1065, (_e1065 > 0i)))];
let _e1071 = local_1;
let _e1076 = (_e1026 + (((_e1018 - _e988) * _e677) * _e682));
let _e1078 = select(_e810, _e1076, (_e1076 < _e810));
let _e1083 = global_1.member[bitcast<u32>(select(0i, _e1078, (_e1078 > 0i)))];
let _e1084 = local_1;
let _e1087 = local_2;
let _e1088 = (_e1076 + _e1087);
let _e1090 = select(_e810, _e1088, (_e1088 < _e810));
let _e1095 = global_1.member[bitcast<u32>(select(0i, _e1090, (_e1090 > 0i)))];
let _e1096 = local_1;
let _e1100 = (_e1076 + _e1011);
let _e1102 = select(_e810, _e1100, (_e1100 < _e810));
let _e1107 = global_1.member[bitcast<u32>(select(0i, _e1102, (_e1102 > 0i)))];
let _e1108 = local_1;
let _e1111 = local_2;
let _e1112 = (_e1100 + _e1111);
let _e1114 = select(_e810, _e1112, (_e1112 < _e810));
let _e1119 = global_1.member[bitcast<u32>(select(0i, _e1114, (_e1114 > 0i)))];
let _e1120 = local_1;
phi_1477_ = (_e652 + 1u);
phi_1480_ = (_e654 + ((0.5f * (((((((_e817 * (1f - _e818)) + (_e829 * _e830)) * _e833) + (((_e842 * (1f - _e843)) + (_e854 * _e855)) * _e769)) * (1f - _e771)) + (((((_e867 * (1f - _e868)) + (_e879 * _e880)) * _e833) + (((_e891 * (1f - _e892)) + (_e903 * _e904)) * _e769)) * _e771)) + ((((((_e1033 * (1f - _e1034)) + (_e1045 * _e1046)) * _e1049) + (((_e1058 * (1f - _e1059)) + (_e1070 * _e1071)) * _e992)) * (1f - _e994)) + (((((_e1083 * (1f - _e1084)) + (_e1095 * _e1096)) * _e1049) + (((_e1107 * (1f - _e1108)) + (_e1119 * _e1120)) * _e992)) * _e994)))) * _e664));
} else {
phi_1477_ = u32();
phi_1480_ = f32();
}
let _e1135 = phi_1477_;
let _e1137 = phi_1480_;
continue;
continuing {
phi_1476_ = _e1135;
phi_1479_ = _e1137;
break if !(_e657);
}
}
let _e1863 = local_5;
phi_2189_ = _e1863;
}
let _e1140 = phi_2189_;
let _e1142 = select(0f, _e1140, (_e1140 > 0f));
let _e1146 = global_3.member.member_13.member;
let _e1151 = -((_e1146.member * _e1142));
let _e1153 = select(-87f, _e1151, (_e1151 > -87f));
let _e1155 = select(88f, _e1153, (_e1153 < 88f));
let _e1157 = ((_e1155 * 1.442695f) + 0.5f);
let _e1159 = select(-127f, _e1157, (_e1157 > -127f));
let _e1161 = select(128f, _e1159, (_e1159 < 128f));
let _e1168 = select(0i, select(select(i32(_e1161), i32(-2147483648), (_e1161 < -2147483600f)), 2147483647i, (_e1161 > 2147483500f)), (_e1161 == _e1161));
let _e1172 = (_e1168 - select(0i, 1i, (_e1161 < f32(_e1168))));
let _e1173 = f32(_e1172);
let _e1177 = ((_e1155 - (_e1173 * 0.6933594f)) - (_e1173 * -2.1219444e-4f));
let _e1199 = -((_e1146.member_1 * _e1142));
let _e1201 = select(-87f, _e1199, (_e1199 > -87f));
let _e1203 = select(88f, _e1201, (_e1201 < 88f));
let _e1205 = ((_e1203 * 1.442695f) + 0.5f);
let _e1207 = select(-127f, _e1205, (_e1205 > -127f));
let _e1209 = select(128f, _e1207, (_e1207 < 128f));
let _e1216 = select(0i, select(select(i32(_e1209), i32(-2147483648), (_e1209 < -2147483600f)), 2147483647i, (_e1209 > 2147483500f)), (_e1209 == _e1209));
let _e1220 = (_e1216 - select(0i, 1i, (_e1209 < f32(_e1216))));
let _e1221 = f32(_e1220);
let _e1225 = ((_e1203 - (_e1221 * 0.6933594f)) - (_e1221 * -2.1219444e-4f));
let _e1247 = -((_e1146.member_2 * _e1142));
let _e1249 = select(-87f, _e1247, (_e1247 > -87f));
let _e1251 = select(88f, _e1249, (_e1249 < 88f));
let _e1253 = ((_e1251 * 1.442695f) + 0.5f);
let _e1255 = select(-127f, _e1253, (_e1253 > -127f));
let _e1257 = select(128f, _e1255, (_e1255 < 128f));
let _e1264 = select(0i, select(select(i32(_e1257), i32(-2147483648), (_e1257 < -2147483600f)), 2147483647i, (_e1257 > 2147483500f)), (_e1257 == _e1257));
let _e1268 = (_e1264 - select(0i, 1i, (_e1257 < f32(_e1264))));
let _e1269 = f32(_e1268);
let _e1273 = ((_e1251 - (_e1269 * 0.6933594f)) - (_e1269 * -2.1219444e-4f));
let _e1294 = (_e582 * _e594);
if _e617 {
let _e1298 = global_3.member.member_10.member_2;
let _e1302 = (3.1415927f * _e1294);
phi_2959_ = vec3<f32>((_e1298.member * _e1302), (_e1298.member_1 * _e1302), (_e1298.member_2 * _e1302));
} else {
let _e1311 = (((_e633 * _e609.member) + (_e634 * _e609.member_1)) + (_e635 * _e609.member_2));
let _e1315 = global_3.member.member_11.member_4;
let _e1325 = global_3.member.member_10.member_2;
if _e617 {
let _e1333 = global_3.member.member_10.member_1;
phi_2952_ = type_25(vec3<f32>(_e1333.member, _e1333.member_1, _e1333.member_2), vec3<f32>(_e1325.member, _e1325.member_1, _e1325.member_2));
} else {
let _e1342 = global_3.member.member_10.member_3;
let _e1346 = ((_e1315.member + _e633) - _e1342.member);
let _e1347 = ((_e1315.member_1 + _e634) - _e1342.member_1);
let _e1348 = ((_e1315.member_2 + _e635) - _e1342.member_2);
let _e1353 = (((_e1346 * _e1346) + (_e1347 * _e1347)) + (_e1348 * _e1348));
let _e1355 = select(1e-12f, _e1353, (_e1353 > 1e-12f));
let _e1356 = (1f / _e1355);
let _e1360 = vec3<f32>((_e1325.member * _e1356), (_e1325.member_1 * _e1356), (_e1325.member_2 * _e1356));
if (_e616 == 2u) {
let _e1365 = global_3.member.member_10.member_1;
let _e1373 = (((_e1365.member * _e1346) + (_e1365.member_1 * _e1347)) + (_e1365.member_2 * _e1348));
let _e1376 = (1f / select(1e-20f, _e1373, (_e1373 > 1e-20f)));
let _e1381 = global_3.member.member_10.member_4.member;
let _e1390 = ((((_e1381.member * _e1346) + (_e1381.member_1 * _e1347)) + (_e1381.member_2 * _e1348)) * _e1376);
let _e1395 = global_3.member.member_10.member_4.member_1;
let _e1404 = ((((_e1395.member * _e1346) + (_e1395.member_1 * _e1347)) + (_e1395.member_2 * _e1348)) * _e1376);
let _e1409 = global_3.member.member_10.member_4.member_2;
let _e1412 = ((_e1390 * _e1390) + (_e1404 * _e1404));
let _e1421 = global_3.member.member_10.member_4.member_3;
let _e1422 = ((_e1409 - sqrt(select(0f, _e1412, (_e1412 > 0f)))) * _e1421);
let _e1424 = select(0f, _e1422, (_e1422 > 0f));
let _e1426 = select(1f, _e1424, (_e1424 < 1f));
let _e1432 = select(0f, ((_e1426 * _e1426) * (3f - (2f * _e1426))), (_e1373 > 0f));
let _e1437 = global_3.member.member_10.member_4.member_5;
if ((_e1437 > 0u) && (_e1432 > 0f)) {
let _e1441 = (0.5f / _e1409);
let _e1451 = global_3.member.member_10.member_4.member_6;
let _e1452 = bitcast<i32>(_e1451);
local = bitcast<i32>(_e1437);
let _e1453 = local;
let _e1455 = f32((_e1453 - 1i));
let _e1457 = f32((_e1452 - 1i));
let _e1458 = local;
let _e1461 = (((0.5f + (_e1390 * _e1441)) * f32(_e1458)) - 0.5f);
let _e1463 = select(0f, _e1461, (_e1461 > 0f));
let _e1465 = select(_e1455, _e1463, (_e1463 < _e1455));
let _e1468 = (((0.5f - (_e1404 * _e1441)) * f32(_e1452)) - 0.5f);
let _e1470 = select(0f, _e1468, (_e1468 > 0f));
let _e1472 = select(_e1457, _e1470, (_e1470 < _e1457));
let _e1474 = select(0f, _e1465, (_e1465 > 0f));
let _e1476 = select(_e1455, _e1474, (_e1474 < _e1455));
let _e1483 = select(0i, select(select(i32(_e1476), i32(-2147483648), (_e1476 < -2147483600f)), 2147483647i, (_e1476 > 2147483500f)), (_e1476 == _e1476));
let _e1487 = (_e1483 - select(0i, 1i, (_e1476 < f32(_e1483))));
let _e1489 = select(0f, _e1472, (_e1472 > 0f));
let _e1491 = select(_e1457, _e1489, (_e1489 < _e1457));
let _e1498 = select(0i, select(select(i32(_e1491), i32(-2147483648), (_e1491 < -2147483600f)), 2147483647i, (_e1491 > 2147483500f)), (_e1491 == _e1491));
let _e1502 = (_e1498 - select(0i, 1i, (_e1491 < f32(_e1498))));
let _e1504 = (_e1465 - f32(_e1487));
let _e1506 = (_e1472 - f32(_e1502));
let _e1507 = (_e1487 + 1i);
let _e1508 = local;
let _e1510 = select(_e1487, _e1507, (_e1507 < _e1508));
let _e1511 = (_e1502 + 1i);
let _e1513 = select(_e1502, _e1511, (_e1511 < _e1452));
let _e1518 = global_3.member.member_10.member_4.member_4;
let _e1519 = bitcast<i32>(_e1518);
let _e1520 = local;
let _e1524 = (_e1519 + (3i * ((_e1502 * _e1520) + _e1487)));
let _e1526 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1528 = select(_e1526, _e1524, (_e1524 < _e1526));
let _e1533 = global_5.member[bitcast<u32>(select(0i, _e1528, (_e1528 > 0i)))];
let _e1534 = (_e1524 + 1i);
let _e1536 = select(_e1526, _e1534, (_e1534 < _e1526));
let _e1541 = global_5.member[bitcast<u32>(select(0i, _e1536, (_e1536 > 0i)))];
let _e1542 = (_e1524 + 2i);
let _e1544 = select(_e1526, _e1542, (_e1542 < _e1526));
let _e1549 = global_5.member[bitcast<u32>(select(0i, _e1544, (_e1544 > 0i)))];
let _e1550 = local;
let _e1554 = (_e1519 + (3i * ((_e1502 * _e1550) + _e1510)));
let _e1556 = select(_e1526, _e1554, (_e1554 < _e1526));
let _e1561 = global_5.member[bitcast<u32>(select(0i, _e1556, (_e1556 > 0i)))];
let _e1562 = (_e1554 + 1i);
let _e1564 = select(_e1526, _e1562, (_e1562 < _e1526));
let _e1569 = global_5.member[bitcast<u32>(select(0i, _e1564, (_e1564 > 0i)))];
let _e1570 = (_e1554 + 2i);
let _e1572 = select(_e1526, _e1570, (_e1570 < _e1526));
let _e1577 = global_5.member[bitcast<u32>(select(0i, _e1572, (_e1572 > 0i)))];
let _e1578 = local;
let _e1582 = (_e1519 + (3i * ((_e1513 * _e1578) + _e1487)));
let _e1584 = select(_e1526, _e1582, (_e1582 < _e1526));
let _e1589 = global_5.member[bitcast<u32>(select(0i, _e1584, (_e1584 > 0i)))];
let _e1590 = (_e1582 + 1i);
let _e1592 = select(_e1526, _e1590, (_e1590 < _e1526));
let _e1597 = global_5.member[bitcast<u32>(select(0i, _e1592, (_e1592 > 0i)))];
let _e1598 = (_e1582 + 2i);
let _e1600 = select(_e1526, _e1598, (_e1598 < _e1526));
let _e1605 = global_5.member[bitcast<u32>(select(0i, _e1600, (_e1600 > 0i)))];
let _e1606 = local;
let _e1610 = (_e1519 + (3i * ((_e1513 * _e1606) + _e1510)));
let _e1612 = select(_e1526, _e1610, (_e1610 < _e1526));
let _e1617 = global_5.member[bitcast<u32>(select(0i, _e1612, (_e1612 > 0i)))];
let _e1618 = (_e1610 + 1i);
let _e1620 = select(_e1526, _e1618, (_e1618 < _e1526));
let _e1625 = global_5.member[bitcast<u32>(select(0i, _e1620, (_e1620 > 0i)))];
let _e1626 = (_e1610 + 2i);
let _e1628 = select(_e1526, _e1626, (_e1626 < _e1526));
let _e1633 = global_5.member[bitcast<u32>(select(0i, _e1628, (_e1628 > 0i)))];
let _e1640 = (_e1533 + ((_e1561 - _e1533) * _e1504));
let _e1641 = (_e1541 + ((_e1569 - _e1541) * _e1504));
let _e1642 = (_e1549 + ((_e1577 - _e1549) * _e1504));
phi_2936_ = vec3<f32>(((_e1640 + (((_e1589 + ((_e1617 - _e1589) * _e1504)) - _e1640) * _e1506)) * _e1432), ((_e1641 + (((_e1597 + ((_e1625 - _e1597) * _e1504)) - _e1641) * _e1506)) * _e1432), ((_e1642 + (((_e1605 + ((_e1633 - _e1605) * _e1504)) - _e1642) * _e1506)) * _e1432));
} else {
phi_2936_ = vec3(_e1432);
}
let _e1667 = phi_2936_;
phi_2939_ = (_e1360 * _e1667);
} else {
phi_2939_ = _e1360;
}
let _e1670 = phi_2939_;
let _e1674 = (1f / sqrt(select(0f, _e1355, (_e1355 > 0f))));
phi_2952_ = type_25(vec3<f32>((_e1346 * _e1674), (_e1347 * _e1674), (_e1348 * _e1674)), _e1670);
}
let _e1681 = phi_2952_;
phi_2959_ = (_e1681.member_1 * ((3.1415927f * _e1294) * ((_e1311 * _e1311) * _e1311)));
}
let _e1689 = phi_2959_;
let _e1712 = (((_e548 * _e548) + (_e549 * _e549)) + (_e550 * _e550));
let _e1720 = (((_e554 * _e554) + (_e555 * _e555)) + (_e556 * _e556));
let _e1732 = (((_e526 * _e526) + (_e527 * _e527)) + (_e528 * _e528));
let _e1740 = (((_e542 * _e542) + (_e543 * _e543)) + (_e544 * _e544));
global_2.member[_e98] = (_e121 + (_e153 * _e511));
global_2.member[(_e96 + _e98)] = (_e131 + (_e164 * _e511));
global_2.member[((2u * _e96) + _e98)] = (_e142 + (_e175 * _e511));
global_2.member[((3u * _e96) + _e98)] = _e153;
global_2.member[((4u * _e96) + _e98)] = _e164;
global_2.member[((5u * _e96) + _e98)] = _e175;
global_2.member[((6u * _e96) + _e98)] = _e548;
global_2.member[((7u * _e96) + _e98)] = _e549;
global_2.member[((8u * _e96) + _e98)] = _e550;
global_2.member[((9u * _e96) + _e98)] = _e554;
global_2.member[((10u * _e96) + _e98)] = _e555;
global_2.member[((11u * _e96) + _e98)] = _e556;
global_2.member[((12u * _e96) + _e98)] = _e526;
global_2.member[((13u * _e96) + _e98)] = _e527;
global_2.member[((14u * _e96) + _e98)] = _e528;
global_2.member[((15u * _e96) + _e98)] = _e542;
global_2.member[((16u * _e96) + _e98)] = _e543;
global_2.member[((17u * _e96) + _e98)] = _e544;
global_2.member[((18u * _e96) + _e98)] = select(0f, ((_e1689.x * _e318) * ((1f + (_e1177 * (1f + (_e1177 * (0.5f + (_e1177 * (0.16666667f + (_e1177 * (0.041666668f + (_e1177 * (0.008333334f + (_e1177 * (0.001388889f + (_e1177 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1172 + 127i)) << bitcast<u32>(23i))))), _e433);
global_2.member[((19u * _e96) + _e98)] = select(0f, ((_e1689.y * _e329) * ((1f + (_e1225 * (1f + (_e1225 * (0.5f + (_e1225 * (0.16666667f + (_e1225 * (0.041666668f + (_e1225 * (0.008333334f + (_e1225 * (0.001388889f + (_e1225 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1220 + 127i)) << bitcast<u32>(23i))))), _e433);
global_2.member[((20u * _e96) + _e98)] = select(0f, ((_e1689.z * _e340) * ((1f + (_e1273 * (1f + (_e1273 * (0.5f + (_e1273 * (0.16666667f + (_e1273 * (0.041666668f + (_e1273 * (0.008333334f + (_e1273 * (0.001388889f + (_e1273 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1268 + 127i)) << bitcast<u32>(23i))))), _e433);
global_2.member[((21u * _e96) + _e98)] = select(-(1e30f), (0.5f * (sqrt(select(0f, _e1712, (_e1712 > 0f))) + sqrt(select(0f, _e1720, (_e1720 > 0f))))), _e433);
global_2.member[((22u * _e96) + _e98)] = (0.5f * (sqrt(select(0f, _e1732, (_e1732 > 0f))) + sqrt(select(0f, _e1740, (_e1740 > 0f)))));
global_2.member[((23u * _e96) + _e98)] = (select(_e434, _e509, _e510) - _e511);
global_2.member[((24u * _e96) + _e98)] = (_e435 - _e511);
global_2.member[((25u * _e96) + _e98)] = f32(select(_e402, -1i, _e418));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
