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
member_12: vec3<f32>,
member_13: i32,
member_14: i32,
member_15: f32,
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
var phi_671_: u32;
var phi_727_: type_19;
var phi_730_: i32;
var phi_1688_: type_19;
var phi_1690_: type_19;
var phi_1353_: type_19;
var phi_1354_: type_19;
var phi_1386_: i32;
var phi_1691_: type_19;
var phi_728_: type_19;
var phi_731_: i32;
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
var local_24: type_19;
var local_25: type_19;
var local_26: type_19;
var local_27: f32;
let _e61 = global;
let _e70 = global_1.member.member;
if (_e61.x < _e70.member) {
if (_e61.y < _e70.member_1) {
let _e77 = (_e70.member * _e70.member_1);
let _e79 = ((_e61.y * _e70.member) + _e61.x);
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
let _e355 = ((25u * _e77) + _e79);
let _e356 = bitcast<i32>(_e355);
let _e358 = select(_e82, _e356, (_e356 < _e82));
let _e364 = global_4.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e366 = ((26u * _e77) + _e79);
let _e367 = bitcast<i32>(_e366);
let _e369 = select(_e82, _e367, (_e367 < _e82));
let _e375 = global_4.member[bitcast<u32>(select(0i, _e369, (_e369 > 0i)))];
let _e377 = ((27u * _e77) + _e79);
let _e378 = bitcast<i32>(_e377);
let _e380 = select(_e82, _e378, (_e378 < _e82));
let _e386 = global_4.member[bitcast<u32>(select(0i, _e380, (_e380 > 0i)))];
if (_e265 == 4f) {
phi_671_ = 3u;
} else {
phi_671_ = select(0u, 1u, (_e265 == 0f));
}
let _e391 = phi_671_;
if (_e391 > 1u) {
let _e422 = bitcast<i32>(arrayLength((&global_2.member)));
phi_727_ = type_19(vec3<f32>(_e90, _e100, _e111), vec3<f32>(_e122, _e133, _e144), vec3<f32>(_e155, _e166, _e177), vec3<f32>(_e188, _e199, _e210), vec3<f32>(_e221, _e232, _e243), _e254, _e265, select(0i, select(select(i32(_e276), i32(-2147483648), (_e276 < -2147483600f)), 2147483647i, (_e276 > 2147483500f)), (_e276 == _e276)), _e287, _e298, _e309, _e320, vec3<f32>(_e331, _e342, _e353), select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < -2147483600f)), 2147483647i, (_e364 > 2147483500f)), (_e364 == _e364)), select(0i, select(select(i32(_e375), i32(-2147483648), (_e375 < -2147483600f)), 2147483647i, (_e375 > 2147483500f)), (_e375 == _e375)), _e386);
phi_730_ = 0i;
loop {
let _e425 = phi_727_;
let _e427 = phi_730_;
local = _e425;
local_1 = _e425;
local_2 = _e425;
local_3 = _e425;
local_4 = _e425;
local_5 = _e425;
local_6 = _e425;
local_7 = _e425;
local_8 = _e425;
local_9 = _e425;
local_10 = _e425;
local_11 = _e425;
local_12 = _e425;
local_13 = _e425;
local_14 = _e425;
local_15 = _e425;
local_16 = _e425;
local_17 = _e425;
local_18 = _e425;
local_19 = _e425;
local_20 = _e425;
local_21 = _e425;
local_22 = _e425;
local_23 = _e425;
local_24 = _e425;
local_25 = _e425;
local_26 = _e425;
let _e431 = ((_e427 < 1024i) && (_e425.member_6 == 4f));
local_27 = _e425.member_6;
if _e431 {
if (_e425.member_13 < (_e422 / 8i)) {
let _e583 = (_e425.member_13 * 8i);
let _e587 = bitcast<f32>((bitcast<u32>(_e425.member_1.x) & 2147483647u));
let _e592 = (1f / select(_e425.member_1.x, select(1e-12f, -1e-12f, (_e425.member_1.x < 0f)), (_e587 < 1e-12f)));
let _e596 = bitcast<f32>((bitcast<u32>(_e425.member_1.y) & 2147483647u));
let _e601 = (1f / select(_e425.member_1.y, select(1e-12f, -1e-12f, (_e425.member_1.y < 0f)), (_e596 < 1e-12f)));
let _e605 = bitcast<f32>((bitcast<u32>(_e425.member_1.z) & 2147483647u));
let _e610 = (1f / select(_e425.member_1.z, select(1e-12f, -1e-12f, (_e425.member_1.z < 0f)), (_e605 < 1e-12f)));
let _e612 = (_e422 - 1i);
let _e614 = select(_e612, _e583, (_e583 < _e612));
let _e620 = global_2.member[bitcast<u32>(select(0i, _e614, (_e614 > 0i)))];
let _e621 = (_e583 + 1i);
let _e623 = select(_e612, _e621, (_e621 < _e612));
let _e629 = global_2.member[bitcast<u32>(select(0i, _e623, (_e623 > 0i)))];
let _e630 = (_e583 + 2i);
let _e632 = select(_e612, _e630, (_e630 < _e612));
let _e638 = global_2.member[bitcast<u32>(select(0i, _e632, (_e632 > 0i)))];
let _e639 = (_e583 + 3i);
let _e641 = select(_e612, _e639, (_e639 < _e612));
let _e647 = global_2.member[bitcast<u32>(select(0i, _e641, (_e641 > 0i)))];
let _e648 = (_e583 + 4i);
let _e650 = select(_e612, _e648, (_e648 < _e612));
let _e656 = global_2.member[bitcast<u32>(select(0i, _e650, (_e650 > 0i)))];
let _e657 = (_e583 + 5i);
let _e659 = select(_e612, _e657, (_e657 < _e612));
let _e665 = global_2.member[bitcast<u32>(select(0i, _e659, (_e659 > 0i)))];
let _e668 = ((_e620 - _e425.member.x) * _e592);
let _e670 = ((_e647 - _e425.member.x) * _e592);
let _e673 = ((_e629 - _e425.member.y) * _e601);
let _e675 = ((_e656 - _e425.member.y) * _e601);
let _e678 = ((_e638 - _e425.member.z) * _e610);
let _e680 = ((_e665 - _e425.member.z) * _e610);
let _e682 = select(_e670, _e668, (_e668 < _e670));
let _e684 = select(_e675, _e673, (_e673 < _e675));
let _e686 = select(_e684, _e682, (_e682 > _e684));
let _e688 = select(_e680, _e678, (_e678 < _e680));
let _e692 = select(_e670, _e668, (_e668 > _e670));
let _e694 = select(_e675, _e673, (_e673 > _e675));
let _e696 = select(_e694, _e692, (_e692 < _e694));
let _e698 = select(_e680, _e678, (_e678 > _e680));
let _e700 = select(_e698, _e696, (_e696 < _e698));
let _e706 = ((select(_e688, _e686, (_e686 > _e688)) <= select(_e425.member_15, _e700, (_e700 < _e425.member_15))) && (_e700 >= 0f));
let _e707 = (_e583 + 6i);
let _e709 = select(_e612, _e707, (_e707 < _e612));
let _e715 = global_2.member[bitcast<u32>(select(0i, _e709, (_e709 > 0i)))];
let _e722 = select(0i, select(select(i32(_e715), i32(-2147483648), (_e715 < -2147483600f)), 2147483647i, (_e715 > 2147483500f)), (_e715 == _e715));
if (_e706 && (_e722 >= 0i)) {
let _e727 = ((_e587 >= _e596) && (_e587 >= _e605));
let _e730 = (!(_e727) && (_e596 >= _e605));
let _e737 = (1f / select(select(_e425.member_1.z, _e425.member_1.y, _e730), _e425.member_1.x, _e727));
let _e738 = (select(select(_e425.member_1.x, _e425.member_1.z, _e730), _e425.member_1.y, _e727) * _e737);
let _e739 = (select(select(_e425.member_1.y, _e425.member_1.x, _e730), _e425.member_1.z, _e727) * _e737);
let _e740 = (_e722 * 19i);
let _e742 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e744 = select(_e742, _e740, (_e740 < _e742));
let _e750 = global_3.member[bitcast<u32>(select(0i, _e744, (_e744 > 0i)))];
let _e751 = (_e740 + 1i);
let _e753 = select(_e742, _e751, (_e751 < _e742));
let _e759 = global_3.member[bitcast<u32>(select(0i, _e753, (_e753 > 0i)))];
let _e760 = (_e740 + 2i);
let _e762 = select(_e742, _e760, (_e760 < _e742));
let _e768 = global_3.member[bitcast<u32>(select(0i, _e762, (_e762 > 0i)))];
let _e769 = (_e750 - _e425.member.x);
let _e770 = (_e759 - _e425.member.y);
let _e771 = (_e768 - _e425.member.z);
let _e777 = select(select(_e771, _e770, _e730), _e769, _e727);
let _e779 = (select(select(_e769, _e771, _e730), _e770, _e727) - (_e738 * _e777));
let _e781 = (select(select(_e770, _e769, _e730), _e771, _e727) - (_e739 * _e777));
let _e783 = (_e740 + 3i);
let _e785 = select(_e742, _e783, (_e783 < _e742));
let _e791 = global_3.member[bitcast<u32>(select(0i, _e785, (_e785 > 0i)))];
let _e792 = (_e740 + 4i);
let _e794 = select(_e742, _e792, (_e792 < _e742));
let _e800 = global_3.member[bitcast<u32>(select(0i, _e794, (_e794 > 0i)))];
let _e801 = (_e740 + 5i);
let _e803 = select(_e742, _e801, (_e801 < _e742));
let _e809 = global_3.member[bitcast<u32>(select(0i, _e803, (_e803 > 0i)))];
let _e810 = (_e791 - _e425.member.x);
let _e811 = (_e800 - _e425.member.y);
let _e812 = (_e809 - _e425.member.z);
let _e818 = select(select(_e812, _e811, _e730), _e810, _e727);
let _e820 = (select(select(_e810, _e812, _e730), _e811, _e727) - (_e738 * _e818));
let _e822 = (select(select(_e811, _e810, _e730), _e812, _e727) - (_e739 * _e818));
let _e824 = (_e740 + 6i);
let _e826 = select(_e742, _e824, (_e824 < _e742));
let _e832 = global_3.member[bitcast<u32>(select(0i, _e826, (_e826 > 0i)))];
let _e833 = (_e740 + 7i);
let _e835 = select(_e742, _e833, (_e833 < _e742));
let _e841 = global_3.member[bitcast<u32>(select(0i, _e835, (_e835 > 0i)))];
let _e842 = (_e740 + 8i);
let _e844 = select(_e742, _e842, (_e842 < _e742));
let _e850 = global_3.member[bitcast<u32>(select(0i, _e844, (_e844 > 0i)))];
let _e851 = (_e832 - _e425.member.x);
let _e852 = (_e841 - _e425.member.y);
let _e853 = (_e850 - _e425.member.z);
let _e859 = select(select(_e853, _e852, _e730), _e851, _e727);
let _e861 = (select(select(_e851, _e853, _e730), _e852, _e727) - (_e738 * _e859));
let _e863 = (select(select(_e852, _e851, _e730), _e853, _e727) - (_e739 * _e859));
let _e867 = ((_e861 * _e822) - (_e863 * _e820));
let _e870 = ((_e779 * _e863) - (_e781 * _e861));
let _e873 = ((_e820 * _e781) - (_e822 * _e779));
let _e875 = ((_e867 + _e870) + _e873);
let _e889 = (!(((((_e867 < 0f) || (_e870 < 0f)) || (_e873 < 0f)) && (((_e867 > 0f) || (_e870 > 0f)) || (_e873 > 0f)))) && (_e875 != 0f));
let _e896 = ((((_e867 * (_e777 * _e737)) + (_e870 * (_e818 * _e737))) + (_e873 * (_e859 * _e737))) / select(1f, _e875, _e889));
let _e899 = select(1e30f, _e896, (_e889 && (_e896 > 1e-3f)));
if (_e899 < _e425.member_15) {
let _e916 = type_19(_e425.member, _e425.member_1, _e425.member_2, _e425.member_3, _e425.member_4, _e425.member_5, _e425.member_6, _e425.member_7, _e425.member_8, _e425.member_9, _e425.member_10, _e425.member_11, _e425.member_12, _e425.member_13, _e425.member_14, _e899);
phi_1353_ = type_19(_e916.member, _e916.member_1, _e916.member_2, _e916.member_3, _e916.member_4, _e916.member_5, _e916.member_6, _e916.member_7, _e916.member_8, _e916.member_9, _e916.member_10, _e916.member_11, _e916.member_12, _e916.member_13, _e722, _e916.member_15);
} else {
phi_1353_ = _e425;
}
let _e934 = phi_1353_;
phi_1354_ = _e934;
} else {
phi_1354_ = _e425;
}
let _e936 = phi_1354_;
if _e706 {
phi_1386_ = (_e936.member_13 + 1i);
} else {
let _e937 = (_e583 + 7i);
let _e939 = select(_e612, _e937, (_e937 < _e612));
let _e945 = global_2.member[bitcast<u32>(select(0i, _e939, (_e939 > 0i)))];
phi_1386_ = select(0i, select(select(i32(_e945), i32(-2147483648), (_e945 < -2147483600f)), 2147483647i, (_e945 > 2147483500f)), (_e945 == _e945));
}
let _e956 = phi_1386_;
phi_1691_ = type_19(_e936.member, _e936.member_1, _e936.member_2, _e936.member_3, _e936.member_4, _e936.member_5, _e936.member_6, _e936.member_7, _e936.member_8, _e936.member_9, _e936.member_10, _e936.member_11, _e936.member_12, _e956, _e936.member_14, _e936.member_15);
} else {
if ((_e70.member_2 == 0u) && (_e425.member_8 >= 2f)) {
if (_e425.member_14 == -1i) {
phi_1688_ = type_19(_e425.member, _e425.member_1, _e425.member_2, _e425.member_3, _e425.member_4, _e425.member_5, 1f, _e425.member_7, _e425.member_8, _e425.member_9, _e425.member_10, _e425.member_11, _e425.member_12, _e425.member_13, _e425.member_14, _e425.member_15);
} else {
let _e490 = type_19(vec3<f32>((_e425.member.x + (_e425.member_1.x * _e425.member_15)), (_e425.member.y + (_e425.member_1.y * _e425.member_15)), (_e425.member.z + (_e425.member_1.z * _e425.member_15))), _e425.member_1, _e425.member_2, _e425.member_3, _e425.member_4, _e425.member_5, _e425.member_6, _e425.member_7, _e425.member_8, _e425.member_9, _e425.member_10, _e425.member_11, _e425.member_12, _e425.member_13, _e425.member_14, _e425.member_15);
let _e508 = type_19(_e490.member, _e490.member_1, _e490.member_2, _e490.member_3, _e490.member_4, (_e425.member_5 + _e425.member_15), _e490.member_6, _e490.member_7, _e490.member_8, _e490.member_9, _e490.member_10, _e490.member_11, _e490.member_12, _e490.member_13, _e490.member_14, _e490.member_15);
let _e525 = type_19(_e508.member, _e508.member_1, _e508.member_2, _e508.member_3, _e508.member_4, _e508.member_5, _e508.member_6, _e508.member_7, _e508.member_8, _e508.member_9, _e508.member_10, _e508.member_11, _e508.member_12, _e508.member_13, _e508.member_14, (_e425.member_15 - _e425.member_15));
let _e545 = type_19(_e525.member, _e525.member_1, _e525.member_2, _e525.member_3, _e525.member_4, _e525.member_5, _e525.member_6, _e525.member_7, _e525.member_8, _e525.member_9, (_e425.member_10 + select(0f, _e425.member_15, (_e425.member_8 == 0f))), _e525.member_11, _e525.member_12, _e525.member_13, _e525.member_14, _e525.member_15);
phi_1688_ = type_19(_e545.member, _e545.member_1, _e545.member_2, _e545.member_3, _e545.member_4, _e545.member_5, 3f, _e545.member_7, _e545.member_8, _e545.member_9, _e545.member_10, _e545.member_11, _e545.member_12, _e545.member_13, _e545.member_14, _e545.member_15);
}
let _e579 = phi_1688_;
phi_1690_ = _e579;
} else {
phi_1690_ = type_19(_e425.member, _e425.member_1, _e425.member_2, _e425.member_3, _e425.member_4, _e425.member_5, 0f, _e425.member_7, _e425.member_8, _e425.member_9, _e425.member_10, _e425.member_11, _e425.member_12, _e425.member_13, _e425.member_14, _e425.member_15);
}
let _e581 = phi_1690_;
phi_1691_ = _e581;
}
let _e974 = phi_1691_;
phi_728_ = _e974;
phi_731_ = (_e427 + 1i);
} else {
phi_728_ = type_19();
phi_731_ = i32();
}
let _e976 = phi_728_;
let _e978 = phi_731_;
continue;
continuing {
phi_727_ = _e976;
phi_730_ = _e978;
break if !(_e431);
}
}
let _e981 = local;
let _e985 = local_1;
let _e989 = local_2;
let _e993 = local_3;
let _e997 = local_4;
let _e1001 = local_5;
let _e1005 = local_6;
let _e1009 = local_7;
let _e1013 = local_8;
let _e1017 = local_9;
let _e1021 = local_10;
let _e1025 = local_11;
let _e1029 = local_12;
let _e1033 = local_13;
let _e1037 = local_14;
let _e1041 = local_15;
let _e1044 = local_16;
let _e1048 = local_17;
let _e1051 = local_18;
let _e1054 = local_19;
let _e1057 = local_20;
let _e1060 = local_21;
let _e1064 = local_22;
let _e1068 = local_23;
let _e1072 = local_24;
let _e1076 = local_25;
let _e1080 = local_26;
global_4.member[_e79] = _e981.member.x;
global_4.member[_e91] = _e985.member.y;
global_4.member[_e102] = _e989.member.z;
global_4.member[_e113] = _e993.member_1.x;
global_4.member[_e124] = _e997.member_1.y;
global_4.member[_e135] = _e1001.member_1.z;
global_4.member[_e146] = _e1005.member_2.x;
global_4.member[_e157] = _e1009.member_2.y;
global_4.member[_e168] = _e1013.member_2.z;
global_4.member[_e179] = _e1017.member_3.x;
global_4.member[_e190] = _e1021.member_3.y;
global_4.member[_e201] = _e1025.member_3.z;
global_4.member[_e212] = _e1029.member_4.x;
global_4.member[_e223] = _e1033.member_4.y;
global_4.member[_e234] = _e1037.member_4.z;
global_4.member[_e245] = _e1041.member_5;
let _e1117 = local_27;
global_4.member[_e256] = _e1117;
global_4.member[_e267] = f32(_e1044.member_7);
global_4.member[_e278] = _e1048.member_8;
global_4.member[_e289] = _e1051.member_9;
global_4.member[_e300] = _e1054.member_10;
global_4.member[_e311] = _e1057.member_11;
global_4.member[_e322] = _e1060.member_12.x;
global_4.member[_e333] = _e1064.member_12.y;
global_4.member[_e344] = _e1068.member_12.z;
global_4.member[_e355] = f32(_e1072.member_13);
global_4.member[_e366] = f32(_e1076.member_14);
global_4.member[_e377] = _e1080.member_15;
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
