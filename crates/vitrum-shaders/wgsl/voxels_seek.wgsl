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
var phi_1630_: type_19;
var phi_1632_: type_19;
var phi_1295_: type_19;
var phi_1296_: type_19;
var phi_1328_: i32;
var phi_1633_: type_19;
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
let _e539 = (_e388.member_12 * 8i);
let _e543 = bitcast<f32>((bitcast<u32>(_e388.member_1.x) & 2147483647u));
let _e548 = (1f / select(_e388.member_1.x, select(1e-12f, -1e-12f, (_e388.member_1.x < 0f)), (_e543 < 1e-12f)));
let _e552 = bitcast<f32>((bitcast<u32>(_e388.member_1.y) & 2147483647u));
let _e557 = (1f / select(_e388.member_1.y, select(1e-12f, -1e-12f, (_e388.member_1.y < 0f)), (_e552 < 1e-12f)));
let _e561 = bitcast<f32>((bitcast<u32>(_e388.member_1.z) & 2147483647u));
let _e566 = (1f / select(_e388.member_1.z, select(1e-12f, -1e-12f, (_e388.member_1.z < 0f)), (_e561 < 1e-12f)));
let _e568 = (_e385 - 1i);
let _e570 = select(_e568, _e539, (_e539 < _e568));
let _e576 = global_2.member[bitcast<u32>(select(0i, _e570, (_e570 > 0i)))];
let _e577 = (_e539 + 1i);
let _e579 = select(_e568, _e577, (_e577 < _e568));
let _e585 = global_2.member[bitcast<u32>(select(0i, _e579, (_e579 > 0i)))];
let _e586 = (_e539 + 2i);
let _e588 = select(_e568, _e586, (_e586 < _e568));
let _e594 = global_2.member[bitcast<u32>(select(0i, _e588, (_e588 > 0i)))];
let _e595 = (_e539 + 3i);
let _e597 = select(_e568, _e595, (_e595 < _e568));
let _e603 = global_2.member[bitcast<u32>(select(0i, _e597, (_e597 > 0i)))];
let _e604 = (_e539 + 4i);
let _e606 = select(_e568, _e604, (_e604 < _e568));
let _e612 = global_2.member[bitcast<u32>(select(0i, _e606, (_e606 > 0i)))];
let _e613 = (_e539 + 5i);
let _e615 = select(_e568, _e613, (_e613 < _e568));
let _e621 = global_2.member[bitcast<u32>(select(0i, _e615, (_e615 > 0i)))];
let _e624 = ((_e576 - _e388.member.x) * _e548);
let _e626 = ((_e603 - _e388.member.x) * _e548);
let _e629 = ((_e585 - _e388.member.y) * _e557);
let _e631 = ((_e612 - _e388.member.y) * _e557);
let _e634 = ((_e594 - _e388.member.z) * _e566);
let _e636 = ((_e621 - _e388.member.z) * _e566);
let _e638 = select(_e626, _e624, (_e624 < _e626));
let _e640 = select(_e631, _e629, (_e629 < _e631));
let _e642 = select(_e640, _e638, (_e638 > _e640));
let _e644 = select(_e636, _e634, (_e634 < _e636));
let _e648 = select(_e626, _e624, (_e624 > _e626));
let _e650 = select(_e631, _e629, (_e629 > _e631));
let _e652 = select(_e650, _e648, (_e648 < _e650));
let _e654 = select(_e636, _e634, (_e634 > _e636));
let _e656 = select(_e654, _e652, (_e652 < _e654));
let _e662 = ((select(_e644, _e642, (_e642 > _e644)) <= select(_e388.member_14, _e656, (_e656 < _e388.member_14))) && (_e656 >= 0f));
let _e663 = (_e539 + 6i);
let _e665 = select(_e568, _e663, (_e663 < _e568));
let _e671 = global_2.member[bitcast<u32>(select(0i, _e665, (_e665 > 0i)))];
let _e678 = select(0i, select(select(i32(_e671), i32(-2147483648), (_e671 < -2147483600f)), 2147483647i, (_e671 > 2147483500f)), (_e671 == _e671));
if (_e662 && (_e678 >= 0i)) {
let _e683 = ((_e543 >= _e552) && (_e543 >= _e561));
let _e686 = (!(_e683) && (_e552 >= _e561));
let _e693 = (1f / select(select(_e388.member_1.z, _e388.member_1.y, _e686), _e388.member_1.x, _e683));
let _e694 = (select(select(_e388.member_1.x, _e388.member_1.z, _e686), _e388.member_1.y, _e683) * _e693);
let _e695 = (select(select(_e388.member_1.y, _e388.member_1.x, _e686), _e388.member_1.z, _e683) * _e693);
let _e696 = (_e678 * 19i);
let _e698 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e700 = select(_e698, _e696, (_e696 < _e698));
let _e706 = global_3.member[bitcast<u32>(select(0i, _e700, (_e700 > 0i)))];
let _e707 = (_e696 + 1i);
let _e709 = select(_e698, _e707, (_e707 < _e698));
let _e715 = global_3.member[bitcast<u32>(select(0i, _e709, (_e709 > 0i)))];
let _e716 = (_e696 + 2i);
let _e718 = select(_e698, _e716, (_e716 < _e698));
let _e724 = global_3.member[bitcast<u32>(select(0i, _e718, (_e718 > 0i)))];
let _e725 = (_e706 - _e388.member.x);
let _e726 = (_e715 - _e388.member.y);
let _e727 = (_e724 - _e388.member.z);
let _e733 = select(select(_e727, _e726, _e686), _e725, _e683);
let _e735 = (select(select(_e725, _e727, _e686), _e726, _e683) - (_e694 * _e733));
let _e737 = (select(select(_e726, _e725, _e686), _e727, _e683) - (_e695 * _e733));
let _e739 = (_e696 + 3i);
let _e741 = select(_e698, _e739, (_e739 < _e698));
let _e747 = global_3.member[bitcast<u32>(select(0i, _e741, (_e741 > 0i)))];
let _e748 = (_e696 + 4i);
let _e750 = select(_e698, _e748, (_e748 < _e698));
let _e756 = global_3.member[bitcast<u32>(select(0i, _e750, (_e750 > 0i)))];
let _e757 = (_e696 + 5i);
let _e759 = select(_e698, _e757, (_e757 < _e698));
let _e765 = global_3.member[bitcast<u32>(select(0i, _e759, (_e759 > 0i)))];
let _e766 = (_e747 - _e388.member.x);
let _e767 = (_e756 - _e388.member.y);
let _e768 = (_e765 - _e388.member.z);
let _e774 = select(select(_e768, _e767, _e686), _e766, _e683);
let _e776 = (select(select(_e766, _e768, _e686), _e767, _e683) - (_e694 * _e774));
let _e778 = (select(select(_e767, _e766, _e686), _e768, _e683) - (_e695 * _e774));
let _e780 = (_e696 + 6i);
let _e782 = select(_e698, _e780, (_e780 < _e698));
let _e788 = global_3.member[bitcast<u32>(select(0i, _e782, (_e782 > 0i)))];
let _e789 = (_e696 + 7i);
let _e791 = select(_e698, _e789, (_e789 < _e698));
let _e797 = global_3.member[bitcast<u32>(select(0i, _e791, (_e791 > 0i)))];
let _e798 = (_e696 + 8i);
let _e800 = select(_e698, _e798, (_e798 < _e698));
let _e806 = global_3.member[bitcast<u32>(select(0i, _e800, (_e800 > 0i)))];
let _e807 = (_e788 - _e388.member.x);
let _e808 = (_e797 - _e388.member.y);
let _e809 = (_e806 - _e388.member.z);
let _e815 = select(select(_e809, _e808, _e686), _e807, _e683);
let _e817 = (select(select(_e807, _e809, _e686), _e808, _e683) - (_e694 * _e815));
let _e819 = (select(select(_e808, _e807, _e686), _e809, _e683) - (_e695 * _e815));
let _e823 = ((_e817 * _e778) - (_e819 * _e776));
let _e826 = ((_e735 * _e819) - (_e737 * _e817));
let _e829 = ((_e776 * _e737) - (_e778 * _e735));
let _e831 = ((_e823 + _e826) + _e829);
let _e845 = (!(((((_e823 < 0f) || (_e826 < 0f)) || (_e829 < 0f)) && (((_e823 > 0f) || (_e826 > 0f)) || (_e829 > 0f)))) && (_e831 != 0f));
let _e852 = ((((_e823 * (_e733 * _e693)) + (_e826 * (_e774 * _e693))) + (_e829 * (_e815 * _e693))) / select(1f, _e831, _e845));
let _e855 = select(1e30f, _e852, (_e845 && (_e852 > 1e-3f)));
if (_e855 < _e388.member_14) {
let _e871 = type_19(_e388.member, _e388.member_1, _e388.member_2, _e388.member_3, _e388.member_4, _e388.member_5, _e388.member_6, _e388.member_7, _e388.member_8, _e388.member_9, _e388.member_10, _e388.member_11, _e388.member_12, _e388.member_13, _e855);
phi_1295_ = type_19(_e871.member, _e871.member_1, _e871.member_2, _e871.member_3, _e871.member_4, _e871.member_5, _e871.member_6, _e871.member_7, _e871.member_8, _e871.member_9, _e871.member_10, _e871.member_11, _e871.member_12, _e678, _e871.member_14);
} else {
phi_1295_ = _e388;
}
let _e888 = phi_1295_;
phi_1296_ = _e888;
} else {
phi_1296_ = _e388;
}
let _e890 = phi_1296_;
if _e662 {
phi_1328_ = (_e890.member_12 + 1i);
} else {
let _e891 = (_e539 + 7i);
let _e893 = select(_e568, _e891, (_e891 < _e568));
let _e899 = global_2.member[bitcast<u32>(select(0i, _e893, (_e893 > 0i)))];
phi_1328_ = select(0i, select(select(i32(_e899), i32(-2147483648), (_e899 < -2147483600f)), 2147483647i, (_e899 > 2147483500f)), (_e899 == _e899));
}
let _e910 = phi_1328_;
phi_1633_ = type_19(_e890.member, _e890.member_1, _e890.member_2, _e890.member_3, _e890.member_4, _e890.member_5, _e890.member_6, _e890.member_7, _e890.member_8, _e890.member_9, _e890.member_10, _e890.member_11, _e910, _e890.member_13, _e890.member_14);
} else {
if ((_e67.member_2 == 0u) && (_e388.member_8 >= 2f)) {
if (_e388.member_13 == -1i) {
phi_1630_ = type_19(_e388.member, _e388.member_1, _e388.member_2, _e388.member_3, _e388.member_4, _e388.member_5, 1f, _e388.member_7, _e388.member_8, _e388.member_9, _e388.member_10, _e388.member_11, _e388.member_12, _e388.member_13, _e388.member_14);
} else {
let _e451 = type_19(vec3<f32>((_e388.member.x + (_e388.member_1.x * _e388.member_14)), (_e388.member.y + (_e388.member_1.y * _e388.member_14)), (_e388.member.z + (_e388.member_1.z * _e388.member_14))), _e388.member_1, _e388.member_2, _e388.member_3, _e388.member_4, _e388.member_5, _e388.member_6, _e388.member_7, _e388.member_8, _e388.member_9, _e388.member_10, _e388.member_11, _e388.member_12, _e388.member_13, _e388.member_14);
let _e468 = type_19(_e451.member, _e451.member_1, _e451.member_2, _e451.member_3, _e451.member_4, (_e388.member_5 + _e388.member_14), _e451.member_6, _e451.member_7, _e451.member_8, _e451.member_9, _e451.member_10, _e451.member_11, _e451.member_12, _e451.member_13, _e451.member_14);
let _e484 = type_19(_e468.member, _e468.member_1, _e468.member_2, _e468.member_3, _e468.member_4, _e468.member_5, _e468.member_6, _e468.member_7, _e468.member_8, _e468.member_9, _e468.member_10, _e468.member_11, _e468.member_12, _e468.member_13, (_e388.member_14 - _e388.member_14));
let _e503 = type_19(_e484.member, _e484.member_1, _e484.member_2, _e484.member_3, _e484.member_4, _e484.member_5, _e484.member_6, _e484.member_7, _e484.member_8, _e484.member_9, (_e388.member_10 + select(0f, _e388.member_14, (_e388.member_8 == 0f))), _e484.member_11, _e484.member_12, _e484.member_13, _e484.member_14);
phi_1630_ = type_19(_e503.member, _e503.member_1, _e503.member_2, _e503.member_3, _e503.member_4, _e503.member_5, 3f, _e503.member_7, _e503.member_8, _e503.member_9, _e503.member_10, _e503.member_11, _e503.member_12, _e503.member_13, _e503.member_14);
}
let _e535 = phi_1630_;
phi_1632_ = _e535;
} else {
phi_1632_ = type_19(_e388.member, _e388.member_1, _e388.member_2, _e388.member_3, _e388.member_4, _e388.member_5, 0f, _e388.member_7, _e388.member_8, _e388.member_9, _e388.member_10, _e388.member_11, _e388.member_12, _e388.member_13, _e388.member_14);
}
let _e537 = phi_1632_;
phi_1633_ = _e537;
}
let _e927 = phi_1633_;
phi_670_ = _e927;
phi_673_ = (_e390 + 1i);
} else {
phi_670_ = type_19();
phi_673_ = i32();
}
let _e929 = phi_670_;
let _e931 = phi_673_;
continue;
continuing {
phi_669_ = _e929;
phi_672_ = _e931;
break if !(_e394);
}
}
let _e934 = local;
let _e938 = local_1;
let _e942 = local_2;
let _e946 = local_3;
let _e950 = local_4;
let _e954 = local_5;
let _e958 = local_6;
let _e962 = local_7;
let _e966 = local_8;
let _e970 = local_9;
let _e974 = local_10;
let _e978 = local_11;
let _e982 = local_12;
let _e986 = local_13;
let _e990 = local_14;
let _e994 = local_15;
let _e997 = local_16;
let _e1001 = local_17;
let _e1004 = local_18;
let _e1007 = local_19;
let _e1010 = local_20;
let _e1013 = local_21;
let _e1017 = local_22;
let _e1021 = local_23;
global_4.member[_e76] = _e934.member.x;
global_4.member[_e88] = _e938.member.y;
global_4.member[_e99] = _e942.member.z;
global_4.member[_e110] = _e946.member_1.x;
global_4.member[_e121] = _e950.member_1.y;
global_4.member[_e132] = _e954.member_1.z;
global_4.member[_e143] = _e958.member_2.x;
global_4.member[_e154] = _e962.member_2.y;
global_4.member[_e165] = _e966.member_2.z;
global_4.member[_e176] = _e970.member_3.x;
global_4.member[_e187] = _e974.member_3.y;
global_4.member[_e198] = _e978.member_3.z;
global_4.member[_e209] = _e982.member_4.x;
global_4.member[_e220] = _e986.member_4.y;
global_4.member[_e231] = _e990.member_4.z;
global_4.member[_e242] = _e994.member_5;
let _e1058 = local_24;
global_4.member[_e253] = _e1058;
global_4.member[_e264] = f32(_e997.member_7);
global_4.member[_e275] = _e1001.member_8;
global_4.member[_e286] = _e1004.member_9;
global_4.member[_e297] = _e1007.member_10;
global_4.member[_e308] = _e1010.member_11;
global_4.member[_e319] = f32(_e1013.member_12);
global_4.member[_e330] = f32(_e1017.member_13);
global_4.member[_e341] = _e1021.member_14;
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
