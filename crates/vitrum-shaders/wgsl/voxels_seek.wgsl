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
member_17: type_9,
member_18: type_11,
member_19: type_5,
member_20: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_19 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: i32,
member_13: i32,
member_14: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(2)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage, read_write> global_4: type_16;
fn function_() {
var phi_614_: u32;
var phi_669_: type_19;
var phi_672_: i32;
var phi_1636_: type_19;
var phi_1638_: type_19;
var phi_967_: i32;
var phi_1334_: type_19;
var phi_1335_: type_19;
var phi_1639_: type_19;
var phi_670_: type_19;
var phi_673_: i32;
var local: type_19;
var local_1: type_19;
var local_2: type_19;
var local_3: type_19;
var local_4: type_19;
var local_5: type_19;
var local_6: type_19;
var local_7: type_19;
var local_8: type_19;
var local_9: type_19;
var local_10: type_19;
var local_11: type_19;
var local_12: type_19;
var local_13: type_19;
var local_14: type_19;
var local_15: type_19;
var local_16: type_19;
var local_17: type_19;
var local_18: type_19;
var local_19: type_19;
var local_20: type_19;
var local_21: type_19;
var local_22: type_19;
var local_23: type_19;
var local_24: f32;
let _e58 = global;
let _e67 = global_1.member.member;
if (_e58.x < _e67.member) {
if (_e58.y < _e67.member_1) {
let _e74 = (_e67.member * _e67.member_1);
let _e76 = ((_e58.y * _e67.member) + _e58.x);
let _e77 = bitcast<i32>(_e76);
let _e79 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e81 = select(_e79, _e77, (_e77 < _e79));
let _e87 = global_4.member[bitcast<u32>(select(0i, _e81, (_e81 > 0i)))];
let _e88 = (_e74 + _e76);
let _e89 = bitcast<i32>(_e88);
let _e91 = select(_e79, _e89, (_e89 < _e79));
let _e97 = global_4.member[bitcast<u32>(select(0i, _e91, (_e91 > 0i)))];
let _e99 = ((2u * _e74) + _e76);
let _e100 = bitcast<i32>(_e99);
let _e102 = select(_e79, _e100, (_e100 < _e79));
let _e108 = global_4.member[bitcast<u32>(select(0i, _e102, (_e102 > 0i)))];
let _e110 = ((3u * _e74) + _e76);
let _e111 = bitcast<i32>(_e110);
let _e113 = select(_e79, _e111, (_e111 < _e79));
let _e119 = global_4.member[bitcast<u32>(select(0i, _e113, (_e113 > 0i)))];
let _e121 = ((4u * _e74) + _e76);
let _e122 = bitcast<i32>(_e121);
let _e124 = select(_e79, _e122, (_e122 < _e79));
let _e130 = global_4.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e132 = ((5u * _e74) + _e76);
let _e133 = bitcast<i32>(_e132);
let _e135 = select(_e79, _e133, (_e133 < _e79));
let _e141 = global_4.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
let _e143 = ((6u * _e74) + _e76);
let _e144 = bitcast<i32>(_e143);
let _e146 = select(_e79, _e144, (_e144 < _e79));
let _e152 = global_4.member[bitcast<u32>(select(0i, _e146, (_e146 > 0i)))];
let _e154 = ((7u * _e74) + _e76);
let _e155 = bitcast<i32>(_e154);
let _e157 = select(_e79, _e155, (_e155 < _e79));
let _e163 = global_4.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e165 = ((8u * _e74) + _e76);
let _e166 = bitcast<i32>(_e165);
let _e168 = select(_e79, _e166, (_e166 < _e79));
let _e174 = global_4.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e176 = ((9u * _e74) + _e76);
let _e177 = bitcast<i32>(_e176);
let _e179 = select(_e79, _e177, (_e177 < _e79));
let _e185 = global_4.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e187 = ((10u * _e74) + _e76);
let _e188 = bitcast<i32>(_e187);
let _e190 = select(_e79, _e188, (_e188 < _e79));
let _e196 = global_4.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e198 = ((11u * _e74) + _e76);
let _e199 = bitcast<i32>(_e198);
let _e201 = select(_e79, _e199, (_e199 < _e79));
let _e207 = global_4.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e209 = ((12u * _e74) + _e76);
let _e210 = bitcast<i32>(_e209);
let _e212 = select(_e79, _e210, (_e210 < _e79));
let _e218 = global_4.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e220 = ((13u * _e74) + _e76);
let _e221 = bitcast<i32>(_e220);
let _e223 = select(_e79, _e221, (_e221 < _e79));
let _e229 = global_4.member[bitcast<u32>(select(0i, _e223, (_e223 > 0i)))];
let _e231 = ((14u * _e74) + _e76);
let _e232 = bitcast<i32>(_e231);
let _e234 = select(_e79, _e232, (_e232 < _e79));
let _e240 = global_4.member[bitcast<u32>(select(0i, _e234, (_e234 > 0i)))];
let _e242 = ((15u * _e74) + _e76);
let _e243 = bitcast<i32>(_e242);
let _e245 = select(_e79, _e243, (_e243 < _e79));
let _e251 = global_4.member[bitcast<u32>(select(0i, _e245, (_e245 > 0i)))];
let _e253 = ((16u * _e74) + _e76);
let _e254 = bitcast<i32>(_e253);
let _e256 = select(_e79, _e254, (_e254 < _e79));
let _e262 = global_4.member[bitcast<u32>(select(0i, _e256, (_e256 > 0i)))];
let _e264 = ((17u * _e74) + _e76);
let _e265 = bitcast<i32>(_e264);
let _e267 = select(_e79, _e265, (_e265 < _e79));
let _e273 = global_4.member[bitcast<u32>(select(0i, _e267, (_e267 > 0i)))];
let _e275 = ((18u * _e74) + _e76);
let _e276 = bitcast<i32>(_e275);
let _e278 = select(_e79, _e276, (_e276 < _e79));
let _e284 = global_4.member[bitcast<u32>(select(0i, _e278, (_e278 > 0i)))];
let _e286 = ((19u * _e74) + _e76);
let _e287 = bitcast<i32>(_e286);
let _e289 = select(_e79, _e287, (_e287 < _e79));
let _e295 = global_4.member[bitcast<u32>(select(0i, _e289, (_e289 > 0i)))];
let _e297 = ((20u * _e74) + _e76);
let _e298 = bitcast<i32>(_e297);
let _e300 = select(_e79, _e298, (_e298 < _e79));
let _e306 = global_4.member[bitcast<u32>(select(0i, _e300, (_e300 > 0i)))];
let _e308 = ((21u * _e74) + _e76);
let _e309 = bitcast<i32>(_e308);
let _e311 = select(_e79, _e309, (_e309 < _e79));
let _e317 = global_4.member[bitcast<u32>(select(0i, _e311, (_e311 > 0i)))];
let _e319 = ((22u * _e74) + _e76);
let _e320 = bitcast<i32>(_e319);
let _e322 = select(_e79, _e320, (_e320 < _e79));
let _e328 = global_4.member[bitcast<u32>(select(0i, _e322, (_e322 > 0i)))];
let _e330 = ((23u * _e74) + _e76);
let _e331 = bitcast<i32>(_e330);
let _e333 = select(_e79, _e331, (_e331 < _e79));
let _e339 = global_4.member[bitcast<u32>(select(0i, _e333, (_e333 > 0i)))];
let _e341 = ((24u * _e74) + _e76);
let _e342 = bitcast<i32>(_e341);
let _e344 = select(_e79, _e342, (_e342 < _e79));
let _e350 = global_4.member[bitcast<u32>(select(0i, _e344, (_e344 > 0i)))];
if (_e262 == 4f) {
phi_614_ = 3u;
} else {
phi_614_ = select(0u, 1u, (_e262 == 0f));
}
let _e355 = phi_614_;
if (_e355 > 1u) {
let _e385 = bitcast<i32>(arrayLength((&global_2.member)));
phi_669_ = type_19(vec3<f32>(_e87, _e97, _e108), vec3<f32>(_e119, _e130, _e141), vec3<f32>(_e152, _e163, _e174), vec3<f32>(_e185, _e196, _e207), vec3<f32>(_e218, _e229, _e240), _e251, _e262, select(0i, select(select(i32(_e273), i32(-2147483648), (_e273 < -2147483600f)), 2147483647i, (_e273 > 2147483500f)), (_e273 == _e273)), _e284, _e295, _e306, _e317, select(0i, select(select(i32(_e328), i32(-2147483648), (_e328 < -2147483600f)), 2147483647i, (_e328 > 2147483500f)), (_e328 == _e328)), select(0i, select(select(i32(_e339), i32(-2147483648), (_e339 < -2147483600f)), 2147483647i, (_e339 > 2147483500f)), (_e339 == _e339)), _e350);
phi_672_ = 0i;
loop {
let _e388 = phi_669_;
let _e390 = phi_672_;
local = _e388;
local_1 = _e388;
local_2 = _e388;
local_3 = _e388;
local_4 = _e388;
local_5 = _e388;
local_6 = _e388;
local_7 = _e388;
local_8 = _e388;
local_9 = _e388;
local_10 = _e388;
local_11 = _e388;
local_12 = _e388;
local_13 = _e388;
local_14 = _e388;
local_15 = _e388;
local_16 = _e388;
local_17 = _e388;
local_18 = _e388;
local_19 = _e388;
local_20 = _e388;
local_21 = _e388;
local_22 = _e388;
local_23 = _e388;
let _e394 = ((_e390 < 1024i) && (_e388.member_6 == 4f));
local_24 = _e388.member_6;
if _e394 {
if (_e388.member_12 < (_e385 / 8i)) {
let _e545 = (_e388.member_12 * 8i);
let _e553 = (1f / select(_e388.member_1.x, select(1e-12f, -1e-12f, (_e388.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e388.member_1.x) & 2147483647u)) < 1e-12f)));
let _e561 = (1f / select(_e388.member_1.y, select(1e-12f, -1e-12f, (_e388.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e388.member_1.y) & 2147483647u)) < 1e-12f)));
let _e569 = (1f / select(_e388.member_1.z, select(1e-12f, -1e-12f, (_e388.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e388.member_1.z) & 2147483647u)) < 1e-12f)));
let _e571 = (_e385 - 1i);
let _e573 = select(_e571, _e545, (_e545 < _e571));
let _e579 = global_2.member[bitcast<u32>(select(0i, _e573, (_e573 > 0i)))];
let _e580 = (_e545 + 1i);
let _e582 = select(_e571, _e580, (_e580 < _e571));
let _e588 = global_2.member[bitcast<u32>(select(0i, _e582, (_e582 > 0i)))];
let _e589 = (_e545 + 2i);
let _e591 = select(_e571, _e589, (_e589 < _e571));
let _e597 = global_2.member[bitcast<u32>(select(0i, _e591, (_e591 > 0i)))];
let _e598 = (_e545 + 3i);
let _e600 = select(_e571, _e598, (_e598 < _e571));
let _e606 = global_2.member[bitcast<u32>(select(0i, _e600, (_e600 > 0i)))];
let _e607 = (_e545 + 4i);
let _e609 = select(_e571, _e607, (_e607 < _e571));
let _e615 = global_2.member[bitcast<u32>(select(0i, _e609, (_e609 > 0i)))];
let _e616 = (_e545 + 5i);
let _e618 = select(_e571, _e616, (_e616 < _e571));
let _e624 = global_2.member[bitcast<u32>(select(0i, _e618, (_e618 > 0i)))];
let _e627 = ((_e579 - _e388.member.x) * _e553);
let _e629 = ((_e606 - _e388.member.x) * _e553);
let _e632 = ((_e588 - _e388.member.y) * _e561);
let _e634 = ((_e615 - _e388.member.y) * _e561);
let _e637 = ((_e597 - _e388.member.z) * _e569);
let _e639 = ((_e624 - _e388.member.z) * _e569);
let _e641 = select(_e629, _e627, (_e627 < _e629));
let _e643 = select(_e634, _e632, (_e632 < _e634));
let _e645 = select(_e643, _e641, (_e641 > _e643));
let _e647 = select(_e639, _e637, (_e637 < _e639));
let _e651 = select(_e629, _e627, (_e627 > _e629));
let _e653 = select(_e634, _e632, (_e632 > _e634));
let _e655 = select(_e653, _e651, (_e651 < _e653));
let _e657 = select(_e639, _e637, (_e637 > _e639));
let _e659 = select(_e657, _e655, (_e655 < _e657));
let _e664 = ((select(_e647, _e645, (_e645 > _e647)) <= select(_e388.member_14, _e659, (_e659 < _e388.member_14))) && (_e659 >= 0f));
let _e665 = (_e545 + 6i);
let _e667 = select(_e571, _e665, (_e665 < _e571));
let _e673 = global_2.member[bitcast<u32>(select(0i, _e667, (_e667 > 0i)))];
if _e664 {
phi_967_ = (_e388.member_12 + 1i);
} else {
let _e681 = (_e545 + 7i);
let _e683 = select(_e571, _e681, (_e681 < _e571));
let _e689 = global_2.member[bitcast<u32>(select(0i, _e683, (_e683 > 0i)))];
phi_967_ = select(0i, select(select(i32(_e689), i32(-2147483648), (_e689 < -2147483600f)), 2147483647i, (_e689 > 2147483500f)), (_e689 == _e689));
}
let _e699 = phi_967_;
let _e714 = type_19(_e388.member, _e388.member_1, _e388.member_2, _e388.member_3, _e388.member_4, _e388.member_5, _e388.member_6, _e388.member_7, _e388.member_8, _e388.member_9, _e388.member_10, _e388.member_11, _e699, _e388.member_13, _e388.member_14);
let _e715 = select(-1i, select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < -2147483600f)), 2147483647i, (_e673 > 2147483500f)), (_e673 == _e673)), _e664);
if (_e715 >= 0i) {
let _e721 = bitcast<f32>((bitcast<u32>(_e388.member_1.x) & 2147483647u));
let _e725 = bitcast<f32>((bitcast<u32>(_e388.member_1.y) & 2147483647u));
let _e729 = bitcast<f32>((bitcast<u32>(_e388.member_1.z) & 2147483647u));
let _e732 = ((_e721 >= _e725) && (_e721 >= _e729));
let _e735 = (!(_e732) && (_e725 >= _e729));
let _e742 = (1f / select(select(_e388.member_1.z, _e388.member_1.y, _e735), _e388.member_1.x, _e732));
let _e743 = (select(select(_e388.member_1.x, _e388.member_1.z, _e735), _e388.member_1.y, _e732) * _e742);
let _e744 = (select(select(_e388.member_1.y, _e388.member_1.x, _e735), _e388.member_1.z, _e732) * _e742);
let _e745 = (_e715 * 19i);
let _e747 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e749 = select(_e747, _e745, (_e745 < _e747));
let _e755 = global_3.member[bitcast<u32>(select(0i, _e749, (_e749 > 0i)))];
let _e756 = (_e745 + 1i);
let _e758 = select(_e747, _e756, (_e756 < _e747));
let _e764 = global_3.member[bitcast<u32>(select(0i, _e758, (_e758 > 0i)))];
let _e765 = (_e745 + 2i);
let _e767 = select(_e747, _e765, (_e765 < _e747));
let _e773 = global_3.member[bitcast<u32>(select(0i, _e767, (_e767 > 0i)))];
let _e774 = (_e755 - _e388.member.x);
let _e775 = (_e764 - _e388.member.y);
let _e776 = (_e773 - _e388.member.z);
let _e782 = select(select(_e776, _e775, _e735), _e774, _e732);
let _e784 = (select(select(_e774, _e776, _e735), _e775, _e732) - (_e743 * _e782));
let _e786 = (select(select(_e775, _e774, _e735), _e776, _e732) - (_e744 * _e782));
let _e788 = (_e745 + 3i);
let _e790 = select(_e747, _e788, (_e788 < _e747));
let _e796 = global_3.member[bitcast<u32>(select(0i, _e790, (_e790 > 0i)))];
let _e797 = (_e745 + 4i);
let _e799 = select(_e747, _e797, (_e797 < _e747));
let _e805 = global_3.member[bitcast<u32>(select(0i, _e799, (_e799 > 0i)))];
let _e806 = (_e745 + 5i);
let _e808 = select(_e747, _e806, (_e806 < _e747));
let _e814 = global_3.member[bitcast<u32>(select(0i, _e808, (_e808 > 0i)))];
let _e815 = (_e796 - _e388.member.x);
let _e816 = (_e805 - _e388.member.y);
let _e817 = (_e814 - _e388.member.z);
let _e823 = select(select(_e817, _e816, _e735), _e815, _e732);
let _e825 = (select(select(_e815, _e817, _e735), _e816, _e732) - (_e743 * _e823));
let _e827 = (select(select(_e816, _e815, _e735), _e817, _e732) - (_e744 * _e823));
let _e829 = (_e745 + 6i);
let _e831 = select(_e747, _e829, (_e829 < _e747));
let _e837 = global_3.member[bitcast<u32>(select(0i, _e831, (_e831 > 0i)))];
let _e838 = (_e745 + 7i);
let _e840 = select(_e747, _e838, (_e838 < _e747));
let _e846 = global_3.member[bitcast<u32>(select(0i, _e840, (_e840 > 0i)))];
let _e847 = (_e745 + 8i);
let _e849 = select(_e747, _e847, (_e847 < _e747));
let _e855 = global_3.member[bitcast<u32>(select(0i, _e849, (_e849 > 0i)))];
let _e856 = (_e837 - _e388.member.x);
let _e857 = (_e846 - _e388.member.y);
let _e858 = (_e855 - _e388.member.z);
let _e864 = select(select(_e858, _e857, _e735), _e856, _e732);
let _e866 = (select(select(_e856, _e858, _e735), _e857, _e732) - (_e743 * _e864));
let _e868 = (select(select(_e857, _e856, _e735), _e858, _e732) - (_e744 * _e864));
let _e872 = ((_e866 * _e827) - (_e868 * _e825));
let _e875 = ((_e784 * _e868) - (_e786 * _e866));
let _e878 = ((_e825 * _e786) - (_e827 * _e784));
let _e880 = ((_e872 + _e875) + _e878);
let _e894 = (!(((((_e872 < 0f) || (_e875 < 0f)) || (_e878 < 0f)) && (((_e872 > 0f) || (_e875 > 0f)) || (_e878 > 0f)))) && (_e880 != 0f));
let _e902 = select(1e30f, ((((_e872 * (_e782 * _e742)) + (_e875 * (_e823 * _e742))) + (_e878 * (_e864 * _e742))) / select(1f, _e880, _e894)), _e894);
let _e904 = select(1e30f, _e902, (_e902 > 1e-3f));
if (_e904 < _e388.member_14) {
let _e920 = type_19(_e714.member, _e714.member_1, _e714.member_2, _e714.member_3, _e714.member_4, _e714.member_5, _e714.member_6, _e714.member_7, _e714.member_8, _e714.member_9, _e714.member_10, _e714.member_11, _e714.member_12, _e714.member_13, _e904);
phi_1334_ = type_19(_e920.member, _e920.member_1, _e920.member_2, _e920.member_3, _e920.member_4, _e920.member_5, _e920.member_6, _e920.member_7, _e920.member_8, _e920.member_9, _e920.member_10, _e920.member_11, _e920.member_12, _e715, _e920.member_14);
} else {
phi_1334_ = _e714;
}
let _e937 = phi_1334_;
phi_1335_ = _e937;
} else {
phi_1335_ = _e714;
}
let _e939 = phi_1335_;
phi_1639_ = _e939;
} else {
if ((_e67.member_2 == 0u) && (_e388.member_8 >= 2f)) {
if (_e388.member_13 == -1i) {
phi_1636_ = type_19(_e388.member, _e388.member_1, _e388.member_2, _e388.member_3, _e388.member_4, _e388.member_5, 1f, _e388.member_7, _e388.member_8, _e388.member_9, _e388.member_10, _e388.member_11, _e388.member_12, _e388.member_13, _e388.member_14);
} else {
let _e451 = type_19(vec3<f32>((_e388.member.x + (_e388.member_1.x * _e388.member_14)), (_e388.member.y + (_e388.member_1.y * _e388.member_14)), (_e388.member.z + (_e388.member_1.z * _e388.member_14))), _e388.member_1, _e388.member_2, _e388.member_3, _e388.member_4, _e388.member_5, _e388.member_6, _e388.member_7, _e388.member_8, _e388.member_9, _e388.member_10, _e388.member_11, _e388.member_12, _e388.member_13, _e388.member_14);
let _e468 = type_19(_e451.member, _e451.member_1, _e451.member_2, _e451.member_3, _e451.member_4, (_e388.member_5 + _e388.member_14), _e451.member_6, _e451.member_7, _e451.member_8, _e451.member_9, _e451.member_10, _e451.member_11, _e451.member_12, _e451.member_13, _e451.member_14);
let _e484 = type_19(_e468.member, _e468.member_1, _e468.member_2, _e468.member_3, _e468.member_4, _e468.member_5, _e468.member_6, _e468.member_7, _e468.member_8, _e468.member_9, _e468.member_10, _e468.member_11, _e468.member_12, _e468.member_13, (_e388.member_14 - _e388.member_14));
let _e503 = type_19(_e484.member, _e484.member_1, _e484.member_2, _e484.member_3, _e484.member_4, _e484.member_5, _e484.member_6, _e484.member_7, _e484.member_8, _e484.member_9, (_e388.member_10 + select(0f, _e388.member_14, (_e388.member_8 == 0f))), _e484.member_11, _e484.member_12, _e484.member_13, _e484.member_14);
phi_1636_ = type_19(_e503.member, _e503.member_1, _e503.member_2, _e503.member_3, _e503.member_4, _e503.member_5, 3f, _e503.member_7, _e503.member_8, _e503.member_9, _e503.member_10, _e503.member_11, _e503.member_12, _e503.member_13, _e503.member_14);
}
let _e535 = phi_1636_;
phi_1638_ = _e535;
} else {
phi_1638_ = type_19(_e388.member, _e388.member_1, _e388.member_2, _e388.member_3, _e388.member_4, _e388.member_5, 0f, _e388.member_7, _e388.member_8, _e388.member_9, _e388.member_10, _e388.member_11, _e388.member_12, _e388.member_13, _e388.member_14);
}
let _e537 = phi_1638_;
phi_1639_ = _e537;
}
let _e941 = phi_1639_;
phi_670_ = _e941;
phi_673_ = (_e390 + 1i);
} else {
phi_670_ = type_19();
phi_673_ = i32();
}
let _e943 = phi_670_;
let _e945 = phi_673_;
continue;
continuing {
phi_669_ = _e943;
phi_672_ = _e945;
break if !(_e394);
}
}
let _e948 = local;
let _e952 = local_1;
let _e956 = local_2;
let _e960 = local_3;
let _e964 = local_4;
let _e968 = local_5;
let _e972 = local_6;
let _e976 = local_7;
let _e980 = local_8;
let _e984 = local_9;
let _e988 = local_10;
let _e992 = local_11;
let _e996 = local_12;
let _e1000 = local_13;
let _e1004 = local_14;
let _e1008 = local_15;
let _e1011 = local_16;
let _e1015 = local_17;
let _e1018 = local_18;
let _e1021 = local_19;
let _e1024 = local_20;
let _e1027 = local_21;
let _e1031 = local_22;
let _e1035 = local_23;
global_4.member[_e76] = _e948.member.x;
global_4.member[_e88] = _e952.member.y;
global_4.member[_e99] = _e956.member.z;
global_4.member[_e110] = _e960.member_1.x;
global_4.member[_e121] = _e964.member_1.y;
global_4.member[_e132] = _e968.member_1.z;
global_4.member[_e143] = _e972.member_2.x;
global_4.member[_e154] = _e976.member_2.y;
global_4.member[_e165] = _e980.member_2.z;
global_4.member[_e176] = _e984.member_3.x;
global_4.member[_e187] = _e988.member_3.y;
global_4.member[_e198] = _e992.member_3.z;
global_4.member[_e209] = _e996.member_4.x;
global_4.member[_e220] = _e1000.member_4.y;
global_4.member[_e231] = _e1004.member_4.z;
global_4.member[_e242] = _e1008.member_5;
let _e1072 = local_24;
global_4.member[_e253] = _e1072;
global_4.member[_e264] = f32(_e1011.member_7);
global_4.member[_e275] = _e1015.member_8;
global_4.member[_e286] = _e1018.member_9;
global_4.member[_e297] = _e1021.member_10;
global_4.member[_e308] = _e1024.member_11;
global_4.member[_e319] = f32(_e1027.member_12);
global_4.member[_e330] = f32(_e1031.member_13);
global_4.member[_e341] = _e1035.member_14;
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
