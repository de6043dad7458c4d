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
member_10: f32,
member_11: u32,
member_12: u32,
member_13: u32,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_15 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_16 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_17 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_14,
member_18: type_15,
member_19: type_5,
member_20: type_16,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_18 {
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
member_20: type_12,
member_21: type_13,
member_22: type_17,
}
struct type_19 {
member: type_18,
}
struct type_21 {
member: array<f32>,
}
struct type_24 {
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
member_13: vec3<f32>,
member_14: i32,
member_15: i32,
member_16: i32,
member_17: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_19;
@group(0) @binding(1)
var<storage> global_2: type_21;
@group(0) @binding(2)
var<storage> global_3: type_21;
@group(0) @binding(4)
var<storage, read_write> global_4: type_21;
fn function_() {
var phi_755_: u32;
var phi_821_: type_24;
var phi_824_: i32;
var phi_1821_: type_24;
var phi_1823_: type_24;
var phi_1119_: i32;
var phi_1486_: type_24;
var phi_1487_: type_24;
var phi_1824_: type_24;
var phi_822_: type_24;
var phi_825_: i32;
var local: type_24;
var local_1: type_24;
var local_2: type_24;
var local_3: type_24;
var local_4: type_24;
var local_5: type_24;
var local_6: type_24;
var local_7: type_24;
var local_8: type_24;
var local_9: type_24;
var local_10: type_24;
var local_11: type_24;
var local_12: type_24;
var local_13: type_24;
var local_14: type_24;
var local_15: type_24;
var local_16: type_24;
var local_17: type_24;
var local_18: type_24;
var local_19: type_24;
var local_20: type_24;
var local_21: type_24;
var local_22: type_24;
var local_23: type_24;
var local_24: type_24;
var local_25: type_24;
var local_26: type_24;
var local_27: type_24;
var local_28: type_24;
var local_29: type_24;
var local_30: type_24;
var local_31: f32;
let _e67 = global;
let _e76 = global_1.member.member;
if (_e67.x < _e76.member) {
if (_e67.y < _e76.member_1) {
let _e83 = (_e76.member * _e76.member_1);
let _e85 = ((_e67.y * _e76.member) + _e67.x);
let _e86 = bitcast<i32>(_e85);
let _e88 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e90 = select(_e88, _e86, (_e86 < _e88));
let _e96 = global_4.member[bitcast<u32>(select(0i, _e90, (_e90 > 0i)))];
let _e97 = (_e83 + _e85);
let _e98 = bitcast<i32>(_e97);
let _e100 = select(_e88, _e98, (_e98 < _e88));
let _e106 = global_4.member[bitcast<u32>(select(0i, _e100, (_e100 > 0i)))];
let _e108 = ((2u * _e83) + _e85);
let _e109 = bitcast<i32>(_e108);
let _e111 = select(_e88, _e109, (_e109 < _e88));
let _e117 = global_4.member[bitcast<u32>(select(0i, _e111, (_e111 > 0i)))];
let _e119 = ((3u * _e83) + _e85);
let _e120 = bitcast<i32>(_e119);
let _e122 = select(_e88, _e120, (_e120 < _e88));
let _e128 = global_4.member[bitcast<u32>(select(0i, _e122, (_e122 > 0i)))];
let _e130 = ((4u * _e83) + _e85);
let _e131 = bitcast<i32>(_e130);
let _e133 = select(_e88, _e131, (_e131 < _e88));
let _e139 = global_4.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e141 = ((5u * _e83) + _e85);
let _e142 = bitcast<i32>(_e141);
let _e144 = select(_e88, _e142, (_e142 < _e88));
let _e150 = global_4.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((6u * _e83) + _e85);
let _e153 = bitcast<i32>(_e152);
let _e155 = select(_e88, _e153, (_e153 < _e88));
let _e161 = global_4.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e163 = ((7u * _e83) + _e85);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e88, _e164, (_e164 < _e88));
let _e172 = global_4.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((8u * _e83) + _e85);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e88, _e175, (_e175 < _e88));
let _e183 = global_4.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((9u * _e83) + _e85);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e88, _e186, (_e186 < _e88));
let _e194 = global_4.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((10u * _e83) + _e85);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e88, _e197, (_e197 < _e88));
let _e205 = global_4.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((11u * _e83) + _e85);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e88, _e208, (_e208 < _e88));
let _e216 = global_4.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e218 = ((12u * _e83) + _e85);
let _e219 = bitcast<i32>(_e218);
let _e221 = select(_e88, _e219, (_e219 < _e88));
let _e227 = global_4.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e229 = ((13u * _e83) + _e85);
let _e230 = bitcast<i32>(_e229);
let _e232 = select(_e88, _e230, (_e230 < _e88));
let _e238 = global_4.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e240 = ((14u * _e83) + _e85);
let _e241 = bitcast<i32>(_e240);
let _e243 = select(_e88, _e241, (_e241 < _e88));
let _e249 = global_4.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
let _e251 = ((15u * _e83) + _e85);
let _e252 = bitcast<i32>(_e251);
let _e254 = select(_e88, _e252, (_e252 < _e88));
let _e260 = global_4.member[bitcast<u32>(select(0i, _e254, (_e254 > 0i)))];
let _e262 = ((16u * _e83) + _e85);
let _e263 = bitcast<i32>(_e262);
let _e265 = select(_e88, _e263, (_e263 < _e88));
let _e271 = global_4.member[bitcast<u32>(select(0i, _e265, (_e265 > 0i)))];
let _e273 = ((17u * _e83) + _e85);
let _e274 = bitcast<i32>(_e273);
let _e276 = select(_e88, _e274, (_e274 < _e88));
let _e282 = global_4.member[bitcast<u32>(select(0i, _e276, (_e276 > 0i)))];
let _e284 = ((18u * _e83) + _e85);
let _e285 = bitcast<i32>(_e284);
let _e287 = select(_e88, _e285, (_e285 < _e88));
let _e293 = global_4.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e295 = ((19u * _e83) + _e85);
let _e296 = bitcast<i32>(_e295);
let _e298 = select(_e88, _e296, (_e296 < _e88));
let _e304 = global_4.member[bitcast<u32>(select(0i, _e298, (_e298 > 0i)))];
let _e306 = ((20u * _e83) + _e85);
let _e307 = bitcast<i32>(_e306);
let _e309 = select(_e88, _e307, (_e307 < _e88));
let _e315 = global_4.member[bitcast<u32>(select(0i, _e309, (_e309 > 0i)))];
let _e317 = ((21u * _e83) + _e85);
let _e318 = bitcast<i32>(_e317);
let _e320 = select(_e88, _e318, (_e318 < _e88));
let _e326 = global_4.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e328 = ((22u * _e83) + _e85);
let _e329 = bitcast<i32>(_e328);
let _e331 = select(_e88, _e329, (_e329 < _e88));
let _e337 = global_4.member[bitcast<u32>(select(0i, _e331, (_e331 > 0i)))];
let _e339 = ((23u * _e83) + _e85);
let _e340 = bitcast<i32>(_e339);
let _e342 = select(_e88, _e340, (_e340 < _e88));
let _e348 = global_4.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e350 = ((24u * _e83) + _e85);
let _e351 = bitcast<i32>(_e350);
let _e353 = select(_e88, _e351, (_e351 < _e88));
let _e359 = global_4.member[bitcast<u32>(select(0i, _e353, (_e353 > 0i)))];
let _e361 = ((25u * _e83) + _e85);
let _e362 = bitcast<i32>(_e361);
let _e364 = select(_e88, _e362, (_e362 < _e88));
let _e370 = global_4.member[bitcast<u32>(select(0i, _e364, (_e364 > 0i)))];
let _e372 = ((26u * _e83) + _e85);
let _e373 = bitcast<i32>(_e372);
let _e375 = select(_e88, _e373, (_e373 < _e88));
let _e381 = global_4.member[bitcast<u32>(select(0i, _e375, (_e375 > 0i)))];
let _e383 = ((27u * _e83) + _e85);
let _e384 = bitcast<i32>(_e383);
let _e386 = select(_e88, _e384, (_e384 < _e88));
let _e392 = global_4.member[bitcast<u32>(select(0i, _e386, (_e386 > 0i)))];
let _e394 = ((28u * _e83) + _e85);
let _e395 = bitcast<i32>(_e394);
let _e397 = select(_e88, _e395, (_e395 < _e88));
let _e403 = global_4.member[bitcast<u32>(select(0i, _e397, (_e397 > 0i)))];
let _e405 = ((29u * _e83) + _e85);
let _e406 = bitcast<i32>(_e405);
let _e408 = select(_e88, _e406, (_e406 < _e88));
let _e414 = global_4.member[bitcast<u32>(select(0i, _e408, (_e408 > 0i)))];
let _e416 = ((30u * _e83) + _e85);
let _e417 = bitcast<i32>(_e416);
let _e419 = select(_e88, _e417, (_e417 < _e88));
let _e425 = global_4.member[bitcast<u32>(select(0i, _e419, (_e419 > 0i)))];
let _e427 = ((31u * _e83) + _e85);
let _e428 = bitcast<i32>(_e427);
let _e430 = select(_e88, _e428, (_e428 < _e88));
let _e436 = global_4.member[bitcast<u32>(select(0i, _e430, (_e430 > 0i)))];
if (_e271 == 4f) {
phi_755_ = 3u;
} else {
phi_755_ = select(0u, 1u, (_e271 == 0f));
}
let _e441 = phi_755_;
if (_e441 > 1u) {
let _e480 = bitcast<i32>(arrayLength((&global_2.member)));
phi_821_ = type_24(vec3<f32>(_e96, _e106, _e117), vec3<f32>(_e128, _e139, _e150), vec3<f32>(_e161, _e172, _e183), vec3<f32>(_e194, _e205, _e216), vec3<f32>(_e227, _e238, _e249), _e260, _e271, select(0i, select(select(i32(_e282), i32(-2147483648), (_e282 < -2147483600f)), 2147483647i, (_e282 > 2147483500f)), (_e282 == _e282)), _e293, _e304, _e315, _e326, vec3<f32>(_e337, _e348, _e359), vec3<f32>(_e370, _e381, _e392), select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < -2147483600f)), 2147483647i, (_e403 > 2147483500f)), (_e403 == _e403)), select(0i, select(select(i32(_e414), i32(-2147483648), (_e414 < -2147483600f)), 2147483647i, (_e414 > 2147483500f)), (_e414 == _e414)), select(0i, select(select(i32(_e425), i32(-2147483648), (_e425 < -2147483600f)), 2147483647i, (_e425 > 2147483500f)), (_e425 == _e425)), _e436);
phi_824_ = 0i;
loop {
let _e483 = phi_821_;
let _e485 = phi_824_;
local = _e483;
local_1 = _e483;
local_2 = _e483;
local_3 = _e483;
local_4 = _e483;
local_5 = _e483;
local_6 = _e483;
local_7 = _e483;
local_8 = _e483;
local_9 = _e483;
local_10 = _e483;
local_11 = _e483;
local_12 = _e483;
local_13 = _e483;
local_14 = _e483;
local_15 = _e483;
local_16 = _e483;
local_17 = _e483;
local_18 = _e483;
local_19 = _e483;
local_20 = _e483;
local_21 = _e483;
local_22 = _e483;
local_23 = _e483;
local_24 = _e483;
local_25 = _e483;
local_26 = _e483;
local_27 = _e483;
local_28 = _e483;
local_29 = _e483;
local_30 = _e483;
let _e489 = ((_e485 < 1024i) && (_e483.member_6 == 4f));
local_31 = _e483.member_6;
if _e489 {
if (_e483.member_15 < (_e480 / 8i)) {
let _e688 = (_e483.member_15 * 8i);
let _e696 = (1f / select(_e483.member_1.x, select(1e-12f, -1e-12f, (_e483.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e483.member_1.x) & 2147483647u)) < 1e-12f)));
let _e704 = (1f / select(_e483.member_1.y, select(1e-12f, -1e-12f, (_e483.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e483.member_1.y) & 2147483647u)) < 1e-12f)));
let _e712 = (1f / select(_e483.member_1.z, select(1e-12f, -1e-12f, (_e483.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e483.member_1.z) & 2147483647u)) < 1e-12f)));
let _e714 = (_e480 - 1i);
let _e716 = select(_e714, _e688, (_e688 < _e714));
let _e722 = global_2.member[bitcast<u32>(select(0i, _e716, (_e716 > 0i)))];
let _e723 = (_e688 + 1i);
let _e725 = select(_e714, _e723, (_e723 < _e714));
let _e731 = global_2.member[bitcast<u32>(select(0i, _e725, (_e725 > 0i)))];
let _e732 = (_e688 + 2i);
let _e734 = select(_e714, _e732, (_e732 < _e714));
let _e740 = global_2.member[bitcast<u32>(select(0i, _e734, (_e734 > 0i)))];
let _e741 = (_e688 + 3i);
let _e743 = select(_e714, _e741, (_e741 < _e714));
let _e749 = global_2.member[bitcast<u32>(select(0i, _e743, (_e743 > 0i)))];
let _e750 = (_e688 + 4i);
let _e752 = select(_e714, _e750, (_e750 < _e714));
let _e758 = global_2.member[bitcast<u32>(select(0i, _e752, (_e752 > 0i)))];
let _e759 = (_e688 + 5i);
let _e761 = select(_e714, _e759, (_e759 < _e714));
let _e767 = global_2.member[bitcast<u32>(select(0i, _e761, (_e761 > 0i)))];
let _e770 = ((_e722 - _e483.member.x) * _e696);
let _e772 = ((_e749 - _e483.member.x) * _e696);
let _e775 = ((_e731 - _e483.member.y) * _e704);
let _e777 = ((_e758 - _e483.member.y) * _e704);
let _e780 = ((_e740 - _e483.member.z) * _e712);
let _e782 = ((_e767 - _e483.member.z) * _e712);
let _e784 = select(_e772, _e770, (_e770 < _e772));
let _e786 = select(_e777, _e775, (_e775 < _e777));
let _e788 = select(_e786, _e784, (_e784 > _e786));
let _e790 = select(_e782, _e780, (_e780 < _e782));
let _e794 = select(_e772, _e770, (_e770 > _e772));
let _e796 = select(_e777, _e775, (_e775 > _e777));
let _e798 = select(_e796, _e794, (_e794 < _e796));
let _e800 = select(_e782, _e780, (_e780 > _e782));
let _e802 = select(_e800, _e798, (_e798 < _e800));
let _e807 = ((select(_e790, _e788, (_e788 > _e790)) <= select(_e483.member_17, _e802, (_e802 < _e483.member_17))) && (_e802 >= 0f));
let _e808 = (_e688 + 6i);
let _e810 = select(_e714, _e808, (_e808 < _e714));
let _e816 = global_2.member[bitcast<u32>(select(0i, _e810, (_e810 > 0i)))];
if _e807 {
phi_1119_ = (_e483.member_15 + 1i);
} else {
let _e824 = (_e688 + 7i);
let _e826 = select(_e714, _e824, (_e824 < _e714));
let _e832 = global_2.member[bitcast<u32>(select(0i, _e826, (_e826 > 0i)))];
phi_1119_ = select(0i, select(select(i32(_e832), i32(-2147483648), (_e832 < -2147483600f)), 2147483647i, (_e832 > 2147483500f)), (_e832 == _e832));
}
let _e842 = phi_1119_;
let _e860 = type_24(_e483.member, _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, _e483.member_6, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e842, _e483.member_16, _e483.member_17);
let _e861 = select(-1i, select(0i, select(select(i32(_e816), i32(-2147483648), (_e816 < -2147483600f)), 2147483647i, (_e816 > 2147483500f)), (_e816 == _e816)), _e807);
if (_e861 >= 0i) {
let _e867 = bitcast<f32>((bitcast<u32>(_e483.member_1.x) & 2147483647u));
let _e871 = bitcast<f32>((bitcast<u32>(_e483.member_1.y) & 2147483647u));
let _e875 = bitcast<f32>((bitcast<u32>(_e483.member_1.z) & 2147483647u));
let _e878 = ((_e867 >= _e871) && (_e867 >= _e875));
let _e881 = (!(_e878) && (_e871 >= _e875));
let _e888 = (1f / select(select(_e483.member_1.z, _e483.member_1.y, _e881), _e483.member_1.x, _e878));
let _e889 = (select(select(_e483.member_1.x, _e483.member_1.z, _e881), _e483.member_1.y, _e878) * _e888);
let _e890 = (select(select(_e483.member_1.y, _e483.member_1.x, _e881), _e483.member_1.z, _e878) * _e888);
let _e891 = (_e861 * 19i);
let _e893 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e895 = select(_e893, _e891, (_e891 < _e893));
let _e901 = global_3.member[bitcast<u32>(select(0i, _e895, (_e895 > 0i)))];
let _e902 = (_e891 + 1i);
let _e904 = select(_e893, _e902, (_e902 < _e893));
let _e910 = global_3.member[bitcast<u32>(select(0i, _e904, (_e904 > 0i)))];
let _e911 = (_e891 + 2i);
let _e913 = select(_e893, _e911, (_e911 < _e893));
let _e919 = global_3.member[bitcast<u32>(select(0i, _e913, (_e913 > 0i)))];
let _e920 = (_e901 - _e483.member.x);
let _e921 = (_e910 - _e483.member.y);
let _e922 = (_e919 - _e483.member.z);
let _e928 = select(select(_e922, _e921, _e881), _e920, _e878);
let _e930 = (select(select(_e920, _e922, _e881), _e921, _e878) - (_e889 * _e928));
let _e932 = (select(select(_e921, _e920, _e881), _e922, _e878) - (_e890 * _e928));
let _e934 = (_e891 + 3i);
let _e936 = select(_e893, _e934, (_e934 < _e893));
let _e942 = global_3.member[bitcast<u32>(select(0i, _e936, (_e936 > 0i)))];
let _e943 = (_e891 + 4i);
let _e945 = select(_e893, _e943, (_e943 < _e893));
let _e951 = global_3.member[bitcast<u32>(select(0i, _e945, (_e945 > 0i)))];
let _e952 = (_e891 + 5i);
let _e954 = select(_e893, _e952, (_e952 < _e893));
let _e960 = global_3.member[bitcast<u32>(select(0i, _e954, (_e954 > 0i)))];
let _e961 = (_e942 - _e483.member.x);
let _e962 = (_e951 - _e483.member.y);
let _e963 = (_e960 - _e483.member.z);
let _e969 = select(select(_e963, _e962, _e881), _e961, _e878);
let _e971 = (select(select(_e961, _e963, _e881), _e962, _e878) - (_e889 * _e969));
let _e973 = (select(select(_e962, _e961, _e881), _e963, _e878) - (_e890 * _e969));
let _e975 = (_e891 + 6i);
let _e977 = select(_e893, _e975, (_e975 < _e893));
let _e983 = global_3.member[bitcast<u32>(select(0i, _e977, (_e977 > 0i)))];
let _e984 = (_e891 + 7i);
let _e986 = select(_e893, _e984, (_e984 < _e893));
let _e992 = global_3.member[bitcast<u32>(select(0i, _e986, (_e986 > 0i)))];
let _e993 = (_e891 + 8i);
let _e995 = select(_e893, _e993, (_e993 < _e893));
let _e1001 = global_3.member[bitcast<u32>(select(0i, _e995, (_e995 > 0i)))];
let _e1002 = (_e983 - _e483.member.x);
let _e1003 = (_e992 - _e483.member.y);
let _e1004 = (_e1001 - _e483.member.z);
let _e1010 = select(select(_e1004, _e1003, _e881), _e1002, _e878);
let _e1012 = (select(select(_e1002, _e1004, _e881), _e1003, _e878) - (_e889 * _e1010));
let _e1014 = (select(select(_e1003, _e1002, _e881), _e1004, _e878) - (_e890 * _e1010));
let _e1018 = ((_e1012 * _e973) - (_e1014 * _e971));
let _e1021 = ((_e930 * _e1014) - (_e932 * _e1012));
let _e1024 = ((_e971 * _e932) - (_e973 * _e930));
let _e1026 = ((_e1018 + _e1021) + _e1024);
let _e1040 = (!(((((_e1018 < 0f) || (_e1021 < 0f)) || (_e1024 < 0f)) && (((_e1018 > 0f) || (_e1021 > 0f)) || (_e1024 > 0f)))) && (_e1026 != 0f));
let _e1048 = select(1e30f, ((((_e1018 * (_e928 * _e888)) + (_e1021 * (_e969 * _e888))) + (_e1024 * (_e1010 * _e888))) / select(1f, _e1026, _e1040)), _e1040);
let _e1050 = select(1e30f, _e1048, (_e1048 > 1e-3f));
if (_e1050 < _e483.member_17) {
let _e1069 = type_24(_e860.member, _e860.member_1, _e860.member_2, _e860.member_3, _e860.member_4, _e860.member_5, _e860.member_6, _e860.member_7, _e860.member_8, _e860.member_9, _e860.member_10, _e860.member_11, _e860.member_12, _e860.member_13, _e860.member_14, _e860.member_15, _e860.member_16, _e1050);
phi_1486_ = type_24(_e1069.member, _e1069.member_1, _e1069.member_2, _e1069.member_3, _e1069.member_4, _e1069.member_5, _e1069.member_6, _e1069.member_7, _e1069.member_8, _e1069.member_9, _e1069.member_10, _e1069.member_11, _e1069.member_12, _e1069.member_13, _e1069.member_14, _e1069.member_15, _e861, _e1069.member_17);
} else {
phi_1486_ = _e860;
}
let _e1089 = phi_1486_;
phi_1487_ = _e1089;
} else {
phi_1487_ = _e860;
}
let _e1091 = phi_1487_;
phi_1824_ = _e1091;
} else {
let _e499 = (24f + 1f);
let _e501 = select(_e499, _e483.member_8, (_e483.member_8 < _e499));
if (((_e76.member_2 == 0u) && (_e483.member_8 >= 2f)) && !(((((_e483.member_13.x + _e483.member_13.y) + _e483.member_13.z) <= 0f) && ((((2i * _e483.member_14) >> bitcast<u32>((select(0i, select(select(i32(_e501), i32(-2147483648), (_e501 < -2147483600f)), 2147483647i, (_e501 > 2147483500f)), (_e501 == _e501)) & 31i))) & 1i) == 1i)))) {
if (_e483.member_16 == -1i) {
phi_1821_ = type_24(_e483.member, _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, 1f, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e483.member_15, _e483.member_16, _e483.member_17);
} else {
let _e579 = type_24(vec3<f32>((_e483.member.x + (_e483.member_1.x * _e483.member_17)), (_e483.member.y + (_e483.member_1.y * _e483.member_17)), (_e483.member.z + (_e483.member_1.z * _e483.member_17))), _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, _e483.member_6, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e483.member_15, _e483.member_16, _e483.member_17);
let _e599 = type_24(_e579.member, _e579.member_1, _e579.member_2, _e579.member_3, _e579.member_4, (_e483.member_5 + _e483.member_17), _e579.member_6, _e579.member_7, _e579.member_8, _e579.member_9, _e579.member_10, _e579.member_11, _e579.member_12, _e579.member_13, _e579.member_14, _e579.member_15, _e579.member_16, _e579.member_17);
let _e618 = type_24(_e599.member, _e599.member_1, _e599.member_2, _e599.member_3, _e599.member_4, _e599.member_5, _e599.member_6, _e599.member_7, _e599.member_8, _e599.member_9, _e599.member_10, _e599.member_11, _e599.member_12, _e599.member_13, _e599.member_14, _e599.member_15, _e599.member_16, (_e483.member_17 - _e483.member_17));
let _e640 = type_24(_e618.member, _e618.member_1, _e618.member_2, _e618.member_3, _e618.member_4, _e618.member_5, _e618.member_6, _e618.member_7, _e618.member_8, _e618.member_9, (_e483.member_10 + select(0f, _e483.member_17, (_e483.member_8 == 0f))), _e618.member_11, _e618.member_12, _e618.member_13, _e618.member_14, _e618.member_15, _e618.member_16, _e618.member_17);
phi_1821_ = type_24(_e640.member, _e640.member_1, _e640.member_2, _e640.member_3, _e640.member_4, _e640.member_5, 3f, _e640.member_7, _e640.member_8, _e640.member_9, _e640.member_10, _e640.member_11, _e640.member_12, _e640.member_13, _e640.member_14, _e640.member_15, _e640.member_16, _e640.member_17);
}
let _e678 = phi_1821_;
phi_1823_ = _e678;
} else {
phi_1823_ = type_24(_e483.member, _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, 0f, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e483.member_15, _e483.member_16, _e483.member_17);
}
let _e680 = phi_1823_;
phi_1824_ = _e680;
}
let _e1093 = phi_1824_;
phi_822_ = _e1093;
phi_825_ = (_e485 + 1i);
} else {
phi_822_ = type_24();
phi_825_ = i32();
}
let _e1095 = phi_822_;
let _e1097 = phi_825_;
continue;
continuing {
phi_821_ = _e1095;
phi_824_ = _e1097;
break if !(_e489);
}
}
let _e1100 = local;
let _e1104 = local_1;
let _e1108 = local_2;
let _e1112 = local_3;
let _e1116 = local_4;
let _e1120 = local_5;
let _e1124 = local_6;
let _e1128 = local_7;
let _e1132 = local_8;
let _e1136 = local_9;
let _e1140 = local_10;
let _e1144 = local_11;
let _e1148 = local_12;
let _e1152 = local_13;
let _e1156 = local_14;
let _e1160 = local_15;
let _e1163 = local_16;
let _e1167 = local_17;
let _e1170 = local_18;
let _e1173 = local_19;
let _e1176 = local_20;
let _e1179 = local_21;
let _e1183 = local_22;
let _e1187 = local_23;
let _e1191 = local_24;
let _e1195 = local_25;
let _e1199 = local_26;
let _e1203 = local_27;
let _e1207 = local_28;
let _e1211 = local_29;
let _e1215 = local_30;
global_4.member[_e85] = _e1100.member.x;
global_4.member[_e97] = _e1104.member.y;
global_4.member[_e108] = _e1108.member.z;
global_4.member[_e119] = _e1112.member_1.x;
global_4.member[_e130] = _e1116.member_1.y;
global_4.member[_e141] = _e1120.member_1.z;
global_4.member[_e152] = _e1124.member_2.x;
global_4.member[_e163] = _e1128.member_2.y;
global_4.member[_e174] = _e1132.member_2.z;
global_4.member[_e185] = _e1136.member_3.x;
global_4.member[_e196] = _e1140.member_3.y;
global_4.member[_e207] = _e1144.member_3.z;
global_4.member[_e218] = _e1148.member_4.x;
global_4.member[_e229] = _e1152.member_4.y;
global_4.member[_e240] = _e1156.member_4.z;
global_4.member[_e251] = _e1160.member_5;
let _e1252 = local_31;
global_4.member[_e262] = _e1252;
global_4.member[_e273] = f32(_e1163.member_7);
global_4.member[_e284] = _e1167.member_8;
global_4.member[_e295] = _e1170.member_9;
global_4.member[_e306] = _e1173.member_10;
global_4.member[_e317] = _e1176.member_11;
global_4.member[_e328] = _e1179.member_12.x;
global_4.member[_e339] = _e1183.member_12.y;
global_4.member[_e350] = _e1187.member_12.z;
global_4.member[_e361] = _e1191.member_13.x;
global_4.member[_e372] = _e1195.member_13.y;
global_4.member[_e383] = _e1199.member_13.z;
global_4.member[_e394] = f32(_e1203.member_14);
global_4.member[_e405] = f32(_e1207.member_15);
global_4.member[_e416] = f32(_e1211.member_16);
global_4.member[_e427] = _e1215.member_17;
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
