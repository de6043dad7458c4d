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
var phi_3910_: type_29;
var phi_4672_: type_30;
var phi_5657_: type_5;
var phi_6683_: vec3<f32>;
var phi_6684_: bool;
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
let _e689 = (select(0i, select(select(i32(_e462), i32(-2147483648), (_e462 < -2147483600f)), 2147483647i, (_e462 > 2147483500f)), (_e462 == _e462)) - 1i);
let _e690 = (_e658 - 1i);
let _e695 = (_e658 + 1i);
let _e698 = (_e658 + 2i);
let _e708 = (select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < -2147483600f)), 2147483647i, (_e472 > 2147483500f)), (_e472 == _e472)) - 1i);
let _e709 = (_e673 - 1i);
let _e714 = (_e673 + 1i);
let _e717 = (_e673 + 2i);
let _e726 = select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < -2147483600f)), 2147483647i, (_e452 > 2147483500f)), (_e452 == _e452));
let _e727 = (_e726 - 1i);
let _e728 = (_e643 - 1i);
let _e730 = select(0i, _e728, (_e728 > 0i));
let _e733 = (_e643 + 1i);
let _e736 = (_e643 + 2i);
let _e739 = (_e726 - 4i);
let _e741 = select(0i, _e739, (_e739 > 0i));
let _e743 = select(_e741, _e730, (_e730 < _e741));
let _e756 = (select(0i, _e690, (_e690 > 0i)) * _e677);
let _e757 = (select(0i, _e658, (_e658 > 0i)) * _e677);
let _e758 = (select(_e689, _e695, (_e695 < _e689)) * _e677);
let _e759 = (select(_e689, _e698, (_e698 < _e689)) * _e677);
let _e760 = (select(0i, _e709, (_e709 > 0i)) * _e681);
let _e761 = (select(0i, _e673, (_e673 > 0i)) * _e681);
let _e762 = (select(_e708, _e714, (_e714 < _e708)) * _e681);
let _e763 = (select(_e708, _e717, (_e717 < _e708)) * _e681);
local_4 = type_28(array<i32, 4>(_e743, _e743, _e743, _e743), array<u32, 6>(bitcast<u32>(((_e730 - _e743) * 8i)), bitcast<u32>(((select(0i, _e643, (_e643 > 0i)) - _e743) * 8i)), bitcast<u32>(((select(_e727, _e733, (_e733 < _e727)) - _e743) * 8i)), bitcast<u32>(((select(_e727, _e736, (_e736 < _e727)) - _e743) * 8i)), 0u, 0u));
local_5 = vec3<f32>((_e457 - f32(_e643)), (_e467 - f32(_e658)), (_e477 - f32(_e673)));
let _e778 = local_4.member[0u];
let _e779 = ((_e761 + _e757) + _e778);
let _e781 = (_e779 >> bitcast<u32>(2i));
let _e784 = bitcast<u32>(((_e779 & 3i) * 8i));
let _e786 = (bitcast<i32>(_e91) - 1i);
let _e788 = select(_e786, _e781, (_e781 < _e786));
let _e793 = global_2.member[bitcast<u32>(select(0i, _e788, (_e788 > 0i)))];
let _e797 = (_e781 + 1i);
let _e799 = select(_e786, _e797, (_e797 < _e786));
let _e804 = global_2.member[bitcast<u32>(select(0i, _e799, (_e799 > 0i)))];
let _e811 = ((_e793 >> bitcast<u32>((_e784 & 31u))) | ((_e804 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e784) & 31u))));
let _e814 = local_4.member_1[0u];
let _e820 = f32(bitcast<i32>(((_e811 >> bitcast<u32>((_e814 & 31u))) & 255u)));
let _e823 = local_4.member_1[1u];
let _e829 = f32(bitcast<i32>(((_e811 >> bitcast<u32>((_e823 & 31u))) & 255u)));
let _e832 = local_4.member_1[2u];
let _e838 = f32(bitcast<i32>(((_e811 >> bitcast<u32>((_e832 & 31u))) & 255u)));
let _e841 = local_4.member_1[3u];
let _e848 = local_5[0u];
let _e851 = (_e820 + ((_e829 - _e820) * _e848));
let _e852 = local_5[0u];
let _e855 = (_e829 + ((_e838 - _e829) * _e852));
let _e856 = local_5[0u];
let _e859 = (_e838 + ((f32(bitcast<i32>(((_e811 >> bitcast<u32>((_e841 & 31u))) & 255u))) - _e838) * _e856));
let _e861 = local_4.member[0u];
let _e862 = ((_e761 + _e758) + _e861);
let _e864 = (_e862 >> bitcast<u32>(2i));
let _e867 = bitcast<u32>(((_e862 & 3i) * 8i));
let _e869 = select(_e786, _e864, (_e864 < _e786));
let _e874 = global_2.member[bitcast<u32>(select(0i, _e869, (_e869 > 0i)))];
let _e878 = (_e864 + 1i);
let _e880 = select(_e786, _e878, (_e878 < _e786));
let _e885 = global_2.member[bitcast<u32>(select(0i, _e880, (_e880 > 0i)))];
let _e892 = ((_e874 >> bitcast<u32>((_e867 & 31u))) | ((_e885 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e867) & 31u))));
let _e893 = local_4.member_1[0u];
let _e899 = f32(bitcast<i32>(((_e892 >> bitcast<u32>((_e893 & 31u))) & 255u)));
let _e900 = local_4.member_1[1u];
let _e906 = f32(bitcast<i32>(((_e892 >> bitcast<u32>((_e900 & 31u))) & 255u)));
let _e907 = local_4.member_1[2u];
let _e913 = f32(bitcast<i32>(((_e892 >> bitcast<u32>((_e907 & 31u))) & 255u)));
let _e914 = local_4.member_1[3u];
let _e921 = local_5[0u];
let _e925 = local_5[0u];
let _e928 = (_e906 + ((_e913 - _e906) * _e925));
let _e929 = local_5[0u];
let _e934 = local_4.member[0u];
let _e935 = ((_e762 + _e757) + _e934);
let _e937 = (_e935 >> bitcast<u32>(2i));
let _e940 = bitcast<u32>(((_e935 & 3i) * 8i));
let _e942 = select(_e786, _e937, (_e937 < _e786));
let _e947 = global_2.member[bitcast<u32>(select(0i, _e942, (_e942 > 0i)))];
let _e951 = (_e937 + 1i);
let _e953 = select(_e786, _e951, (_e951 < _e786));
let _e958 = global_2.member[bitcast<u32>(select(0i, _e953, (_e953 > 0i)))];
let _e965 = ((_e947 >> bitcast<u32>((_e940 & 31u))) | ((_e958 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e940) & 31u))));
let _e966 = local_4.member_1[0u];
let _e972 = f32(bitcast<i32>(((_e965 >> bitcast<u32>((_e966 & 31u))) & 255u)));
let _e973 = local_4.member_1[1u];
let _e979 = f32(bitcast<i32>(((_e965 >> bitcast<u32>((_e973 & 31u))) & 255u)));
let _e980 = local_4.member_1[2u];
let _e986 = f32(bitcast<i32>(((_e965 >> bitcast<u32>((_e980 & 31u))) & 255u)));
let _e987 = local_4.member_1[3u];
let _e994 = local_5[0u];
let _e997 = (_e972 + ((_e979 - _e972) * _e994));
let _e998 = local_5[0u];
let _e1001 = (_e979 + ((_e986 - _e979) * _e998));
let _e1002 = local_5[0u];
let _e1005 = (_e986 + ((f32(bitcast<i32>(((_e965 >> bitcast<u32>((_e987 & 31u))) & 255u))) - _e986) * _e1002));
let _e1007 = local_4.member[0u];
let _e1008 = ((_e762 + _e758) + _e1007);
let _e1010 = (_e1008 >> bitcast<u32>(2i));
let _e1013 = bitcast<u32>(((_e1008 & 3i) * 8i));
let _e1015 = select(_e786, _e1010, (_e1010 < _e786));
let _e1020 = global_2.member[bitcast<u32>(select(0i, _e1015, (_e1015 > 0i)))];
let _e1024 = (_e1010 + 1i);
let _e1026 = select(_e786, _e1024, (_e1024 < _e786));
let _e1031 = global_2.member[bitcast<u32>(select(0i, _e1026, (_e1026 > 0i)))];
let _e1038 = ((_e1020 >> bitcast<u32>((_e1013 & 31u))) | ((_e1031 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1013) & 31u))));
let _e1039 = local_4.member_1[0u];
let _e1045 = f32(bitcast<i32>(((_e1038 >> bitcast<u32>((_e1039 & 31u))) & 255u)));
let _e1046 = local_4.member_1[1u];
let _e1052 = f32(bitcast<i32>(((_e1038 >> bitcast<u32>((_e1046 & 31u))) & 255u)));
let _e1053 = local_4.member_1[2u];
let _e1059 = f32(bitcast<i32>(((_e1038 >> bitcast<u32>((_e1053 & 31u))) & 255u)));
let _e1060 = local_4.member_1[3u];
let _e1067 = local_5[0u];
let _e1071 = local_5[0u];
let _e1074 = (_e1052 + ((_e1059 - _e1052) * _e1071));
let _e1075 = local_5[0u];
let _e1080 = local_4.member[0u];
let _e1081 = ((_e761 + _e756) + _e1080);
let _e1083 = (_e1081 >> bitcast<u32>(2i));
let _e1086 = bitcast<u32>(((_e1081 & 3i) * 8i));
let _e1088 = select(_e786, _e1083, (_e1083 < _e786));
let _e1093 = global_2.member[bitcast<u32>(select(0i, _e1088, (_e1088 > 0i)))];
let _e1097 = (_e1083 + 1i);
let _e1099 = select(_e786, _e1097, (_e1097 < _e786));
let _e1104 = global_2.member[bitcast<u32>(select(0i, _e1099, (_e1099 > 0i)))];
let _e1111 = ((_e1093 >> bitcast<u32>((_e1086 & 31u))) | ((_e1104 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1086) & 31u))));
let _e1112 = local_4.member_1[1u];
let _e1118 = f32(bitcast<i32>(((_e1111 >> bitcast<u32>((_e1112 & 31u))) & 255u)));
let _e1119 = local_4.member_1[2u];
let _e1126 = local_5[0u];
let _e1129 = (_e1118 + ((f32(bitcast<i32>(((_e1111 >> bitcast<u32>((_e1119 & 31u))) & 255u))) - _e1118) * _e1126));
let _e1131 = local_4.member[0u];
let _e1132 = ((_e761 + _e759) + _e1131);
let _e1134 = (_e1132 >> bitcast<u32>(2i));
let _e1137 = bitcast<u32>(((_e1132 & 3i) * 8i));
let _e1139 = select(_e786, _e1134, (_e1134 < _e786));
let _e1144 = global_2.member[bitcast<u32>(select(0i, _e1139, (_e1139 > 0i)))];
let _e1148 = (_e1134 + 1i);
let _e1150 = select(_e786, _e1148, (_e1148 < _e786));
let _e1155 = global_2.member[bitcast<u32>(select(0i, _e1150, (_e1150 > 0i)))];
let _e1162 = ((_e1144 >> bitcast<u32>((_e1137 & 31u))) | ((_e1155 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1137) & 31u))));
let _e1163 = local_4.member_1[1u];
let _e1169 = f32(bitcast<i32>(((_e1162 >> bitcast<u32>((_e1163 & 31u))) & 255u)));
let _e1170 = local_4.member_1[2u];
let _e1177 = local_5[0u];
let _e1182 = local_4.member[0u];
let _e1183 = ((_e762 + _e756) + _e1182);
let _e1185 = (_e1183 >> bitcast<u32>(2i));
let _e1188 = bitcast<u32>(((_e1183 & 3i) * 8i));
let _e1190 = select(_e786, _e1185, (_e1185 < _e786));
let _e1195 = global_2.member[bitcast<u32>(select(0i, _e1190, (_e1190 > 0i)))];
let _e1199 = (_e1185 + 1i);
let _e1201 = select(_e786, _e1199, (_e1199 < _e786));
let _e1206 = global_2.member[bitcast<u32>(select(0i, _e1201, (_e1201 > 0i)))];
let _e1213 = ((_e1195 >> bitcast<u32>((_e1188 & 31u))) | ((_e1206 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1188) & 31u))));
let _e1214 = local_4.member_1[1u];
let _e1220 = f32(bitcast<i32>(((_e1213 >> bitcast<u32>((_e1214 & 31u))) & 255u)));
let _e1221 = local_4.member_1[2u];
let _e1228 = local_5[0u];
let _e1231 = (_e1220 + ((f32(bitcast<i32>(((_e1213 >> bitcast<u32>((_e1221 & 31u))) & 255u))) - _e1220) * _e1228));
let _e1233 = local_4.member[0u];
let _e1234 = ((_e762 + _e759) + _e1233);
let _e1236 = (_e1234 >> bitcast<u32>(2i));
let _e1239 = bitcast<u32>(((_e1234 & 3i) * 8i));
let _e1241 = select(_e786, _e1236, (_e1236 < _e786));
let _e1246 = global_2.member[bitcast<u32>(select(0i, _e1241, (_e1241 > 0i)))];
let _e1250 = (_e1236 + 1i);
let _e1252 = select(_e786, _e1250, (_e1250 < _e786));
let _e1257 = global_2.member[bitcast<u32>(select(0i, _e1252, (_e1252 > 0i)))];
let _e1264 = ((_e1246 >> bitcast<u32>((_e1239 & 31u))) | ((_e1257 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1239) & 31u))));
let _e1265 = local_4.member_1[1u];
let _e1271 = f32(bitcast<i32>(((_e1264 >> bitcast<u32>((_e1265 & 31u))) & 255u)));
let _e1272 = local_4.member_1[2u];
let _e1279 = local_5[0u];
let _e1284 = local_4.member[0u];
let _e1285 = ((_e760 + _e757) + _e1284);
let _e1287 = (_e1285 >> bitcast<u32>(2i));
let _e1290 = bitcast<u32>(((_e1285 & 3i) * 8i));
let _e1292 = select(_e786, _e1287, (_e1287 < _e786));
let _e1297 = global_2.member[bitcast<u32>(select(0i, _e1292, (_e1292 > 0i)))];
let _e1301 = (_e1287 + 1i);
let _e1303 = select(_e786, _e1301, (_e1301 < _e786));
let _e1308 = global_2.member[bitcast<u32>(select(0i, _e1303, (_e1303 > 0i)))];
let _e1315 = ((_e1297 >> bitcast<u32>((_e1290 & 31u))) | ((_e1308 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1290) & 31u))));
let _e1316 = local_4.member_1[1u];
let _e1322 = f32(bitcast<i32>(((_e1315 >> bitcast<u32>((_e1316 & 31u))) & 255u)));
let _e1323 = local_4.member_1[2u];
let _e1330 = local_5[0u];
let _e1333 = (_e1322 + ((f32(bitcast<i32>(((_e1315 >> bitcast<u32>((_e1323 & 31u))) & 255u))) - _e1322) * _e1330));
let _e1335 = local_4.member[0u];
let _e1336 = ((_e763 + _e757) + _e1335);
let _e1338 = (_e1336 >> bitcast<u32>(2i));
let _e1341 = bitcast<u32>(((_e1336 & 3i) * 8i));
let _e1343 = select(_e786, _e1338, (_e1338 < _e786));
let _e1348 = global_2.member[bitcast<u32>(select(0i, _e1343, (_e1343 > 0i)))];
let _e1352 = (_e1338 + 1i);
let _e1354 = select(_e786, _e1352, (_e1352 < _e786));
let _e1359 = global_2.member[bitcast<u32>(select(0i, _e1354, (_e1354 > 0i)))];
let _e1366 = ((_e1348 >> bitcast<u32>((_e1341 & 31u))) | ((_e1359 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1341) & 31u))));
let _e1367 = local_4.member_1[1u];
let _e1373 = f32(bitcast<i32>(((_e1366 >> bitcast<u32>((_e1367 & 31u))) & 255u)));
let _e1374 = local_4.member_1[2u];
let _e1381 = local_5[0u];
let _e1384 = (_e1373 + ((f32(bitcast<i32>(((_e1366 >> bitcast<u32>((_e1374 & 31u))) & 255u))) - _e1373) * _e1381));
let _e1386 = local_4.member[0u];
let _e1387 = ((_e760 + _e758) + _e1386);
let _e1389 = (_e1387 >> bitcast<u32>(2i));
let _e1392 = bitcast<u32>(((_e1387 & 3i) * 8i));
let _e1394 = select(_e786, _e1389, (_e1389 < _e786));
let _e1399 = global_2.member[bitcast<u32>(select(0i, _e1394, (_e1394 > 0i)))];
let _e1403 = (_e1389 + 1i);
let _e1405 = select(_e786, _e1403, (_e1403 < _e786));
let _e1410 = global_2.member[bitcast<u32>(select(0i, _e1405, (_e1405 > 0i)))];
let _e1417 = ((_e1399 >> bitcast<u32>((_e1392 & 31u))) | ((_e1410 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1392) & 31u))));
let _e1418 = local_4.member_1[1u];
let _e1424 = f32(bitcast<i32>(((_e1417 >> bitcast<u32>((_e1418 & 31u))) & 255u)));
let _e1425 = local_4.member_1[2u];
let _e1432 = local_5[0u];
let _e1437 = local_4.member[0u];
let _e1438 = ((_e763 + _e758) + _e1437);
let _e1440 = (_e1438 >> bitcast<u32>(2i));
let _e1443 = bitcast<u32>(((_e1438 & 3i) * 8i));
let _e1445 = select(_e786, _e1440, (_e1440 < _e786));
let _e1450 = global_2.member[bitcast<u32>(select(0i, _e1445, (_e1445 > 0i)))];
let _e1454 = (_e1440 + 1i);
let _e1456 = select(_e786, _e1454, (_e1454 < _e786));
let _e1461 = global_2.member[bitcast<u32>(select(0i, _e1456, (_e1456 > 0i)))];
let _e1468 = ((_e1450 >> bitcast<u32>((_e1443 & 31u))) | ((_e1461 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1443) & 31u))));
let _e1469 = local_4.member_1[1u];
let _e1475 = f32(bitcast<i32>(((_e1468 >> bitcast<u32>((_e1469 & 31u))) & 255u)));
let _e1476 = local_4.member_1[2u];
let _e1483 = local_5[0u];
let _e1488 = local_5[1u];
let _e1491 = (_e855 + ((_e928 - _e855) * _e1488));
let _e1492 = local_5[1u];
let _e1495 = (_e1001 + ((_e1074 - _e1001) * _e1492));
let _e1496 = local_5[1u];
let _e1499 = (_e851 + (((_e899 + ((_e906 - _e899) * _e921)) - _e851) * _e1496));
let _e1500 = local_5[1u];
let _e1505 = local_5[2u];
let _e1509 = local_5[1u];
let _e1512 = (_e859 + (((_e913 + ((f32(bitcast<i32>(((_e892 >> bitcast<u32>((_e914 & 31u))) & 255u))) - _e913) * _e929)) - _e859) * _e1509));
let _e1513 = local_5[1u];
let _e1517 = local_5[2u];
let _e1521 = local_5[1u];
let _e1524 = (_e1129 + ((_e855 - _e1129) * _e1521));
let _e1525 = local_5[1u];
let _e1529 = local_5[2u];
let _e1533 = local_5[1u];
let _e1536 = (_e928 + (((_e1169 + ((f32(bitcast<i32>(((_e1162 >> bitcast<u32>((_e1170 & 31u))) & 255u))) - _e1169) * _e1177)) - _e928) * _e1533));
let _e1537 = local_5[1u];
let _e1541 = local_5[2u];
let _e1545 = local_5[1u];
let _e1548 = (_e1333 + (((_e1424 + ((f32(bitcast<i32>(((_e1417 >> bitcast<u32>((_e1425 & 31u))) & 255u))) - _e1424) * _e1432)) - _e1333) * _e1545));
let _e1549 = local_5[2u];
let _e1553 = local_5[1u];
let _e1557 = local_5[2u];
let _e1561 = local_5[2u];
let _e1568 = global_1.member.member_6.member_5;
let _e1573 = global_1.member.member_6.member_6;
let _e1574 = (((_e1491 + ((_e1495 - _e1491) * _e1561)) * _e1568) + _e1573);
let _e1576 = select(0f, _e1574, (_e1574 > 0f));
let _e1578 = select(1f, _e1576, (_e1576 < 1f));
let _e1580 = (((_e1499 + (((_e997 + (((_e1045 + ((_e1052 - _e1045) * _e1067)) - _e997) * _e1500)) - _e1499) * _e1505)) * _e1568) + _e1573);
let _e1582 = select(0f, _e1580, (_e1580 > 0f));
let _e1584 = select(1f, _e1582, (_e1582 < 1f));
let _e1586 = (((_e1512 + (((_e1005 + (((_e1059 + ((f32(bitcast<i32>(((_e1038 >> bitcast<u32>((_e1060 & 31u))) & 255u))) - _e1059) * _e1075)) - _e1005) * _e1513)) - _e1512) * _e1517)) * _e1568) + _e1573);
let _e1588 = select(0f, _e1586, (_e1586 > 0f));
let _e1590 = select(1f, _e1588, (_e1588 < 1f));
let _e1592 = (((_e1524 + (((_e1231 + ((_e1001 - _e1231) * _e1525)) - _e1524) * _e1529)) * _e1568) + _e1573);
let _e1594 = select(0f, _e1592, (_e1592 > 0f));
let _e1596 = select(1f, _e1594, (_e1594 < 1f));
let _e1598 = (((_e1536 + (((_e1074 + (((_e1271 + ((f32(bitcast<i32>(((_e1264 >> bitcast<u32>((_e1272 & 31u))) & 255u))) - _e1271) * _e1279)) - _e1074) * _e1537)) - _e1536) * _e1541)) * _e1568) + _e1573);
let _e1600 = select(0f, _e1598, (_e1598 > 0f));
let _e1602 = select(1f, _e1600, (_e1600 < 1f));
let _e1604 = (((_e1548 + ((_e1491 - _e1548) * _e1549)) * _e1568) + _e1573);
let _e1606 = select(0f, _e1604, (_e1604 > 0f));
let _e1608 = select(1f, _e1606, (_e1606 < 1f));
let _e1610 = (((_e1495 + (((_e1384 + (((_e1475 + ((f32(bitcast<i32>(((_e1468 >> bitcast<u32>((_e1476 & 31u))) & 255u))) - _e1475) * _e1483)) - _e1384) * _e1553)) - _e1495) * _e1557)) * _e1568) + _e1573);
let _e1612 = select(0f, _e1610, (_e1610 > 0f));
let _e1614 = select(1f, _e1612, (_e1612 < 1f));
let _e1615 = (_e1578 * 1024f);
let _e1616 = (1024f - 1f);
let _e1618 = select(0f, _e1615, (_e1615 > 0f));
let _e1620 = select(_e1616, _e1618, (_e1618 < _e1616));
let _e1627 = select(0i, select(select(i32(_e1620), i32(-2147483648), (_e1620 < -2147483600f)), 2147483647i, (_e1620 > 2147483500f)), (_e1620 == _e1620));
let _e1631 = (_e1627 - select(0i, 1i, (_e1620 < f32(_e1627))));
let _e1632 = (262147i + _e1631);
let _e1634 = (bitcast<i32>(_e95) - 1i);
let _e1636 = select(_e1634, _e1632, (_e1632 < _e1634));
let _e1642 = global_4.member[bitcast<u32>(select(0i, _e1636, (_e1636 > 0i)))];
let _e1652 = select(_e1634, 262146i, (262146i < _e1634));
let _e1658 = global_4.member[bitcast<u32>(select(0i, _e1652, (_e1652 > 0i)))];
let _e1659 = bitcast<f32>(_e1658);
let _e1660 = (f32((bitcast<i32>((_e1642 & 4095u)) - 2048i)) * _e1659);
let _e1662 = select(_e1634, 262144i, (262144i < _e1634));
let _e1668 = global_4.member[bitcast<u32>(select(0i, _e1662, (_e1662 > 0i)))];
let _e1669 = bitcast<f32>(_e1668);
let _e1671 = select(_e1634, 262145i, (262145i < _e1634));
let _e1677 = global_4.member[bitcast<u32>(select(0i, _e1671, (_e1671 > 0i)))];
let _e1678 = bitcast<f32>(_e1677);
let _e1684 = ((_e1669 + (f32(bitcast<i32>((_e1642 >> bitcast<u32>(12u)))) * _e1678)) + (_e1660 * (_e1615 - f32(_e1631))));
let _e1685 = (_e1660 * 1024f);
if _e625 {
let _e1692 = ((0.5f * (_e1590 - _e1584)) * _e1685);
let _e1693 = ((0.5f * (_e1602 - _e1596)) * _e1685);
let _e1694 = ((0.5f * (_e1614 - _e1608)) * _e1685);
phi_3910_ = type_29(_e1684, vec3<f32>(_e1692, _e1693, _e1694), vec3<f32>((_e1692 * _e1684), (_e1693 * _e1684), (_e1694 * _e1684)));
} else {
let _e1701 = (_e1584 * 1024f);
let _e1703 = select(0f, _e1701, (_e1701 > 0f));
let _e1705 = select(_e1616, _e1703, (_e1703 < _e1616));
let _e1712 = select(0i, select(select(i32(_e1705), i32(-2147483648), (_e1705 < -2147483600f)), 2147483647i, (_e1705 > 2147483500f)), (_e1705 == _e1705));
let _e1716 = (_e1712 - select(0i, 1i, (_e1705 < f32(_e1712))));
let _e1717 = (262147i + _e1716);
let _e1719 = select(_e1634, _e1717, (_e1717 < _e1634));
let _e1725 = global_4.member[bitcast<u32>(select(0i, _e1719, (_e1719 > 0i)))];
let _e1740 = ((_e1669 + (f32(bitcast<i32>((_e1725 >> bitcast<u32>(12u)))) * _e1678)) + ((f32((bitcast<i32>((_e1725 & 4095u)) - 2048i)) * _e1659) * (_e1701 - f32(_e1716))));
let _e1741 = (_e1590 * 1024f);
let _e1743 = select(0f, _e1741, (_e1741 > 0f));
let _e1745 = select(_e1616, _e1743, (_e1743 < _e1616));
let _e1752 = select(0i, select(select(i32(_e1745), i32(-2147483648), (_e1745 < -2147483600f)), 2147483647i, (_e1745 > 2147483500f)), (_e1745 == _e1745));
let _e1756 = (_e1752 - select(0i, 1i, (_e1745 < f32(_e1752))));
let _e1757 = (262147i + _e1756);
let _e1759 = select(_e1634, _e1757, (_e1757 < _e1634));
let _e1765 = global_4.member[bitcast<u32>(select(0i, _e1759, (_e1759 > 0i)))];
let _e1780 = ((_e1669 + (f32(bitcast<i32>((_e1765 >> bitcast<u32>(12u)))) * _e1678)) + ((f32((bitcast<i32>((_e1765 & 4095u)) - 2048i)) * _e1659) * (_e1741 - f32(_e1756))));
let _e1781 = (_e1596 * 1024f);
let _e1783 = select(0f, _e1781, (_e1781 > 0f));
let _e1785 = select(_e1616, _e1783, (_e1783 < _e1616));
let _e1792 = select(0i, select(select(i32(_e1785), i32(-2147483648), (_e1785 < -2147483600f)), 2147483647i, (_e1785 > 2147483500f)), (_e1785 == _e1785));
let _e1796 = (_e1792 - select(0i, 1i, (_e1785 < f32(_e1792))));
let _e1797 = (262147i + _e1796);
let _e1799 = select(_e1634, _e1797, (_e1797 < _e1634));
let _e1805 = global_4.member[bitcast<u32>(select(0i, _e1799, (_e1799 > 0i)))];
let _e1820 = ((_e1669 + (f32(bitcast<i32>((_e1805 >> bitcast<u32>(12u)))) * _e1678)) + ((f32((bitcast<i32>((_e1805 & 4095u)) - 2048i)) * _e1659) * (_e1781 - f32(_e1796))));
let _e1821 = (_e1602 * 1024f);
let _e1823 = select(0f, _e1821, (_e1821 > 0f));
let _e1825 = select(_e1616, _e1823, (_e1823 < _e1616));
let _e1832 = select(0i, select(select(i32(_e1825), i32(-2147483648), (_e1825 < -2147483600f)), 2147483647i, (_e1825 > 2147483500f)), (_e1825 == _e1825));
let _e1836 = (_e1832 - select(0i, 1i, (_e1825 < f32(_e1832))));
let _e1837 = (262147i + _e1836);
let _e1839 = select(_e1634, _e1837, (_e1837 < _e1634));
let _e1845 = global_4.member[bitcast<u32>(select(0i, _e1839, (_e1839 > 0i)))];
let _e1860 = ((_e1669 + (f32(bitcast<i32>((_e1845 >> bitcast<u32>(12u)))) * _e1678)) + ((f32((bitcast<i32>((_e1845 & 4095u)) - 2048i)) * _e1659) * (_e1821 - f32(_e1836))));
let _e1861 = (_e1608 * 1024f);
let _e1863 = select(0f, _e1861, (_e1861 > 0f));
let _e1865 = select(_e1616, _e1863, (_e1863 < _e1616));
let _e1872 = select(0i, select(select(i32(_e1865), i32(-2147483648), (_e1865 < -2147483600f)), 2147483647i, (_e1865 > 2147483500f)), (_e1865 == _e1865));
let _e1876 = (_e1872 - select(0i, 1i, (_e1865 < f32(_e1872))));
let _e1877 = (262147i + _e1876);
let _e1879 = select(_e1634, _e1877, (_e1877 < _e1634));
let _e1885 = global_4.member[bitcast<u32>(select(0i, _e1879, (_e1879 > 0i)))];
let _e1900 = ((_e1669 + (f32(bitcast<i32>((_e1885 >> bitcast<u32>(12u)))) * _e1678)) + ((f32((bitcast<i32>((_e1885 & 4095u)) - 2048i)) * _e1659) * (_e1861 - f32(_e1876))));
let _e1901 = (_e1614 * 1024f);
let _e1903 = select(0f, _e1901, (_e1901 > 0f));
let _e1905 = select(_e1616, _e1903, (_e1903 < _e1616));
let _e1912 = select(0i, select(select(i32(_e1905), i32(-2147483648), (_e1905 < -2147483600f)), 2147483647i, (_e1905 > 2147483500f)), (_e1905 == _e1905));
let _e1916 = (_e1912 - select(0i, 1i, (_e1905 < f32(_e1912))));
let _e1917 = (262147i + _e1916);
let _e1919 = select(_e1634, _e1917, (_e1917 < _e1634));
let _e1925 = global_4.member[bitcast<u32>(select(0i, _e1919, (_e1919 > 0i)))];
let _e1940 = ((_e1669 + (f32(bitcast<i32>((_e1925 >> bitcast<u32>(12u)))) * _e1678)) + ((f32((bitcast<i32>((_e1925 & 4095u)) - 2048i)) * _e1659) * (_e1901 - f32(_e1916))));
let _e1941 = (_e1780 - _e1740);
let _e1943 = (_e1860 - _e1820);
let _e1945 = (_e1940 - _e1900);
phi_3910_ = type_29(_e1684, vec3<f32>((0.5f * _e1941), (0.5f * _e1943), (0.5f * _e1945)), vec3<f32>((0.25f * (_e1941 * (_e1780 + _e1740))), (0.25f * (_e1943 * (_e1860 + _e1820))), (0.25f * (_e1945 * (_e1940 + _e1900)))));
}
let _e1960 = phi_3910_;
let _e1975 = select(0f, 1f, ((((((_e431 >= -0.5f) && (_e431 <= _e453)) && (_e437 >= -0.5f)) && (_e437 <= _e463)) && (_e443 >= -0.5f)) && (_e443 <= _e473)));
let _e1977 = (0.5f * (_e1590 - _e1584));
let _e1979 = (0.5f * (_e1602 - _e1596));
let _e1981 = (0.5f * (_e1614 - _e1608));
let _e1987 = global_1.member.member_6.member.member.member;
let _e1993 = global_1.member.member_6.member.member.member_1;
let _e1999 = global_1.member.member_6.member.member.member_2;
let _e2005 = global_1.member.member_6.member_1.member.member;
let _e2011 = global_1.member.member_6.member_1.member.member_1;
let _e2017 = global_1.member.member_6.member_1.member.member_2;
let _e2023 = global_1.member.member_6.member_2.member.member;
let _e2029 = global_1.member.member_6.member_2.member.member_1;
let _e2035 = global_1.member.member_6.member_2.member.member_2;
phi_4672_ = type_30(_e1578, vec3<f32>(((((_e1987 * _e1977) + (_e2005 * _e1979)) + (_e2023 * _e1981)) * _e1975), ((((_e1993 * _e1977) + (_e2011 * _e1979)) + (_e2029 * _e1981)) * _e1975), ((((_e1999 * _e1977) + (_e2017 * _e1979)) + (_e2035 * _e1981)) * _e1975)), _e1960.member, vec3<f32>(((((_e1987 * _e1960.member_2.x) + (_e2005 * _e1960.member_2.y)) + (_e2023 * _e1960.member_2.z)) * _e1975), ((((_e1993 * _e1960.member_2.x) + (_e2011 * _e1960.member_2.y)) + (_e2029 * _e1960.member_2.z)) * _e1975), ((((_e1999 * _e1960.member_2.x) + (_e2017 * _e1960.member_2.y)) + (_e2035 * _e1960.member_2.z)) * _e1975)), vec3<f32>(((((_e1987 * _e1960.member_1.x) + (_e2005 * _e1960.member_1.y)) + (_e2023 * _e1960.member_1.z)) * _e1975), ((((_e1993 * _e1960.member_1.x) + (_e2011 * _e1960.member_1.y)) + (_e2029 * _e1960.member_1.z)) * _e1975), ((((_e1999 * _e1960.member_1.x) + (_e2017 * _e1960.member_1.y)) + (_e2035 * _e1960.member_1.z)) * _e1975)));
} else {
let _e2101 = select(-1f, _e457, (_e457 > -1f));
let _e2103 = select(_e452, _e2101, (_e2101 < _e452));
let _e2110 = select(0i, select(select(i32(_e2103), i32(-2147483648), (_e2103 < -2147483600f)), 2147483647i, (_e2103 > 2147483500f)), (_e2103 == _e2103));
let _e2114 = (_e2110 - select(0i, 1i, (_e2103 < f32(_e2110))));
let _e2116 = select(-1f, _e467, (_e467 > -1f));
let _e2118 = select(_e462, _e2116, (_e2116 < _e462));
let _e2125 = select(0i, select(select(i32(_e2118), i32(-2147483648), (_e2118 < -2147483600f)), 2147483647i, (_e2118 > 2147483500f)), (_e2118 == _e2118));
let _e2129 = (_e2125 - select(0i, 1i, (_e2118 < f32(_e2125))));
let _e2131 = select(-1f, _e477, (_e477 > -1f));
let _e2133 = select(_e472, _e2131, (_e2131 < _e472));
let _e2140 = select(0i, select(select(i32(_e2133), i32(-2147483648), (_e2133 < -2147483600f)), 2147483647i, (_e2133 > 2147483500f)), (_e2133 == _e2133));
let _e2144 = (_e2140 - select(0i, 1i, (_e2133 < f32(_e2140))));
let _e2148 = global_1.member.member_6.member_7;
let _e2152 = global_1.member.member_6.member_8;
let _e2160 = (select(0i, select(select(i32(_e462), i32(-2147483648), (_e462 < -2147483600f)), 2147483647i, (_e462 > 2147483500f)), (_e462 == _e462)) - 1i);
let _e2163 = (_e2129 + 1i);
let _e2173 = (select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < -2147483600f)), 2147483647i, (_e472 > 2147483500f)), (_e472 == _e472)) - 1i);
let _e2176 = (_e2144 + 1i);
let _e2185 = select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < -2147483600f)), 2147483647i, (_e452 > 2147483500f)), (_e452 == _e452));
let _e2186 = (_e2185 - 1i);
let _e2187 = (_e2114 - 1i);
let _e2189 = select(0i, _e2187, (_e2187 > 0i));
let _e2192 = (_e2114 + 1i);
let _e2195 = (_e2114 + 2i);
let _e2198 = (_e2185 - 4i);
let _e2200 = select(0i, _e2198, (_e2198 > 0i));
let _e2202 = select(_e2200, _e2189, (_e2189 < _e2200));
let _e2215 = (select(0i, _e2129, (_e2129 > 0i)) * _e2148);
let _e2216 = (select(_e2160, _e2163, (_e2163 < _e2160)) * _e2148);
let _e2217 = (select(0i, _e2144, (_e2144 > 0i)) * _e2152);
let _e2218 = (select(_e2173, _e2176, (_e2176 < _e2173)) * _e2152);
local_2 = type_28(array<i32, 4>(_e2202, _e2202, _e2202, _e2202), array<u32, 6>(bitcast<u32>(((_e2189 - _e2202) * 8i)), bitcast<u32>(((select(0i, _e2114, (_e2114 > 0i)) - _e2202) * 8i)), bitcast<u32>(((select(_e2186, _e2192, (_e2192 < _e2186)) - _e2202) * 8i)), bitcast<u32>(((select(_e2186, _e2195, (_e2195 < _e2186)) - _e2202) * 8i)), 0u, 0u));
local_3 = vec3<f32>((_e457 - f32(_e2114)), (_e467 - f32(_e2129)), (_e477 - f32(_e2144)));
let _e2233 = local_2.member[0u];
let _e2234 = ((_e2217 + _e2215) + _e2233);
let _e2236 = (_e2234 >> bitcast<u32>(2i));
let _e2239 = bitcast<u32>(((_e2234 & 3i) * 8i));
let _e2241 = (bitcast<i32>(_e91) - 1i);
let _e2243 = select(_e2241, _e2236, (_e2236 < _e2241));
let _e2248 = global_2.member[bitcast<u32>(select(0i, _e2243, (_e2243 > 0i)))];
let _e2252 = (_e2236 + 1i);
let _e2254 = select(_e2241, _e2252, (_e2252 < _e2241));
let _e2259 = global_2.member[bitcast<u32>(select(0i, _e2254, (_e2254 > 0i)))];
let _e2266 = ((_e2248 >> bitcast<u32>((_e2239 & 31u))) | ((_e2259 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2239) & 31u))));
let _e2269 = local_2.member_1[1u];
let _e2275 = f32(bitcast<i32>(((_e2266 >> bitcast<u32>((_e2269 & 31u))) & 255u)));
let _e2278 = local_2.member_1[2u];
let _e2285 = local_3[0u];
let _e2288 = (_e2275 + ((f32(bitcast<i32>(((_e2266 >> bitcast<u32>((_e2278 & 31u))) & 255u))) - _e2275) * _e2285));
let _e2290 = local_2.member[0u];
let _e2291 = ((_e2217 + _e2216) + _e2290);
let _e2293 = (_e2291 >> bitcast<u32>(2i));
let _e2296 = bitcast<u32>(((_e2291 & 3i) * 8i));
let _e2298 = select(_e2241, _e2293, (_e2293 < _e2241));
let _e2303 = global_2.member[bitcast<u32>(select(0i, _e2298, (_e2298 > 0i)))];
let _e2307 = (_e2293 + 1i);
let _e2309 = select(_e2241, _e2307, (_e2307 < _e2241));
let _e2314 = global_2.member[bitcast<u32>(select(0i, _e2309, (_e2309 > 0i)))];
let _e2321 = ((_e2303 >> bitcast<u32>((_e2296 & 31u))) | ((_e2314 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2296) & 31u))));
let _e2322 = local_2.member_1[1u];
let _e2328 = f32(bitcast<i32>(((_e2321 >> bitcast<u32>((_e2322 & 31u))) & 255u)));
let _e2329 = local_2.member_1[2u];
let _e2336 = local_3[0u];
let _e2341 = local_3[1u];
let _e2344 = (_e2288 + (((_e2328 + ((f32(bitcast<i32>(((_e2321 >> bitcast<u32>((_e2329 & 31u))) & 255u))) - _e2328) * _e2336)) - _e2288) * _e2341));
let _e2346 = local_2.member[0u];
let _e2347 = ((_e2218 + _e2215) + _e2346);
let _e2349 = (_e2347 >> bitcast<u32>(2i));
let _e2352 = bitcast<u32>(((_e2347 & 3i) * 8i));
let _e2354 = select(_e2241, _e2349, (_e2349 < _e2241));
let _e2359 = global_2.member[bitcast<u32>(select(0i, _e2354, (_e2354 > 0i)))];
let _e2363 = (_e2349 + 1i);
let _e2365 = select(_e2241, _e2363, (_e2363 < _e2241));
let _e2370 = global_2.member[bitcast<u32>(select(0i, _e2365, (_e2365 > 0i)))];
let _e2377 = ((_e2359 >> bitcast<u32>((_e2352 & 31u))) | ((_e2370 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2352) & 31u))));
let _e2378 = local_2.member_1[1u];
let _e2384 = f32(bitcast<i32>(((_e2377 >> bitcast<u32>((_e2378 & 31u))) & 255u)));
let _e2385 = local_2.member_1[2u];
let _e2392 = local_3[0u];
let _e2395 = (_e2384 + ((f32(bitcast<i32>(((_e2377 >> bitcast<u32>((_e2385 & 31u))) & 255u))) - _e2384) * _e2392));
let _e2397 = local_2.member[0u];
let _e2398 = ((_e2218 + _e2216) + _e2397);
let _e2400 = (_e2398 >> bitcast<u32>(2i));
let _e2403 = bitcast<u32>(((_e2398 & 3i) * 8i));
let _e2405 = select(_e2241, _e2400, (_e2400 < _e2241));
let _e2410 = global_2.member[bitcast<u32>(select(0i, _e2405, (_e2405 > 0i)))];
let _e2414 = (_e2400 + 1i);
let _e2416 = select(_e2241, _e2414, (_e2414 < _e2241));
let _e2421 = global_2.member[bitcast<u32>(select(0i, _e2416, (_e2416 > 0i)))];
let _e2428 = ((_e2410 >> bitcast<u32>((_e2403 & 31u))) | ((_e2421 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2403) & 31u))));
let _e2429 = local_2.member_1[1u];
let _e2435 = f32(bitcast<i32>(((_e2428 >> bitcast<u32>((_e2429 & 31u))) & 255u)));
let _e2436 = local_2.member_1[2u];
let _e2443 = local_3[0u];
let _e2447 = local_3[1u];
let _e2452 = local_3[2u];
let _e2459 = global_1.member.member_6.member_5;
let _e2464 = global_1.member.member_6.member_6;
let _e2465 = (((_e2344 + (((_e2395 + (((_e2435 + ((f32(bitcast<i32>(((_e2428 >> bitcast<u32>((_e2436 & 31u))) & 255u))) - _e2435) * _e2443)) - _e2395) * _e2447)) - _e2344) * _e2452)) * _e2459) + _e2464);
let _e2467 = select(0f, _e2465, (_e2465 > 0f));
phi_4672_ = type_30(select(1f, _e2467, (_e2467 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2472 = phi_4672_;
let _e2474 = select(-0.5f, _e395, (_e395 > -0.5f));
let _e2476 = select(_e453, _e2474, (_e2474 < _e453));
let _e2478 = select(-0.5f, _e410, (_e410 > -0.5f));
let _e2480 = select(_e463, _e2478, (_e2478 < _e463));
let _e2482 = select(-0.5f, _e425, (_e425 > -0.5f));
let _e2484 = select(_e473, _e2482, (_e2482 < _e473));
let _e2486 = select(-1f, _e2476, (_e2476 > -1f));
let _e2488 = select(_e452, _e2486, (_e2486 < _e452));
let _e2495 = select(0i, select(select(i32(_e2488), i32(-2147483648), (_e2488 < -2147483600f)), 2147483647i, (_e2488 > 2147483500f)), (_e2488 == _e2488));
let _e2499 = (_e2495 - select(0i, 1i, (_e2488 < f32(_e2495))));
let _e2501 = select(-1f, _e2480, (_e2480 > -1f));
let _e2503 = select(_e462, _e2501, (_e2501 < _e462));
let _e2510 = select(0i, select(select(i32(_e2503), i32(-2147483648), (_e2503 < -2147483600f)), 2147483647i, (_e2503 > 2147483500f)), (_e2503 == _e2503));
let _e2514 = (_e2510 - select(0i, 1i, (_e2503 < f32(_e2510))));
let _e2516 = select(-1f, _e2484, (_e2484 > -1f));
let _e2518 = select(_e472, _e2516, (_e2516 < _e472));
let _e2525 = select(0i, select(select(i32(_e2518), i32(-2147483648), (_e2518 < -2147483600f)), 2147483647i, (_e2518 > 2147483500f)), (_e2518 == _e2518));
let _e2529 = (_e2525 - select(0i, 1i, (_e2518 < f32(_e2525))));
let _e2533 = global_1.member.member_6.member_7;
let _e2537 = global_1.member.member_6.member_8;
let _e2545 = (select(0i, select(select(i32(_e462), i32(-2147483648), (_e462 < -2147483600f)), 2147483647i, (_e462 > 2147483500f)), (_e462 == _e462)) - 1i);
let _e2548 = (_e2514 + 1i);
let _e2558 = (select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < -2147483600f)), 2147483647i, (_e472 > 2147483500f)), (_e472 == _e472)) - 1i);
let _e2561 = (_e2529 + 1i);
let _e2570 = select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < -2147483600f)), 2147483647i, (_e452 > 2147483500f)), (_e452 == _e452));
let _e2571 = (_e2570 - 1i);
let _e2572 = (_e2499 - 1i);
let _e2574 = select(0i, _e2572, (_e2572 > 0i));
let _e2577 = (_e2499 + 1i);
let _e2580 = (_e2499 + 2i);
let _e2583 = (_e2570 - 4i);
let _e2585 = select(0i, _e2583, (_e2583 > 0i));
let _e2587 = select(_e2585, _e2574, (_e2574 < _e2585));
let _e2600 = (select(0i, _e2514, (_e2514 > 0i)) * _e2533);
let _e2601 = (select(_e2545, _e2548, (_e2548 < _e2545)) * _e2533);
let _e2602 = (select(0i, _e2529, (_e2529 > 0i)) * _e2537);
let _e2603 = (select(_e2558, _e2561, (_e2561 < _e2558)) * _e2537);
local = type_28(array<i32, 4>(_e2587, _e2587, _e2587, _e2587), array<u32, 6>(bitcast<u32>(((_e2574 - _e2587) * 8i)), bitcast<u32>(((select(0i, _e2499, (_e2499 > 0i)) - _e2587) * 8i)), bitcast<u32>(((select(_e2571, _e2577, (_e2577 < _e2571)) - _e2587) * 8i)), bitcast<u32>(((select(_e2571, _e2580, (_e2580 < _e2571)) - _e2587) * 8i)), 0u, 0u));
local_1 = vec3<f32>((_e2476 - f32(_e2499)), (_e2480 - f32(_e2514)), (_e2484 - f32(_e2529)));
let _e2618 = local.member[0u];
let _e2619 = ((_e2602 + _e2600) + _e2618);
let _e2621 = (_e2619 >> bitcast<u32>(2i));
let _e2624 = bitcast<u32>(((_e2619 & 3i) * 8i));
let _e2626 = (bitcast<i32>(_e91) - 1i);
let _e2628 = select(_e2626, _e2621, (_e2621 < _e2626));
let _e2633 = global_2.member[bitcast<u32>(select(0i, _e2628, (_e2628 > 0i)))];
let _e2637 = (_e2621 + 1i);
let _e2639 = select(_e2626, _e2637, (_e2637 < _e2626));
let _e2644 = global_2.member[bitcast<u32>(select(0i, _e2639, (_e2639 > 0i)))];
let _e2651 = ((_e2633 >> bitcast<u32>((_e2624 & 31u))) | ((_e2644 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2624) & 31u))));
let _e2654 = local.member_1[1u];
let _e2660 = f32(bitcast<i32>(((_e2651 >> bitcast<u32>((_e2654 & 31u))) & 255u)));
let _e2663 = local.member_1[2u];
let _e2670 = local_1[0u];
let _e2673 = (_e2660 + ((f32(bitcast<i32>(((_e2651 >> bitcast<u32>((_e2663 & 31u))) & 255u))) - _e2660) * _e2670));
let _e2675 = local.member[0u];
let _e2676 = ((_e2602 + _e2601) + _e2675);
let _e2678 = (_e2676 >> bitcast<u32>(2i));
let _e2681 = bitcast<u32>(((_e2676 & 3i) * 8i));
let _e2683 = select(_e2626, _e2678, (_e2678 < _e2626));
let _e2688 = global_2.member[bitcast<u32>(select(0i, _e2683, (_e2683 > 0i)))];
let _e2692 = (_e2678 + 1i);
let _e2694 = select(_e2626, _e2692, (_e2692 < _e2626));
let _e2699 = global_2.member[bitcast<u32>(select(0i, _e2694, (_e2694 > 0i)))];
let _e2706 = ((_e2688 >> bitcast<u32>((_e2681 & 31u))) | ((_e2699 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2681) & 31u))));
let _e2707 = local.member_1[1u];
let _e2713 = f32(bitcast<i32>(((_e2706 >> bitcast<u32>((_e2707 & 31u))) & 255u)));
let _e2714 = local.member_1[2u];
let _e2721 = local_1[0u];
let _e2726 = local_1[1u];
let _e2729 = (_e2673 + (((_e2713 + ((f32(bitcast<i32>(((_e2706 >> bitcast<u32>((_e2714 & 31u))) & 255u))) - _e2713) * _e2721)) - _e2673) * _e2726));
let _e2731 = local.member[0u];
let _e2732 = ((_e2603 + _e2600) + _e2731);
let _e2734 = (_e2732 >> bitcast<u32>(2i));
let _e2737 = bitcast<u32>(((_e2732 & 3i) * 8i));
let _e2739 = select(_e2626, _e2734, (_e2734 < _e2626));
let _e2744 = global_2.member[bitcast<u32>(select(0i, _e2739, (_e2739 > 0i)))];
let _e2748 = (_e2734 + 1i);
let _e2750 = select(_e2626, _e2748, (_e2748 < _e2626));
let _e2755 = global_2.member[bitcast<u32>(select(0i, _e2750, (_e2750 > 0i)))];
let _e2762 = ((_e2744 >> bitcast<u32>((_e2737 & 31u))) | ((_e2755 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2737) & 31u))));
let _e2763 = local.member_1[1u];
let _e2769 = f32(bitcast<i32>(((_e2762 >> bitcast<u32>((_e2763 & 31u))) & 255u)));
let _e2770 = local.member_1[2u];
let _e2777 = local_1[0u];
let _e2780 = (_e2769 + ((f32(bitcast<i32>(((_e2762 >> bitcast<u32>((_e2770 & 31u))) & 255u))) - _e2769) * _e2777));
let _e2782 = local.member[0u];
let _e2783 = ((_e2603 + _e2601) + _e2782);
let _e2785 = (_e2783 >> bitcast<u32>(2i));
let _e2788 = bitcast<u32>(((_e2783 & 3i) * 8i));
let _e2790 = select(_e2626, _e2785, (_e2785 < _e2626));
let _e2795 = global_2.member[bitcast<u32>(select(0i, _e2790, (_e2790 > 0i)))];
let _e2799 = (_e2785 + 1i);
let _e2801 = select(_e2626, _e2799, (_e2799 < _e2626));
let _e2806 = global_2.member[bitcast<u32>(select(0i, _e2801, (_e2801 > 0i)))];
let _e2813 = ((_e2795 >> bitcast<u32>((_e2788 & 31u))) | ((_e2806 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2788) & 31u))));
let _e2814 = local.member_1[1u];
let _e2820 = f32(bitcast<i32>(((_e2813 >> bitcast<u32>((_e2814 & 31u))) & 255u)));
let _e2821 = local.member_1[2u];
let _e2828 = local_1[0u];
let _e2832 = local_1[1u];
let _e2837 = local_1[2u];
let _e2844 = global_1.member.member_6.member_5;
let _e2849 = global_1.member.member_6.member_6;
let _e2850 = (((_e2729 + (((_e2780 + (((_e2820 + ((f32(bitcast<i32>(((_e2813 >> bitcast<u32>((_e2821 & 31u))) & 255u))) - _e2820) * _e2828)) - _e2780) * _e2832)) - _e2729) * _e2837)) * _e2844) + _e2849);
let _e2852 = select(0f, _e2850, (_e2850 > 0f));
if ((_e611 & 16u) == 0u) {
phi_5657_ = type_5(1f, 1f, 1f);
} else {
let _e2860 = global_1.member.member_14.member;
let _e2871 = ((((_e2860.member.member * _e306) + (_e2860.member.member_1 * _e315)) + (_e2860.member.member_2 * _e288)) + _e2860.member_1);
let _e2877 = ((((_e2860.member.member * _e327) + (_e2860.member.member_1 * _e332)) + (_e2860.member.member_2 * _e321)) + _e2860.member_1);
let _e2879 = select(_e2877, _e2871, (_e2871 < _e2877));
let _e2881 = select(_e2877, _e2871, (_e2871 > _e2877));
let _e2883 = (_e2881 - _e2879);
let _e2886 = (-(_e2879) / select(1e-30f, _e2883, (_e2883 > 1e-30f)));
let _e2888 = select(0f, _e2886, (_e2886 > 0f));
let _e2894 = select(select(select(1f, _e2888, (_e2888 < 1f)), 1f, (_e2881 <= 0f)), 0f, (_e2879 > 0f));
let _e2899 = global_1.member.member_14.member_1;
let _e2900 = (_e2899 != 0u);
let _e2910 = global_1.member.member_15.member;
let _e2921 = ((((_e2910.member.member * _e306) + (_e2910.member.member_1 * _e315)) + (_e2910.member.member_2 * _e288)) + _e2910.member_1);
let _e2927 = ((((_e2910.member.member * _e327) + (_e2910.member.member_1 * _e332)) + (_e2910.member.member_2 * _e321)) + _e2910.member_1);
let _e2929 = select(_e2927, _e2921, (_e2921 < _e2927));
let _e2931 = select(_e2927, _e2921, (_e2921 > _e2927));
let _e2933 = (_e2931 - _e2929);
let _e2936 = (-(_e2929) / select(1e-30f, _e2933, (_e2933 > 1e-30f)));
let _e2938 = select(0f, _e2936, (_e2936 > 0f));
let _e2944 = select(select(select(1f, _e2938, (_e2938 < 1f)), 1f, (_e2931 <= 0f)), 0f, (_e2929 > 0f));
let _e2949 = global_1.member.member_15.member_1;
let _e2950 = (_e2949 != 0u);
let _e2960 = global_1.member.member_16.member;
let _e2971 = ((((_e2960.member.member * _e306) + (_e2960.member.member_1 * _e315)) + (_e2960.member.member_2 * _e288)) + _e2960.member_1);
let _e2977 = ((((_e2960.member.member * _e327) + (_e2960.member.member_1 * _e332)) + (_e2960.member.member_2 * _e321)) + _e2960.member_1);
let _e2979 = select(_e2977, _e2971, (_e2971 < _e2977));
let _e2981 = select(_e2977, _e2971, (_e2971 > _e2977));
let _e2983 = (_e2981 - _e2979);
let _e2986 = (-(_e2979) / select(1e-30f, _e2983, (_e2983 > 1e-30f)));
let _e2988 = select(0f, _e2986, (_e2986 > 0f));
let _e2994 = select(select(select(1f, _e2988, (_e2988 < 1f)), 1f, (_e2981 <= 0f)), 0f, (_e2979 > 0f));
let _e2999 = global_1.member.member_16.member_1;
let _e3000 = (_e2999 != 0u);
let _e3010 = global_1.member.member_17.member;
let _e3021 = ((((_e3010.member.member * _e306) + (_e3010.member.member_1 * _e315)) + (_e3010.member.member_2 * _e288)) + _e3010.member_1);
let _e3027 = ((((_e3010.member.member * _e327) + (_e3010.member.member_1 * _e332)) + (_e3010.member.member_2 * _e321)) + _e3010.member_1);
let _e3029 = select(_e3027, _e3021, (_e3021 < _e3027));
let _e3031 = select(_e3027, _e3021, (_e3021 > _e3027));
let _e3033 = (_e3031 - _e3029);
let _e3036 = (-(_e3029) / select(1e-30f, _e3033, (_e3033 > 1e-30f)));
let _e3038 = select(0f, _e3036, (_e3036 > 0f));
let _e3044 = select(select(select(1f, _e3038, (_e3038 < 1f)), 1f, (_e3031 <= 0f)), 0f, (_e3029 > 0f));
let _e3049 = global_1.member.member_17.member_1;
let _e3050 = (_e3049 != 0u);
phi_5657_ = type_5(((((1f * _e2894) * _e2944) * _e2994) * _e3044), ((((1f * select(1f, _e2894, _e2900)) * select(1f, _e2944, _e2950)) * select(1f, _e2994, _e3000)) * select(1f, _e3044, _e3050)), ((((1f * select(1f, 0f, (_e2900 && (_e2877 > 0f)))) * select(1f, 0f, (_e2950 && (_e2927 > 0f)))) * select(1f, 0f, (_e3000 && (_e2977 > 0f)))) * select(1f, 0f, (_e3050 && (_e3027 > 0f)))));
}
let _e3059 = phi_5657_;
let _e3060 = (_e327 - _e306);
let _e3061 = (_e332 - _e315);
let _e3062 = (_e321 - _e288);
let _e3067 = (((_e3060 * _e3060) + (_e3061 * _e3061)) + (_e3062 * _e3062));
let _e3071 = (_e483 < 1e-12f);
let _e3073 = (1f / select(_e478, 1f, _e3071));
let _e3075 = ((-0.5f - _e395) * _e3073);
let _e3077 = ((_e453 - _e395) * _e3073);
let _e3083 = select(_e3077, _e3075, (_e3075 < _e3077));
let _e3085 = select(0f, _e3083, (_e3083 > 0f));
let _e3088 = select(select(1f, _e3085, (_e3085 < 1f)), select(2f, 0f, ((_e395 >= -0.5f) && (_e395 <= _e453))), _e3071);
let _e3090 = select(_e3077, _e3075, (_e3075 > _e3077));
let _e3092 = select(0f, _e3090, (_e3090 > 0f));
let _e3095 = select(select(1f, _e3092, (_e3092 < 1f)), 1f, _e3071);
let _e3096 = (_e486 < 1e-12f);
let _e3098 = (1f / select(_e479, 1f, _e3096));
let _e3100 = ((-0.5f - _e410) * _e3098);
let _e3102 = ((_e463 - _e410) * _e3098);
let _e3108 = select(_e3102, _e3100, (_e3100 < _e3102));
let _e3110 = select(0f, _e3108, (_e3108 > 0f));
let _e3113 = select(select(1f, _e3110, (_e3110 < 1f)), select(2f, 0f, ((_e410 >= -0.5f) && (_e410 <= _e463))), _e3096);
let _e3115 = select(_e3102, _e3100, (_e3100 > _e3102));
let _e3117 = select(0f, _e3115, (_e3115 > 0f));
let _e3120 = select(select(1f, _e3117, (_e3117 < 1f)), 1f, _e3096);
let _e3121 = (_e491 < 1e-12f);
let _e3123 = (1f / select(_e480, 1f, _e3121));
let _e3125 = ((-0.5f - _e425) * _e3123);
let _e3127 = ((_e473 - _e425) * _e3123);
let _e3133 = select(_e3127, _e3125, (_e3125 < _e3127));
let _e3135 = select(0f, _e3133, (_e3133 > 0f));
let _e3138 = select(select(1f, _e3135, (_e3135 < 1f)), select(2f, 0f, ((_e425 >= -0.5f) && (_e425 <= _e473))), _e3121);
let _e3140 = select(_e3127, _e3125, (_e3125 > _e3127));
let _e3142 = select(0f, _e3140, (_e3140 > 0f));
let _e3145 = select(select(1f, _e3142, (_e3142 < 1f)), 1f, _e3121);
let _e3147 = select(_e3120, _e3095, (_e3095 < _e3120));
let _e3151 = select(_e3113, _e3088, (_e3088 > _e3113));
let _e3154 = (select(_e3145, _e3147, (_e3147 < _e3145)) - select(_e3138, _e3151, (_e3151 > _e3138)));
let _e3161 = global_1.member.member_5.member_3;
let _e3162 = ((sqrt(select(0f, _e3067, (_e3067 > 0f))) * select(0f, _e3154, (_e3154 > 0f))) * _e3161);
let _e3164 = (select(1f, _e2852, (_e2852 < 1f)) * 255f);
let _e3165 = (_e2472.member * 255f);
let _e3166 = (255f - 1f);
let _e3168 = select(0f, _e3164, (_e3164 > 0f));
let _e3170 = select(_e3166, _e3168, (_e3168 < _e3166));
let _e3177 = select(0i, select(select(i32(_e3170), i32(-2147483648), (_e3170 < -2147483600f)), 2147483647i, (_e3170 > 2147483500f)), (_e3170 == _e3170));
let _e3181 = (_e3177 - select(0i, 1i, (_e3170 < f32(_e3177))));
let _e3183 = select(0f, _e3165, (_e3165 > 0f));
let _e3185 = select(_e3166, _e3183, (_e3183 < _e3166));
let _e3192 = select(0i, select(select(i32(_e3185), i32(-2147483648), (_e3185 < -2147483600f)), 2147483647i, (_e3185 > 2147483500f)), (_e3185 == _e3185));
let _e3196 = (_e3192 - select(0i, 1i, (_e3185 < f32(_e3192))));
let _e3199 = (((_e3181 * 256i) + _e3196) * 4i);
let _e3201 = (_e3164 - f32(_e3181));
let _e3203 = (_e3165 - f32(_e3196));
let _e3205 = (bitcast<i32>(_e95) - 1i);
let _e3207 = select(_e3205, _e3199, (_e3199 < _e3205));
let _e3213 = global_4.member[bitcast<u32>(select(0i, _e3207, (_e3207 > 0i)))];
let _e3214 = (_e3199 + 4i);
let _e3216 = select(_e3205, _e3214, (_e3214 < _e3205));
let _e3222 = global_4.member[bitcast<u32>(select(0i, _e3216, (_e3216 > 0i)))];
let _e3223 = (_e3199 + 1024i);
let _e3225 = select(_e3205, _e3223, (_e3223 < _e3205));
let _e3231 = global_4.member[bitcast<u32>(select(0i, _e3225, (_e3225 > 0i)))];
let _e3232 = (_e3199 + 1028i);
let _e3234 = select(_e3205, _e3232, (_e3232 < _e3205));
let _e3240 = global_4.member[bitcast<u32>(select(0i, _e3234, (_e3234 > 0i)))];
let _e3245 = (bitcast<f32>(((_e3213 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3253 = (_e3245 + (((bitcast<f32>(((_e3222 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3245) * _e3203));
let _e3258 = (bitcast<f32>(((_e3231 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3282 = (bitcast<f32>((((_e3213 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3290 = (_e3282 + (((bitcast<f32>((((_e3222 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3282) * _e3203));
let _e3295 = (bitcast<f32>((((_e3231 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3307 = (_e3199 + 1i);
let _e3309 = select(_e3205, _e3307, (_e3307 < _e3205));
let _e3315 = global_4.member[bitcast<u32>(select(0i, _e3309, (_e3309 > 0i)))];
let _e3316 = (_e3199 + 5i);
let _e3318 = select(_e3205, _e3316, (_e3316 < _e3205));
let _e3324 = global_4.member[bitcast<u32>(select(0i, _e3318, (_e3318 > 0i)))];
let _e3325 = (_e3199 + 1025i);
let _e3327 = select(_e3205, _e3325, (_e3325 < _e3205));
let _e3333 = global_4.member[bitcast<u32>(select(0i, _e3327, (_e3327 > 0i)))];
let _e3334 = (_e3199 + 1029i);
let _e3336 = select(_e3205, _e3334, (_e3334 < _e3205));
let _e3342 = global_4.member[bitcast<u32>(select(0i, _e3336, (_e3336 > 0i)))];
let _e3347 = (bitcast<f32>(((_e3315 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3355 = (_e3347 + (((bitcast<f32>(((_e3324 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3347) * _e3203));
let _e3360 = (bitcast<f32>(((_e3333 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3384 = (bitcast<f32>((((_e3315 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3392 = (_e3384 + (((bitcast<f32>((((_e3324 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3384) * _e3203));
let _e3397 = (bitcast<f32>((((_e3333 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3412 = (_e3162 * _e3059.member_1);
let _e3414 = -(((_e3290 + (((_e3295 + (((bitcast<f32>((((_e3240 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3295) * _e3203)) - _e3290) * _e3201)) * _e3412));
let _e3416 = select(-87f, _e3414, (_e3414 > -87f));
let _e3418 = select(88f, _e3416, (_e3416 < 88f));
let _e3420 = ((_e3418 * 1.442695f) + 0.5f);
let _e3422 = select(-127f, _e3420, (_e3420 > -127f));
let _e3424 = select(128f, _e3422, (_e3422 < 128f));
let _e3431 = select(0i, select(select(i32(_e3424), i32(-2147483648), (_e3424 < -2147483600f)), 2147483647i, (_e3424 > 2147483500f)), (_e3424 == _e3424));
let _e3435 = (_e3431 - select(0i, 1i, (_e3424 < f32(_e3431))));
let _e3436 = f32(_e3435);
let _e3440 = ((_e3418 - (_e3436 * 0.6933594f)) - (_e3436 * -2.1219444e-4f));
let _e3462 = -(((_e3355 + (((_e3360 + (((bitcast<f32>(((_e3342 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3360) * _e3203)) - _e3355) * _e3201)) * _e3412));
let _e3464 = select(-87f, _e3462, (_e3462 > -87f));
let _e3466 = select(88f, _e3464, (_e3464 < 88f));
let _e3468 = ((_e3466 * 1.442695f) + 0.5f);
let _e3470 = select(-127f, _e3468, (_e3468 > -127f));
let _e3472 = select(128f, _e3470, (_e3470 < 128f));
let _e3479 = select(0i, select(select(i32(_e3472), i32(-2147483648), (_e3472 < -2147483600f)), 2147483647i, (_e3472 > 2147483500f)), (_e3472 == _e3472));
let _e3483 = (_e3479 - select(0i, 1i, (_e3472 < f32(_e3479))));
let _e3484 = f32(_e3483);
let _e3488 = ((_e3466 - (_e3484 * 0.6933594f)) - (_e3484 * -2.1219444e-4f));
let _e3510 = -(((_e3392 + (((_e3397 + (((bitcast<f32>((((_e3342 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3397) * _e3203)) - _e3392) * _e3201)) * _e3412));
let _e3512 = select(-87f, _e3510, (_e3510 > -87f));
let _e3514 = select(88f, _e3512, (_e3512 < 88f));
let _e3516 = ((_e3514 * 1.442695f) + 0.5f);
let _e3518 = select(-127f, _e3516, (_e3516 > -127f));
let _e3520 = select(128f, _e3518, (_e3518 < 128f));
let _e3527 = select(0i, select(select(i32(_e3520), i32(-2147483648), (_e3520 < -2147483600f)), 2147483647i, (_e3520 > 2147483500f)), (_e3520 == _e3520));
let _e3531 = (_e3527 - select(0i, 1i, (_e3520 < f32(_e3527))));
let _e3532 = f32(_e3531);
let _e3536 = ((_e3514 - (_e3532 * 0.6933594f)) - (_e3532 * -2.1219444e-4f));
let _e3558 = -(((_e3253 + (((_e3258 + (((bitcast<f32>(((_e3240 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3258) * _e3203)) - _e3253) * _e3201)) * (_e3162 * _e3059.member)));
let _e3560 = select(-87f, _e3558, (_e3558 > -87f));
let _e3562 = select(88f, _e3560, (_e3560 < 88f));
let _e3564 = ((_e3562 * 1.442695f) + 0.5f);
let _e3566 = select(-127f, _e3564, (_e3564 > -127f));
let _e3568 = select(128f, _e3566, (_e3566 < 128f));
let _e3575 = select(0i, select(select(i32(_e3568), i32(-2147483648), (_e3568 < -2147483600f)), 2147483647i, (_e3568 > 2147483500f)), (_e3568 == _e3568));
let _e3579 = (_e3575 - select(0i, 1i, (_e3568 < f32(_e3575))));
let _e3580 = f32(_e3579);
let _e3584 = ((_e3562 - (_e3580 * 0.6933594f)) - (_e3580 * -2.1219444e-4f));
let _e3604 = ((1f + (_e3584 * (1f + (_e3584 * (0.5f + (_e3584 * (0.16666667f + (_e3584 * (0.041666668f + (_e3584 * (0.008333334f + (_e3584 * (0.001388889f + (_e3584 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3579 + 127i)) << bitcast<u32>(23i))));
if _e628 {
let _e3619 = global_1.member.member_5.member_4;
let _e3622 = (_e2472.member_3.x * _e3059.member_2);
let _e3624 = (_e2472.member_3.y * _e3059.member_2);
let _e3626 = (_e2472.member_3.z * _e3059.member_2);
let _e3627 = (0.5f * (_e245 / _e196));
let _e3631 = (_e174 + (_e3622 * _e3627));
let _e3632 = (_e185 + (_e3624 * _e3627));
let _e3633 = (_e196 + (_e3626 * _e3627));
let _e3635 = (2f * _e245);
let _e3637 = ((_e3633 * _e3633) + (_e3635 * _e3626));
let _e3641 = (_e3633 + sqrt(select(0f, _e3637, (_e3637 > 0f))));
let _e3645 = (0.5f * (_e3635 / select(1e-6f, _e3641, (_e3641 > 1e-6f))));
let _e3649 = (_e3631 + (_e3622 * _e3645));
let _e3650 = (_e3632 + (_e3624 * _e3645));
let _e3651 = (_e3633 + (_e3626 * _e3645));
let _e3655 = (_e3619 * _e3619);
let _e3657 = (_e3651 * _e3651);
let _e3665 = (((_e3633 <= 0f) || (_e3637 <= 0f)) || ((_e3651 <= 0f) || (_e3657 <= (_e3655 * (((_e3649 * _e3649) + (_e3650 * _e3650)) + _e3657)))));
let _e3679 = (_e174 + ((_e2472.member_4.x * _e3059.member_2) * _e245));
let _e3680 = (_e185 + ((_e2472.member_4.y * _e3059.member_2) * _e245));
let _e3681 = (_e196 + ((_e2472.member_4.z * _e3059.member_2) * _e245));
let _e3683 = (_e3681 * _e3681);
let _e3692 = ((_e611 & 1u) != 0u);
phi_6683_ = vec3<f32>(select(select(select(_e3649, _e3631, _e3665), _e3679, _e3692), _e174, _e618), select(select(select(_e3650, _e3632, _e3665), _e3680, _e3692), _e185, _e618), select(select(select(_e3651, _e3633, _e3665), _e3681, _e3692), _e196, _e618));
phi_6684_ = (select(_e3665, ((_e3681 <= 0f) || (_e3683 <= (_e3655 * (((_e3679 * _e3679) + (_e3680 * _e3680)) + _e3683)))), _e3692) && !(_e618));
} else {
phi_6683_ = vec3<f32>(_e174, _e185, _e196);
phi_6684_ = false;
}
let _e3704 = phi_6683_;
let _e3706 = phi_6684_;
global_6.member[_e120] = (_e131 + _e260);
global_6.member[_e132] = (_e141 + _e267);
global_6.member[_e143] = (_e152 + _e369);
global_6.member[_e154] = (_e163 + _e372);
global_6.member[_e165] = _e3704.x;
global_6.member[_e176] = _e3704.y;
global_6.member[_e187] = _e3704.z;
global_6.member[_e198] = select((_e207 * (((1f + (_e3440 * (1f + (_e3440 * (0.5f + (_e3440 * (0.16666667f + (_e3440 * (0.041666668f + (_e3440 * (0.008333334f + (_e3440 * (0.001388889f + (_e3440 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3435 + 127i)) << bitcast<u32>(23i)))) * _e3604)), _e207, _e618);
global_6.member[_e209] = select((_e218 * (((1f + (_e3488 * (1f + (_e3488 * (0.5f + (_e3488 * (0.16666667f + (_e3488 * (0.041666668f + (_e3488 * (0.008333334f + (_e3488 * (0.001388889f + (_e3488 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3483 + 127i)) << bitcast<u32>(23i)))) * _e3604)), _e218, _e618);
global_6.member[_e220] = select((_e229 * (((1f + (_e3536 * (1f + (_e3536 * (0.5f + (_e3536 * (0.16666667f + (_e3536 * (0.041666668f + (_e3536 * (0.008333334f + (_e3536 * (0.001388889f + (_e3536 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3531 + 127i)) << bitcast<u32>(23i)))) * _e3604)), _e229, _e618);
global_6.member[_e231] = select(_e240, 1f, _e3706);
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
