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
var phi_4008_: type_29;
var phi_4709_: type_30;
var phi_5633_: type_5;
var phi_6657_: f32;
var phi_6658_: f32;
var phi_6659_: f32;
var phi_6660_: bool;
switch bitcast<i32>(0u) {
default: {
let _e89 = global;
let _e92 = arrayLength((&global_2.member));
let _e96 = arrayLength((&global_4.member));
let _e103 = global_1.member.member_2;
let _e106 = global_1.member.member;
let _e114 = (_e89.x + _e103.member);
let _e116 = (_e89.y + _e103.member_1);
if (_e114 < _e103.member_2) {
if (_e116 < _e103.member_3) {
let _e119 = (_e106.member * _e106.member_1);
let _e121 = ((_e116 * _e106.member) + _e114);
let _e122 = bitcast<i32>(_e121);
let _e124 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e126 = select(_e124, _e122, (_e122 < _e124));
let _e132 = global_6.member[bitcast<u32>(select(0i, _e126, (_e126 > 0i)))];
let _e133 = (_e119 + _e121);
let _e134 = bitcast<i32>(_e133);
let _e136 = select(_e124, _e134, (_e134 < _e124));
let _e142 = global_6.member[bitcast<u32>(select(0i, _e136, (_e136 > 0i)))];
let _e144 = ((2u * _e119) + _e121);
let _e145 = bitcast<i32>(_e144);
let _e147 = select(_e124, _e145, (_e145 < _e124));
let _e153 = global_6.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e155 = ((3u * _e119) + _e121);
let _e156 = bitcast<i32>(_e155);
let _e158 = select(_e124, _e156, (_e156 < _e124));
let _e164 = global_6.member[bitcast<u32>(select(0i, _e158, (_e158 > 0i)))];
let _e166 = ((4u * _e119) + _e121);
let _e167 = bitcast<i32>(_e166);
let _e169 = select(_e124, _e167, (_e167 < _e124));
let _e175 = global_6.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e177 = ((5u * _e119) + _e121);
let _e178 = bitcast<i32>(_e177);
let _e180 = select(_e124, _e178, (_e178 < _e124));
let _e186 = global_6.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e188 = ((6u * _e119) + _e121);
let _e189 = bitcast<i32>(_e188);
let _e191 = select(_e124, _e189, (_e189 < _e124));
let _e197 = global_6.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
let _e199 = ((7u * _e119) + _e121);
let _e200 = bitcast<i32>(_e199);
let _e202 = select(_e124, _e200, (_e200 < _e124));
let _e208 = global_6.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e210 = ((8u * _e119) + _e121);
let _e211 = bitcast<i32>(_e210);
let _e213 = select(_e124, _e211, (_e211 < _e124));
let _e219 = global_6.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e221 = ((9u * _e119) + _e121);
let _e222 = bitcast<i32>(_e221);
let _e224 = select(_e124, _e222, (_e222 < _e124));
let _e230 = global_6.member[bitcast<u32>(select(0i, _e224, (_e224 > 0i)))];
let _e232 = ((10u * _e119) + _e121);
let _e233 = bitcast<i32>(_e232);
let _e235 = select(_e124, _e233, (_e233 < _e124));
let _e241 = global_6.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e245 = global_1.member.member_5.member_2;
let _e248 = (1f / select(1e-6f, _e197, (_e197 > 1e-6f)));
let _e252 = global_1.member.member_8.member_5;
let _e253 = (_e245 * _e252);
let _e258 = global_1.member.member_8.member_6;
let _e260 = (((_e175 * _e248) - _e258) * _e253);
let _e265 = global_1.member.member_8.member_7;
let _e267 = (((_e186 * _e248) - _e265) * _e253);
let _e271 = ((f32(bitcast<i32>(_e114)) - 0.5f) + _e132);
let _e275 = global_1.member.member_8.member_1;
let _e276 = (_e275 + 1u);
let _e278 = select(1u, _e276, (_e276 > 0u));
let _e279 = (_e278 == 0u);
if _e279 {
break;
}
let _e284 = ((f32(bitcast<i32>((_e116 % _e278))) - 0.5f) + _e142);
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
let _e335 = bitcast<i32>(((_e116 / _e278) * 3u));
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
if (select(0u, select(7u, select(3u, 1u, ((((_e260 == 0f) && (_e267 == 0f)) && (_e369 == 0f)) && (_e372 == 0f))), _e618), (_e241 == 0f)) > 1u) {
if _e279 {
break;
}
if _e279 {
break;
}
let _e625 = (_e106.member_2 == 2u);
let _e628 = (((_e106.member_2 == 1u) || _e625) || (_e106.member_2 == 5u));
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
let _e708 = (bitcast<i32>(_e92) - 1i);
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
let _e753 = (_e751 >> bitcast<u32>(1i));
let _e756 = bitcast<u32>(((_e751 & 1i) * 16i));
let _e758 = select(_e708, _e753, (_e753 < _e708));
let _e763 = global_2.member[bitcast<u32>(select(0i, _e758, (_e758 > 0i)))];
let _e767 = (_e753 + 1i);
let _e769 = select(_e708, _e767, (_e767 < _e708));
let _e774 = global_2.member[bitcast<u32>(select(0i, _e769, (_e769 > 0i)))];
let _e781 = ((_e763 >> bitcast<u32>((_e756 & 31u))) | ((_e774 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e756) & 31u))));
let _e784 = local_4.member[2u];
let _e785 = (_e747 + _e784);
let _e787 = (_e785 >> bitcast<u32>(1i));
let _e790 = bitcast<u32>(((_e785 & 1i) * 16i));
let _e792 = select(_e708, _e787, (_e787 < _e708));
let _e797 = global_2.member[bitcast<u32>(select(0i, _e792, (_e792 > 0i)))];
let _e801 = (_e787 + 1i);
let _e803 = select(_e708, _e801, (_e801 < _e708));
let _e808 = global_2.member[bitcast<u32>(select(0i, _e803, (_e803 > 0i)))];
let _e815 = ((_e797 >> bitcast<u32>((_e790 & 31u))) | ((_e808 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e790) & 31u))));
let _e818 = local_4.member_1[0u];
let _e824 = f32(bitcast<i32>(((_e781 >> bitcast<u32>((_e818 & 31u))) & 65535u)));
let _e827 = local_4.member_1[1u];
let _e833 = f32(bitcast<i32>(((_e781 >> bitcast<u32>((_e827 & 31u))) & 65535u)));
let _e836 = local_4.member_1[4u];
let _e842 = f32(bitcast<i32>(((_e815 >> bitcast<u32>((_e836 & 31u))) & 65535u)));
let _e845 = local_4.member_1[5u];
let _e852 = local_5[0u];
let _e855 = (_e824 + ((_e833 - _e824) * _e852));
let _e856 = local_5[0u];
let _e859 = (_e833 + ((_e842 - _e833) * _e856));
let _e860 = local_5[0u];
let _e863 = (_e842 + ((f32(bitcast<i32>(((_e815 >> bitcast<u32>((_e845 & 31u))) & 65535u))) - _e842) * _e860));
let _e864 = (_e732 + _e729);
let _e865 = local_4.member[0u];
let _e866 = (_e864 + _e865);
let _e868 = (_e866 >> bitcast<u32>(1i));
let _e871 = bitcast<u32>(((_e866 & 1i) * 16i));
let _e873 = select(_e708, _e868, (_e868 < _e708));
let _e878 = global_2.member[bitcast<u32>(select(0i, _e873, (_e873 > 0i)))];
let _e882 = (_e868 + 1i);
let _e884 = select(_e708, _e882, (_e882 < _e708));
let _e889 = global_2.member[bitcast<u32>(select(0i, _e884, (_e884 > 0i)))];
let _e896 = ((_e878 >> bitcast<u32>((_e871 & 31u))) | ((_e889 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e871) & 31u))));
let _e897 = local_4.member[2u];
let _e898 = (_e864 + _e897);
let _e900 = (_e898 >> bitcast<u32>(1i));
let _e903 = bitcast<u32>(((_e898 & 1i) * 16i));
let _e905 = select(_e708, _e900, (_e900 < _e708));
let _e910 = global_2.member[bitcast<u32>(select(0i, _e905, (_e905 > 0i)))];
let _e914 = (_e900 + 1i);
let _e916 = select(_e708, _e914, (_e914 < _e708));
let _e921 = global_2.member[bitcast<u32>(select(0i, _e916, (_e916 > 0i)))];
let _e928 = ((_e910 >> bitcast<u32>((_e903 & 31u))) | ((_e921 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e903) & 31u))));
let _e929 = local_4.member_1[0u];
let _e935 = f32(bitcast<i32>(((_e896 >> bitcast<u32>((_e929 & 31u))) & 65535u)));
let _e936 = local_4.member_1[1u];
let _e942 = f32(bitcast<i32>(((_e896 >> bitcast<u32>((_e936 & 31u))) & 65535u)));
let _e943 = local_4.member_1[4u];
let _e949 = f32(bitcast<i32>(((_e928 >> bitcast<u32>((_e943 & 31u))) & 65535u)));
let _e950 = local_4.member_1[5u];
let _e957 = local_5[0u];
let _e961 = local_5[0u];
let _e964 = (_e942 + ((_e949 - _e942) * _e961));
let _e965 = local_5[0u];
let _e969 = (_e734 + _e727);
let _e970 = local_4.member[0u];
let _e971 = (_e969 + _e970);
let _e973 = (_e971 >> bitcast<u32>(1i));
let _e976 = bitcast<u32>(((_e971 & 1i) * 16i));
let _e978 = select(_e708, _e973, (_e973 < _e708));
let _e983 = global_2.member[bitcast<u32>(select(0i, _e978, (_e978 > 0i)))];
let _e987 = (_e973 + 1i);
let _e989 = select(_e708, _e987, (_e987 < _e708));
let _e994 = global_2.member[bitcast<u32>(select(0i, _e989, (_e989 > 0i)))];
let _e1001 = ((_e983 >> bitcast<u32>((_e976 & 31u))) | ((_e994 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e976) & 31u))));
let _e1002 = local_4.member[2u];
let _e1003 = (_e969 + _e1002);
let _e1005 = (_e1003 >> bitcast<u32>(1i));
let _e1008 = bitcast<u32>(((_e1003 & 1i) * 16i));
let _e1010 = select(_e708, _e1005, (_e1005 < _e708));
let _e1015 = global_2.member[bitcast<u32>(select(0i, _e1010, (_e1010 > 0i)))];
let _e1019 = (_e1005 + 1i);
let _e1021 = select(_e708, _e1019, (_e1019 < _e708));
let _e1026 = global_2.member[bitcast<u32>(select(0i, _e1021, (_e1021 > 0i)))];
let _e1033 = ((_e1015 >> bitcast<u32>((_e1008 & 31u))) | ((_e1026 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1008) & 31u))));
let _e1034 = local_4.member_1[0u];
let _e1040 = f32(bitcast<i32>(((_e1001 >> bitcast<u32>((_e1034 & 31u))) & 65535u)));
let _e1041 = local_4.member_1[1u];
let _e1047 = f32(bitcast<i32>(((_e1001 >> bitcast<u32>((_e1041 & 31u))) & 65535u)));
let _e1048 = local_4.member_1[4u];
let _e1054 = f32(bitcast<i32>(((_e1033 >> bitcast<u32>((_e1048 & 31u))) & 65535u)));
let _e1055 = local_4.member_1[5u];
let _e1062 = local_5[0u];
let _e1065 = (_e1040 + ((_e1047 - _e1040) * _e1062));
let _e1066 = local_5[0u];
let _e1069 = (_e1047 + ((_e1054 - _e1047) * _e1066));
let _e1070 = local_5[0u];
let _e1073 = (_e1054 + ((f32(bitcast<i32>(((_e1033 >> bitcast<u32>((_e1055 & 31u))) & 65535u))) - _e1054) * _e1070));
let _e1074 = (_e734 + _e729);
let _e1075 = local_4.member[0u];
let _e1076 = (_e1074 + _e1075);
let _e1078 = (_e1076 >> bitcast<u32>(1i));
let _e1081 = bitcast<u32>(((_e1076 & 1i) * 16i));
let _e1083 = select(_e708, _e1078, (_e1078 < _e708));
let _e1088 = global_2.member[bitcast<u32>(select(0i, _e1083, (_e1083 > 0i)))];
let _e1092 = (_e1078 + 1i);
let _e1094 = select(_e708, _e1092, (_e1092 < _e708));
let _e1099 = global_2.member[bitcast<u32>(select(0i, _e1094, (_e1094 > 0i)))];
let _e1106 = ((_e1088 >> bitcast<u32>((_e1081 & 31u))) | ((_e1099 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1081) & 31u))));
let _e1107 = local_4.member[2u];
let _e1108 = (_e1074 + _e1107);
let _e1110 = (_e1108 >> bitcast<u32>(1i));
let _e1113 = bitcast<u32>(((_e1108 & 1i) * 16i));
let _e1115 = select(_e708, _e1110, (_e1110 < _e708));
let _e1120 = global_2.member[bitcast<u32>(select(0i, _e1115, (_e1115 > 0i)))];
let _e1124 = (_e1110 + 1i);
let _e1126 = select(_e708, _e1124, (_e1124 < _e708));
let _e1131 = global_2.member[bitcast<u32>(select(0i, _e1126, (_e1126 > 0i)))];
let _e1138 = ((_e1120 >> bitcast<u32>((_e1113 & 31u))) | ((_e1131 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1113) & 31u))));
let _e1139 = local_4.member_1[0u];
let _e1145 = f32(bitcast<i32>(((_e1106 >> bitcast<u32>((_e1139 & 31u))) & 65535u)));
let _e1146 = local_4.member_1[1u];
let _e1152 = f32(bitcast<i32>(((_e1106 >> bitcast<u32>((_e1146 & 31u))) & 65535u)));
let _e1153 = local_4.member_1[4u];
let _e1159 = f32(bitcast<i32>(((_e1138 >> bitcast<u32>((_e1153 & 31u))) & 65535u)));
let _e1160 = local_4.member_1[5u];
let _e1167 = local_5[0u];
let _e1171 = local_5[0u];
let _e1174 = (_e1152 + ((_e1159 - _e1152) * _e1171));
let _e1175 = local_5[0u];
let _e1182 = local_4.member[1u];
let _e1183 = ((_e732 + _e721) + _e1182);
let _e1185 = (_e1183 >> bitcast<u32>(1i));
let _e1188 = bitcast<u32>(((_e1183 & 1i) * 16i));
let _e1190 = select(_e708, _e1185, (_e1185 < _e708));
let _e1195 = global_2.member[bitcast<u32>(select(0i, _e1190, (_e1190 > 0i)))];
let _e1199 = (_e1185 + 1i);
let _e1201 = select(_e708, _e1199, (_e1199 < _e708));
let _e1206 = global_2.member[bitcast<u32>(select(0i, _e1201, (_e1201 > 0i)))];
let _e1213 = ((_e1195 >> bitcast<u32>((_e1188 & 31u))) | ((_e1206 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1188) & 31u))));
let _e1216 = local_4.member_1[2u];
let _e1222 = f32(bitcast<i32>(((_e1213 >> bitcast<u32>((_e1216 & 31u))) & 65535u)));
let _e1225 = local_4.member_1[3u];
let _e1232 = local_5[0u];
let _e1235 = (_e1222 + ((f32(bitcast<i32>(((_e1213 >> bitcast<u32>((_e1225 & 31u))) & 65535u))) - _e1222) * _e1232));
let _e1237 = local_4.member[1u];
let _e1238 = ((_e732 + _e731) + _e1237);
let _e1240 = (_e1238 >> bitcast<u32>(1i));
let _e1243 = bitcast<u32>(((_e1238 & 1i) * 16i));
let _e1245 = select(_e708, _e1240, (_e1240 < _e708));
let _e1250 = global_2.member[bitcast<u32>(select(0i, _e1245, (_e1245 > 0i)))];
let _e1254 = (_e1240 + 1i);
let _e1256 = select(_e708, _e1254, (_e1254 < _e708));
let _e1261 = global_2.member[bitcast<u32>(select(0i, _e1256, (_e1256 > 0i)))];
let _e1268 = ((_e1250 >> bitcast<u32>((_e1243 & 31u))) | ((_e1261 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1243) & 31u))));
let _e1269 = local_4.member_1[2u];
let _e1275 = f32(bitcast<i32>(((_e1268 >> bitcast<u32>((_e1269 & 31u))) & 65535u)));
let _e1276 = local_4.member_1[3u];
let _e1283 = local_5[0u];
let _e1288 = local_4.member[1u];
let _e1289 = ((_e734 + _e721) + _e1288);
let _e1291 = (_e1289 >> bitcast<u32>(1i));
let _e1294 = bitcast<u32>(((_e1289 & 1i) * 16i));
let _e1296 = select(_e708, _e1291, (_e1291 < _e708));
let _e1301 = global_2.member[bitcast<u32>(select(0i, _e1296, (_e1296 > 0i)))];
let _e1305 = (_e1291 + 1i);
let _e1307 = select(_e708, _e1305, (_e1305 < _e708));
let _e1312 = global_2.member[bitcast<u32>(select(0i, _e1307, (_e1307 > 0i)))];
let _e1319 = ((_e1301 >> bitcast<u32>((_e1294 & 31u))) | ((_e1312 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1294) & 31u))));
let _e1320 = local_4.member_1[2u];
let _e1326 = f32(bitcast<i32>(((_e1319 >> bitcast<u32>((_e1320 & 31u))) & 65535u)));
let _e1327 = local_4.member_1[3u];
let _e1334 = local_5[0u];
let _e1337 = (_e1326 + ((f32(bitcast<i32>(((_e1319 >> bitcast<u32>((_e1327 & 31u))) & 65535u))) - _e1326) * _e1334));
let _e1339 = local_4.member[1u];
let _e1340 = ((_e734 + _e731) + _e1339);
let _e1342 = (_e1340 >> bitcast<u32>(1i));
let _e1345 = bitcast<u32>(((_e1340 & 1i) * 16i));
let _e1347 = select(_e708, _e1342, (_e1342 < _e708));
let _e1352 = global_2.member[bitcast<u32>(select(0i, _e1347, (_e1347 > 0i)))];
let _e1356 = (_e1342 + 1i);
let _e1358 = select(_e708, _e1356, (_e1356 < _e708));
let _e1363 = global_2.member[bitcast<u32>(select(0i, _e1358, (_e1358 > 0i)))];
let _e1370 = ((_e1352 >> bitcast<u32>((_e1345 & 31u))) | ((_e1363 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1345) & 31u))));
let _e1371 = local_4.member_1[2u];
let _e1377 = f32(bitcast<i32>(((_e1370 >> bitcast<u32>((_e1371 & 31u))) & 65535u)));
let _e1378 = local_4.member_1[3u];
let _e1385 = local_5[0u];
let _e1390 = local_4.member[1u];
let _e1391 = ((_e723 + _e727) + _e1390);
let _e1393 = (_e1391 >> bitcast<u32>(1i));
let _e1396 = bitcast<u32>(((_e1391 & 1i) * 16i));
let _e1398 = select(_e708, _e1393, (_e1393 < _e708));
let _e1403 = global_2.member[bitcast<u32>(select(0i, _e1398, (_e1398 > 0i)))];
let _e1407 = (_e1393 + 1i);
let _e1409 = select(_e708, _e1407, (_e1407 < _e708));
let _e1414 = global_2.member[bitcast<u32>(select(0i, _e1409, (_e1409 > 0i)))];
let _e1421 = ((_e1403 >> bitcast<u32>((_e1396 & 31u))) | ((_e1414 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1396) & 31u))));
let _e1422 = local_4.member_1[2u];
let _e1428 = f32(bitcast<i32>(((_e1421 >> bitcast<u32>((_e1422 & 31u))) & 65535u)));
let _e1429 = local_4.member_1[3u];
let _e1436 = local_5[0u];
let _e1439 = (_e1428 + ((f32(bitcast<i32>(((_e1421 >> bitcast<u32>((_e1429 & 31u))) & 65535u))) - _e1428) * _e1436));
let _e1441 = local_4.member[1u];
let _e1442 = ((_e736 + _e727) + _e1441);
let _e1444 = (_e1442 >> bitcast<u32>(1i));
let _e1447 = bitcast<u32>(((_e1442 & 1i) * 16i));
let _e1449 = select(_e708, _e1444, (_e1444 < _e708));
let _e1454 = global_2.member[bitcast<u32>(select(0i, _e1449, (_e1449 > 0i)))];
let _e1458 = (_e1444 + 1i);
let _e1460 = select(_e708, _e1458, (_e1458 < _e708));
let _e1465 = global_2.member[bitcast<u32>(select(0i, _e1460, (_e1460 > 0i)))];
let _e1472 = ((_e1454 >> bitcast<u32>((_e1447 & 31u))) | ((_e1465 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1447) & 31u))));
let _e1473 = local_4.member_1[2u];
let _e1479 = f32(bitcast<i32>(((_e1472 >> bitcast<u32>((_e1473 & 31u))) & 65535u)));
let _e1480 = local_4.member_1[3u];
let _e1487 = local_5[0u];
let _e1490 = (_e1479 + ((f32(bitcast<i32>(((_e1472 >> bitcast<u32>((_e1480 & 31u))) & 65535u))) - _e1479) * _e1487));
let _e1492 = local_4.member[1u];
let _e1493 = ((_e723 + _e729) + _e1492);
let _e1495 = (_e1493 >> bitcast<u32>(1i));
let _e1498 = bitcast<u32>(((_e1493 & 1i) * 16i));
let _e1500 = select(_e708, _e1495, (_e1495 < _e708));
let _e1505 = global_2.member[bitcast<u32>(select(0i, _e1500, (_e1500 > 0i)))];
let _e1509 = (_e1495 + 1i);
let _e1511 = select(_e708, _e1509, (_e1509 < _e708));
let _e1516 = global_2.member[bitcast<u32>(select(0i, _e1511, (_e1511 > 0i)))];
let _e1523 = ((_e1505 >> bitcast<u32>((_e1498 & 31u))) | ((_e1516 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1498) & 31u))));
let _e1524 = local_4.member_1[2u];
let _e1530 = f32(bitcast<i32>(((_e1523 >> bitcast<u32>((_e1524 & 31u))) & 65535u)));
let _e1531 = local_4.member_1[3u];
let _e1538 = local_5[0u];
let _e1543 = local_4.member[1u];
let _e1544 = ((_e736 + _e729) + _e1543);
let _e1546 = (_e1544 >> bitcast<u32>(1i));
let _e1549 = bitcast<u32>(((_e1544 & 1i) * 16i));
let _e1551 = select(_e708, _e1546, (_e1546 < _e708));
let _e1556 = global_2.member[bitcast<u32>(select(0i, _e1551, (_e1551 > 0i)))];
let _e1560 = (_e1546 + 1i);
let _e1562 = select(_e708, _e1560, (_e1560 < _e708));
let _e1567 = global_2.member[bitcast<u32>(select(0i, _e1562, (_e1562 > 0i)))];
let _e1574 = ((_e1556 >> bitcast<u32>((_e1549 & 31u))) | ((_e1567 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1549) & 31u))));
let _e1575 = local_4.member_1[2u];
let _e1581 = f32(bitcast<i32>(((_e1574 >> bitcast<u32>((_e1575 & 31u))) & 65535u)));
let _e1582 = local_4.member_1[3u];
let _e1589 = local_5[0u];
let _e1594 = local_5[1u];
let _e1597 = (_e859 + ((_e964 - _e859) * _e1594));
let _e1598 = local_5[1u];
let _e1601 = (_e1069 + ((_e1174 - _e1069) * _e1598));
let _e1602 = local_5[1u];
let _e1605 = (_e855 + (((_e935 + ((_e942 - _e935) * _e957)) - _e855) * _e1602));
let _e1606 = local_5[1u];
let _e1611 = local_5[2u];
let _e1615 = local_5[1u];
let _e1618 = (_e863 + (((_e949 + ((f32(bitcast<i32>(((_e928 >> bitcast<u32>((_e950 & 31u))) & 65535u))) - _e949) * _e965)) - _e863) * _e1615));
let _e1619 = local_5[1u];
let _e1623 = local_5[2u];
let _e1627 = local_5[1u];
let _e1630 = (_e1235 + ((_e859 - _e1235) * _e1627));
let _e1631 = local_5[1u];
let _e1635 = local_5[2u];
let _e1639 = local_5[1u];
let _e1642 = (_e964 + (((_e1275 + ((f32(bitcast<i32>(((_e1268 >> bitcast<u32>((_e1276 & 31u))) & 65535u))) - _e1275) * _e1283)) - _e964) * _e1639));
let _e1643 = local_5[1u];
let _e1647 = local_5[2u];
let _e1651 = local_5[1u];
let _e1654 = (_e1439 + (((_e1530 + ((f32(bitcast<i32>(((_e1523 >> bitcast<u32>((_e1531 & 31u))) & 65535u))) - _e1530) * _e1538)) - _e1439) * _e1651));
let _e1655 = local_5[2u];
let _e1659 = local_5[1u];
let _e1663 = local_5[2u];
let _e1667 = local_5[2u];
let _e1674 = global_1.member.member_6.member_5;
let _e1679 = global_1.member.member_6.member_6;
let _e1680 = (((_e1597 + ((_e1601 - _e1597) * _e1667)) * _e1674) + _e1679);
let _e1682 = select(0f, _e1680, (_e1680 > 0f));
let _e1684 = select(1f, _e1682, (_e1682 < 1f));
let _e1686 = (((_e1605 + (((_e1065 + (((_e1145 + ((_e1152 - _e1145) * _e1167)) - _e1065) * _e1606)) - _e1605) * _e1611)) * _e1674) + _e1679);
let _e1688 = select(0f, _e1686, (_e1686 > 0f));
let _e1690 = select(1f, _e1688, (_e1688 < 1f));
let _e1692 = (((_e1618 + (((_e1073 + (((_e1159 + ((f32(bitcast<i32>(((_e1138 >> bitcast<u32>((_e1160 & 31u))) & 65535u))) - _e1159) * _e1175)) - _e1073) * _e1619)) - _e1618) * _e1623)) * _e1674) + _e1679);
let _e1694 = select(0f, _e1692, (_e1692 > 0f));
let _e1696 = select(1f, _e1694, (_e1694 < 1f));
let _e1698 = (((_e1630 + (((_e1337 + ((_e1069 - _e1337) * _e1631)) - _e1630) * _e1635)) * _e1674) + _e1679);
let _e1700 = select(0f, _e1698, (_e1698 > 0f));
let _e1702 = select(1f, _e1700, (_e1700 < 1f));
let _e1704 = (((_e1642 + (((_e1174 + (((_e1377 + ((f32(bitcast<i32>(((_e1370 >> bitcast<u32>((_e1378 & 31u))) & 65535u))) - _e1377) * _e1385)) - _e1174) * _e1643)) - _e1642) * _e1647)) * _e1674) + _e1679);
let _e1706 = select(0f, _e1704, (_e1704 > 0f));
let _e1708 = select(1f, _e1706, (_e1706 < 1f));
let _e1710 = (((_e1654 + ((_e1597 - _e1654) * _e1655)) * _e1674) + _e1679);
let _e1712 = select(0f, _e1710, (_e1710 > 0f));
let _e1714 = select(1f, _e1712, (_e1712 < 1f));
let _e1716 = (((_e1601 + (((_e1490 + (((_e1581 + ((f32(bitcast<i32>(((_e1574 >> bitcast<u32>((_e1582 & 31u))) & 65535u))) - _e1581) * _e1589)) - _e1490) * _e1659)) - _e1601) * _e1663)) * _e1674) + _e1679);
let _e1718 = select(0f, _e1716, (_e1716 > 0f));
let _e1720 = select(1f, _e1718, (_e1718 < 1f));
let _e1721 = (_e1684 * 1024f);
let _e1722 = (1024f - 1f);
let _e1724 = select(0f, _e1721, (_e1721 > 0f));
let _e1726 = select(_e1722, _e1724, (_e1724 < _e1722));
let _e1733 = select(0i, select(select(i32(_e1726), i32(-2147483648), (_e1726 < -2147483600f)), 2147483647i, (_e1726 > 2147483500f)), (_e1726 == _e1726));
let _e1737 = (_e1733 - select(0i, 1i, (_e1726 < f32(_e1733))));
let _e1738 = (262147i + _e1737);
let _e1740 = (bitcast<i32>(_e96) - 1i);
let _e1742 = select(_e1740, _e1738, (_e1738 < _e1740));
let _e1748 = global_4.member[bitcast<u32>(select(0i, _e1742, (_e1742 > 0i)))];
let _e1758 = select(_e1740, 262146i, (262146i < _e1740));
let _e1764 = global_4.member[bitcast<u32>(select(0i, _e1758, (_e1758 > 0i)))];
let _e1765 = bitcast<f32>(_e1764);
let _e1766 = (f32((bitcast<i32>((_e1748 & 4095u)) - 2048i)) * _e1765);
let _e1768 = select(_e1740, 262144i, (262144i < _e1740));
let _e1774 = global_4.member[bitcast<u32>(select(0i, _e1768, (_e1768 > 0i)))];
let _e1775 = bitcast<f32>(_e1774);
let _e1777 = select(_e1740, 262145i, (262145i < _e1740));
let _e1783 = global_4.member[bitcast<u32>(select(0i, _e1777, (_e1777 > 0i)))];
let _e1784 = bitcast<f32>(_e1783);
let _e1790 = ((_e1775 + (f32(bitcast<i32>((_e1748 >> bitcast<u32>(12u)))) * _e1784)) + (_e1766 * (_e1721 - f32(_e1737))));
let _e1791 = (_e1766 * 1024f);
if _e625 {
let _e1798 = ((0.5f * (_e1696 - _e1690)) * _e1791);
let _e1799 = ((0.5f * (_e1708 - _e1702)) * _e1791);
let _e1800 = ((0.5f * (_e1720 - _e1714)) * _e1791);
phi_4008_ = type_29(_e1790, vec3<f32>(_e1798, _e1799, _e1800), vec3<f32>((_e1798 * _e1790), (_e1799 * _e1790), (_e1800 * _e1790)));
} else {
let _e1807 = (_e1690 * 1024f);
let _e1809 = select(0f, _e1807, (_e1807 > 0f));
let _e1811 = select(_e1722, _e1809, (_e1809 < _e1722));
let _e1818 = select(0i, select(select(i32(_e1811), i32(-2147483648), (_e1811 < -2147483600f)), 2147483647i, (_e1811 > 2147483500f)), (_e1811 == _e1811));
let _e1822 = (_e1818 - select(0i, 1i, (_e1811 < f32(_e1818))));
let _e1823 = (262147i + _e1822);
let _e1825 = select(_e1740, _e1823, (_e1823 < _e1740));
let _e1831 = global_4.member[bitcast<u32>(select(0i, _e1825, (_e1825 > 0i)))];
let _e1846 = ((_e1775 + (f32(bitcast<i32>((_e1831 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e1831 & 4095u)) - 2048i)) * _e1765) * (_e1807 - f32(_e1822))));
let _e1847 = (_e1696 * 1024f);
let _e1849 = select(0f, _e1847, (_e1847 > 0f));
let _e1851 = select(_e1722, _e1849, (_e1849 < _e1722));
let _e1858 = select(0i, select(select(i32(_e1851), i32(-2147483648), (_e1851 < -2147483600f)), 2147483647i, (_e1851 > 2147483500f)), (_e1851 == _e1851));
let _e1862 = (_e1858 - select(0i, 1i, (_e1851 < f32(_e1858))));
let _e1863 = (262147i + _e1862);
let _e1865 = select(_e1740, _e1863, (_e1863 < _e1740));
let _e1871 = global_4.member[bitcast<u32>(select(0i, _e1865, (_e1865 > 0i)))];
let _e1886 = ((_e1775 + (f32(bitcast<i32>((_e1871 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e1871 & 4095u)) - 2048i)) * _e1765) * (_e1847 - f32(_e1862))));
let _e1887 = (_e1702 * 1024f);
let _e1889 = select(0f, _e1887, (_e1887 > 0f));
let _e1891 = select(_e1722, _e1889, (_e1889 < _e1722));
let _e1898 = select(0i, select(select(i32(_e1891), i32(-2147483648), (_e1891 < -2147483600f)), 2147483647i, (_e1891 > 2147483500f)), (_e1891 == _e1891));
let _e1902 = (_e1898 - select(0i, 1i, (_e1891 < f32(_e1898))));
let _e1903 = (262147i + _e1902);
let _e1905 = select(_e1740, _e1903, (_e1903 < _e1740));
let _e1911 = global_4.member[bitcast<u32>(select(0i, _e1905, (_e1905 > 0i)))];
let _e1926 = ((_e1775 + (f32(bitcast<i32>((_e1911 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e1911 & 4095u)) - 2048i)) * _e1765) * (_e1887 - f32(_e1902))));
let _e1927 = (_e1708 * 1024f);
let _e1929 = select(0f, _e1927, (_e1927 > 0f));
let _e1931 = select(_e1722, _e1929, (_e1929 < _e1722));
let _e1938 = select(0i, select(select(i32(_e1931), i32(-2147483648), (_e1931 < -2147483600f)), 2147483647i, (_e1931 > 2147483500f)), (_e1931 == _e1931));
let _e1942 = (_e1938 - select(0i, 1i, (_e1931 < f32(_e1938))));
let _e1943 = (262147i + _e1942);
let _e1945 = select(_e1740, _e1943, (_e1943 < _e1740));
let _e1951 = global_4.member[bitcast<u32>(select(0i, _e1945, (_e1945 > 0i)))];
let _e1966 = ((_e1775 + (f32(bitcast<i32>((_e1951 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e1951 & 4095u)) - 2048i)) * _e1765) * (_e1927 - f32(_e1942))));
let _e1967 = (_e1714 * 1024f);
let _e1969 = select(0f, _e1967, (_e1967 > 0f));
let _e1971 = select(_e1722, _e1969, (_e1969 < _e1722));
let _e1978 = select(0i, select(select(i32(_e1971), i32(-2147483648), (_e1971 < -2147483600f)), 2147483647i, (_e1971 > 2147483500f)), (_e1971 == _e1971));
let _e1982 = (_e1978 - select(0i, 1i, (_e1971 < f32(_e1978))));
let _e1983 = (262147i + _e1982);
let _e1985 = select(_e1740, _e1983, (_e1983 < _e1740));
let _e1991 = global_4.member[bitcast<u32>(select(0i, _e1985, (_e1985 > 0i)))];
let _e2006 = ((_e1775 + (f32(bitcast<i32>((_e1991 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e1991 & 4095u)) - 2048i)) * _e1765) * (_e1967 - f32(_e1982))));
let _e2007 = (_e1720 * 1024f);
let _e2009 = select(0f, _e2007, (_e2007 > 0f));
let _e2011 = select(_e1722, _e2009, (_e2009 < _e1722));
let _e2018 = select(0i, select(select(i32(_e2011), i32(-2147483648), (_e2011 < -2147483600f)), 2147483647i, (_e2011 > 2147483500f)), (_e2011 == _e2011));
let _e2022 = (_e2018 - select(0i, 1i, (_e2011 < f32(_e2018))));
let _e2023 = (262147i + _e2022);
let _e2025 = select(_e1740, _e2023, (_e2023 < _e1740));
let _e2031 = global_4.member[bitcast<u32>(select(0i, _e2025, (_e2025 > 0i)))];
let _e2046 = ((_e1775 + (f32(bitcast<i32>((_e2031 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e2031 & 4095u)) - 2048i)) * _e1765) * (_e2007 - f32(_e2022))));
let _e2047 = (_e1886 - _e1846);
let _e2049 = (_e1966 - _e1926);
let _e2051 = (_e2046 - _e2006);
phi_4008_ = type_29(_e1790, vec3<f32>((0.5f * _e2047), (0.5f * _e2049), (0.5f * _e2051)), vec3<f32>((0.25f * (_e2047 * (_e1886 + _e1846))), (0.25f * (_e2049 * (_e1966 + _e1926))), (0.25f * (_e2051 * (_e2046 + _e2006)))));
}
let _e2066 = phi_4008_;
let _e2081 = select(0f, 1f, ((((((_e431 >= -0.5f) && (_e431 <= _e453)) && (_e437 >= -0.5f)) && (_e437 <= _e463)) && (_e443 >= -0.5f)) && (_e443 <= _e473)));
let _e2083 = (0.5f * (_e1696 - _e1690));
let _e2085 = (0.5f * (_e1708 - _e1702));
let _e2087 = (0.5f * (_e1720 - _e1714));
let _e2093 = global_1.member.member_6.member.member.member;
let _e2099 = global_1.member.member_6.member.member.member_1;
let _e2105 = global_1.member.member_6.member.member.member_2;
let _e2111 = global_1.member.member_6.member_1.member.member;
let _e2117 = global_1.member.member_6.member_1.member.member_1;
let _e2123 = global_1.member.member_6.member_1.member.member_2;
let _e2129 = global_1.member.member_6.member_2.member.member;
let _e2135 = global_1.member.member_6.member_2.member.member_1;
let _e2141 = global_1.member.member_6.member_2.member.member_2;
phi_4709_ = type_30(_e1684, vec3<f32>(((((_e2093 * _e2083) + (_e2111 * _e2085)) + (_e2129 * _e2087)) * _e2081), ((((_e2099 * _e2083) + (_e2117 * _e2085)) + (_e2135 * _e2087)) * _e2081), ((((_e2105 * _e2083) + (_e2123 * _e2085)) + (_e2141 * _e2087)) * _e2081)), _e2066.member, vec3<f32>(((((_e2093 * _e2066.member_2.x) + (_e2111 * _e2066.member_2.y)) + (_e2129 * _e2066.member_2.z)) * _e2081), ((((_e2099 * _e2066.member_2.x) + (_e2117 * _e2066.member_2.y)) + (_e2135 * _e2066.member_2.z)) * _e2081), ((((_e2105 * _e2066.member_2.x) + (_e2123 * _e2066.member_2.y)) + (_e2141 * _e2066.member_2.z)) * _e2081)), vec3<f32>(((((_e2093 * _e2066.member_1.x) + (_e2111 * _e2066.member_1.y)) + (_e2129 * _e2066.member_1.z)) * _e2081), ((((_e2099 * _e2066.member_1.x) + (_e2117 * _e2066.member_1.y)) + (_e2135 * _e2066.member_1.z)) * _e2081), ((((_e2105 * _e2066.member_1.x) + (_e2123 * _e2066.member_1.y)) + (_e2141 * _e2066.member_1.z)) * _e2081)));
} else {
let _e2207 = select(-1f, _e457, (_e457 > -1f));
let _e2209 = select(_e452, _e2207, (_e2207 < _e452));
let _e2216 = select(0i, select(select(i32(_e2209), i32(-2147483648), (_e2209 < -2147483600f)), 2147483647i, (_e2209 > 2147483500f)), (_e2209 == _e2209));
let _e2220 = (_e2216 - select(0i, 1i, (_e2209 < f32(_e2216))));
let _e2222 = select(-1f, _e467, (_e467 > -1f));
let _e2224 = select(_e462, _e2222, (_e2222 < _e462));
let _e2231 = select(0i, select(select(i32(_e2224), i32(-2147483648), (_e2224 < -2147483600f)), 2147483647i, (_e2224 > 2147483500f)), (_e2224 == _e2224));
let _e2235 = (_e2231 - select(0i, 1i, (_e2224 < f32(_e2231))));
let _e2237 = select(-1f, _e477, (_e477 > -1f));
let _e2239 = select(_e472, _e2237, (_e2237 < _e472));
let _e2246 = select(0i, select(select(i32(_e2239), i32(-2147483648), (_e2239 < -2147483600f)), 2147483647i, (_e2239 > 2147483500f)), (_e2239 == _e2239));
let _e2250 = (_e2246 - select(0i, 1i, (_e2239 < f32(_e2246))));
let _e2254 = global_1.member.member_6.member_7;
let _e2258 = global_1.member.member_6.member_8;
let _e2259 = (_e2220 + 1i);
let _e2260 = (_e2235 + 1i);
let _e2261 = (_e2250 + 1i);
let _e2266 = global_1.member.member_6.member_11.member;
let _e2272 = global_1.member.member_6.member_11.member_1;
let _e2283 = ((_e2259 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2266) * ((_e2260 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2272) * (_e2261 >> bitcast<u32>(4i))))));
let _e2285 = (bitcast<i32>(_e92) - 1i);
let _e2287 = select(_e2285, _e2283, (_e2283 < _e2285));
let _e2293 = global_2.member[bitcast<u32>(select(0i, _e2287, (_e2287 > 0i)))];
let _e2295 = (_e2259 & 15i);
let _e2298 = ((_e2260 & 15i) * _e2254);
let _e2300 = (bitcast<i32>(_e2293) + ((_e2261 & 15i) * _e2258));
let _e2304 = (_e2298 + _e2254);
let _e2306 = (_e2298 + (2i * _e2254));
let _e2307 = (_e2300 + _e2258);
let _e2309 = (_e2300 + (2i * _e2258));
local_2 = type_28(array<i32, 4>(_e2295, (_e2295 + 1i), (_e2295 + 2i), (_e2295 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e457 - f32(_e2220)), (_e467 - f32(_e2235)), (_e477 - f32(_e2250)));
let _e2323 = local_2.member[1u];
let _e2324 = ((_e2307 + _e2304) + _e2323);
let _e2326 = (_e2324 >> bitcast<u32>(1i));
let _e2329 = bitcast<u32>(((_e2324 & 1i) * 16i));
let _e2331 = select(_e2285, _e2326, (_e2326 < _e2285));
let _e2336 = global_2.member[bitcast<u32>(select(0i, _e2331, (_e2331 > 0i)))];
let _e2340 = (_e2326 + 1i);
let _e2342 = select(_e2285, _e2340, (_e2340 < _e2285));
let _e2347 = global_2.member[bitcast<u32>(select(0i, _e2342, (_e2342 > 0i)))];
let _e2354 = ((_e2336 >> bitcast<u32>((_e2329 & 31u))) | ((_e2347 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2329) & 31u))));
let _e2357 = local_2.member_1[2u];
let _e2363 = f32(bitcast<i32>(((_e2354 >> bitcast<u32>((_e2357 & 31u))) & 65535u)));
let _e2366 = local_2.member_1[3u];
let _e2373 = local_3[0u];
let _e2376 = (_e2363 + ((f32(bitcast<i32>(((_e2354 >> bitcast<u32>((_e2366 & 31u))) & 65535u))) - _e2363) * _e2373));
let _e2378 = local_2.member[1u];
let _e2379 = ((_e2307 + _e2306) + _e2378);
let _e2381 = (_e2379 >> bitcast<u32>(1i));
let _e2384 = bitcast<u32>(((_e2379 & 1i) * 16i));
let _e2386 = select(_e2285, _e2381, (_e2381 < _e2285));
let _e2391 = global_2.member[bitcast<u32>(select(0i, _e2386, (_e2386 > 0i)))];
let _e2395 = (_e2381 + 1i);
let _e2397 = select(_e2285, _e2395, (_e2395 < _e2285));
let _e2402 = global_2.member[bitcast<u32>(select(0i, _e2397, (_e2397 > 0i)))];
let _e2409 = ((_e2391 >> bitcast<u32>((_e2384 & 31u))) | ((_e2402 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2384) & 31u))));
let _e2410 = local_2.member_1[2u];
let _e2416 = f32(bitcast<i32>(((_e2409 >> bitcast<u32>((_e2410 & 31u))) & 65535u)));
let _e2417 = local_2.member_1[3u];
let _e2424 = local_3[0u];
let _e2429 = local_3[1u];
let _e2432 = (_e2376 + (((_e2416 + ((f32(bitcast<i32>(((_e2409 >> bitcast<u32>((_e2417 & 31u))) & 65535u))) - _e2416) * _e2424)) - _e2376) * _e2429));
let _e2434 = local_2.member[1u];
let _e2435 = ((_e2309 + _e2304) + _e2434);
let _e2437 = (_e2435 >> bitcast<u32>(1i));
let _e2440 = bitcast<u32>(((_e2435 & 1i) * 16i));
let _e2442 = select(_e2285, _e2437, (_e2437 < _e2285));
let _e2447 = global_2.member[bitcast<u32>(select(0i, _e2442, (_e2442 > 0i)))];
let _e2451 = (_e2437 + 1i);
let _e2453 = select(_e2285, _e2451, (_e2451 < _e2285));
let _e2458 = global_2.member[bitcast<u32>(select(0i, _e2453, (_e2453 > 0i)))];
let _e2465 = ((_e2447 >> bitcast<u32>((_e2440 & 31u))) | ((_e2458 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2440) & 31u))));
let _e2466 = local_2.member_1[2u];
let _e2472 = f32(bitcast<i32>(((_e2465 >> bitcast<u32>((_e2466 & 31u))) & 65535u)));
let _e2473 = local_2.member_1[3u];
let _e2480 = local_3[0u];
let _e2483 = (_e2472 + ((f32(bitcast<i32>(((_e2465 >> bitcast<u32>((_e2473 & 31u))) & 65535u))) - _e2472) * _e2480));
let _e2485 = local_2.member[1u];
let _e2486 = ((_e2309 + _e2306) + _e2485);
let _e2488 = (_e2486 >> bitcast<u32>(1i));
let _e2491 = bitcast<u32>(((_e2486 & 1i) * 16i));
let _e2493 = select(_e2285, _e2488, (_e2488 < _e2285));
let _e2498 = global_2.member[bitcast<u32>(select(0i, _e2493, (_e2493 > 0i)))];
let _e2502 = (_e2488 + 1i);
let _e2504 = select(_e2285, _e2502, (_e2502 < _e2285));
let _e2509 = global_2.member[bitcast<u32>(select(0i, _e2504, (_e2504 > 0i)))];
let _e2516 = ((_e2498 >> bitcast<u32>((_e2491 & 31u))) | ((_e2509 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2491) & 31u))));
let _e2517 = local_2.member_1[2u];
let _e2523 = f32(bitcast<i32>(((_e2516 >> bitcast<u32>((_e2517 & 31u))) & 65535u)));
let _e2524 = local_2.member_1[3u];
let _e2531 = local_3[0u];
let _e2535 = local_3[1u];
let _e2540 = local_3[2u];
let _e2547 = global_1.member.member_6.member_5;
let _e2552 = global_1.member.member_6.member_6;
let _e2553 = (((_e2432 + (((_e2483 + (((_e2523 + ((f32(bitcast<i32>(((_e2516 >> bitcast<u32>((_e2524 & 31u))) & 65535u))) - _e2523) * _e2531)) - _e2483) * _e2535)) - _e2432) * _e2540)) * _e2547) + _e2552);
let _e2555 = select(0f, _e2553, (_e2553 > 0f));
phi_4709_ = type_30(select(1f, _e2555, (_e2555 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2560 = phi_4709_;
let _e2562 = select(-0.5f, _e395, (_e395 > -0.5f));
let _e2564 = select(_e453, _e2562, (_e2562 < _e453));
let _e2566 = select(-0.5f, _e410, (_e410 > -0.5f));
let _e2568 = select(_e463, _e2566, (_e2566 < _e463));
let _e2570 = select(-0.5f, _e425, (_e425 > -0.5f));
let _e2572 = select(_e473, _e2570, (_e2570 < _e473));
let _e2574 = select(-1f, _e2564, (_e2564 > -1f));
let _e2576 = select(_e452, _e2574, (_e2574 < _e452));
let _e2583 = select(0i, select(select(i32(_e2576), i32(-2147483648), (_e2576 < -2147483600f)), 2147483647i, (_e2576 > 2147483500f)), (_e2576 == _e2576));
let _e2587 = (_e2583 - select(0i, 1i, (_e2576 < f32(_e2583))));
let _e2589 = select(-1f, _e2568, (_e2568 > -1f));
let _e2591 = select(_e462, _e2589, (_e2589 < _e462));
let _e2598 = select(0i, select(select(i32(_e2591), i32(-2147483648), (_e2591 < -2147483600f)), 2147483647i, (_e2591 > 2147483500f)), (_e2591 == _e2591));
let _e2602 = (_e2598 - select(0i, 1i, (_e2591 < f32(_e2598))));
let _e2604 = select(-1f, _e2572, (_e2572 > -1f));
let _e2606 = select(_e472, _e2604, (_e2604 < _e472));
let _e2613 = select(0i, select(select(i32(_e2606), i32(-2147483648), (_e2606 < -2147483600f)), 2147483647i, (_e2606 > 2147483500f)), (_e2606 == _e2606));
let _e2617 = (_e2613 - select(0i, 1i, (_e2606 < f32(_e2613))));
let _e2621 = global_1.member.member_6.member_7;
let _e2625 = global_1.member.member_6.member_8;
let _e2626 = (_e2587 + 1i);
let _e2627 = (_e2602 + 1i);
let _e2628 = (_e2617 + 1i);
let _e2633 = global_1.member.member_6.member_11.member;
let _e2639 = global_1.member.member_6.member_11.member_1;
let _e2650 = ((_e2626 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2633) * ((_e2627 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2639) * (_e2628 >> bitcast<u32>(4i))))));
let _e2652 = (bitcast<i32>(_e92) - 1i);
let _e2654 = select(_e2652, _e2650, (_e2650 < _e2652));
let _e2660 = global_2.member[bitcast<u32>(select(0i, _e2654, (_e2654 > 0i)))];
let _e2662 = (_e2626 & 15i);
let _e2665 = ((_e2627 & 15i) * _e2621);
let _e2667 = (bitcast<i32>(_e2660) + ((_e2628 & 15i) * _e2625));
let _e2671 = (_e2665 + _e2621);
let _e2673 = (_e2665 + (2i * _e2621));
let _e2674 = (_e2667 + _e2625);
let _e2676 = (_e2667 + (2i * _e2625));
local = type_28(array<i32, 4>(_e2662, (_e2662 + 1i), (_e2662 + 2i), (_e2662 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2564 - f32(_e2587)), (_e2568 - f32(_e2602)), (_e2572 - f32(_e2617)));
let _e2690 = local.member[1u];
let _e2691 = ((_e2674 + _e2671) + _e2690);
let _e2693 = (_e2691 >> bitcast<u32>(1i));
let _e2696 = bitcast<u32>(((_e2691 & 1i) * 16i));
let _e2698 = select(_e2652, _e2693, (_e2693 < _e2652));
let _e2703 = global_2.member[bitcast<u32>(select(0i, _e2698, (_e2698 > 0i)))];
let _e2707 = (_e2693 + 1i);
let _e2709 = select(_e2652, _e2707, (_e2707 < _e2652));
let _e2714 = global_2.member[bitcast<u32>(select(0i, _e2709, (_e2709 > 0i)))];
let _e2721 = ((_e2703 >> bitcast<u32>((_e2696 & 31u))) | ((_e2714 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2696) & 31u))));
let _e2724 = local.member_1[2u];
let _e2730 = f32(bitcast<i32>(((_e2721 >> bitcast<u32>((_e2724 & 31u))) & 65535u)));
let _e2733 = local.member_1[3u];
let _e2740 = local_1[0u];
let _e2743 = (_e2730 + ((f32(bitcast<i32>(((_e2721 >> bitcast<u32>((_e2733 & 31u))) & 65535u))) - _e2730) * _e2740));
let _e2745 = local.member[1u];
let _e2746 = ((_e2674 + _e2673) + _e2745);
let _e2748 = (_e2746 >> bitcast<u32>(1i));
let _e2751 = bitcast<u32>(((_e2746 & 1i) * 16i));
let _e2753 = select(_e2652, _e2748, (_e2748 < _e2652));
let _e2758 = global_2.member[bitcast<u32>(select(0i, _e2753, (_e2753 > 0i)))];
let _e2762 = (_e2748 + 1i);
let _e2764 = select(_e2652, _e2762, (_e2762 < _e2652));
let _e2769 = global_2.member[bitcast<u32>(select(0i, _e2764, (_e2764 > 0i)))];
let _e2776 = ((_e2758 >> bitcast<u32>((_e2751 & 31u))) | ((_e2769 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2751) & 31u))));
let _e2777 = local.member_1[2u];
let _e2783 = f32(bitcast<i32>(((_e2776 >> bitcast<u32>((_e2777 & 31u))) & 65535u)));
let _e2784 = local.member_1[3u];
let _e2791 = local_1[0u];
let _e2796 = local_1[1u];
let _e2799 = (_e2743 + (((_e2783 + ((f32(bitcast<i32>(((_e2776 >> bitcast<u32>((_e2784 & 31u))) & 65535u))) - _e2783) * _e2791)) - _e2743) * _e2796));
let _e2801 = local.member[1u];
let _e2802 = ((_e2676 + _e2671) + _e2801);
let _e2804 = (_e2802 >> bitcast<u32>(1i));
let _e2807 = bitcast<u32>(((_e2802 & 1i) * 16i));
let _e2809 = select(_e2652, _e2804, (_e2804 < _e2652));
let _e2814 = global_2.member[bitcast<u32>(select(0i, _e2809, (_e2809 > 0i)))];
let _e2818 = (_e2804 + 1i);
let _e2820 = select(_e2652, _e2818, (_e2818 < _e2652));
let _e2825 = global_2.member[bitcast<u32>(select(0i, _e2820, (_e2820 > 0i)))];
let _e2832 = ((_e2814 >> bitcast<u32>((_e2807 & 31u))) | ((_e2825 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2807) & 31u))));
let _e2833 = local.member_1[2u];
let _e2839 = f32(bitcast<i32>(((_e2832 >> bitcast<u32>((_e2833 & 31u))) & 65535u)));
let _e2840 = local.member_1[3u];
let _e2847 = local_1[0u];
let _e2850 = (_e2839 + ((f32(bitcast<i32>(((_e2832 >> bitcast<u32>((_e2840 & 31u))) & 65535u))) - _e2839) * _e2847));
let _e2852 = local.member[1u];
let _e2853 = ((_e2676 + _e2673) + _e2852);
let _e2855 = (_e2853 >> bitcast<u32>(1i));
let _e2858 = bitcast<u32>(((_e2853 & 1i) * 16i));
let _e2860 = select(_e2652, _e2855, (_e2855 < _e2652));
let _e2865 = global_2.member[bitcast<u32>(select(0i, _e2860, (_e2860 > 0i)))];
let _e2869 = (_e2855 + 1i);
let _e2871 = select(_e2652, _e2869, (_e2869 < _e2652));
let _e2876 = global_2.member[bitcast<u32>(select(0i, _e2871, (_e2871 > 0i)))];
let _e2883 = ((_e2865 >> bitcast<u32>((_e2858 & 31u))) | ((_e2876 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2858) & 31u))));
let _e2884 = local.member_1[2u];
let _e2890 = f32(bitcast<i32>(((_e2883 >> bitcast<u32>((_e2884 & 31u))) & 65535u)));
let _e2891 = local.member_1[3u];
let _e2898 = local_1[0u];
let _e2902 = local_1[1u];
let _e2907 = local_1[2u];
let _e2914 = global_1.member.member_6.member_5;
let _e2919 = global_1.member.member_6.member_6;
let _e2920 = (((_e2799 + (((_e2850 + (((_e2890 + ((f32(bitcast<i32>(((_e2883 >> bitcast<u32>((_e2891 & 31u))) & 65535u))) - _e2890) * _e2898)) - _e2850) * _e2902)) - _e2799) * _e2907)) * _e2914) + _e2919);
let _e2922 = select(0f, _e2920, (_e2920 > 0f));
if ((_e611 & 16u) == 0u) {
phi_5633_ = type_5(1f, 1f, 1f);
} else {
let _e2930 = global_1.member.member_14.member;
let _e2941 = ((((_e2930.member.member * _e306) + (_e2930.member.member_1 * _e315)) + (_e2930.member.member_2 * _e288)) + _e2930.member_1);
let _e2947 = ((((_e2930.member.member * _e327) + (_e2930.member.member_1 * _e332)) + (_e2930.member.member_2 * _e321)) + _e2930.member_1);
let _e2949 = select(_e2947, _e2941, (_e2941 < _e2947));
let _e2951 = select(_e2947, _e2941, (_e2941 > _e2947));
let _e2953 = (_e2951 - _e2949);
let _e2956 = (-(_e2949) / select(1e-30f, _e2953, (_e2953 > 1e-30f)));
let _e2958 = select(0f, _e2956, (_e2956 > 0f));
let _e2964 = select(select(select(1f, _e2958, (_e2958 < 1f)), 1f, (_e2951 <= 0f)), 0f, (_e2949 > 0f));
let _e2969 = global_1.member.member_14.member_1;
let _e2970 = (_e2969 != 0u);
let _e2980 = global_1.member.member_15.member;
let _e2991 = ((((_e2980.member.member * _e306) + (_e2980.member.member_1 * _e315)) + (_e2980.member.member_2 * _e288)) + _e2980.member_1);
let _e2997 = ((((_e2980.member.member * _e327) + (_e2980.member.member_1 * _e332)) + (_e2980.member.member_2 * _e321)) + _e2980.member_1);
let _e2999 = select(_e2997, _e2991, (_e2991 < _e2997));
let _e3001 = select(_e2997, _e2991, (_e2991 > _e2997));
let _e3003 = (_e3001 - _e2999);
let _e3006 = (-(_e2999) / select(1e-30f, _e3003, (_e3003 > 1e-30f)));
let _e3008 = select(0f, _e3006, (_e3006 > 0f));
let _e3014 = select(select(select(1f, _e3008, (_e3008 < 1f)), 1f, (_e3001 <= 0f)), 0f, (_e2999 > 0f));
let _e3019 = global_1.member.member_15.member_1;
let _e3020 = (_e3019 != 0u);
let _e3030 = global_1.member.member_16.member;
let _e3041 = ((((_e3030.member.member * _e306) + (_e3030.member.member_1 * _e315)) + (_e3030.member.member_2 * _e288)) + _e3030.member_1);
let _e3047 = ((((_e3030.member.member * _e327) + (_e3030.member.member_1 * _e332)) + (_e3030.member.member_2 * _e321)) + _e3030.member_1);
let _e3049 = select(_e3047, _e3041, (_e3041 < _e3047));
let _e3051 = select(_e3047, _e3041, (_e3041 > _e3047));
let _e3053 = (_e3051 - _e3049);
let _e3056 = (-(_e3049) / select(1e-30f, _e3053, (_e3053 > 1e-30f)));
let _e3058 = select(0f, _e3056, (_e3056 > 0f));
let _e3064 = select(select(select(1f, _e3058, (_e3058 < 1f)), 1f, (_e3051 <= 0f)), 0f, (_e3049 > 0f));
let _e3069 = global_1.member.member_16.member_1;
let _e3070 = (_e3069 != 0u);
let _e3080 = global_1.member.member_17.member;
let _e3091 = ((((_e3080.member.member * _e306) + (_e3080.member.member_1 * _e315)) + (_e3080.member.member_2 * _e288)) + _e3080.member_1);
let _e3097 = ((((_e3080.member.member * _e327) + (_e3080.member.member_1 * _e332)) + (_e3080.member.member_2 * _e321)) + _e3080.member_1);
let _e3099 = select(_e3097, _e3091, (_e3091 < _e3097));
let _e3101 = select(_e3097, _e3091, (_e3091 > _e3097));
let _e3103 = (_e3101 - _e3099);
let _e3106 = (-(_e3099) / select(1e-30f, _e3103, (_e3103 > 1e-30f)));
let _e3108 = select(0f, _e3106, (_e3106 > 0f));
let _e3114 = select(select(select(1f, _e3108, (_e3108 < 1f)), 1f, (_e3101 <= 0f)), 0f, (_e3099 > 0f));
let _e3119 = global_1.member.member_17.member_1;
let _e3120 = (_e3119 != 0u);
phi_5633_ = type_5(((((1f * _e2964) * _e3014) * _e3064) * _e3114), ((((1f * select(1f, _e2964, _e2970)) * select(1f, _e3014, _e3020)) * select(1f, _e3064, _e3070)) * select(1f, _e3114, _e3120)), ((((1f * select(1f, 0f, (_e2970 && (_e2947 > 0f)))) * select(1f, 0f, (_e3020 && (_e2997 > 0f)))) * select(1f, 0f, (_e3070 && (_e3047 > 0f)))) * select(1f, 0f, (_e3120 && (_e3097 > 0f)))));
}
let _e3129 = phi_5633_;
let _e3130 = (_e327 - _e306);
let _e3131 = (_e332 - _e315);
let _e3132 = (_e321 - _e288);
let _e3137 = (((_e3130 * _e3130) + (_e3131 * _e3131)) + (_e3132 * _e3132));
let _e3141 = (_e483 < 1e-12f);
let _e3143 = (1f / select(_e478, 1f, _e3141));
let _e3145 = ((-0.5f - _e395) * _e3143);
let _e3147 = ((_e453 - _e395) * _e3143);
let _e3153 = select(_e3147, _e3145, (_e3145 < _e3147));
let _e3155 = select(0f, _e3153, (_e3153 > 0f));
let _e3158 = select(select(1f, _e3155, (_e3155 < 1f)), select(2f, 0f, ((_e395 >= -0.5f) && (_e395 <= _e453))), _e3141);
let _e3160 = select(_e3147, _e3145, (_e3145 > _e3147));
let _e3162 = select(0f, _e3160, (_e3160 > 0f));
let _e3165 = select(select(1f, _e3162, (_e3162 < 1f)), 1f, _e3141);
let _e3166 = (_e486 < 1e-12f);
let _e3168 = (1f / select(_e479, 1f, _e3166));
let _e3170 = ((-0.5f - _e410) * _e3168);
let _e3172 = ((_e463 - _e410) * _e3168);
let _e3178 = select(_e3172, _e3170, (_e3170 < _e3172));
let _e3180 = select(0f, _e3178, (_e3178 > 0f));
let _e3183 = select(select(1f, _e3180, (_e3180 < 1f)), select(2f, 0f, ((_e410 >= -0.5f) && (_e410 <= _e463))), _e3166);
let _e3185 = select(_e3172, _e3170, (_e3170 > _e3172));
let _e3187 = select(0f, _e3185, (_e3185 > 0f));
let _e3190 = select(select(1f, _e3187, (_e3187 < 1f)), 1f, _e3166);
let _e3191 = (_e491 < 1e-12f);
let _e3193 = (1f / select(_e480, 1f, _e3191));
let _e3195 = ((-0.5f - _e425) * _e3193);
let _e3197 = ((_e473 - _e425) * _e3193);
let _e3203 = select(_e3197, _e3195, (_e3195 < _e3197));
let _e3205 = select(0f, _e3203, (_e3203 > 0f));
let _e3208 = select(select(1f, _e3205, (_e3205 < 1f)), select(2f, 0f, ((_e425 >= -0.5f) && (_e425 <= _e473))), _e3191);
let _e3210 = select(_e3197, _e3195, (_e3195 > _e3197));
let _e3212 = select(0f, _e3210, (_e3210 > 0f));
let _e3215 = select(select(1f, _e3212, (_e3212 < 1f)), 1f, _e3191);
let _e3217 = select(_e3190, _e3165, (_e3165 < _e3190));
let _e3221 = select(_e3183, _e3158, (_e3158 > _e3183));
let _e3224 = (select(_e3215, _e3217, (_e3217 < _e3215)) - select(_e3208, _e3221, (_e3221 > _e3208)));
let _e3231 = global_1.member.member_5.member_3;
let _e3232 = ((sqrt(select(0f, _e3137, (_e3137 > 0f))) * select(0f, _e3224, (_e3224 > 0f))) * _e3231);
let _e3234 = (select(1f, _e2922, (_e2922 < 1f)) * 255f);
let _e3235 = (_e2560.member * 255f);
let _e3236 = (255f - 1f);
let _e3238 = select(0f, _e3234, (_e3234 > 0f));
let _e3240 = select(_e3236, _e3238, (_e3238 < _e3236));
let _e3247 = select(0i, select(select(i32(_e3240), i32(-2147483648), (_e3240 < -2147483600f)), 2147483647i, (_e3240 > 2147483500f)), (_e3240 == _e3240));
let _e3251 = (_e3247 - select(0i, 1i, (_e3240 < f32(_e3247))));
let _e3253 = select(0f, _e3235, (_e3235 > 0f));
let _e3255 = select(_e3236, _e3253, (_e3253 < _e3236));
let _e3262 = select(0i, select(select(i32(_e3255), i32(-2147483648), (_e3255 < -2147483600f)), 2147483647i, (_e3255 > 2147483500f)), (_e3255 == _e3255));
let _e3266 = (_e3262 - select(0i, 1i, (_e3255 < f32(_e3262))));
let _e3269 = (((_e3251 * 256i) + _e3266) * 4i);
let _e3271 = (_e3234 - f32(_e3251));
let _e3273 = (_e3235 - f32(_e3266));
let _e3275 = (bitcast<i32>(_e96) - 1i);
let _e3277 = select(_e3275, _e3269, (_e3269 < _e3275));
let _e3283 = global_4.member[bitcast<u32>(select(0i, _e3277, (_e3277 > 0i)))];
let _e3284 = (_e3269 + 4i);
let _e3286 = select(_e3275, _e3284, (_e3284 < _e3275));
let _e3292 = global_4.member[bitcast<u32>(select(0i, _e3286, (_e3286 > 0i)))];
let _e3293 = (_e3269 + 1024i);
let _e3295 = select(_e3275, _e3293, (_e3293 < _e3275));
let _e3301 = global_4.member[bitcast<u32>(select(0i, _e3295, (_e3295 > 0i)))];
let _e3302 = (_e3269 + 1028i);
let _e3304 = select(_e3275, _e3302, (_e3302 < _e3275));
let _e3310 = global_4.member[bitcast<u32>(select(0i, _e3304, (_e3304 > 0i)))];
let _e3315 = (bitcast<f32>(((_e3283 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3323 = (_e3315 + (((bitcast<f32>(((_e3292 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3315) * _e3273));
let _e3328 = (bitcast<f32>(((_e3301 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3352 = (bitcast<f32>((((_e3283 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3360 = (_e3352 + (((bitcast<f32>((((_e3292 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3352) * _e3273));
let _e3365 = (bitcast<f32>((((_e3301 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3377 = (_e3269 + 1i);
let _e3379 = select(_e3275, _e3377, (_e3377 < _e3275));
let _e3385 = global_4.member[bitcast<u32>(select(0i, _e3379, (_e3379 > 0i)))];
let _e3386 = (_e3269 + 5i);
let _e3388 = select(_e3275, _e3386, (_e3386 < _e3275));
let _e3394 = global_4.member[bitcast<u32>(select(0i, _e3388, (_e3388 > 0i)))];
let _e3395 = (_e3269 + 1025i);
let _e3397 = select(_e3275, _e3395, (_e3395 < _e3275));
let _e3403 = global_4.member[bitcast<u32>(select(0i, _e3397, (_e3397 > 0i)))];
let _e3404 = (_e3269 + 1029i);
let _e3406 = select(_e3275, _e3404, (_e3404 < _e3275));
let _e3412 = global_4.member[bitcast<u32>(select(0i, _e3406, (_e3406 > 0i)))];
let _e3417 = (bitcast<f32>(((_e3385 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3425 = (_e3417 + (((bitcast<f32>(((_e3394 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3417) * _e3273));
let _e3430 = (bitcast<f32>(((_e3403 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3454 = (bitcast<f32>((((_e3385 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3462 = (_e3454 + (((bitcast<f32>((((_e3394 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3454) * _e3273));
let _e3467 = (bitcast<f32>((((_e3403 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3482 = (_e3232 * _e3129.member_1);
let _e3484 = -(((_e3360 + (((_e3365 + (((bitcast<f32>((((_e3310 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3365) * _e3273)) - _e3360) * _e3271)) * _e3482));
let _e3486 = select(-87f, _e3484, (_e3484 > -87f));
let _e3488 = select(88f, _e3486, (_e3486 < 88f));
let _e3490 = ((_e3488 * 1.442695f) + 0.5f);
let _e3492 = select(-127f, _e3490, (_e3490 > -127f));
let _e3494 = select(128f, _e3492, (_e3492 < 128f));
let _e3501 = select(0i, select(select(i32(_e3494), i32(-2147483648), (_e3494 < -2147483600f)), 2147483647i, (_e3494 > 2147483500f)), (_e3494 == _e3494));
let _e3505 = (_e3501 - select(0i, 1i, (_e3494 < f32(_e3501))));
let _e3506 = f32(_e3505);
let _e3510 = ((_e3488 - (_e3506 * 0.6933594f)) - (_e3506 * -2.1219444e-4f));
let _e3532 = -(((_e3425 + (((_e3430 + (((bitcast<f32>(((_e3412 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3430) * _e3273)) - _e3425) * _e3271)) * _e3482));
let _e3534 = select(-87f, _e3532, (_e3532 > -87f));
let _e3536 = select(88f, _e3534, (_e3534 < 88f));
let _e3538 = ((_e3536 * 1.442695f) + 0.5f);
let _e3540 = select(-127f, _e3538, (_e3538 > -127f));
let _e3542 = select(128f, _e3540, (_e3540 < 128f));
let _e3549 = select(0i, select(select(i32(_e3542), i32(-2147483648), (_e3542 < -2147483600f)), 2147483647i, (_e3542 > 2147483500f)), (_e3542 == _e3542));
let _e3553 = (_e3549 - select(0i, 1i, (_e3542 < f32(_e3549))));
let _e3554 = f32(_e3553);
let _e3558 = ((_e3536 - (_e3554 * 0.6933594f)) - (_e3554 * -2.1219444e-4f));
let _e3580 = -(((_e3462 + (((_e3467 + (((bitcast<f32>((((_e3412 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3467) * _e3273)) - _e3462) * _e3271)) * _e3482));
let _e3582 = select(-87f, _e3580, (_e3580 > -87f));
let _e3584 = select(88f, _e3582, (_e3582 < 88f));
let _e3586 = ((_e3584 * 1.442695f) + 0.5f);
let _e3588 = select(-127f, _e3586, (_e3586 > -127f));
let _e3590 = select(128f, _e3588, (_e3588 < 128f));
let _e3597 = select(0i, select(select(i32(_e3590), i32(-2147483648), (_e3590 < -2147483600f)), 2147483647i, (_e3590 > 2147483500f)), (_e3590 == _e3590));
let _e3601 = (_e3597 - select(0i, 1i, (_e3590 < f32(_e3597))));
let _e3602 = f32(_e3601);
let _e3606 = ((_e3584 - (_e3602 * 0.6933594f)) - (_e3602 * -2.1219444e-4f));
let _e3628 = -(((_e3323 + (((_e3328 + (((bitcast<f32>(((_e3310 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3328) * _e3273)) - _e3323) * _e3271)) * (_e3232 * _e3129.member)));
let _e3630 = select(-87f, _e3628, (_e3628 > -87f));
let _e3632 = select(88f, _e3630, (_e3630 < 88f));
let _e3634 = ((_e3632 * 1.442695f) + 0.5f);
let _e3636 = select(-127f, _e3634, (_e3634 > -127f));
let _e3638 = select(128f, _e3636, (_e3636 < 128f));
let _e3645 = select(0i, select(select(i32(_e3638), i32(-2147483648), (_e3638 < -2147483600f)), 2147483647i, (_e3638 > 2147483500f)), (_e3638 == _e3638));
let _e3649 = (_e3645 - select(0i, 1i, (_e3638 < f32(_e3645))));
let _e3650 = f32(_e3649);
let _e3654 = ((_e3632 - (_e3650 * 0.6933594f)) - (_e3650 * -2.1219444e-4f));
let _e3674 = ((1f + (_e3654 * (1f + (_e3654 * (0.5f + (_e3654 * (0.16666667f + (_e3654 * (0.041666668f + (_e3654 * (0.008333334f + (_e3654 * (0.001388889f + (_e3654 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3649 + 127i)) << bitcast<u32>(23i))));
if _e628 {
let _e3689 = global_1.member.member_5.member_4;
let _e3692 = (_e2560.member_3.x * _e3129.member_2);
let _e3694 = (_e2560.member_3.y * _e3129.member_2);
let _e3696 = (_e2560.member_3.z * _e3129.member_2);
let _e3697 = (0.5f * (_e245 / _e197));
let _e3701 = (_e175 + (_e3692 * _e3697));
let _e3702 = (_e186 + (_e3694 * _e3697));
let _e3703 = (_e197 + (_e3696 * _e3697));
let _e3705 = (2f * _e245);
let _e3707 = ((_e3703 * _e3703) + (_e3705 * _e3696));
let _e3711 = (_e3703 + sqrt(select(0f, _e3707, (_e3707 > 0f))));
let _e3715 = (0.5f * (_e3705 / select(1e-6f, _e3711, (_e3711 > 1e-6f))));
let _e3719 = (_e3701 + (_e3692 * _e3715));
let _e3720 = (_e3702 + (_e3694 * _e3715));
let _e3721 = (_e3703 + (_e3696 * _e3715));
let _e3725 = (_e3689 * _e3689);
let _e3727 = (_e3721 * _e3721);
let _e3735 = (((_e3703 <= 0f) || (_e3707 <= 0f)) || ((_e3721 <= 0f) || (_e3727 <= (_e3725 * (((_e3719 * _e3719) + (_e3720 * _e3720)) + _e3727)))));
let _e3749 = (_e175 + ((_e2560.member_4.x * _e3129.member_2) * _e245));
let _e3750 = (_e186 + ((_e2560.member_4.y * _e3129.member_2) * _e245));
let _e3751 = (_e197 + ((_e2560.member_4.z * _e3129.member_2) * _e245));
let _e3753 = (_e3751 * _e3751);
let _e3762 = ((_e611 & 1u) != 0u);
phi_6657_ = select(select(select(_e3721, _e3703, _e3735), _e3751, _e3762), _e197, _e618);
phi_6658_ = select(select(select(_e3720, _e3702, _e3735), _e3750, _e3762), _e186, _e618);
phi_6659_ = select(select(select(_e3719, _e3701, _e3735), _e3749, _e3762), _e175, _e618);
phi_6660_ = (select(_e3735, ((_e3751 <= 0f) || (_e3753 <= (_e3725 * (((_e3749 * _e3749) + (_e3750 * _e3750)) + _e3753)))), _e3762) && !(_e618));
} else {
phi_6657_ = _e197;
phi_6658_ = _e186;
phi_6659_ = _e175;
phi_6660_ = false;
}
let _e3773 = phi_6657_;
let _e3775 = phi_6658_;
let _e3777 = phi_6659_;
let _e3779 = phi_6660_;
global_6.member[_e121] = (_e132 + _e260);
global_6.member[_e133] = (_e142 + _e267);
global_6.member[_e144] = (_e153 + _e369);
global_6.member[_e155] = (_e164 + _e372);
global_6.member[_e166] = _e3777;
global_6.member[_e177] = _e3775;
global_6.member[_e188] = _e3773;
global_6.member[_e199] = select((_e208 * (((1f + (_e3510 * (1f + (_e3510 * (0.5f + (_e3510 * (0.16666667f + (_e3510 * (0.041666668f + (_e3510 * (0.008333334f + (_e3510 * (0.001388889f + (_e3510 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3505 + 127i)) << bitcast<u32>(23i)))) * _e3674)), _e208, _e618);
global_6.member[_e210] = select((_e219 * (((1f + (_e3558 * (1f + (_e3558 * (0.5f + (_e3558 * (0.16666667f + (_e3558 * (0.041666668f + (_e3558 * (0.008333334f + (_e3558 * (0.001388889f + (_e3558 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3553 + 127i)) << bitcast<u32>(23i)))) * _e3674)), _e219, _e618);
global_6.member[_e221] = select((_e230 * (((1f + (_e3606 * (1f + (_e3606 * (0.5f + (_e3606 * (0.16666667f + (_e3606 * (0.041666668f + (_e3606 * (0.008333334f + (_e3606 * (0.001388889f + (_e3606 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3601 + 127i)) << bitcast<u32>(23i)))) * _e3674)), _e230, _e618);
global_6.member[_e232] = select(_e241, 1f, _e3779);
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
