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
struct type_11 {
member: array<f32>,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(5)
var<storage> global_5: type_11;
@group(0) @binding(6)
var<storage, read_write> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_3636_: type_29;
var phi_4245_: type_30;
var phi_5077_: type_5;
var phi_6103_: vec3<f32>;
var phi_6104_: bool;
switch bitcast<i32>(0u) {
default: {
let _e88 = global;
let _e91 = arrayLength((&global_2.member));
let _e95 = arrayLength((&global_4.member));
let _e102 = global_1.member.member_2;
let _e105 = global_1.member.member;
let _e113 = (_e88.x + _e102.member);
let _e115 = (_e88.y + _e102.member_1);
if (_e113 < _e102.member_2) {
if (_e115 < _e102.member_3) {
let _e118 = (_e105.member * _e105.member_1);
let _e120 = ((_e115 * _e105.member) + _e113);
let _e121 = bitcast<i32>(_e120);
let _e123 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e125 = select(_e123, _e121, (_e121 < _e123));
let _e131 = global_6.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e132 = (_e118 + _e120);
let _e133 = bitcast<i32>(_e132);
let _e135 = select(_e123, _e133, (_e133 < _e123));
let _e141 = global_6.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
let _e143 = ((2u * _e118) + _e120);
let _e144 = bitcast<i32>(_e143);
let _e146 = select(_e123, _e144, (_e144 < _e123));
let _e152 = global_6.member[bitcast<u32>(select(0i, _e146, (_e146 > 0i)))];
let _e154 = ((3u * _e118) + _e120);
let _e155 = bitcast<i32>(_e154);
let _e157 = select(_e123, _e155, (_e155 < _e123));
let _e163 = global_6.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e165 = ((4u * _e118) + _e120);
let _e166 = bitcast<i32>(_e165);
let _e168 = select(_e123, _e166, (_e166 < _e123));
let _e174 = global_6.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e176 = ((5u * _e118) + _e120);
let _e177 = bitcast<i32>(_e176);
let _e179 = select(_e123, _e177, (_e177 < _e123));
let _e185 = global_6.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e187 = ((6u * _e118) + _e120);
let _e188 = bitcast<i32>(_e187);
let _e190 = select(_e123, _e188, (_e188 < _e123));
let _e196 = global_6.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e198 = ((7u * _e118) + _e120);
let _e199 = bitcast<i32>(_e198);
let _e201 = select(_e123, _e199, (_e199 < _e123));
let _e207 = global_6.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e209 = ((8u * _e118) + _e120);
let _e210 = bitcast<i32>(_e209);
let _e212 = select(_e123, _e210, (_e210 < _e123));
let _e218 = global_6.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e220 = ((9u * _e118) + _e120);
let _e221 = bitcast<i32>(_e220);
let _e223 = select(_e123, _e221, (_e221 < _e123));
let _e229 = global_6.member[bitcast<u32>(select(0i, _e223, (_e223 > 0i)))];
let _e231 = ((10u * _e118) + _e120);
let _e232 = bitcast<i32>(_e231);
let _e234 = select(_e123, _e232, (_e232 < _e123));
let _e240 = global_6.member[bitcast<u32>(select(0i, _e234, (_e234 > 0i)))];
let _e245 = global_1.member.member_5.member_2;
let _e248 = (1f / select(1e-6f, _e196, (_e196 > 1e-6f)));
let _e252 = global_1.member.member_8.member_5;
let _e253 = (_e245 * _e252);
let _e258 = global_1.member.member_8.member_6;
let _e260 = (((_e174 * _e248) - _e258) * _e253);
let _e265 = global_1.member.member_8.member_7;
let _e267 = (((_e185 * _e248) - _e265) * _e253);
let _e271 = ((f32(bitcast<i32>(_e113)) - 0.5f) + _e131);
let _e275 = global_1.member.member_8.member_1;
let _e276 = (_e275 + 1u);
let _e278 = select(1u, _e276, (_e276 > 0u));
let _e279 = (_e278 == 0u);
if _e279 {
break;
}
let _e284 = ((f32(bitcast<i32>((_e115 % _e278))) - 0.5f) + _e141);
let _e288 = global_1.member.member_5.member;
let _e292 = global_1.member.member_8.member_8;
let _e293 = (_e288 - _e292);
let _e297 = global_1.member.member_8.member_2;
let _e304 = global_1.member.member_8.member_4;
let _e306 = ((_e297 + (_e258 * _e293)) + ((_e271 + 0.5f) * _e304));
let _e310 = global_1.member.member_8.member_3;
let _e315 = ((_e310 + (_e265 * _e293)) + ((_e284 + 0.5f) * _e304));
let _e321 = global_1.member.member_5.member_1;
let _e322 = (_e321 - _e292);
let _e327 = ((_e297 + (_e258 * _e322)) + (((_e271 + _e260) + 0.5f) * _e304));
let _e332 = ((_e310 + (_e265 * _e322)) + (((_e284 + _e267) + 0.5f) * _e304));
if _e279 {
break;
}
let _e335 = bitcast<i32>(((_e115 / _e278) * 3u));
let _e337 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e339 = select(_e337, _e335, (_e335 < _e337));
let _e345 = global_5.member[bitcast<u32>(select(0i, _e339, (_e339 > 0i)))];
let _e346 = (_e335 + 1i);
let _e348 = select(_e337, _e346, (_e346 < _e337));
let _e354 = global_5.member[bitcast<u32>(select(0i, _e348, (_e348 > 0i)))];
let _e355 = (_e335 + 2i);
let _e357 = select(_e337, _e355, (_e355 < _e337));
let _e363 = global_5.member[bitcast<u32>(select(0i, _e357, (_e357 > 0i)))];
let _e366 = (1f / select(1e-6f, _e363, (_e363 > 1e-6f)));
let _e369 = (((_e345 * _e366) - _e258) * _e253);
let _e372 = (((_e354 * _e366) - _e265) * _e253);
let _e384 = global_1.member.member_6.member;
let _e395 = ((((_e384.member.member * _e306) + (_e384.member.member_1 * _e315)) + (_e384.member.member_2 * _e288)) + _e384.member_1);
let _e399 = global_1.member.member_6.member_1;
let _e410 = ((((_e399.member.member * _e306) + (_e399.member.member_1 * _e315)) + (_e399.member.member_2 * _e288)) + _e399.member_1);
let _e414 = global_1.member.member_6.member_2;
let _e425 = ((((_e414.member.member * _e306) + (_e414.member.member_1 * _e315)) + (_e414.member.member_2 * _e288)) + _e414.member_1);
let _e431 = ((((_e384.member.member * _e327) + (_e384.member.member_1 * _e332)) + (_e384.member.member_2 * _e321)) + _e384.member_1);
let _e437 = ((((_e399.member.member * _e327) + (_e399.member.member_1 * _e332)) + (_e399.member.member_2 * _e321)) + _e399.member_1);
let _e443 = ((((_e414.member.member * _e327) + (_e414.member.member_1 * _e332)) + (_e414.member.member_2 * _e321)) + _e414.member_1);
let _e447 = global_1.member.member_6.member_4;
let _e452 = global_1.member.member_6.member_3.member;
let _e453 = (_e452 - 0.5f);
let _e455 = select(-0.5f, _e431, (_e431 > -0.5f));
let _e457 = select(_e453, _e455, (_e455 < _e453));
let _e462 = global_1.member.member_6.member_3.member_1;
let _e463 = (_e462 - 0.5f);
let _e465 = select(-0.5f, _e437, (_e437 > -0.5f));
let _e467 = select(_e463, _e465, (_e465 < _e463));
let _e472 = global_1.member.member_6.member_3.member_2;
let _e473 = (_e472 - 0.5f);
let _e475 = select(-0.5f, _e443, (_e443 > -0.5f));
let _e477 = select(_e473, _e475, (_e475 < _e473));
let _e478 = (_e431 - _e395);
let _e479 = (_e437 - _e410);
let _e480 = (_e443 - _e425);
let _e483 = bitcast<f32>((bitcast<u32>(_e478) & 2147483647u));
let _e486 = bitcast<f32>((bitcast<u32>(_e479) & 2147483647u));
let _e488 = select(_e486, _e483, (_e483 > _e486));
let _e491 = bitcast<f32>((bitcast<u32>(_e480) & 2147483647u));
let _e500 = bitcast<f32>((bitcast<u32>((_e431 - _e457)) & 2147483647u));
let _e503 = bitcast<f32>((bitcast<u32>((_e437 - _e467)) & 2147483647u));
let _e505 = select(_e503, _e500, (_e500 > _e503));
let _e508 = bitcast<f32>((bitcast<u32>((_e443 - _e477)) & 2147483647u));
let _e512 = (_e457 + 0.5f);
let _e513 = (_e452 - 1f);
let _e515 = select(0f, _e512, (_e512 > 0f));
let _e517 = select(_e513, _e515, (_e515 < _e513));
let _e524 = select(0i, select(select(i32(_e517), i32(-2147483648), (_e517 < -2147483600f)), 2147483647i, (_e517 > 2147483500f)), (_e517 == _e517));
let _e532 = global_1.member.member_6.member_12;
let _e533 = (_e532 & 31u);
let _e536 = (_e467 + 0.5f);
let _e537 = (_e462 - 1f);
let _e539 = select(0f, _e536, (_e536 > 0f));
let _e541 = select(_e537, _e539, (_e539 < _e537));
let _e548 = select(0i, select(select(i32(_e541), i32(-2147483648), (_e541 < -2147483600f)), 2147483647i, (_e541 > 2147483500f)), (_e541 == _e541));
let _e555 = (_e477 + 0.5f);
let _e556 = (_e472 - 1f);
let _e558 = select(0f, _e555, (_e555 > 0f));
let _e560 = select(_e556, _e558, (_e558 < _e556));
let _e567 = select(0i, select(select(i32(_e560), i32(-2147483648), (_e560 < -2147483600f)), 2147483647i, (_e560 > 2147483500f)), (_e560 == _e560));
let _e578 = global_1.member.member_6.member_9.member;
let _e584 = global_1.member.member_6.member_9.member_1;
let _e589 = global_1.member.member_6.member_10;
let _e595 = ((bitcast<i32>(_e589) + ((_e524 - select(0i, 1i, (_e517 < f32(_e524)))) >> bitcast<u32>(_e533))) + (bitcast<i32>(_e578) * (((_e548 - select(0i, 1i, (_e541 < f32(_e548)))) >> bitcast<u32>(_e533)) + (bitcast<i32>(_e584) * ((_e567 - select(0i, 1i, (_e560 < f32(_e567)))) >> bitcast<u32>(_e533))))));
let _e597 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e599 = select(_e597, _e595, (_e595 < _e597));
let _e605 = global_3.member[bitcast<u32>(select(0i, _e599, (_e599 > 0i)))];
let _e611 = global_1.member.member_1;
let _e618 = (((_e611 & 64u) != 0u) || ((((select(_e491, _e488, (_e488 > _e491)) <= _e447) && ((select(_e508, _e505, (_e505 > _e508)) > _e447) || (_e605 != 0u))) && true) && ((_e611 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e260 == 0f) && (_e267 == 0f)) && (_e369 == 0f)) && (_e372 == 0f))), _e618), (_e240 == 0f)) > 1u) {
if _e279 {
break;
}
if _e279 {
break;
}
let _e625 = (_e105.member_2 == 2u);
let _e628 = (((_e105.member_2 == 1u) || _e625) || (_e105.member_2 == 5u));
if _e628 {
let _e630 = select(-1f, _e457, (_e457 > -1f));
let _e632 = select(_e452, _e630, (_e630 < _e452));
let _e639 = select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < -2147483600f)), 2147483647i, (_e632 > 2147483500f)), (_e632 == _e632));
let _e643 = (_e639 - select(0i, 1i, (_e632 < f32(_e639))));
let _e645 = select(-1f, _e467, (_e467 > -1f));
let _e647 = select(_e462, _e645, (_e645 < _e462));
let _e654 = select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < -2147483600f)), 2147483647i, (_e647 > 2147483500f)), (_e647 == _e647));
let _e658 = (_e654 - select(0i, 1i, (_e647 < f32(_e654))));
let _e660 = select(-1f, _e477, (_e477 > -1f));
let _e662 = select(_e472, _e660, (_e660 < _e472));
let _e669 = select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < -2147483600f)), 2147483647i, (_e662 > 2147483500f)), (_e662 == _e662));
let _e673 = (_e669 - select(0i, 1i, (_e662 < f32(_e669))));
let _e677 = global_1.member.member_6.member_7;
let _e681 = global_1.member.member_6.member_8;
let _e682 = (_e643 + 1i);
let _e683 = (_e658 + 1i);
let _e684 = (_e673 + 1i);
let _e689 = global_1.member.member_6.member_11.member;
let _e695 = global_1.member.member_6.member_11.member_1;
let _e706 = ((_e682 >> bitcast<u32>(4i)) + (bitcast<i32>(_e689) * ((_e683 >> bitcast<u32>(4i)) + (bitcast<i32>(_e695) * (_e684 >> bitcast<u32>(4i))))));
let _e708 = (bitcast<i32>(_e91) - 1i);
let _e710 = select(_e708, _e706, (_e706 < _e708));
let _e716 = global_2.member[bitcast<u32>(select(0i, _e710, (_e710 > 0i)))];
let _e718 = (_e682 & 15i);
let _e721 = ((_e683 & 15i) * _e677);
let _e723 = (bitcast<i32>(_e716) + ((_e684 & 15i) * _e681));
let _e727 = (_e721 + _e677);
let _e729 = (_e721 + (2i * _e677));
let _e731 = (_e721 + (3i * _e677));
let _e732 = (_e723 + _e681);
let _e734 = (_e723 + (2i * _e681));
let _e736 = (_e723 + (3i * _e681));
local_4 = type_28(array<i32, 4>(_e718, (_e718 + 1i), (_e718 + 2i), (_e718 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e457 - f32(_e643)), (_e467 - f32(_e658)), (_e477 - f32(_e673)));
let _e747 = (_e732 + _e727);
let _e750 = local_4.member[0u];
let _e751 = (_e747 + _e750);
let _e753 = select(_e708, _e751, (_e751 < _e708));
let _e758 = global_2.member[bitcast<u32>(select(0i, _e753, (_e753 > 0i)))];
let _e759 = bitcast<f32>(_e758);
let _e762 = local_4.member[1u];
let _e763 = (_e747 + _e762);
let _e765 = select(_e708, _e763, (_e763 < _e708));
let _e770 = global_2.member[bitcast<u32>(select(0i, _e765, (_e765 > 0i)))];
let _e771 = bitcast<f32>(_e770);
let _e774 = local_4.member[2u];
let _e775 = (_e747 + _e774);
let _e777 = select(_e708, _e775, (_e775 < _e708));
let _e782 = global_2.member[bitcast<u32>(select(0i, _e777, (_e777 > 0i)))];
let _e783 = bitcast<f32>(_e782);
let _e786 = local_4.member[3u];
let _e787 = (_e747 + _e786);
let _e789 = select(_e708, _e787, (_e787 < _e708));
let _e794 = global_2.member[bitcast<u32>(select(0i, _e789, (_e789 > 0i)))];
let _e796 = local_5[0u];
let _e799 = (_e759 + ((_e771 - _e759) * _e796));
let _e800 = local_5[0u];
let _e803 = (_e771 + ((_e783 - _e771) * _e800));
let _e804 = local_5[0u];
let _e807 = (_e783 + ((bitcast<f32>(_e794) - _e783) * _e804));
let _e808 = (_e732 + _e729);
let _e809 = local_4.member[0u];
let _e810 = (_e808 + _e809);
let _e812 = select(_e708, _e810, (_e810 < _e708));
let _e817 = global_2.member[bitcast<u32>(select(0i, _e812, (_e812 > 0i)))];
let _e818 = bitcast<f32>(_e817);
let _e819 = local_4.member[1u];
let _e820 = (_e808 + _e819);
let _e822 = select(_e708, _e820, (_e820 < _e708));
let _e827 = global_2.member[bitcast<u32>(select(0i, _e822, (_e822 > 0i)))];
let _e828 = bitcast<f32>(_e827);
let _e829 = local_4.member[2u];
let _e830 = (_e808 + _e829);
let _e832 = select(_e708, _e830, (_e830 < _e708));
let _e837 = global_2.member[bitcast<u32>(select(0i, _e832, (_e832 > 0i)))];
let _e838 = bitcast<f32>(_e837);
let _e839 = local_4.member[3u];
let _e840 = (_e808 + _e839);
let _e842 = select(_e708, _e840, (_e840 < _e708));
let _e847 = global_2.member[bitcast<u32>(select(0i, _e842, (_e842 > 0i)))];
let _e849 = local_5[0u];
let _e853 = local_5[0u];
let _e856 = (_e828 + ((_e838 - _e828) * _e853));
let _e857 = local_5[0u];
let _e861 = (_e734 + _e727);
let _e862 = local_4.member[0u];
let _e863 = (_e861 + _e862);
let _e865 = select(_e708, _e863, (_e863 < _e708));
let _e870 = global_2.member[bitcast<u32>(select(0i, _e865, (_e865 > 0i)))];
let _e871 = bitcast<f32>(_e870);
let _e872 = local_4.member[1u];
let _e873 = (_e861 + _e872);
let _e875 = select(_e708, _e873, (_e873 < _e708));
let _e880 = global_2.member[bitcast<u32>(select(0i, _e875, (_e875 > 0i)))];
let _e881 = bitcast<f32>(_e880);
let _e882 = local_4.member[2u];
let _e883 = (_e861 + _e882);
let _e885 = select(_e708, _e883, (_e883 < _e708));
let _e890 = global_2.member[bitcast<u32>(select(0i, _e885, (_e885 > 0i)))];
let _e891 = bitcast<f32>(_e890);
let _e892 = local_4.member[3u];
let _e893 = (_e861 + _e892);
let _e895 = select(_e708, _e893, (_e893 < _e708));
let _e900 = global_2.member[bitcast<u32>(select(0i, _e895, (_e895 > 0i)))];
let _e902 = local_5[0u];
let _e905 = (_e871 + ((_e881 - _e871) * _e902));
let _e906 = local_5[0u];
let _e909 = (_e881 + ((_e891 - _e881) * _e906));
let _e910 = local_5[0u];
let _e913 = (_e891 + ((bitcast<f32>(_e900) - _e891) * _e910));
let _e914 = (_e734 + _e729);
let _e915 = local_4.member[0u];
let _e916 = (_e914 + _e915);
let _e918 = select(_e708, _e916, (_e916 < _e708));
let _e923 = global_2.member[bitcast<u32>(select(0i, _e918, (_e918 > 0i)))];
let _e924 = bitcast<f32>(_e923);
let _e925 = local_4.member[1u];
let _e926 = (_e914 + _e925);
let _e928 = select(_e708, _e926, (_e926 < _e708));
let _e933 = global_2.member[bitcast<u32>(select(0i, _e928, (_e928 > 0i)))];
let _e934 = bitcast<f32>(_e933);
let _e935 = local_4.member[2u];
let _e936 = (_e914 + _e935);
let _e938 = select(_e708, _e936, (_e936 < _e708));
let _e943 = global_2.member[bitcast<u32>(select(0i, _e938, (_e938 > 0i)))];
let _e944 = bitcast<f32>(_e943);
let _e945 = local_4.member[3u];
let _e946 = (_e914 + _e945);
let _e948 = select(_e708, _e946, (_e946 < _e708));
let _e953 = global_2.member[bitcast<u32>(select(0i, _e948, (_e948 > 0i)))];
let _e955 = local_5[0u];
let _e959 = local_5[0u];
let _e962 = (_e934 + ((_e944 - _e934) * _e959));
let _e963 = local_5[0u];
let _e967 = (_e732 + _e721);
let _e968 = local_4.member[1u];
let _e969 = (_e967 + _e968);
let _e971 = select(_e708, _e969, (_e969 < _e708));
let _e976 = global_2.member[bitcast<u32>(select(0i, _e971, (_e971 > 0i)))];
let _e977 = bitcast<f32>(_e976);
let _e978 = local_4.member[2u];
let _e979 = (_e967 + _e978);
let _e981 = select(_e708, _e979, (_e979 < _e708));
let _e986 = global_2.member[bitcast<u32>(select(0i, _e981, (_e981 > 0i)))];
let _e988 = local_5[0u];
let _e991 = (_e977 + ((bitcast<f32>(_e986) - _e977) * _e988));
let _e992 = (_e732 + _e731);
let _e993 = local_4.member[1u];
let _e994 = (_e992 + _e993);
let _e996 = select(_e708, _e994, (_e994 < _e708));
let _e1001 = global_2.member[bitcast<u32>(select(0i, _e996, (_e996 > 0i)))];
let _e1002 = bitcast<f32>(_e1001);
let _e1003 = local_4.member[2u];
let _e1004 = (_e992 + _e1003);
let _e1006 = select(_e708, _e1004, (_e1004 < _e708));
let _e1011 = global_2.member[bitcast<u32>(select(0i, _e1006, (_e1006 > 0i)))];
let _e1013 = local_5[0u];
let _e1017 = (_e734 + _e721);
let _e1018 = local_4.member[1u];
let _e1019 = (_e1017 + _e1018);
let _e1021 = select(_e708, _e1019, (_e1019 < _e708));
let _e1026 = global_2.member[bitcast<u32>(select(0i, _e1021, (_e1021 > 0i)))];
let _e1027 = bitcast<f32>(_e1026);
let _e1028 = local_4.member[2u];
let _e1029 = (_e1017 + _e1028);
let _e1031 = select(_e708, _e1029, (_e1029 < _e708));
let _e1036 = global_2.member[bitcast<u32>(select(0i, _e1031, (_e1031 > 0i)))];
let _e1038 = local_5[0u];
let _e1041 = (_e1027 + ((bitcast<f32>(_e1036) - _e1027) * _e1038));
let _e1042 = (_e734 + _e731);
let _e1043 = local_4.member[1u];
let _e1044 = (_e1042 + _e1043);
let _e1046 = select(_e708, _e1044, (_e1044 < _e708));
let _e1051 = global_2.member[bitcast<u32>(select(0i, _e1046, (_e1046 > 0i)))];
let _e1052 = bitcast<f32>(_e1051);
let _e1053 = local_4.member[2u];
let _e1054 = (_e1042 + _e1053);
let _e1056 = select(_e708, _e1054, (_e1054 < _e708));
let _e1061 = global_2.member[bitcast<u32>(select(0i, _e1056, (_e1056 > 0i)))];
let _e1063 = local_5[0u];
let _e1067 = (_e723 + _e727);
let _e1068 = local_4.member[1u];
let _e1069 = (_e1067 + _e1068);
let _e1071 = select(_e708, _e1069, (_e1069 < _e708));
let _e1076 = global_2.member[bitcast<u32>(select(0i, _e1071, (_e1071 > 0i)))];
let _e1077 = bitcast<f32>(_e1076);
let _e1078 = local_4.member[2u];
let _e1079 = (_e1067 + _e1078);
let _e1081 = select(_e708, _e1079, (_e1079 < _e708));
let _e1086 = global_2.member[bitcast<u32>(select(0i, _e1081, (_e1081 > 0i)))];
let _e1088 = local_5[0u];
let _e1091 = (_e1077 + ((bitcast<f32>(_e1086) - _e1077) * _e1088));
let _e1092 = (_e736 + _e727);
let _e1093 = local_4.member[1u];
let _e1094 = (_e1092 + _e1093);
let _e1096 = select(_e708, _e1094, (_e1094 < _e708));
let _e1101 = global_2.member[bitcast<u32>(select(0i, _e1096, (_e1096 > 0i)))];
let _e1102 = bitcast<f32>(_e1101);
let _e1103 = local_4.member[2u];
let _e1104 = (_e1092 + _e1103);
let _e1106 = select(_e708, _e1104, (_e1104 < _e708));
let _e1111 = global_2.member[bitcast<u32>(select(0i, _e1106, (_e1106 > 0i)))];
let _e1113 = local_5[0u];
let _e1116 = (_e1102 + ((bitcast<f32>(_e1111) - _e1102) * _e1113));
let _e1117 = (_e723 + _e729);
let _e1118 = local_4.member[1u];
let _e1119 = (_e1117 + _e1118);
let _e1121 = select(_e708, _e1119, (_e1119 < _e708));
let _e1126 = global_2.member[bitcast<u32>(select(0i, _e1121, (_e1121 > 0i)))];
let _e1127 = bitcast<f32>(_e1126);
let _e1128 = local_4.member[2u];
let _e1129 = (_e1117 + _e1128);
let _e1131 = select(_e708, _e1129, (_e1129 < _e708));
let _e1136 = global_2.member[bitcast<u32>(select(0i, _e1131, (_e1131 > 0i)))];
let _e1138 = local_5[0u];
let _e1142 = (_e736 + _e729);
let _e1143 = local_4.member[1u];
let _e1144 = (_e1142 + _e1143);
let _e1146 = select(_e708, _e1144, (_e1144 < _e708));
let _e1151 = global_2.member[bitcast<u32>(select(0i, _e1146, (_e1146 > 0i)))];
let _e1152 = bitcast<f32>(_e1151);
let _e1153 = local_4.member[2u];
let _e1154 = (_e1142 + _e1153);
let _e1156 = select(_e708, _e1154, (_e1154 < _e708));
let _e1161 = global_2.member[bitcast<u32>(select(0i, _e1156, (_e1156 > 0i)))];
let _e1163 = local_5[0u];
let _e1168 = local_5[1u];
let _e1171 = (_e803 + ((_e856 - _e803) * _e1168));
let _e1172 = local_5[1u];
let _e1175 = (_e909 + ((_e962 - _e909) * _e1172));
let _e1176 = local_5[1u];
let _e1179 = (_e799 + (((_e818 + ((_e828 - _e818) * _e849)) - _e799) * _e1176));
let _e1180 = local_5[1u];
let _e1185 = local_5[2u];
let _e1189 = local_5[1u];
let _e1192 = (_e807 + (((_e838 + ((bitcast<f32>(_e847) - _e838) * _e857)) - _e807) * _e1189));
let _e1193 = local_5[1u];
let _e1197 = local_5[2u];
let _e1201 = local_5[1u];
let _e1204 = (_e991 + ((_e803 - _e991) * _e1201));
let _e1205 = local_5[1u];
let _e1209 = local_5[2u];
let _e1213 = local_5[1u];
let _e1216 = (_e856 + (((_e1002 + ((bitcast<f32>(_e1011) - _e1002) * _e1013)) - _e856) * _e1213));
let _e1217 = local_5[1u];
let _e1221 = local_5[2u];
let _e1225 = local_5[1u];
let _e1228 = (_e1091 + (((_e1127 + ((bitcast<f32>(_e1136) - _e1127) * _e1138)) - _e1091) * _e1225));
let _e1229 = local_5[2u];
let _e1233 = local_5[1u];
let _e1237 = local_5[2u];
let _e1241 = local_5[2u];
let _e1248 = global_1.member.member_6.member_5;
let _e1253 = global_1.member.member_6.member_6;
let _e1254 = (((_e1171 + ((_e1175 - _e1171) * _e1241)) * _e1248) + _e1253);
let _e1256 = select(0f, _e1254, (_e1254 > 0f));
let _e1258 = select(1f, _e1256, (_e1256 < 1f));
let _e1260 = (((_e1179 + (((_e905 + (((_e924 + ((_e934 - _e924) * _e955)) - _e905) * _e1180)) - _e1179) * _e1185)) * _e1248) + _e1253);
let _e1262 = select(0f, _e1260, (_e1260 > 0f));
let _e1264 = select(1f, _e1262, (_e1262 < 1f));
let _e1266 = (((_e1192 + (((_e913 + (((_e944 + ((bitcast<f32>(_e953) - _e944) * _e963)) - _e913) * _e1193)) - _e1192) * _e1197)) * _e1248) + _e1253);
let _e1268 = select(0f, _e1266, (_e1266 > 0f));
let _e1270 = select(1f, _e1268, (_e1268 < 1f));
let _e1272 = (((_e1204 + (((_e1041 + ((_e909 - _e1041) * _e1205)) - _e1204) * _e1209)) * _e1248) + _e1253);
let _e1274 = select(0f, _e1272, (_e1272 > 0f));
let _e1276 = select(1f, _e1274, (_e1274 < 1f));
let _e1278 = (((_e1216 + (((_e962 + (((_e1052 + ((bitcast<f32>(_e1061) - _e1052) * _e1063)) - _e962) * _e1217)) - _e1216) * _e1221)) * _e1248) + _e1253);
let _e1280 = select(0f, _e1278, (_e1278 > 0f));
let _e1282 = select(1f, _e1280, (_e1280 < 1f));
let _e1284 = (((_e1228 + ((_e1171 - _e1228) * _e1229)) * _e1248) + _e1253);
let _e1286 = select(0f, _e1284, (_e1284 > 0f));
let _e1288 = select(1f, _e1286, (_e1286 < 1f));
let _e1290 = (((_e1175 + (((_e1116 + (((_e1152 + ((bitcast<f32>(_e1161) - _e1152) * _e1163)) - _e1116) * _e1233)) - _e1175) * _e1237)) * _e1248) + _e1253);
let _e1292 = select(0f, _e1290, (_e1290 > 0f));
let _e1294 = select(1f, _e1292, (_e1292 < 1f));
let _e1295 = (_e1258 * 1024f);
let _e1296 = (1024f - 1f);
let _e1298 = select(0f, _e1295, (_e1295 > 0f));
let _e1300 = select(_e1296, _e1298, (_e1298 < _e1296));
let _e1307 = select(0i, select(select(i32(_e1300), i32(-2147483648), (_e1300 < -2147483600f)), 2147483647i, (_e1300 > 2147483500f)), (_e1300 == _e1300));
let _e1311 = (_e1307 - select(0i, 1i, (_e1300 < f32(_e1307))));
let _e1312 = (262147i + _e1311);
let _e1314 = (bitcast<i32>(_e95) - 1i);
let _e1316 = select(_e1314, _e1312, (_e1312 < _e1314));
let _e1322 = global_4.member[bitcast<u32>(select(0i, _e1316, (_e1316 > 0i)))];
let _e1332 = select(_e1314, 262146i, (262146i < _e1314));
let _e1338 = global_4.member[bitcast<u32>(select(0i, _e1332, (_e1332 > 0i)))];
let _e1339 = bitcast<f32>(_e1338);
let _e1340 = (f32((bitcast<i32>((_e1322 & 4095u)) - 2048i)) * _e1339);
let _e1342 = select(_e1314, 262144i, (262144i < _e1314));
let _e1348 = global_4.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
let _e1349 = bitcast<f32>(_e1348);
let _e1351 = select(_e1314, 262145i, (262145i < _e1314));
let _e1357 = global_4.member[bitcast<u32>(select(0i, _e1351, (_e1351 > 0i)))];
let _e1358 = bitcast<f32>(_e1357);
let _e1364 = ((_e1349 + (f32(bitcast<i32>((_e1322 >> bitcast<u32>(12u)))) * _e1358)) + (_e1340 * (_e1295 - f32(_e1311))));
let _e1365 = (_e1340 * 1024f);
if _e625 {
let _e1372 = ((0.5f * (_e1270 - _e1264)) * _e1365);
let _e1373 = ((0.5f * (_e1282 - _e1276)) * _e1365);
let _e1374 = ((0.5f * (_e1294 - _e1288)) * _e1365);
phi_3636_ = type_29(_e1364, vec3<f32>(_e1372, _e1373, _e1374), vec3<f32>((_e1372 * _e1364), (_e1373 * _e1364), (_e1374 * _e1364)));
} else {
let _e1381 = (_e1264 * 1024f);
let _e1383 = select(0f, _e1381, (_e1381 > 0f));
let _e1385 = select(_e1296, _e1383, (_e1383 < _e1296));
let _e1392 = select(0i, select(select(i32(_e1385), i32(-2147483648), (_e1385 < -2147483600f)), 2147483647i, (_e1385 > 2147483500f)), (_e1385 == _e1385));
let _e1396 = (_e1392 - select(0i, 1i, (_e1385 < f32(_e1392))));
let _e1397 = (262147i + _e1396);
let _e1399 = select(_e1314, _e1397, (_e1397 < _e1314));
let _e1405 = global_4.member[bitcast<u32>(select(0i, _e1399, (_e1399 > 0i)))];
let _e1420 = ((_e1349 + (f32(bitcast<i32>((_e1405 >> bitcast<u32>(12u)))) * _e1358)) + ((f32((bitcast<i32>((_e1405 & 4095u)) - 2048i)) * _e1339) * (_e1381 - f32(_e1396))));
let _e1421 = (_e1270 * 1024f);
let _e1423 = select(0f, _e1421, (_e1421 > 0f));
let _e1425 = select(_e1296, _e1423, (_e1423 < _e1296));
let _e1432 = select(0i, select(select(i32(_e1425), i32(-2147483648), (_e1425 < -2147483600f)), 2147483647i, (_e1425 > 2147483500f)), (_e1425 == _e1425));
let _e1436 = (_e1432 - select(0i, 1i, (_e1425 < f32(_e1432))));
let _e1437 = (262147i + _e1436);
let _e1439 = select(_e1314, _e1437, (_e1437 < _e1314));
let _e1445 = global_4.member[bitcast<u32>(select(0i, _e1439, (_e1439 > 0i)))];
let _e1460 = ((_e1349 + (f32(bitcast<i32>((_e1445 >> bitcast<u32>(12u)))) * _e1358)) + ((f32((bitcast<i32>((_e1445 & 4095u)) - 2048i)) * _e1339) * (_e1421 - f32(_e1436))));
let _e1461 = (_e1276 * 1024f);
let _e1463 = select(0f, _e1461, (_e1461 > 0f));
let _e1465 = select(_e1296, _e1463, (_e1463 < _e1296));
let _e1472 = select(0i, select(select(i32(_e1465), i32(-2147483648), (_e1465 < -2147483600f)), 2147483647i, (_e1465 > 2147483500f)), (_e1465 == _e1465));
let _e1476 = (_e1472 - select(0i, 1i, (_e1465 < f32(_e1472))));
let _e1477 = (262147i + _e1476);
let _e1479 = select(_e1314, _e1477, (_e1477 < _e1314));
let _e1485 = global_4.member[bitcast<u32>(select(0i, _e1479, (_e1479 > 0i)))];
let _e1500 = ((_e1349 + (f32(bitcast<i32>((_e1485 >> bitcast<u32>(12u)))) * _e1358)) + ((f32((bitcast<i32>((_e1485 & 4095u)) - 2048i)) * _e1339) * (_e1461 - f32(_e1476))));
let _e1501 = (_e1282 * 1024f);
let _e1503 = select(0f, _e1501, (_e1501 > 0f));
let _e1505 = select(_e1296, _e1503, (_e1503 < _e1296));
let _e1512 = select(0i, select(select(i32(_e1505), i32(-2147483648), (_e1505 < -2147483600f)), 2147483647i, (_e1505 > 2147483500f)), (_e1505 == _e1505));
let _e1516 = (_e1512 - select(0i, 1i, (_e1505 < f32(_e1512))));
let _e1517 = (262147i + _e1516);
let _e1519 = select(_e1314, _e1517, (_e1517 < _e1314));
let _e1525 = global_4.member[bitcast<u32>(select(0i, _e1519, (_e1519 > 0i)))];
let _e1540 = ((_e1349 + (f32(bitcast<i32>((_e1525 >> bitcast<u32>(12u)))) * _e1358)) + ((f32((bitcast<i32>((_e1525 & 4095u)) - 2048i)) * _e1339) * (_e1501 - f32(_e1516))));
let _e1541 = (_e1288 * 1024f);
let _e1543 = select(0f, _e1541, (_e1541 > 0f));
let _e1545 = select(_e1296, _e1543, (_e1543 < _e1296));
let _e1552 = select(0i, select(select(i32(_e1545), i32(-2147483648), (_e1545 < -2147483600f)), 2147483647i, (_e1545 > 2147483500f)), (_e1545 == _e1545));
let _e1556 = (_e1552 - select(0i, 1i, (_e1545 < f32(_e1552))));
let _e1557 = (262147i + _e1556);
let _e1559 = select(_e1314, _e1557, (_e1557 < _e1314));
let _e1565 = global_4.member[bitcast<u32>(select(0i, _e1559, (_e1559 > 0i)))];
let _e1580 = ((_e1349 + (f32(bitcast<i32>((_e1565 >> bitcast<u32>(12u)))) * _e1358)) + ((f32((bitcast<i32>((_e1565 & 4095u)) - 2048i)) * _e1339) * (_e1541 - f32(_e1556))));
let _e1581 = (_e1294 * 1024f);
let _e1583 = select(0f, _e1581, (_e1581 > 0f));
let _e1585 = select(_e1296, _e1583, (_e1583 < _e1296));
let _e1592 = select(0i, select(select(i32(_e1585), i32(-2147483648), (_e1585 < -2147483600f)), 2147483647i, (_e1585 > 2147483500f)), (_e1585 == _e1585));
let _e1596 = (_e1592 - select(0i, 1i, (_e1585 < f32(_e1592))));
let _e1597 = (262147i + _e1596);
let _e1599 = select(_e1314, _e1597, (_e1597 < _e1314));
let _e1605 = global_4.member[bitcast<u32>(select(0i, _e1599, (_e1599 > 0i)))];
let _e1620 = ((_e1349 + (f32(bitcast<i32>((_e1605 >> bitcast<u32>(12u)))) * _e1358)) + ((f32((bitcast<i32>((_e1605 & 4095u)) - 2048i)) * _e1339) * (_e1581 - f32(_e1596))));
let _e1621 = (_e1460 - _e1420);
let _e1623 = (_e1540 - _e1500);
let _e1625 = (_e1620 - _e1580);
phi_3636_ = type_29(_e1364, vec3<f32>((0.5f * _e1621), (0.5f * _e1623), (0.5f * _e1625)), vec3<f32>((0.25f * (_e1621 * (_e1460 + _e1420))), (0.25f * (_e1623 * (_e1540 + _e1500))), (0.25f * (_e1625 * (_e1620 + _e1580)))));
}
let _e1640 = phi_3636_;
let _e1655 = select(0f, 1f, ((((((_e431 >= -0.5f) && (_e431 <= _e453)) && (_e437 >= -0.5f)) && (_e437 <= _e463)) && (_e443 >= -0.5f)) && (_e443 <= _e473)));
let _e1657 = (0.5f * (_e1270 - _e1264));
let _e1659 = (0.5f * (_e1282 - _e1276));
let _e1661 = (0.5f * (_e1294 - _e1288));
let _e1667 = global_1.member.member_6.member.member.member;
let _e1673 = global_1.member.member_6.member.member.member_1;
let _e1679 = global_1.member.member_6.member.member.member_2;
let _e1685 = global_1.member.member_6.member_1.member.member;
let _e1691 = global_1.member.member_6.member_1.member.member_1;
let _e1697 = global_1.member.member_6.member_1.member.member_2;
let _e1703 = global_1.member.member_6.member_2.member.member;
let _e1709 = global_1.member.member_6.member_2.member.member_1;
let _e1715 = global_1.member.member_6.member_2.member.member_2;
phi_4245_ = type_30(_e1258, vec3<f32>(((((_e1667 * _e1657) + (_e1685 * _e1659)) + (_e1703 * _e1661)) * _e1655), ((((_e1673 * _e1657) + (_e1691 * _e1659)) + (_e1709 * _e1661)) * _e1655), ((((_e1679 * _e1657) + (_e1697 * _e1659)) + (_e1715 * _e1661)) * _e1655)), _e1640.member, vec3<f32>(((((_e1667 * _e1640.member_2.x) + (_e1685 * _e1640.member_2.y)) + (_e1703 * _e1640.member_2.z)) * _e1655), ((((_e1673 * _e1640.member_2.x) + (_e1691 * _e1640.member_2.y)) + (_e1709 * _e1640.member_2.z)) * _e1655), ((((_e1679 * _e1640.member_2.x) + (_e1697 * _e1640.member_2.y)) + (_e1715 * _e1640.member_2.z)) * _e1655)), vec3<f32>(((((_e1667 * _e1640.member_1.x) + (_e1685 * _e1640.member_1.y)) + (_e1703 * _e1640.member_1.z)) * _e1655), ((((_e1673 * _e1640.member_1.x) + (_e1691 * _e1640.member_1.y)) + (_e1709 * _e1640.member_1.z)) * _e1655), ((((_e1679 * _e1640.member_1.x) + (_e1697 * _e1640.member_1.y)) + (_e1715 * _e1640.member_1.z)) * _e1655)));
} else {
let _e1781 = select(-1f, _e457, (_e457 > -1f));
let _e1783 = select(_e452, _e1781, (_e1781 < _e452));
let _e1790 = select(0i, select(select(i32(_e1783), i32(-2147483648), (_e1783 < -2147483600f)), 2147483647i, (_e1783 > 2147483500f)), (_e1783 == _e1783));
let _e1794 = (_e1790 - select(0i, 1i, (_e1783 < f32(_e1790))));
let _e1796 = select(-1f, _e467, (_e467 > -1f));
let _e1798 = select(_e462, _e1796, (_e1796 < _e462));
let _e1805 = select(0i, select(select(i32(_e1798), i32(-2147483648), (_e1798 < -2147483600f)), 2147483647i, (_e1798 > 2147483500f)), (_e1798 == _e1798));
let _e1809 = (_e1805 - select(0i, 1i, (_e1798 < f32(_e1805))));
let _e1811 = select(-1f, _e477, (_e477 > -1f));
let _e1813 = select(_e472, _e1811, (_e1811 < _e472));
let _e1820 = select(0i, select(select(i32(_e1813), i32(-2147483648), (_e1813 < -2147483600f)), 2147483647i, (_e1813 > 2147483500f)), (_e1813 == _e1813));
let _e1824 = (_e1820 - select(0i, 1i, (_e1813 < f32(_e1820))));
let _e1828 = global_1.member.member_6.member_7;
let _e1832 = global_1.member.member_6.member_8;
let _e1833 = (_e1794 + 1i);
let _e1834 = (_e1809 + 1i);
let _e1835 = (_e1824 + 1i);
let _e1840 = global_1.member.member_6.member_11.member;
let _e1846 = global_1.member.member_6.member_11.member_1;
let _e1857 = ((_e1833 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1840) * ((_e1834 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1846) * (_e1835 >> bitcast<u32>(4i))))));
let _e1859 = (bitcast<i32>(_e91) - 1i);
let _e1861 = select(_e1859, _e1857, (_e1857 < _e1859));
let _e1867 = global_2.member[bitcast<u32>(select(0i, _e1861, (_e1861 > 0i)))];
let _e1869 = (_e1833 & 15i);
let _e1872 = ((_e1834 & 15i) * _e1828);
let _e1874 = (bitcast<i32>(_e1867) + ((_e1835 & 15i) * _e1832));
let _e1878 = (_e1872 + _e1828);
let _e1880 = (_e1872 + (2i * _e1828));
let _e1881 = (_e1874 + _e1832);
let _e1883 = (_e1874 + (2i * _e1832));
local_2 = type_28(array<i32, 4>(_e1869, (_e1869 + 1i), (_e1869 + 2i), (_e1869 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e457 - f32(_e1794)), (_e467 - f32(_e1809)), (_e477 - f32(_e1824)));
let _e1894 = (_e1881 + _e1878);
let _e1897 = local_2.member[1u];
let _e1898 = (_e1894 + _e1897);
let _e1900 = select(_e1859, _e1898, (_e1898 < _e1859));
let _e1905 = global_2.member[bitcast<u32>(select(0i, _e1900, (_e1900 > 0i)))];
let _e1906 = bitcast<f32>(_e1905);
let _e1909 = local_2.member[2u];
let _e1910 = (_e1894 + _e1909);
let _e1912 = select(_e1859, _e1910, (_e1910 < _e1859));
let _e1917 = global_2.member[bitcast<u32>(select(0i, _e1912, (_e1912 > 0i)))];
let _e1919 = local_3[0u];
let _e1922 = (_e1906 + ((bitcast<f32>(_e1917) - _e1906) * _e1919));
let _e1923 = (_e1881 + _e1880);
let _e1924 = local_2.member[1u];
let _e1925 = (_e1923 + _e1924);
let _e1927 = select(_e1859, _e1925, (_e1925 < _e1859));
let _e1932 = global_2.member[bitcast<u32>(select(0i, _e1927, (_e1927 > 0i)))];
let _e1933 = bitcast<f32>(_e1932);
let _e1934 = local_2.member[2u];
let _e1935 = (_e1923 + _e1934);
let _e1937 = select(_e1859, _e1935, (_e1935 < _e1859));
let _e1942 = global_2.member[bitcast<u32>(select(0i, _e1937, (_e1937 > 0i)))];
let _e1944 = local_3[0u];
let _e1949 = local_3[1u];
let _e1952 = (_e1922 + (((_e1933 + ((bitcast<f32>(_e1942) - _e1933) * _e1944)) - _e1922) * _e1949));
let _e1953 = (_e1883 + _e1878);
let _e1954 = local_2.member[1u];
let _e1955 = (_e1953 + _e1954);
let _e1957 = select(_e1859, _e1955, (_e1955 < _e1859));
let _e1962 = global_2.member[bitcast<u32>(select(0i, _e1957, (_e1957 > 0i)))];
let _e1963 = bitcast<f32>(_e1962);
let _e1964 = local_2.member[2u];
let _e1965 = (_e1953 + _e1964);
let _e1967 = select(_e1859, _e1965, (_e1965 < _e1859));
let _e1972 = global_2.member[bitcast<u32>(select(0i, _e1967, (_e1967 > 0i)))];
let _e1974 = local_3[0u];
let _e1977 = (_e1963 + ((bitcast<f32>(_e1972) - _e1963) * _e1974));
let _e1978 = (_e1883 + _e1880);
let _e1979 = local_2.member[1u];
let _e1980 = (_e1978 + _e1979);
let _e1982 = select(_e1859, _e1980, (_e1980 < _e1859));
let _e1987 = global_2.member[bitcast<u32>(select(0i, _e1982, (_e1982 > 0i)))];
let _e1988 = bitcast<f32>(_e1987);
let _e1989 = local_2.member[2u];
let _e1990 = (_e1978 + _e1989);
let _e1992 = select(_e1859, _e1990, (_e1990 < _e1859));
let _e1997 = global_2.member[bitcast<u32>(select(0i, _e1992, (_e1992 > 0i)))];
let _e1999 = local_3[0u];
let _e2003 = local_3[1u];
let _e2008 = local_3[2u];
let _e2015 = global_1.member.member_6.member_5;
let _e2020 = global_1.member.member_6.member_6;
let _e2021 = (((_e1952 + (((_e1977 + (((_e1988 + ((bitcast<f32>(_e1997) - _e1988) * _e1999)) - _e1977) * _e2003)) - _e1952) * _e2008)) * _e2015) + _e2020);
let _e2023 = select(0f, _e2021, (_e2021 > 0f));
phi_4245_ = type_30(select(1f, _e2023, (_e2023 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2028 = phi_4245_;
let _e2030 = select(-0.5f, _e395, (_e395 > -0.5f));
let _e2032 = select(_e453, _e2030, (_e2030 < _e453));
let _e2034 = select(-0.5f, _e410, (_e410 > -0.5f));
let _e2036 = select(_e463, _e2034, (_e2034 < _e463));
let _e2038 = select(-0.5f, _e425, (_e425 > -0.5f));
let _e2040 = select(_e473, _e2038, (_e2038 < _e473));
let _e2042 = select(-1f, _e2032, (_e2032 > -1f));
let _e2044 = select(_e452, _e2042, (_e2042 < _e452));
let _e2051 = select(0i, select(select(i32(_e2044), i32(-2147483648), (_e2044 < -2147483600f)), 2147483647i, (_e2044 > 2147483500f)), (_e2044 == _e2044));
let _e2055 = (_e2051 - select(0i, 1i, (_e2044 < f32(_e2051))));
let _e2057 = select(-1f, _e2036, (_e2036 > -1f));
let _e2059 = select(_e462, _e2057, (_e2057 < _e462));
let _e2066 = select(0i, select(select(i32(_e2059), i32(-2147483648), (_e2059 < -2147483600f)), 2147483647i, (_e2059 > 2147483500f)), (_e2059 == _e2059));
let _e2070 = (_e2066 - select(0i, 1i, (_e2059 < f32(_e2066))));
let _e2072 = select(-1f, _e2040, (_e2040 > -1f));
let _e2074 = select(_e472, _e2072, (_e2072 < _e472));
let _e2081 = select(0i, select(select(i32(_e2074), i32(-2147483648), (_e2074 < -2147483600f)), 2147483647i, (_e2074 > 2147483500f)), (_e2074 == _e2074));
let _e2085 = (_e2081 - select(0i, 1i, (_e2074 < f32(_e2081))));
let _e2089 = global_1.member.member_6.member_7;
let _e2093 = global_1.member.member_6.member_8;
let _e2094 = (_e2055 + 1i);
let _e2095 = (_e2070 + 1i);
let _e2096 = (_e2085 + 1i);
let _e2101 = global_1.member.member_6.member_11.member;
let _e2107 = global_1.member.member_6.member_11.member_1;
let _e2118 = ((_e2094 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2101) * ((_e2095 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2107) * (_e2096 >> bitcast<u32>(4i))))));
let _e2120 = (bitcast<i32>(_e91) - 1i);
let _e2122 = select(_e2120, _e2118, (_e2118 < _e2120));
let _e2128 = global_2.member[bitcast<u32>(select(0i, _e2122, (_e2122 > 0i)))];
let _e2130 = (_e2094 & 15i);
let _e2133 = ((_e2095 & 15i) * _e2089);
let _e2135 = (bitcast<i32>(_e2128) + ((_e2096 & 15i) * _e2093));
let _e2139 = (_e2133 + _e2089);
let _e2141 = (_e2133 + (2i * _e2089));
let _e2142 = (_e2135 + _e2093);
let _e2144 = (_e2135 + (2i * _e2093));
local = type_28(array<i32, 4>(_e2130, (_e2130 + 1i), (_e2130 + 2i), (_e2130 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2032 - f32(_e2055)), (_e2036 - f32(_e2070)), (_e2040 - f32(_e2085)));
let _e2155 = (_e2142 + _e2139);
let _e2158 = local.member[1u];
let _e2159 = (_e2155 + _e2158);
let _e2161 = select(_e2120, _e2159, (_e2159 < _e2120));
let _e2166 = global_2.member[bitcast<u32>(select(0i, _e2161, (_e2161 > 0i)))];
let _e2167 = bitcast<f32>(_e2166);
let _e2170 = local.member[2u];
let _e2171 = (_e2155 + _e2170);
let _e2173 = select(_e2120, _e2171, (_e2171 < _e2120));
let _e2178 = global_2.member[bitcast<u32>(select(0i, _e2173, (_e2173 > 0i)))];
let _e2180 = local_1[0u];
let _e2183 = (_e2167 + ((bitcast<f32>(_e2178) - _e2167) * _e2180));
let _e2184 = (_e2142 + _e2141);
let _e2185 = local.member[1u];
let _e2186 = (_e2184 + _e2185);
let _e2188 = select(_e2120, _e2186, (_e2186 < _e2120));
let _e2193 = global_2.member[bitcast<u32>(select(0i, _e2188, (_e2188 > 0i)))];
let _e2194 = bitcast<f32>(_e2193);
let _e2195 = local.member[2u];
let _e2196 = (_e2184 + _e2195);
let _e2198 = select(_e2120, _e2196, (_e2196 < _e2120));
let _e2203 = global_2.member[bitcast<u32>(select(0i, _e2198, (_e2198 > 0i)))];
let _e2205 = local_1[0u];
let _e2210 = local_1[1u];
let _e2213 = (_e2183 + (((_e2194 + ((bitcast<f32>(_e2203) - _e2194) * _e2205)) - _e2183) * _e2210));
let _e2214 = (_e2144 + _e2139);
let _e2215 = local.member[1u];
let _e2216 = (_e2214 + _e2215);
let _e2218 = select(_e2120, _e2216, (_e2216 < _e2120));
let _e2223 = global_2.member[bitcast<u32>(select(0i, _e2218, (_e2218 > 0i)))];
let _e2224 = bitcast<f32>(_e2223);
let _e2225 = local.member[2u];
let _e2226 = (_e2214 + _e2225);
let _e2228 = select(_e2120, _e2226, (_e2226 < _e2120));
let _e2233 = global_2.member[bitcast<u32>(select(0i, _e2228, (_e2228 > 0i)))];
let _e2235 = local_1[0u];
let _e2238 = (_e2224 + ((bitcast<f32>(_e2233) - _e2224) * _e2235));
let _e2239 = (_e2144 + _e2141);
let _e2240 = local.member[1u];
let _e2241 = (_e2239 + _e2240);
let _e2243 = select(_e2120, _e2241, (_e2241 < _e2120));
let _e2248 = global_2.member[bitcast<u32>(select(0i, _e2243, (_e2243 > 0i)))];
let _e2249 = bitcast<f32>(_e2248);
let _e2250 = local.member[2u];
let _e2251 = (_e2239 + _e2250);
let _e2253 = select(_e2120, _e2251, (_e2251 < _e2120));
let _e2258 = global_2.member[bitcast<u32>(select(0i, _e2253, (_e2253 > 0i)))];
let _e2260 = local_1[0u];
let _e2264 = local_1[1u];
let _e2269 = local_1[2u];
let _e2276 = global_1.member.member_6.member_5;
let _e2281 = global_1.member.member_6.member_6;
let _e2282 = (((_e2213 + (((_e2238 + (((_e2249 + ((bitcast<f32>(_e2258) - _e2249) * _e2260)) - _e2238) * _e2264)) - _e2213) * _e2269)) * _e2276) + _e2281);
let _e2284 = select(0f, _e2282, (_e2282 > 0f));
if ((_e611 & 16u) == 0u) {
phi_5077_ = type_5(1f, 1f, 1f);
} else {
let _e2292 = global_1.member.member_14.member;
let _e2303 = ((((_e2292.member.member * _e306) + (_e2292.member.member_1 * _e315)) + (_e2292.member.member_2 * _e288)) + _e2292.member_1);
let _e2309 = ((((_e2292.member.member * _e327) + (_e2292.member.member_1 * _e332)) + (_e2292.member.member_2 * _e321)) + _e2292.member_1);
let _e2311 = select(_e2309, _e2303, (_e2303 < _e2309));
let _e2313 = select(_e2309, _e2303, (_e2303 > _e2309));
let _e2315 = (_e2313 - _e2311);
let _e2318 = (-(_e2311) / select(1e-30f, _e2315, (_e2315 > 1e-30f)));
let _e2320 = select(0f, _e2318, (_e2318 > 0f));
let _e2326 = select(select(select(1f, _e2320, (_e2320 < 1f)), 1f, (_e2313 <= 0f)), 0f, (_e2311 > 0f));
let _e2331 = global_1.member.member_14.member_1;
let _e2332 = (_e2331 != 0u);
let _e2342 = global_1.member.member_15.member;
let _e2353 = ((((_e2342.member.member * _e306) + (_e2342.member.member_1 * _e315)) + (_e2342.member.member_2 * _e288)) + _e2342.member_1);
let _e2359 = ((((_e2342.member.member * _e327) + (_e2342.member.member_1 * _e332)) + (_e2342.member.member_2 * _e321)) + _e2342.member_1);
let _e2361 = select(_e2359, _e2353, (_e2353 < _e2359));
let _e2363 = select(_e2359, _e2353, (_e2353 > _e2359));
let _e2365 = (_e2363 - _e2361);
let _e2368 = (-(_e2361) / select(1e-30f, _e2365, (_e2365 > 1e-30f)));
let _e2370 = select(0f, _e2368, (_e2368 > 0f));
let _e2376 = select(select(select(1f, _e2370, (_e2370 < 1f)), 1f, (_e2363 <= 0f)), 0f, (_e2361 > 0f));
let _e2381 = global_1.member.member_15.member_1;
let _e2382 = (_e2381 != 0u);
let _e2392 = global_1.member.member_16.member;
let _e2403 = ((((_e2392.member.member * _e306) + (_e2392.member.member_1 * _e315)) + (_e2392.member.member_2 * _e288)) + _e2392.member_1);
let _e2409 = ((((_e2392.member.member * _e327) + (_e2392.member.member_1 * _e332)) + (_e2392.member.member_2 * _e321)) + _e2392.member_1);
let _e2411 = select(_e2409, _e2403, (_e2403 < _e2409));
let _e2413 = select(_e2409, _e2403, (_e2403 > _e2409));
let _e2415 = (_e2413 - _e2411);
let _e2418 = (-(_e2411) / select(1e-30f, _e2415, (_e2415 > 1e-30f)));
let _e2420 = select(0f, _e2418, (_e2418 > 0f));
let _e2426 = select(select(select(1f, _e2420, (_e2420 < 1f)), 1f, (_e2413 <= 0f)), 0f, (_e2411 > 0f));
let _e2431 = global_1.member.member_16.member_1;
let _e2432 = (_e2431 != 0u);
let _e2442 = global_1.member.member_17.member;
let _e2453 = ((((_e2442.member.member * _e306) + (_e2442.member.member_1 * _e315)) + (_e2442.member.member_2 * _e288)) + _e2442.member_1);
let _e2459 = ((((_e2442.member.member * _e327) + (_e2442.member.member_1 * _e332)) + (_e2442.member.member_2 * _e321)) + _e2442.member_1);
let _e2461 = select(_e2459, _e2453, (_e2453 < _e2459));
let _e2463 = select(_e2459, _e2453, (_e2453 > _e2459));
let _e2465 = (_e2463 - _e2461);
let _e2468 = (-(_e2461) / select(1e-30f, _e2465, (_e2465 > 1e-30f)));
let _e2470 = select(0f, _e2468, (_e2468 > 0f));
let _e2476 = select(select(select(1f, _e2470, (_e2470 < 1f)), 1f, (_e2463 <= 0f)), 0f, (_e2461 > 0f));
let _e2481 = global_1.member.member_17.member_1;
let _e2482 = (_e2481 != 0u);
phi_5077_ = type_5(((((1f * _e2326) * _e2376) * _e2426) * _e2476), ((((1f * select(1f, _e2326, _e2332)) * select(1f, _e2376, _e2382)) * select(1f, _e2426, _e2432)) * select(1f, _e2476, _e2482)), ((((1f * select(1f, 0f, (_e2332 && (_e2309 > 0f)))) * select(1f, 0f, (_e2382 && (_e2359 > 0f)))) * select(1f, 0f, (_e2432 && (_e2409 > 0f)))) * select(1f, 0f, (_e2482 && (_e2459 > 0f)))));
}
let _e2491 = phi_5077_;
let _e2492 = (_e327 - _e306);
let _e2493 = (_e332 - _e315);
let _e2494 = (_e321 - _e288);
let _e2499 = (((_e2492 * _e2492) + (_e2493 * _e2493)) + (_e2494 * _e2494));
let _e2503 = (_e483 < 1e-12f);
let _e2505 = (1f / select(_e478, 1f, _e2503));
let _e2507 = ((-0.5f - _e395) * _e2505);
let _e2509 = ((_e453 - _e395) * _e2505);
let _e2515 = select(_e2509, _e2507, (_e2507 < _e2509));
let _e2517 = select(0f, _e2515, (_e2515 > 0f));
let _e2520 = select(select(1f, _e2517, (_e2517 < 1f)), select(2f, 0f, ((_e395 >= -0.5f) && (_e395 <= _e453))), _e2503);
let _e2522 = select(_e2509, _e2507, (_e2507 > _e2509));
let _e2524 = select(0f, _e2522, (_e2522 > 0f));
let _e2527 = select(select(1f, _e2524, (_e2524 < 1f)), 1f, _e2503);
let _e2528 = (_e486 < 1e-12f);
let _e2530 = (1f / select(_e479, 1f, _e2528));
let _e2532 = ((-0.5f - _e410) * _e2530);
let _e2534 = ((_e463 - _e410) * _e2530);
let _e2540 = select(_e2534, _e2532, (_e2532 < _e2534));
let _e2542 = select(0f, _e2540, (_e2540 > 0f));
let _e2545 = select(select(1f, _e2542, (_e2542 < 1f)), select(2f, 0f, ((_e410 >= -0.5f) && (_e410 <= _e463))), _e2528);
let _e2547 = select(_e2534, _e2532, (_e2532 > _e2534));
let _e2549 = select(0f, _e2547, (_e2547 > 0f));
let _e2552 = select(select(1f, _e2549, (_e2549 < 1f)), 1f, _e2528);
let _e2553 = (_e491 < 1e-12f);
let _e2555 = (1f / select(_e480, 1f, _e2553));
let _e2557 = ((-0.5f - _e425) * _e2555);
let _e2559 = ((_e473 - _e425) * _e2555);
let _e2565 = select(_e2559, _e2557, (_e2557 < _e2559));
let _e2567 = select(0f, _e2565, (_e2565 > 0f));
let _e2570 = select(select(1f, _e2567, (_e2567 < 1f)), select(2f, 0f, ((_e425 >= -0.5f) && (_e425 <= _e473))), _e2553);
let _e2572 = select(_e2559, _e2557, (_e2557 > _e2559));
let _e2574 = select(0f, _e2572, (_e2572 > 0f));
let _e2577 = select(select(1f, _e2574, (_e2574 < 1f)), 1f, _e2553);
let _e2579 = select(_e2552, _e2527, (_e2527 < _e2552));
let _e2583 = select(_e2545, _e2520, (_e2520 > _e2545));
let _e2586 = (select(_e2577, _e2579, (_e2579 < _e2577)) - select(_e2570, _e2583, (_e2583 > _e2570)));
let _e2593 = global_1.member.member_5.member_3;
let _e2594 = ((sqrt(select(0f, _e2499, (_e2499 > 0f))) * select(0f, _e2586, (_e2586 > 0f))) * _e2593);
let _e2596 = (select(1f, _e2284, (_e2284 < 1f)) * 255f);
let _e2597 = (_e2028.member * 255f);
let _e2598 = (255f - 1f);
let _e2600 = select(0f, _e2596, (_e2596 > 0f));
let _e2602 = select(_e2598, _e2600, (_e2600 < _e2598));
let _e2609 = select(0i, select(select(i32(_e2602), i32(-2147483648), (_e2602 < -2147483600f)), 2147483647i, (_e2602 > 2147483500f)), (_e2602 == _e2602));
let _e2613 = (_e2609 - select(0i, 1i, (_e2602 < f32(_e2609))));
let _e2615 = select(0f, _e2597, (_e2597 > 0f));
let _e2617 = select(_e2598, _e2615, (_e2615 < _e2598));
let _e2624 = select(0i, select(select(i32(_e2617), i32(-2147483648), (_e2617 < -2147483600f)), 2147483647i, (_e2617 > 2147483500f)), (_e2617 == _e2617));
let _e2628 = (_e2624 - select(0i, 1i, (_e2617 < f32(_e2624))));
let _e2631 = (((_e2613 * 256i) + _e2628) * 4i);
let _e2633 = (_e2596 - f32(_e2613));
let _e2635 = (_e2597 - f32(_e2628));
let _e2637 = (bitcast<i32>(_e95) - 1i);
let _e2639 = select(_e2637, _e2631, (_e2631 < _e2637));
let _e2645 = global_4.member[bitcast<u32>(select(0i, _e2639, (_e2639 > 0i)))];
let _e2646 = (_e2631 + 4i);
let _e2648 = select(_e2637, _e2646, (_e2646 < _e2637));
let _e2654 = global_4.member[bitcast<u32>(select(0i, _e2648, (_e2648 > 0i)))];
let _e2655 = (_e2631 + 1024i);
let _e2657 = select(_e2637, _e2655, (_e2655 < _e2637));
let _e2663 = global_4.member[bitcast<u32>(select(0i, _e2657, (_e2657 > 0i)))];
let _e2664 = (_e2631 + 1028i);
let _e2666 = select(_e2637, _e2664, (_e2664 < _e2637));
let _e2672 = global_4.member[bitcast<u32>(select(0i, _e2666, (_e2666 > 0i)))];
let _e2677 = (bitcast<f32>(((_e2645 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2685 = (_e2677 + (((bitcast<f32>(((_e2654 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2677) * _e2635));
let _e2690 = (bitcast<f32>(((_e2663 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2714 = (bitcast<f32>((((_e2645 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2722 = (_e2714 + (((bitcast<f32>((((_e2654 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2714) * _e2635));
let _e2727 = (bitcast<f32>((((_e2663 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2739 = (_e2631 + 1i);
let _e2741 = select(_e2637, _e2739, (_e2739 < _e2637));
let _e2747 = global_4.member[bitcast<u32>(select(0i, _e2741, (_e2741 > 0i)))];
let _e2748 = (_e2631 + 5i);
let _e2750 = select(_e2637, _e2748, (_e2748 < _e2637));
let _e2756 = global_4.member[bitcast<u32>(select(0i, _e2750, (_e2750 > 0i)))];
let _e2757 = (_e2631 + 1025i);
let _e2759 = select(_e2637, _e2757, (_e2757 < _e2637));
let _e2765 = global_4.member[bitcast<u32>(select(0i, _e2759, (_e2759 > 0i)))];
let _e2766 = (_e2631 + 1029i);
let _e2768 = select(_e2637, _e2766, (_e2766 < _e2637));
let _e2774 = global_4.member[bitcast<u32>(select(0i, _e2768, (_e2768 > 0i)))];
let _e2779 = (bitcast<f32>(((_e2747 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2787 = (_e2779 + (((bitcast<f32>(((_e2756 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2779) * _e2635));
let _e2792 = (bitcast<f32>(((_e2765 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2816 = (bitcast<f32>((((_e2747 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2824 = (_e2816 + (((bitcast<f32>((((_e2756 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2816) * _e2635));
let _e2829 = (bitcast<f32>((((_e2765 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2844 = (_e2594 * _e2491.member_1);
let _e2846 = -(((_e2722 + (((_e2727 + (((bitcast<f32>((((_e2672 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2727) * _e2635)) - _e2722) * _e2633)) * _e2844));
let _e2848 = select(-87f, _e2846, (_e2846 > -87f));
let _e2850 = select(88f, _e2848, (_e2848 < 88f));
let _e2852 = ((_e2850 * 1.442695f) + 0.5f);
let _e2854 = select(-127f, _e2852, (_e2852 > -127f));
let _e2856 = select(128f, _e2854, (_e2854 < 128f));
let _e2863 = select(0i, select(select(i32(_e2856), i32(-2147483648), (_e2856 < -2147483600f)), 2147483647i, (_e2856 > 2147483500f)), (_e2856 == _e2856));
let _e2867 = (_e2863 - select(0i, 1i, (_e2856 < f32(_e2863))));
let _e2868 = f32(_e2867);
let _e2872 = ((_e2850 - (_e2868 * 0.6933594f)) - (_e2868 * -2.1219444e-4f));
let _e2894 = -(((_e2787 + (((_e2792 + (((bitcast<f32>(((_e2774 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2792) * _e2635)) - _e2787) * _e2633)) * _e2844));
let _e2896 = select(-87f, _e2894, (_e2894 > -87f));
let _e2898 = select(88f, _e2896, (_e2896 < 88f));
let _e2900 = ((_e2898 * 1.442695f) + 0.5f);
let _e2902 = select(-127f, _e2900, (_e2900 > -127f));
let _e2904 = select(128f, _e2902, (_e2902 < 128f));
let _e2911 = select(0i, select(select(i32(_e2904), i32(-2147483648), (_e2904 < -2147483600f)), 2147483647i, (_e2904 > 2147483500f)), (_e2904 == _e2904));
let _e2915 = (_e2911 - select(0i, 1i, (_e2904 < f32(_e2911))));
let _e2916 = f32(_e2915);
let _e2920 = ((_e2898 - (_e2916 * 0.6933594f)) - (_e2916 * -2.1219444e-4f));
let _e2942 = -(((_e2824 + (((_e2829 + (((bitcast<f32>((((_e2774 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2829) * _e2635)) - _e2824) * _e2633)) * _e2844));
let _e2944 = select(-87f, _e2942, (_e2942 > -87f));
let _e2946 = select(88f, _e2944, (_e2944 < 88f));
let _e2948 = ((_e2946 * 1.442695f) + 0.5f);
let _e2950 = select(-127f, _e2948, (_e2948 > -127f));
let _e2952 = select(128f, _e2950, (_e2950 < 128f));
let _e2959 = select(0i, select(select(i32(_e2952), i32(-2147483648), (_e2952 < -2147483600f)), 2147483647i, (_e2952 > 2147483500f)), (_e2952 == _e2952));
let _e2963 = (_e2959 - select(0i, 1i, (_e2952 < f32(_e2959))));
let _e2964 = f32(_e2963);
let _e2968 = ((_e2946 - (_e2964 * 0.6933594f)) - (_e2964 * -2.1219444e-4f));
let _e2990 = -(((_e2685 + (((_e2690 + (((bitcast<f32>(((_e2672 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2690) * _e2635)) - _e2685) * _e2633)) * (_e2594 * _e2491.member)));
let _e2992 = select(-87f, _e2990, (_e2990 > -87f));
let _e2994 = select(88f, _e2992, (_e2992 < 88f));
let _e2996 = ((_e2994 * 1.442695f) + 0.5f);
let _e2998 = select(-127f, _e2996, (_e2996 > -127f));
let _e3000 = select(128f, _e2998, (_e2998 < 128f));
let _e3007 = select(0i, select(select(i32(_e3000), i32(-2147483648), (_e3000 < -2147483600f)), 2147483647i, (_e3000 > 2147483500f)), (_e3000 == _e3000));
let _e3011 = (_e3007 - select(0i, 1i, (_e3000 < f32(_e3007))));
let _e3012 = f32(_e3011);
let _e3016 = ((_e2994 - (_e3012 * 0.6933594f)) - (_e3012 * -2.1219444e-4f));
let _e3036 = ((1f + (_e3016 * (1f + (_e3016 * (0.5f + (_e3016 * (0.16666667f + (_e3016 * (0.041666668f + (_e3016 * (0.008333334f + (_e3016 * (0.001388889f + (_e3016 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3011 + 127i)) << bitcast<u32>(23i))));
if _e628 {
let _e3051 = global_1.member.member_5.member_4;
let _e3054 = (_e2028.member_3.x * _e2491.member_2);
let _e3056 = (_e2028.member_3.y * _e2491.member_2);
let _e3058 = (_e2028.member_3.z * _e2491.member_2);
let _e3059 = (0.5f * (_e245 / _e196));
let _e3063 = (_e174 + (_e3054 * _e3059));
let _e3064 = (_e185 + (_e3056 * _e3059));
let _e3065 = (_e196 + (_e3058 * _e3059));
let _e3067 = (2f * _e245);
let _e3069 = ((_e3065 * _e3065) + (_e3067 * _e3058));
let _e3073 = (_e3065 + sqrt(select(0f, _e3069, (_e3069 > 0f))));
let _e3077 = (0.5f * (_e3067 / select(1e-6f, _e3073, (_e3073 > 1e-6f))));
let _e3081 = (_e3063 + (_e3054 * _e3077));
let _e3082 = (_e3064 + (_e3056 * _e3077));
let _e3083 = (_e3065 + (_e3058 * _e3077));
let _e3087 = (_e3051 * _e3051);
let _e3089 = (_e3083 * _e3083);
let _e3097 = (((_e3065 <= 0f) || (_e3069 <= 0f)) || ((_e3083 <= 0f) || (_e3089 <= (_e3087 * (((_e3081 * _e3081) + (_e3082 * _e3082)) + _e3089)))));
let _e3111 = (_e174 + ((_e2028.member_4.x * _e2491.member_2) * _e245));
let _e3112 = (_e185 + ((_e2028.member_4.y * _e2491.member_2) * _e245));
let _e3113 = (_e196 + ((_e2028.member_4.z * _e2491.member_2) * _e245));
let _e3115 = (_e3113 * _e3113);
let _e3124 = ((_e611 & 1u) != 0u);
phi_6103_ = vec3<f32>(select(select(select(_e3081, _e3063, _e3097), _e3111, _e3124), _e174, _e618), select(select(select(_e3082, _e3064, _e3097), _e3112, _e3124), _e185, _e618), select(select(select(_e3083, _e3065, _e3097), _e3113, _e3124), _e196, _e618));
phi_6104_ = (select(_e3097, ((_e3113 <= 0f) || (_e3115 <= (_e3087 * (((_e3111 * _e3111) + (_e3112 * _e3112)) + _e3115)))), _e3124) && !(_e618));
} else {
phi_6103_ = vec3<f32>(_e174, _e185, _e196);
phi_6104_ = false;
}
let _e3136 = phi_6103_;
let _e3138 = phi_6104_;
global_6.member[_e120] = (_e131 + _e260);
global_6.member[_e132] = (_e141 + _e267);
global_6.member[_e143] = (_e152 + _e369);
global_6.member[_e154] = (_e163 + _e372);
global_6.member[_e165] = _e3136.x;
global_6.member[_e176] = _e3136.y;
global_6.member[_e187] = _e3136.z;
global_6.member[_e198] = select((_e207 * (((1f + (_e2872 * (1f + (_e2872 * (0.5f + (_e2872 * (0.16666667f + (_e2872 * (0.041666668f + (_e2872 * (0.008333334f + (_e2872 * (0.001388889f + (_e2872 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2867 + 127i)) << bitcast<u32>(23i)))) * _e3036)), _e207, _e618);
global_6.member[_e209] = select((_e218 * (((1f + (_e2920 * (1f + (_e2920 * (0.5f + (_e2920 * (0.16666667f + (_e2920 * (0.041666668f + (_e2920 * (0.008333334f + (_e2920 * (0.001388889f + (_e2920 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2915 + 127i)) << bitcast<u32>(23i)))) * _e3036)), _e218, _e618);
global_6.member[_e220] = select((_e229 * (((1f + (_e2968 * (1f + (_e2968 * (0.5f + (_e2968 * (0.16666667f + (_e2968 * (0.041666668f + (_e2968 * (0.008333334f + (_e2968 * (0.001388889f + (_e2968 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2963 + 127i)) << bitcast<u32>(23i)))) * _e3036)), _e229, _e618);
global_6.member[_e231] = select(_e240, 1f, _e3138);
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
