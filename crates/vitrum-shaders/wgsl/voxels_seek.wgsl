struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_5 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: type_4,
member_4: type_4,
member_5: type_4,
member_6: type_4,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: vec4<u32>,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: vec4<u32>,
member_25: type_4,
member_26: type_4,
member_27: type_4,
member_28: type_4,
}
struct type_6 {
member: type_5,
}
struct type_8 {
member: array<f32>,
}
struct type_11 {
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
var<storage> global_1: type_6;
@group(0) @binding(1)
var<storage> global_2: type_8;
@group(0) @binding(2)
var<storage> global_3: type_8;
@group(0) @binding(4)
var<storage, read_write> global_4: type_8;
fn function_() {
var phi_613_: u32;
var phi_818_: type_11;
var phi_821_: i32;
var phi_1779_: type_11;
var phi_1781_: type_11;
var phi_1444_: type_11;
var phi_1445_: type_11;
var phi_1477_: i32;
var phi_1782_: type_11;
var phi_819_: type_11;
var phi_822_: i32;
var local: type_11;
var local_1: type_11;
var local_2: type_11;
var local_3: type_11;
var local_4: type_11;
var local_5: type_11;
var local_6: type_11;
var local_7: type_11;
var local_8: type_11;
var local_9: type_11;
var local_10: type_11;
var local_11: type_11;
var local_12: type_11;
var local_13: type_11;
var local_14: type_11;
var local_15: type_11;
var local_16: type_11;
var local_17: type_11;
var local_18: type_11;
var local_19: type_11;
var local_20: type_11;
var local_21: type_11;
var local_22: type_11;
var local_23: type_11;
var local_24: f32;
let _e58 = global;
let _e68 = global_1.member.member[0u];
let _e72 = global_1.member.member[1u];
if (_e58.x < _e68) {
if (_e58.y < _e72) {
let _e77 = (_e68 * _e72);
let _e79 = ((_e58.y * _e68) + _e58.x);
let _e80 = bitcast<i32>(_e79);
let _e82 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e84 = select(_e82, _e80, (_e80 < _e82));
let _e90 = global_4.member[bitcast<u32>(select(0i, _e84, (_e84 > 0i)))];
let _e91 = (_e77 + _e79);
let _e92 = bitcast<i32>(_e91);
let _e94 = select(_e82, _e92, (_e92 < _e82));
let _e100 = global_4.member[bitcast<u32>(select(0i, _e94, (_e94 > 0i)))];
let _e102 = ((2u * _e77) + _e79);
let _e103 = bitcast<i32>(_e102);
let _e105 = select(_e82, _e103, (_e103 < _e82));
let _e111 = global_4.member[bitcast<u32>(select(0i, _e105, (_e105 > 0i)))];
let _e113 = ((3u * _e77) + _e79);
let _e114 = bitcast<i32>(_e113);
let _e116 = select(_e82, _e114, (_e114 < _e82));
let _e122 = global_4.member[bitcast<u32>(select(0i, _e116, (_e116 > 0i)))];
let _e124 = ((4u * _e77) + _e79);
let _e125 = bitcast<i32>(_e124);
let _e127 = select(_e82, _e125, (_e125 < _e82));
let _e133 = global_4.member[bitcast<u32>(select(0i, _e127, (_e127 > 0i)))];
let _e135 = ((5u * _e77) + _e79);
let _e136 = bitcast<i32>(_e135);
let _e138 = select(_e82, _e136, (_e136 < _e82));
let _e144 = global_4.member[bitcast<u32>(select(0i, _e138, (_e138 > 0i)))];
let _e146 = ((6u * _e77) + _e79);
let _e147 = bitcast<i32>(_e146);
let _e149 = select(_e82, _e147, (_e147 < _e82));
let _e155 = global_4.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e157 = ((7u * _e77) + _e79);
let _e158 = bitcast<i32>(_e157);
let _e160 = select(_e82, _e158, (_e158 < _e82));
let _e166 = global_4.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e168 = ((8u * _e77) + _e79);
let _e169 = bitcast<i32>(_e168);
let _e171 = select(_e82, _e169, (_e169 < _e82));
let _e177 = global_4.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e179 = ((9u * _e77) + _e79);
let _e180 = bitcast<i32>(_e179);
let _e182 = select(_e82, _e180, (_e180 < _e82));
let _e188 = global_4.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e190 = ((10u * _e77) + _e79);
let _e191 = bitcast<i32>(_e190);
let _e193 = select(_e82, _e191, (_e191 < _e82));
let _e199 = global_4.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e201 = ((11u * _e77) + _e79);
let _e202 = bitcast<i32>(_e201);
let _e204 = select(_e82, _e202, (_e202 < _e82));
let _e210 = global_4.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e212 = ((12u * _e77) + _e79);
let _e213 = bitcast<i32>(_e212);
let _e215 = select(_e82, _e213, (_e213 < _e82));
let _e221 = global_4.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e223 = ((13u * _e77) + _e79);
let _e224 = bitcast<i32>(_e223);
let _e226 = select(_e82, _e224, (_e224 < _e82));
let _e232 = global_4.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e234 = ((14u * _e77) + _e79);
let _e235 = bitcast<i32>(_e234);
let _e237 = select(_e82, _e235, (_e235 < _e82));
let _e243 = global_4.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e245 = ((15u * _e77) + _e79);
let _e246 = bitcast<i32>(_e245);
let _e248 = select(_e82, _e246, (_e246 < _e82));
let _e254 = global_4.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e256 = ((16u * _e77) + _e79);
let _e257 = bitcast<i32>(_e256);
let _e259 = select(_e82, _e257, (_e257 < _e82));
let _e265 = global_4.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e267 = ((17u * _e77) + _e79);
let _e268 = bitcast<i32>(_e267);
let _e270 = select(_e82, _e268, (_e268 < _e82));
let _e276 = global_4.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e278 = ((18u * _e77) + _e79);
let _e279 = bitcast<i32>(_e278);
let _e281 = select(_e82, _e279, (_e279 < _e82));
let _e287 = global_4.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e289 = ((19u * _e77) + _e79);
let _e290 = bitcast<i32>(_e289);
let _e292 = select(_e82, _e290, (_e290 < _e82));
let _e298 = global_4.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e300 = ((20u * _e77) + _e79);
let _e301 = bitcast<i32>(_e300);
let _e303 = select(_e82, _e301, (_e301 < _e82));
let _e309 = global_4.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e311 = ((21u * _e77) + _e79);
let _e312 = bitcast<i32>(_e311);
let _e314 = select(_e82, _e312, (_e312 < _e82));
let _e320 = global_4.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e322 = ((22u * _e77) + _e79);
let _e323 = bitcast<i32>(_e322);
let _e325 = select(_e82, _e323, (_e323 < _e82));
let _e331 = global_4.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e333 = ((23u * _e77) + _e79);
let _e334 = bitcast<i32>(_e333);
let _e336 = select(_e82, _e334, (_e334 < _e82));
let _e342 = global_4.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e344 = ((24u * _e77) + _e79);
let _e345 = bitcast<i32>(_e344);
let _e347 = select(_e82, _e345, (_e345 < _e82));
let _e353 = global_4.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
if (_e265 == 4f) {
phi_613_ = 3u;
} else {
phi_613_ = select(0u, 1u, (_e265 == 0f));
}
let _e358 = phi_613_;
if (_e358 > 1u) {
let _e363 = global_1.member.member[2u];
let _e391 = bitcast<i32>(arrayLength((&global_2.member)));
phi_818_ = type_11(vec3<f32>(_e90, _e100, _e111), vec3<f32>(_e122, _e133, _e144), vec3<f32>(_e155, _e166, _e177), vec3<f32>(_e188, _e199, _e210), vec3<f32>(_e221, _e232, _e243), _e254, _e265, select(0i, select(select(i32(_e276), i32(-2147483648), (_e276 < -2147483600f)), 2147483647i, (_e276 > 2147483500f)), (_e276 == _e276)), _e287, _e298, _e309, _e320, select(0i, select(select(i32(_e331), i32(-2147483648), (_e331 < -2147483600f)), 2147483647i, (_e331 > 2147483500f)), (_e331 == _e331)), select(0i, select(select(i32(_e342), i32(-2147483648), (_e342 < -2147483600f)), 2147483647i, (_e342 > 2147483500f)), (_e342 == _e342)), _e353);
phi_821_ = 0i;
loop {
let _e394 = phi_818_;
let _e396 = phi_821_;
local = _e394;
local_1 = _e394;
local_2 = _e394;
local_3 = _e394;
local_4 = _e394;
local_5 = _e394;
local_6 = _e394;
local_7 = _e394;
local_8 = _e394;
local_9 = _e394;
local_10 = _e394;
local_11 = _e394;
local_12 = _e394;
local_13 = _e394;
local_14 = _e394;
local_15 = _e394;
local_16 = _e394;
local_17 = _e394;
local_18 = _e394;
local_19 = _e394;
local_20 = _e394;
local_21 = _e394;
local_22 = _e394;
local_23 = _e394;
let _e400 = ((_e396 < 1024i) && (_e394.member_6 == 4f));
local_24 = _e394.member_6;
if _e400 {
if (_e394.member_12 < (_e391 / 8i)) {
let _e545 = (_e394.member_12 * 8i);
let _e549 = bitcast<f32>((bitcast<u32>(_e394.member_1.x) & 2147483647u));
let _e554 = (1f / select(_e394.member_1.x, select(1e-12f, -1e-12f, (_e394.member_1.x < 0f)), (_e549 < 1e-12f)));
let _e558 = bitcast<f32>((bitcast<u32>(_e394.member_1.y) & 2147483647u));
let _e563 = (1f / select(_e394.member_1.y, select(1e-12f, -1e-12f, (_e394.member_1.y < 0f)), (_e558 < 1e-12f)));
let _e567 = bitcast<f32>((bitcast<u32>(_e394.member_1.z) & 2147483647u));
let _e572 = (1f / select(_e394.member_1.z, select(1e-12f, -1e-12f, (_e394.member_1.z < 0f)), (_e567 < 1e-12f)));
let _e574 = (_e391 - 1i);
let _e576 = select(_e574, _e545, (_e545 < _e574));
let _e582 = global_2.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e583 = (_e545 + 1i);
let _e585 = select(_e574, _e583, (_e583 < _e574));
let _e591 = global_2.member[bitcast<u32>(select(0i, _e585, (_e585 > 0i)))];
let _e592 = (_e545 + 2i);
let _e594 = select(_e574, _e592, (_e592 < _e574));
let _e600 = global_2.member[bitcast<u32>(select(0i, _e594, (_e594 > 0i)))];
let _e601 = (_e545 + 3i);
let _e603 = select(_e574, _e601, (_e601 < _e574));
let _e609 = global_2.member[bitcast<u32>(select(0i, _e603, (_e603 > 0i)))];
let _e610 = (_e545 + 4i);
let _e612 = select(_e574, _e610, (_e610 < _e574));
let _e618 = global_2.member[bitcast<u32>(select(0i, _e612, (_e612 > 0i)))];
let _e619 = (_e545 + 5i);
let _e621 = select(_e574, _e619, (_e619 < _e574));
let _e627 = global_2.member[bitcast<u32>(select(0i, _e621, (_e621 > 0i)))];
let _e630 = ((_e582 - _e394.member.x) * _e554);
let _e632 = ((_e609 - _e394.member.x) * _e554);
let _e635 = ((_e591 - _e394.member.y) * _e563);
let _e637 = ((_e618 - _e394.member.y) * _e563);
let _e640 = ((_e600 - _e394.member.z) * _e572);
let _e642 = ((_e627 - _e394.member.z) * _e572);
let _e644 = select(_e632, _e630, (_e630 < _e632));
let _e646 = select(_e637, _e635, (_e635 < _e637));
let _e648 = select(_e646, _e644, (_e644 > _e646));
let _e650 = select(_e642, _e640, (_e640 < _e642));
let _e654 = select(_e632, _e630, (_e630 > _e632));
let _e656 = select(_e637, _e635, (_e635 > _e637));
let _e658 = select(_e656, _e654, (_e654 < _e656));
let _e660 = select(_e642, _e640, (_e640 > _e642));
let _e662 = select(_e660, _e658, (_e658 < _e660));
let _e668 = ((select(_e650, _e648, (_e648 > _e650)) <= select(_e394.member_14, _e662, (_e662 < _e394.member_14))) && (_e662 >= 0f));
let _e669 = (_e545 + 6i);
let _e671 = select(_e574, _e669, (_e669 < _e574));
let _e677 = global_2.member[bitcast<u32>(select(0i, _e671, (_e671 > 0i)))];
let _e684 = select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < -2147483600f)), 2147483647i, (_e677 > 2147483500f)), (_e677 == _e677));
if (_e668 && (_e684 >= 0i)) {
let _e689 = ((_e549 >= _e558) && (_e549 >= _e567));
let _e692 = (!(_e689) && (_e558 >= _e567));
let _e699 = (1f / select(select(_e394.member_1.z, _e394.member_1.y, _e692), _e394.member_1.x, _e689));
let _e700 = (select(select(_e394.member_1.x, _e394.member_1.z, _e692), _e394.member_1.y, _e689) * _e699);
let _e701 = (select(select(_e394.member_1.y, _e394.member_1.x, _e692), _e394.member_1.z, _e689) * _e699);
let _e702 = (_e684 * 19i);
let _e704 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e706 = select(_e704, _e702, (_e702 < _e704));
let _e712 = global_3.member[bitcast<u32>(select(0i, _e706, (_e706 > 0i)))];
let _e713 = (_e702 + 1i);
let _e715 = select(_e704, _e713, (_e713 < _e704));
let _e721 = global_3.member[bitcast<u32>(select(0i, _e715, (_e715 > 0i)))];
let _e722 = (_e702 + 2i);
let _e724 = select(_e704, _e722, (_e722 < _e704));
let _e730 = global_3.member[bitcast<u32>(select(0i, _e724, (_e724 > 0i)))];
let _e731 = (_e712 - _e394.member.x);
let _e732 = (_e721 - _e394.member.y);
let _e733 = (_e730 - _e394.member.z);
let _e739 = select(select(_e733, _e732, _e692), _e731, _e689);
let _e741 = (select(select(_e731, _e733, _e692), _e732, _e689) - (_e700 * _e739));
let _e743 = (select(select(_e732, _e731, _e692), _e733, _e689) - (_e701 * _e739));
let _e745 = (_e702 + 3i);
let _e747 = select(_e704, _e745, (_e745 < _e704));
let _e753 = global_3.member[bitcast<u32>(select(0i, _e747, (_e747 > 0i)))];
let _e754 = (_e702 + 4i);
let _e756 = select(_e704, _e754, (_e754 < _e704));
let _e762 = global_3.member[bitcast<u32>(select(0i, _e756, (_e756 > 0i)))];
let _e763 = (_e702 + 5i);
let _e765 = select(_e704, _e763, (_e763 < _e704));
let _e771 = global_3.member[bitcast<u32>(select(0i, _e765, (_e765 > 0i)))];
let _e772 = (_e753 - _e394.member.x);
let _e773 = (_e762 - _e394.member.y);
let _e774 = (_e771 - _e394.member.z);
let _e780 = select(select(_e774, _e773, _e692), _e772, _e689);
let _e782 = (select(select(_e772, _e774, _e692), _e773, _e689) - (_e700 * _e780));
let _e784 = (select(select(_e773, _e772, _e692), _e774, _e689) - (_e701 * _e780));
let _e786 = (_e702 + 6i);
let _e788 = select(_e704, _e786, (_e786 < _e704));
let _e794 = global_3.member[bitcast<u32>(select(0i, _e788, (_e788 > 0i)))];
let _e795 = (_e702 + 7i);
let _e797 = select(_e704, _e795, (_e795 < _e704));
let _e803 = global_3.member[bitcast<u32>(select(0i, _e797, (_e797 > 0i)))];
let _e804 = (_e702 + 8i);
let _e806 = select(_e704, _e804, (_e804 < _e704));
let _e812 = global_3.member[bitcast<u32>(select(0i, _e806, (_e806 > 0i)))];
let _e813 = (_e794 - _e394.member.x);
let _e814 = (_e803 - _e394.member.y);
let _e815 = (_e812 - _e394.member.z);
let _e821 = select(select(_e815, _e814, _e692), _e813, _e689);
let _e823 = (select(select(_e813, _e815, _e692), _e814, _e689) - (_e700 * _e821));
let _e825 = (select(select(_e814, _e813, _e692), _e815, _e689) - (_e701 * _e821));
let _e829 = ((_e823 * _e784) - (_e825 * _e782));
let _e832 = ((_e741 * _e825) - (_e743 * _e823));
let _e835 = ((_e782 * _e743) - (_e784 * _e741));
let _e837 = ((_e829 + _e832) + _e835);
let _e851 = (!(((((_e829 < 0f) || (_e832 < 0f)) || (_e835 < 0f)) && (((_e829 > 0f) || (_e832 > 0f)) || (_e835 > 0f)))) && (_e837 != 0f));
let _e858 = ((((_e829 * (_e739 * _e699)) + (_e832 * (_e780 * _e699))) + (_e835 * (_e821 * _e699))) / select(1f, _e837, _e851));
let _e861 = select(1e30f, _e858, (_e851 && (_e858 > 1e-3f)));
if (_e861 < _e394.member_14) {
let _e877 = type_11(_e394.member, _e394.member_1, _e394.member_2, _e394.member_3, _e394.member_4, _e394.member_5, _e394.member_6, _e394.member_7, _e394.member_8, _e394.member_9, _e394.member_10, _e394.member_11, _e394.member_12, _e394.member_13, _e861);
phi_1444_ = type_11(_e877.member, _e877.member_1, _e877.member_2, _e877.member_3, _e877.member_4, _e877.member_5, _e877.member_6, _e877.member_7, _e877.member_8, _e877.member_9, _e877.member_10, _e877.member_11, _e877.member_12, _e684, _e877.member_14);
} else {
phi_1444_ = _e394;
}
let _e894 = phi_1444_;
phi_1445_ = _e894;
} else {
phi_1445_ = _e394;
}
let _e896 = phi_1445_;
if _e668 {
phi_1477_ = (_e896.member_12 + 1i);
} else {
let _e897 = (_e545 + 7i);
let _e899 = select(_e574, _e897, (_e897 < _e574));
let _e905 = global_2.member[bitcast<u32>(select(0i, _e899, (_e899 > 0i)))];
phi_1477_ = select(0i, select(select(i32(_e905), i32(-2147483648), (_e905 < -2147483600f)), 2147483647i, (_e905 > 2147483500f)), (_e905 == _e905));
}
let _e916 = phi_1477_;
phi_1782_ = type_11(_e896.member, _e896.member_1, _e896.member_2, _e896.member_3, _e896.member_4, _e896.member_5, _e896.member_6, _e896.member_7, _e896.member_8, _e896.member_9, _e896.member_10, _e896.member_11, _e916, _e896.member_13, _e896.member_14);
} else {
if ((_e363 == 0u) && (_e394.member_8 >= 2f)) {
if (_e394.member_13 == -1i) {
phi_1779_ = type_11(_e394.member, _e394.member_1, _e394.member_2, _e394.member_3, _e394.member_4, _e394.member_5, 1f, _e394.member_7, _e394.member_8, _e394.member_9, _e394.member_10, _e394.member_11, _e394.member_12, _e394.member_13, _e394.member_14);
} else {
let _e457 = type_11(vec3<f32>((_e394.member.x + (_e394.member_1.x * _e394.member_14)), (_e394.member.y + (_e394.member_1.y * _e394.member_14)), (_e394.member.z + (_e394.member_1.z * _e394.member_14))), _e394.member_1, _e394.member_2, _e394.member_3, _e394.member_4, _e394.member_5, _e394.member_6, _e394.member_7, _e394.member_8, _e394.member_9, _e394.member_10, _e394.member_11, _e394.member_12, _e394.member_13, _e394.member_14);
let _e474 = type_11(_e457.member, _e457.member_1, _e457.member_2, _e457.member_3, _e457.member_4, (_e394.member_5 + _e394.member_14), _e457.member_6, _e457.member_7, _e457.member_8, _e457.member_9, _e457.member_10, _e457.member_11, _e457.member_12, _e457.member_13, _e457.member_14);
let _e490 = type_11(_e474.member, _e474.member_1, _e474.member_2, _e474.member_3, _e474.member_4, _e474.member_5, _e474.member_6, _e474.member_7, _e474.member_8, _e474.member_9, _e474.member_10, _e474.member_11, _e474.member_12, _e474.member_13, (_e394.member_14 - _e394.member_14));
let _e509 = type_11(_e490.member, _e490.member_1, _e490.member_2, _e490.member_3, _e490.member_4, _e490.member_5, _e490.member_6, _e490.member_7, _e490.member_8, _e490.member_9, (_e394.member_10 + select(0f, _e394.member_14, (_e394.member_8 == 0f))), _e490.member_11, _e490.member_12, _e490.member_13, _e490.member_14);
phi_1779_ = type_11(_e509.member, _e509.member_1, _e509.member_2, _e509.member_3, _e509.member_4, _e509.member_5, 3f, _e509.member_7, _e509.member_8, _e509.member_9, _e509.member_10, _e509.member_11, _e509.member_12, _e509.member_13, _e509.member_14);
}
let _e541 = phi_1779_;
phi_1781_ = _e541;
} else {
phi_1781_ = type_11(_e394.member, _e394.member_1, _e394.member_2, _e394.member_3, _e394.member_4, _e394.member_5, 0f, _e394.member_7, _e394.member_8, _e394.member_9, _e394.member_10, _e394.member_11, _e394.member_12, _e394.member_13, _e394.member_14);
}
let _e543 = phi_1781_;
phi_1782_ = _e543;
}
let _e933 = phi_1782_;
phi_819_ = _e933;
phi_822_ = (_e396 + 1i);
} else {
phi_819_ = type_11();
phi_822_ = i32();
}
let _e935 = phi_819_;
let _e937 = phi_822_;
continue;
continuing {
phi_818_ = _e935;
phi_821_ = _e937;
break if !(_e400);
}
}
let _e940 = local;
let _e944 = local_1;
let _e948 = local_2;
let _e952 = local_3;
let _e956 = local_4;
let _e960 = local_5;
let _e964 = local_6;
let _e968 = local_7;
let _e972 = local_8;
let _e976 = local_9;
let _e980 = local_10;
let _e984 = local_11;
let _e988 = local_12;
let _e992 = local_13;
let _e996 = local_14;
let _e1000 = local_15;
let _e1003 = local_16;
let _e1007 = local_17;
let _e1010 = local_18;
let _e1013 = local_19;
let _e1016 = local_20;
let _e1019 = local_21;
let _e1023 = local_22;
let _e1027 = local_23;
global_4.member[_e79] = _e940.member.x;
global_4.member[_e91] = _e944.member.y;
global_4.member[_e102] = _e948.member.z;
global_4.member[_e113] = _e952.member_1.x;
global_4.member[_e124] = _e956.member_1.y;
global_4.member[_e135] = _e960.member_1.z;
global_4.member[_e146] = _e964.member_2.x;
global_4.member[_e157] = _e968.member_2.y;
global_4.member[_e168] = _e972.member_2.z;
global_4.member[_e179] = _e976.member_3.x;
global_4.member[_e190] = _e980.member_3.y;
global_4.member[_e201] = _e984.member_3.z;
global_4.member[_e212] = _e988.member_4.x;
global_4.member[_e223] = _e992.member_4.y;
global_4.member[_e234] = _e996.member_4.z;
global_4.member[_e245] = _e1000.member_5;
let _e1064 = local_24;
global_4.member[_e256] = _e1064;
global_4.member[_e267] = f32(_e1003.member_7);
global_4.member[_e278] = _e1007.member_8;
global_4.member[_e289] = _e1010.member_9;
global_4.member[_e300] = _e1013.member_10;
global_4.member[_e311] = _e1016.member_11;
global_4.member[_e322] = f32(_e1019.member_12);
global_4.member[_e333] = f32(_e1023.member_13);
global_4.member[_e344] = _e1027.member_14;
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
