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
struct type_21 {
member: array<u32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(4)
var<storage> global_2: type_16;
@group(0) @binding(5)
var<storage, read_write> global_3: type_16;
@group(0) @binding(1)
var<storage> global_4: type_21;
@group(0) @binding(2)
var<storage> global_5: type_21;
@group(0) @binding(3)
var<storage> global_6: type_16;
fn function_() {
var phi_641_: u32;
var phi_848_: type_19;
var phi_851_: i32;
var phi_1470_: type_19;
var phi_1183_: type_19;
var phi_1471_: type_19;
var phi_2275_: type_19;
var phi_2328_: type_19;
var phi_2342_: type_19;
var phi_2786_: type_19;
var phi_2787_: type_19;
var phi_2767_: type_19;
var phi_2788_: type_19;
var phi_2797_: type_19;
var phi_2798_: type_19;
var phi_2799_: type_19;
var phi_1803_: type_19;
var phi_2800_: type_19;
var phi_849_: type_19;
var phi_852_: i32;
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
let _e79 = global;
let _e87 = arrayLength((&global_2.member));
let _e92 = global_1.member.member;
if (_e79.x < _e92.member) {
if (_e79.y < _e92.member_1) {
let _e99 = (_e92.member * _e92.member_1);
let _e101 = ((_e79.y * _e92.member) + _e79.x);
let _e102 = bitcast<i32>(_e101);
let _e104 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e106 = select(_e104, _e102, (_e102 < _e104));
let _e112 = global_3.member[bitcast<u32>(select(0i, _e106, (_e106 > 0i)))];
let _e113 = (_e99 + _e101);
let _e114 = bitcast<i32>(_e113);
let _e116 = select(_e104, _e114, (_e114 < _e104));
let _e122 = global_3.member[bitcast<u32>(select(0i, _e116, (_e116 > 0i)))];
let _e124 = ((2u * _e99) + _e101);
let _e125 = bitcast<i32>(_e124);
let _e127 = select(_e104, _e125, (_e125 < _e104));
let _e133 = global_3.member[bitcast<u32>(select(0i, _e127, (_e127 > 0i)))];
let _e135 = ((3u * _e99) + _e101);
let _e136 = bitcast<i32>(_e135);
let _e138 = select(_e104, _e136, (_e136 < _e104));
let _e144 = global_3.member[bitcast<u32>(select(0i, _e138, (_e138 > 0i)))];
let _e146 = ((4u * _e99) + _e101);
let _e147 = bitcast<i32>(_e146);
let _e149 = select(_e104, _e147, (_e147 < _e104));
let _e155 = global_3.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e157 = ((5u * _e99) + _e101);
let _e158 = bitcast<i32>(_e157);
let _e160 = select(_e104, _e158, (_e158 < _e104));
let _e166 = global_3.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e168 = ((6u * _e99) + _e101);
let _e169 = bitcast<i32>(_e168);
let _e171 = select(_e104, _e169, (_e169 < _e104));
let _e177 = global_3.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e179 = ((7u * _e99) + _e101);
let _e180 = bitcast<i32>(_e179);
let _e182 = select(_e104, _e180, (_e180 < _e104));
let _e188 = global_3.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e190 = ((8u * _e99) + _e101);
let _e191 = bitcast<i32>(_e190);
let _e193 = select(_e104, _e191, (_e191 < _e104));
let _e199 = global_3.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e201 = ((9u * _e99) + _e101);
let _e202 = bitcast<i32>(_e201);
let _e204 = select(_e104, _e202, (_e202 < _e104));
let _e210 = global_3.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e212 = ((10u * _e99) + _e101);
let _e213 = bitcast<i32>(_e212);
let _e215 = select(_e104, _e213, (_e213 < _e104));
let _e221 = global_3.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e223 = ((11u * _e99) + _e101);
let _e224 = bitcast<i32>(_e223);
let _e226 = select(_e104, _e224, (_e224 < _e104));
let _e232 = global_3.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e234 = ((12u * _e99) + _e101);
let _e235 = bitcast<i32>(_e234);
let _e237 = select(_e104, _e235, (_e235 < _e104));
let _e243 = global_3.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e245 = ((13u * _e99) + _e101);
let _e246 = bitcast<i32>(_e245);
let _e248 = select(_e104, _e246, (_e246 < _e104));
let _e254 = global_3.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e256 = ((14u * _e99) + _e101);
let _e257 = bitcast<i32>(_e256);
let _e259 = select(_e104, _e257, (_e257 < _e104));
let _e265 = global_3.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e267 = ((15u * _e99) + _e101);
let _e268 = bitcast<i32>(_e267);
let _e270 = select(_e104, _e268, (_e268 < _e104));
let _e276 = global_3.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e278 = ((16u * _e99) + _e101);
let _e279 = bitcast<i32>(_e278);
let _e281 = select(_e104, _e279, (_e279 < _e104));
let _e287 = global_3.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e289 = ((17u * _e99) + _e101);
let _e290 = bitcast<i32>(_e289);
let _e292 = select(_e104, _e290, (_e290 < _e104));
let _e298 = global_3.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e300 = ((18u * _e99) + _e101);
let _e301 = bitcast<i32>(_e300);
let _e303 = select(_e104, _e301, (_e301 < _e104));
let _e309 = global_3.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e311 = ((19u * _e99) + _e101);
let _e312 = bitcast<i32>(_e311);
let _e314 = select(_e104, _e312, (_e312 < _e104));
let _e320 = global_3.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e322 = ((20u * _e99) + _e101);
let _e323 = bitcast<i32>(_e322);
let _e325 = select(_e104, _e323, (_e323 < _e104));
let _e331 = global_3.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e333 = ((21u * _e99) + _e101);
let _e334 = bitcast<i32>(_e333);
let _e336 = select(_e104, _e334, (_e334 < _e104));
let _e342 = global_3.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e344 = ((22u * _e99) + _e101);
let _e345 = bitcast<i32>(_e344);
let _e347 = select(_e104, _e345, (_e345 < _e104));
let _e353 = global_3.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e355 = ((23u * _e99) + _e101);
let _e356 = bitcast<i32>(_e355);
let _e358 = select(_e104, _e356, (_e356 < _e104));
let _e364 = global_3.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e366 = ((24u * _e99) + _e101);
let _e367 = bitcast<i32>(_e366);
let _e369 = select(_e104, _e367, (_e367 < _e104));
let _e375 = global_3.member[bitcast<u32>(select(0i, _e369, (_e369 > 0i)))];
if (_e287 == 0f) {
phi_641_ = 3u;
} else {
phi_641_ = select(0u, 1u, (_e287 == 4f));
}
let _e380 = phi_641_;
if (_e380 > 1u) {
let _e413 = global_1.member.member_2.member;
let _e414 = bitcast<i32>(_e413);
let _e418 = global_1.member.member_2.member_1;
let _e419 = bitcast<i32>(_e418);
let _e423 = global_1.member.member_2.member_2;
let _e424 = bitcast<i32>(_e423);
phi_848_ = type_19(vec3<f32>(_e112, _e122, _e133), vec3<f32>(_e144, _e155, _e166), vec3<f32>(_e177, _e188, _e199), vec3<f32>(_e210, _e221, _e232), vec3<f32>(_e243, _e254, _e265), _e276, _e287, select(0i, select(select(i32(_e298), i32(-2147483648), (_e298 < -2147483600f)), 2147483647i, (_e298 > 2147483500f)), (_e298 == _e298)), _e309, _e320, _e331, _e342, select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < -2147483600f)), 2147483647i, (_e353 > 2147483500f)), (_e353 == _e353)), select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < -2147483600f)), 2147483647i, (_e364 > 2147483500f)), (_e364 == _e364)), _e375);
phi_851_ = 0i;
loop {
let _e429 = phi_848_;
let _e431 = phi_851_;
local = _e429;
local_1 = _e429;
local_2 = _e429;
local_3 = _e429;
local_4 = _e429;
local_5 = _e429;
local_6 = _e429;
local_7 = _e429;
local_8 = _e429;
local_9 = _e429;
local_10 = _e429;
local_11 = _e429;
local_12 = _e429;
local_13 = _e429;
local_14 = _e429;
local_15 = _e429;
local_16 = _e429;
local_17 = _e429;
local_18 = _e429;
local_19 = _e429;
local_20 = _e429;
local_21 = _e429;
local_22 = _e429;
local_23 = _e429;
let _e435 = ((_e431 < 256i) && (_e429.member_6 == 0f));
local_24 = _e429.member_6;
if _e435 {
let _e441 = bitcast<f32>((bitcast<u32>(_e429.member_1.x) & 2147483647u));
let _e445 = bitcast<f32>((bitcast<u32>(_e429.member_1.y) & 2147483647u));
let _e447 = select(_e445, _e441, (_e441 > _e445));
let _e451 = bitcast<f32>((bitcast<u32>(_e429.member_1.z) & 2147483647u));
let _e453 = select(_e451, _e447, (_e447 > _e451));
let _e456 = (1f / select(0.5f, _e453, (_e453 > 0.5f)));
let _e458 = (_e429.member_14 <= _e456);
if _e458 {
let _e788 = type_19(vec3<f32>((_e429.member.x + (_e429.member_1.x * _e429.member_14)), (_e429.member.y + (_e429.member_1.y * _e429.member_14)), (_e429.member.z + (_e429.member_1.z * _e429.member_14))), _e429.member_1, _e429.member_2, _e429.member_3, _e429.member_4, _e429.member_5, _e429.member_6, _e429.member_7, _e429.member_8, _e429.member_9, _e429.member_10, _e429.member_11, _e429.member_12, _e429.member_13, _e429.member_14);
let _e805 = type_19(_e788.member, _e788.member_1, _e788.member_2, _e788.member_3, _e788.member_4, (_e429.member_5 + _e429.member_14), _e788.member_6, _e788.member_7, _e788.member_8, _e788.member_9, _e788.member_10, _e788.member_11, _e788.member_12, _e788.member_13, _e788.member_14);
let _e821 = type_19(_e805.member, _e805.member_1, _e805.member_2, _e805.member_3, _e805.member_4, _e805.member_5, _e805.member_6, _e805.member_7, _e805.member_8, _e805.member_9, _e805.member_10, _e805.member_11, _e805.member_12, _e805.member_13, (_e429.member_14 - _e429.member_14));
let _e841 = type_19(_e821.member, _e821.member_1, _e821.member_2, _e821.member_3, _e821.member_4, _e821.member_5, _e821.member_6, _e821.member_7, _e821.member_8, _e821.member_9, (_e429.member_10 + select(0f, _e429.member_14, (_e429.member_8 == 0f))), _e821.member_11, _e821.member_12, _e821.member_13, _e821.member_14);
if (_e429.member_7 != 16i) {
let _e859 = type_19(_e841.member, _e841.member_1, _e841.member_2, _e841.member_3, _e841.member_4, _e841.member_5, _e841.member_6, _e841.member_7, _e841.member_8, (_e429.member_9 + _e429.member_14), _e841.member_10, _e841.member_11, _e841.member_12, _e841.member_13, _e841.member_14);
let _e860 = (_e429.member_7 * 4i);
let _e861 = (_e860 + 1i);
let _e863 = (bitcast<i32>(_e87) - 1i);
let _e865 = select(_e863, _e861, (_e861 < _e863));
let _e871 = global_2.member[bitcast<u32>(select(0i, _e865, (_e865 > 0i)))];
let _e873 = -((_e871 * _e429.member_14));
let _e875 = select(-87f, _e873, (_e873 > -87f));
let _e877 = select(88f, _e875, (_e875 < 88f));
let _e879 = ((_e877 * 1.442695f) + 0.5f);
let _e881 = select(-127f, _e879, (_e879 > -127f));
let _e883 = select(128f, _e881, (_e881 < 128f));
let _e890 = select(0i, select(select(i32(_e883), i32(-2147483648), (_e883 < -2147483600f)), 2147483647i, (_e883 > 2147483500f)), (_e883 == _e883));
let _e894 = (_e890 - select(0i, 1i, (_e883 < f32(_e890))));
let _e895 = f32(_e894);
let _e899 = ((_e877 - (_e895 * 0.6933594f)) - (_e895 * -2.1219444e-4f));
let _e923 = (_e860 + 2i);
let _e925 = select(_e863, _e923, (_e923 < _e863));
let _e931 = global_2.member[bitcast<u32>(select(0i, _e925, (_e925 > 0i)))];
let _e933 = -((_e931 * _e429.member_14));
let _e935 = select(-87f, _e933, (_e933 > -87f));
let _e937 = select(88f, _e935, (_e935 < 88f));
let _e939 = ((_e937 * 1.442695f) + 0.5f);
let _e941 = select(-127f, _e939, (_e939 > -127f));
let _e943 = select(128f, _e941, (_e941 < 128f));
let _e950 = select(0i, select(select(i32(_e943), i32(-2147483648), (_e943 < -2147483600f)), 2147483647i, (_e943 > 2147483500f)), (_e943 == _e943));
let _e954 = (_e950 - select(0i, 1i, (_e943 < f32(_e950))));
let _e955 = f32(_e954);
let _e959 = ((_e937 - (_e955 * 0.6933594f)) - (_e955 * -2.1219444e-4f));
let _e983 = (_e860 + 3i);
let _e985 = select(_e863, _e983, (_e983 < _e863));
let _e991 = global_2.member[bitcast<u32>(select(0i, _e985, (_e985 > 0i)))];
let _e993 = -((_e991 * _e429.member_14));
let _e995 = select(-87f, _e993, (_e993 > -87f));
let _e997 = select(88f, _e995, (_e995 < 88f));
let _e999 = ((_e997 * 1.442695f) + 0.5f);
let _e1001 = select(-127f, _e999, (_e999 > -127f));
let _e1003 = select(128f, _e1001, (_e1001 < 128f));
let _e1010 = select(0i, select(select(i32(_e1003), i32(-2147483648), (_e1003 < -2147483600f)), 2147483647i, (_e1003 > 2147483500f)), (_e1003 == _e1003));
let _e1014 = (_e1010 - select(0i, 1i, (_e1003 < f32(_e1010))));
let _e1015 = f32(_e1014);
let _e1019 = ((_e997 - (_e1015 * 0.6933594f)) - (_e1015 * -2.1219444e-4f));
phi_1183_ = type_19(_e859.member, _e859.member_1, vec3<f32>((_e429.member_2.x * ((1f + (_e899 * (1f + (_e899 * (0.5f + (_e899 * (0.16666667f + (_e899 * (0.041666668f + (_e899 * (0.008333334f + (_e899 * (0.001388889f + (_e899 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e894 + 127i)) << bitcast<u32>(23i))))), (_e429.member_2.y * ((1f + (_e959 * (1f + (_e959 * (0.5f + (_e959 * (0.16666667f + (_e959 * (0.041666668f + (_e959 * (0.008333334f + (_e959 * (0.001388889f + (_e959 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e954 + 127i)) << bitcast<u32>(23i))))), (_e429.member_2.z * ((1f + (_e1019 * (1f + (_e1019 * (0.5f + (_e1019 * (0.16666667f + (_e1019 * (0.041666668f + (_e1019 * (0.008333334f + (_e1019 * (0.001388889f + (_e1019 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1014 + 127i)) << bitcast<u32>(23i)))))), _e859.member_3, _e859.member_4, _e859.member_5, _e859.member_6, _e859.member_7, _e859.member_8, _e859.member_9, _e859.member_10, _e859.member_11, _e859.member_12, _e859.member_13, _e859.member_14);
} else {
phi_1183_ = _e841;
}
let _e1060 = phi_1183_;
phi_1471_ = type_19(_e1060.member, _e1060.member_1, _e1060.member_2, _e1060.member_3, _e1060.member_4, _e1060.member_5, 3f, _e1060.member_7, _e1060.member_8, _e1060.member_9, _e1060.member_10, _e1060.member_11, _e1060.member_12, _e1060.member_13, _e1060.member_14);
} else {
let _e487 = type_19(vec3<f32>((_e429.member.x + (_e429.member_1.x * _e456)), (_e429.member.y + (_e429.member_1.y * _e456)), (_e429.member.z + (_e429.member_1.z * _e456))), _e429.member_1, _e429.member_2, _e429.member_3, _e429.member_4, _e429.member_5, _e429.member_6, _e429.member_7, _e429.member_8, _e429.member_9, _e429.member_10, _e429.member_11, _e429.member_12, _e429.member_13, _e429.member_14);
let _e504 = type_19(_e487.member, _e487.member_1, _e487.member_2, _e487.member_3, _e487.member_4, (_e429.member_5 + _e456), _e487.member_6, _e487.member_7, _e487.member_8, _e487.member_9, _e487.member_10, _e487.member_11, _e487.member_12, _e487.member_13, _e487.member_14);
let _e520 = type_19(_e504.member, _e504.member_1, _e504.member_2, _e504.member_3, _e504.member_4, _e504.member_5, _e504.member_6, _e504.member_7, _e504.member_8, _e504.member_9, _e504.member_10, _e504.member_11, _e504.member_12, _e504.member_13, (_e429.member_14 - _e456));
let _e540 = type_19(_e520.member, _e520.member_1, _e520.member_2, _e520.member_3, _e520.member_4, _e520.member_5, _e520.member_6, _e520.member_7, _e520.member_8, _e520.member_9, (_e429.member_10 + select(0f, _e456, (_e429.member_8 == 0f))), _e520.member_11, _e520.member_12, _e520.member_13, _e520.member_14);
if (_e429.member_7 != 16i) {
let _e558 = type_19(_e540.member, _e540.member_1, _e540.member_2, _e540.member_3, _e540.member_4, _e540.member_5, _e540.member_6, _e540.member_7, _e540.member_8, (_e429.member_9 + _e456), _e540.member_10, _e540.member_11, _e540.member_12, _e540.member_13, _e540.member_14);
let _e559 = (_e429.member_7 * 4i);
let _e560 = (_e559 + 1i);
let _e562 = (bitcast<i32>(_e87) - 1i);
let _e564 = select(_e562, _e560, (_e560 < _e562));
let _e570 = global_2.member[bitcast<u32>(select(0i, _e564, (_e564 > 0i)))];
let _e572 = -((_e570 * _e456));
let _e574 = select(-87f, _e572, (_e572 > -87f));
let _e576 = select(88f, _e574, (_e574 < 88f));
let _e578 = ((_e576 * 1.442695f) + 0.5f);
let _e580 = select(-127f, _e578, (_e578 > -127f));
let _e582 = select(128f, _e580, (_e580 < 128f));
let _e589 = select(0i, select(select(i32(_e582), i32(-2147483648), (_e582 < -2147483600f)), 2147483647i, (_e582 > 2147483500f)), (_e582 == _e582));
let _e593 = (_e589 - select(0i, 1i, (_e582 < f32(_e589))));
let _e594 = f32(_e593);
let _e598 = ((_e576 - (_e594 * 0.6933594f)) - (_e594 * -2.1219444e-4f));
let _e622 = (_e559 + 2i);
let _e624 = select(_e562, _e622, (_e622 < _e562));
let _e630 = global_2.member[bitcast<u32>(select(0i, _e624, (_e624 > 0i)))];
let _e632 = -((_e630 * _e456));
let _e634 = select(-87f, _e632, (_e632 > -87f));
let _e636 = select(88f, _e634, (_e634 < 88f));
let _e638 = ((_e636 * 1.442695f) + 0.5f);
let _e640 = select(-127f, _e638, (_e638 > -127f));
let _e642 = select(128f, _e640, (_e640 < 128f));
let _e649 = select(0i, select(select(i32(_e642), i32(-2147483648), (_e642 < -2147483600f)), 2147483647i, (_e642 > 2147483500f)), (_e642 == _e642));
let _e653 = (_e649 - select(0i, 1i, (_e642 < f32(_e649))));
let _e654 = f32(_e653);
let _e658 = ((_e636 - (_e654 * 0.6933594f)) - (_e654 * -2.1219444e-4f));
let _e682 = (_e559 + 3i);
let _e684 = select(_e562, _e682, (_e682 < _e562));
let _e690 = global_2.member[bitcast<u32>(select(0i, _e684, (_e684 > 0i)))];
let _e692 = -((_e690 * _e456));
let _e694 = select(-87f, _e692, (_e692 > -87f));
let _e696 = select(88f, _e694, (_e694 < 88f));
let _e698 = ((_e696 * 1.442695f) + 0.5f);
let _e700 = select(-127f, _e698, (_e698 > -127f));
let _e702 = select(128f, _e700, (_e700 < 128f));
let _e709 = select(0i, select(select(i32(_e702), i32(-2147483648), (_e702 < -2147483600f)), 2147483647i, (_e702 > 2147483500f)), (_e702 == _e702));
let _e713 = (_e709 - select(0i, 1i, (_e702 < f32(_e709))));
let _e714 = f32(_e713);
let _e718 = ((_e696 - (_e714 * 0.6933594f)) - (_e714 * -2.1219444e-4f));
phi_1470_ = type_19(_e558.member, _e558.member_1, vec3<f32>((_e429.member_2.x * ((1f + (_e598 * (1f + (_e598 * (0.5f + (_e598 * (0.16666667f + (_e598 * (0.041666668f + (_e598 * (0.008333334f + (_e598 * (0.001388889f + (_e598 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e593 + 127i)) << bitcast<u32>(23i))))), (_e429.member_2.y * ((1f + (_e658 * (1f + (_e658 * (0.5f + (_e658 * (0.16666667f + (_e658 * (0.041666668f + (_e658 * (0.008333334f + (_e658 * (0.001388889f + (_e658 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e653 + 127i)) << bitcast<u32>(23i))))), (_e429.member_2.z * ((1f + (_e718 * (1f + (_e718 * (0.5f + (_e718 * (0.16666667f + (_e718 * (0.041666668f + (_e718 * (0.008333334f + (_e718 * (0.001388889f + (_e718 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e713 + 127i)) << bitcast<u32>(23i)))))), _e558.member_3, _e558.member_4, _e558.member_5, _e558.member_6, _e558.member_7, _e558.member_8, _e558.member_9, _e558.member_10, _e558.member_11, _e558.member_12, _e558.member_13, _e558.member_14);
} else {
phi_1470_ = _e540;
}
let _e759 = phi_1470_;
phi_1471_ = _e759;
}
let _e1077 = phi_1471_;
if (!(_e458) && ((((((_e1077.member.x < 0f) || (_e1077.member.y < 0f)) || (_e1077.member.z < 0f)) || (_e1077.member.x >= f32(_e414))) || (_e1077.member.y >= f32(_e419))) || (_e1077.member.z >= f32(_e424)))) {
if (_e1077.member_13 == -1i) {
phi_1803_ = type_19(_e1077.member, _e1077.member_1, _e1077.member_2, _e1077.member_3, _e1077.member_4, _e1077.member_5, 1f, _e1077.member_7, _e1077.member_8, _e1077.member_9, _e1077.member_10, _e1077.member_11, _e1077.member_12, _e1077.member_13, _e1077.member_14);
} else {
let _e1900 = type_19(vec3<f32>((_e1077.member.x + (_e1077.member_1.x * _e1077.member_14)), (_e1077.member.y + (_e1077.member_1.y * _e1077.member_14)), (_e1077.member.z + (_e1077.member_1.z * _e1077.member_14))), _e1077.member_1, _e1077.member_2, _e1077.member_3, _e1077.member_4, _e1077.member_5, _e1077.member_6, _e1077.member_7, _e1077.member_8, _e1077.member_9, _e1077.member_10, _e1077.member_11, _e1077.member_12, _e1077.member_13, _e1077.member_14);
let _e1917 = type_19(_e1900.member, _e1900.member_1, _e1900.member_2, _e1900.member_3, _e1900.member_4, (_e1077.member_5 + _e1077.member_14), _e1900.member_6, _e1900.member_7, _e1900.member_8, _e1900.member_9, _e1900.member_10, _e1900.member_11, _e1900.member_12, _e1900.member_13, _e1900.member_14);
let _e1933 = type_19(_e1917.member, _e1917.member_1, _e1917.member_2, _e1917.member_3, _e1917.member_4, _e1917.member_5, _e1917.member_6, _e1917.member_7, _e1917.member_8, _e1917.member_9, _e1917.member_10, _e1917.member_11, _e1917.member_12, _e1917.member_13, (_e1077.member_14 - _e1077.member_14));
let _e1953 = type_19(_e1933.member, _e1933.member_1, _e1933.member_2, _e1933.member_3, _e1933.member_4, _e1933.member_5, _e1933.member_6, _e1933.member_7, _e1933.member_8, _e1933.member_9, (_e1077.member_10 + select(0f, _e1077.member_14, (_e1077.member_8 == 0f))), _e1933.member_11, _e1933.member_12, _e1933.member_13, _e1933.member_14);
phi_1803_ = type_19(_e1953.member, _e1953.member_1, _e1953.member_2, _e1953.member_3, _e1953.member_4, _e1953.member_5, 3f, _e1953.member_7, _e1953.member_8, _e1953.member_9, _e1953.member_10, _e1953.member_11, _e1953.member_12, _e1953.member_13, _e1953.member_14);
}
let _e1985 = phi_1803_;
phi_2800_ = _e1985;
} else {
if _e458 {
phi_2799_ = _e1077;
} else {
let _e1099 = f32((_e414 - 1i));
let _e1101 = select(0f, _e1077.member.x, (_e1077.member.x > 0f));
let _e1103 = select(_e1099, _e1101, (_e1101 < _e1099));
let _e1110 = select(0i, select(select(i32(_e1103), i32(-2147483648), (_e1103 < -2147483600f)), 2147483647i, (_e1103 > 2147483500f)), (_e1103 == _e1103));
let _e1114 = (_e1110 - select(0i, 1i, (_e1103 < f32(_e1110))));
let _e1116 = f32((_e419 - 1i));
let _e1118 = select(0f, _e1077.member.y, (_e1077.member.y > 0f));
let _e1120 = select(_e1116, _e1118, (_e1118 < _e1116));
let _e1127 = select(0i, select(select(i32(_e1120), i32(-2147483648), (_e1120 < -2147483600f)), 2147483647i, (_e1120 > 2147483500f)), (_e1120 == _e1120));
let _e1133 = f32((_e424 - 1i));
let _e1135 = select(0f, _e1077.member.z, (_e1077.member.z > 0f));
let _e1137 = select(_e1133, _e1135, (_e1135 < _e1133));
let _e1144 = select(0i, select(select(i32(_e1137), i32(-2147483648), (_e1137 < -2147483600f)), 2147483647i, (_e1137 > 2147483500f)), (_e1137 == _e1137));
let _e1154 = (((((_e1144 - select(0i, 1i, (_e1137 < f32(_e1144)))) * _e419) + (_e1127 - select(0i, 1i, (_e1120 < f32(_e1127))))) * ((_e414 + 31i) >> bitcast<u32>(5i))) + (_e1114 >> bitcast<u32>(5i)));
let _e1156 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1158 = select(_e1156, _e1154, (_e1154 < _e1156));
let _e1164 = global_4.member[bitcast<u32>(select(0i, _e1158, (_e1158 > 0i)))];
let _e1167 = (bitcast<u32>((_e1114 & 31i)) & 31u);
if (((_e1164 >> bitcast<u32>(_e1167)) & 1u) == 1u) {
let _e1173 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1175 = select(_e1173, _e1154, (_e1154 < _e1173));
let _e1181 = global_5.member[bitcast<u32>(select(0i, _e1175, (_e1175 > 0i)))];
let _e1189 = (bitcast<i32>((_e1181 + countOneBits((_e1164 & ((1u << bitcast<u32>(_e1167)) - 1u))))) * 4i);
let _e1191 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e1193 = select(_e1191, _e1189, (_e1189 < _e1191));
let _e1199 = global_6.member[bitcast<u32>(select(0i, _e1193, (_e1193 > 0i)))];
let _e1200 = (_e1189 + 1i);
let _e1202 = select(_e1191, _e1200, (_e1200 < _e1191));
let _e1208 = global_6.member[bitcast<u32>(select(0i, _e1202, (_e1202 > 0i)))];
let _e1209 = (_e1189 + 2i);
let _e1211 = select(_e1191, _e1209, (_e1209 < _e1191));
let _e1217 = global_6.member[bitcast<u32>(select(0i, _e1211, (_e1211 > 0i)))];
let _e1218 = vec3<f32>(_e1199, _e1208, _e1217);
let _e1219 = (_e1189 + 3i);
let _e1221 = select(_e1191, _e1219, (_e1219 < _e1191));
let _e1227 = global_6.member[bitcast<u32>(select(0i, _e1221, (_e1221 > 0i)))];
let _e1229 = select(0f, _e1227, (_e1227 > 0f));
let _e1231 = select(16f, _e1229, (_e1229 < 16f));
let _e1238 = select(0i, select(select(i32(_e1231), i32(-2147483648), (_e1231 < -2147483600f)), 2147483647i, (_e1231 > 2147483500f)), (_e1231 == _e1231));
let _e1247 = (((_e429.member_1.x * _e1199) + (_e429.member_1.y * _e1208)) + (_e429.member_1.z * _e1217));
let _e1249 = select(16i, (_e1238 - select(0i, 1i, (_e1231 < f32(_e1238)))), (_e1247 < 0f));
let _e1263 = global_1.member.member_12;
if ((!(((_e1077.member_8 > 0f) && ((((_e1199 * _e1077.member_4.x) + (_e1208 * _e1077.member_4.y)) + (_e1217 * _e1077.member_4.z)) > _e1263))) && (_e1247 != 0f)) && (_e1249 != _e1077.member_7)) {
let _e1273 = (_e1077.member_7 * 4i);
let _e1275 = (bitcast<i32>(_e87) - 1i);
let _e1277 = select(_e1275, _e1273, (_e1273 < _e1275));
let _e1283 = global_2.member[bitcast<u32>(select(0i, _e1277, (_e1277 > 0i)))];
let _e1285 = select(_e1283, 1f, (_e1077.member_7 == 16i));
let _e1286 = (_e1249 * 4i);
let _e1288 = select(_e1275, _e1286, (_e1286 < _e1275));
let _e1294 = global_2.member[bitcast<u32>(select(0i, _e1288, (_e1288 > 0i)))];
let _e1296 = select(_e1294, 1f, (_e1249 == 16i));
let _e1306 = select(1f, -1f, ((((_e1077.member_1.x * _e1199) + (_e1077.member_1.y * _e1208)) + (_e1077.member_1.z * _e1217)) > 0f));
let _e1307 = (_e1199 * _e1306);
let _e1308 = (_e1208 * _e1306);
let _e1309 = (_e1217 * _e1306);
let _e1315 = -((((_e1077.member_1.x * _e1307) + (_e1077.member_1.y * _e1308)) + (_e1077.member_1.z * _e1309)));
let _e1317 = select(0f, _e1315, (_e1315 > 0f));
let _e1318 = (_e1285 / _e1296);
let _e1320 = (_e1317 * _e1317);
let _e1323 = (1f - ((_e1318 * _e1318) * (1f - _e1320)));
let _e1324 = (_e1323 <= 0f);
let _e1332 = ((_e1318 * _e1317) - sqrt(select(0f, _e1323, (_e1323 > 0f))));
let _e1339 = (2f * _e1317);
let _e1346 = select(((_e1077.member_1.x * _e1318) + (_e1307 * _e1332)), (_e1077.member_1.x + (_e1307 * _e1339)), _e1324);
let _e1347 = select(((_e1077.member_1.y * _e1318) + (_e1308 * _e1332)), (_e1077.member_1.y + (_e1308 * _e1339)), _e1324);
let _e1348 = select(((_e1077.member_1.z * _e1318) + (_e1309 * _e1332)), (_e1077.member_1.z + (_e1309 * _e1339)), _e1324);
let _e1353 = (((_e1346 * _e1346) + (_e1347 * _e1347)) + (_e1348 * _e1348));
let _e1356 = sqrt(select(0f, _e1353, (_e1353 > 0f)));
let _e1359 = (1f / select(1e-20f, _e1356, (_e1356 > 1e-20f)));
let _e1364 = (_e1296 / _e1285);
let _e1367 = (((_e1364 * _e1364) - 1f) + _e1320);
let _e1370 = sqrt(select(0f, _e1367, (_e1367 > 0f)));
let _e1371 = (_e1370 - _e1317);
let _e1372 = (_e1370 + _e1317);
let _e1375 = (_e1371 / select(1e-6f, _e1372, (_e1372 > 1e-6f)));
let _e1379 = ((_e1317 * _e1371) + 1f);
let _e1382 = (((_e1317 * _e1372) - 1f) / select(1e-6f, _e1379, (_e1379 > 1e-6f)));
let _e1395 = global_1.member.member_1;
let _e1398 = select(0f, select(select((((0.5f * _e1375) * _e1375) * (1f + (_e1382 * _e1382))), 1f, (_e1367 <= 0f)), 0f, (_e1285 == _e1296)), ((_e1395 & 1u) != 0u));
if (_e1077.member_8 == 0f) {
let _e1413 = type_19(_e1077.member, _e1077.member_1, _e1077.member_2, _e1218, _e1077.member_4, _e1077.member_5, _e1077.member_6, _e1077.member_7, _e1077.member_8, _e1077.member_9, _e1077.member_10, _e1077.member_11, _e1077.member_12, _e1077.member_13, _e1077.member_14);
phi_2275_ = type_19(_e1413.member, _e1413.member_1, _e1413.member_2, _e1413.member_3, _e1413.member_4, _e1413.member_5, _e1413.member_6, _e1413.member_7, _e1413.member_8, _e1413.member_9, _e1413.member_10, _e1398, _e1413.member_12, _e1413.member_13, _e1413.member_14);
} else {
phi_2275_ = _e1077;
}
let _e1430 = phi_2275_;
let _e1432 = (_e1430.member_8 + 1f);
let _e1447 = type_19(_e1430.member, _e1430.member_1, _e1430.member_2, _e1430.member_3, _e1430.member_4, _e1430.member_5, _e1430.member_6, _e1430.member_7, _e1432, _e1430.member_9, _e1430.member_10, _e1430.member_11, _e1430.member_12, _e1430.member_13, _e1430.member_14);
let _e1450 = ((_e92.member_2 == 0u) && (_e1432 >= 2f));
if (_e1324 && _e1450) {
let _e1475 = (((_e1430.member_1.x * _e1199) + (_e1430.member_1.y * _e1208)) + (_e1430.member_1.z * _e1217));
let _e1479 = (_e1430.member_1.x - (_e1199 * _e1475));
let _e1480 = (_e1430.member_1.y - (_e1208 * _e1475));
let _e1481 = (_e1430.member_1.z - (_e1217 * _e1475));
let _e1486 = (((_e1479 * _e1479) + (_e1480 * _e1480)) + (_e1481 * _e1481));
let _e1489 = sqrt(select(0f, _e1486, (_e1486 > 0f)));
let _e1492 = (1f / select(1e-20f, _e1489, (_e1489 > 1e-20f)));
phi_2328_ = type_19(_e1447.member, vec3<f32>((_e1479 * _e1492), (_e1480 * _e1492), (_e1481 * _e1492)), _e1447.member_2, _e1447.member_3, _e1447.member_4, _e1447.member_5, _e1447.member_6, _e1447.member_7, _e1447.member_8, _e1447.member_9, _e1447.member_10, _e1447.member_11, _e1447.member_12, _e1447.member_13, _e1447.member_14);
} else {
phi_2328_ = type_19(_e1447.member, vec3<f32>((_e1346 * _e1359), (_e1347 * _e1359), (_e1348 * _e1359)), _e1447.member_2, _e1447.member_3, _e1447.member_4, _e1447.member_5, _e1447.member_6, _e1447.member_7, _e1447.member_8, _e1447.member_9, _e1447.member_10, _e1447.member_11, _e1447.member_12, _e1447.member_13, _e1447.member_14);
}
let _e1513 = phi_2328_;
if _e1324 {
phi_2342_ = _e1513;
} else {
let _e1514 = (1f - _e1398);
phi_2342_ = type_19(_e1513.member, _e1513.member_1, vec3<f32>((_e1513.member_2.x * _e1514), (_e1513.member_2.y * _e1514), (_e1513.member_2.z * _e1514)), _e1513.member_3, _e1513.member_4, _e1513.member_5, _e1513.member_6, _e1513.member_7, _e1513.member_8, _e1513.member_9, _e1513.member_10, _e1513.member_11, _e1513.member_12, _e1513.member_13, _e1513.member_14);
}
let _e1541 = phi_2342_;
let _e1548 = global_1.member.member_17.member.member;
let _e1562 = ((((_e1548.member.member * _e1541.member.x) + (_e1548.member.member_1 * _e1541.member.y)) + (_e1548.member.member_2 * _e1541.member.z)) + _e1548.member_1);
let _e1571 = -((((_e1548.member.member * _e1541.member_1.x) + (_e1548.member.member_1 * _e1541.member_1.y)) + (_e1548.member.member_2 * _e1541.member_1.z)));
let _e1573 = (_e1571 > 1e-9f);
let _e1577 = ((_e1562 / select(1e-9f, _e1571, _e1573)) - 0.015625f);
let _e1580 = select(1e30f, select(0f, _e1577, (_e1577 > 0f)), ((_e1562 > 0f) && _e1573));
let _e1585 = global_1.member.member_17.member_1.member;
let _e1596 = ((((_e1585.member.member * _e1541.member.x) + (_e1585.member.member_1 * _e1541.member.y)) + (_e1585.member.member_2 * _e1541.member.z)) + _e1585.member_1);
let _e1602 = -((((_e1585.member.member * _e1541.member_1.x) + (_e1585.member.member_1 * _e1541.member_1.y)) + (_e1585.member.member_2 * _e1541.member_1.z)));
let _e1604 = (_e1602 > 1e-9f);
let _e1608 = ((_e1596 / select(1e-9f, _e1602, _e1604)) - 0.015625f);
let _e1611 = select(1e30f, select(0f, _e1608, (_e1608 > 0f)), ((_e1596 > 0f) && _e1604));
let _e1615 = (_e1611 < _e1580);
let _e1617 = select(select(-2i, -3i, _e1615), -1i, ((_e1580 >= 1e30f) && (_e1611 >= 1e30f)));
let _e1618 = select(_e1580, _e1611, _e1615);
let _e1633 = type_19(_e1541.member, _e1541.member_1, _e1541.member_2, _e1541.member_3, _e1541.member_4, _e1541.member_5, _e1541.member_6, _e1541.member_7, _e1541.member_8, _e1541.member_9, _e1541.member_10, _e1541.member_11, 0i, _e1541.member_13, _e1541.member_14);
let _e1648 = type_19(_e1633.member, _e1633.member_1, _e1633.member_2, _e1633.member_3, _e1633.member_4, _e1633.member_5, _e1633.member_6, _e1633.member_7, _e1633.member_8, _e1633.member_9, _e1633.member_10, _e1633.member_11, _e1633.member_12, _e1617, _e1633.member_14);
let _e1663 = type_19(_e1648.member, _e1648.member_1, _e1648.member_2, _e1648.member_3, _e1648.member_4, _e1648.member_5, _e1648.member_6, _e1648.member_7, _e1648.member_8, _e1648.member_9, _e1648.member_10, _e1648.member_11, _e1648.member_12, _e1648.member_13, _e1618);
let _e1666 = ((_e1395 & 2u) != 0u);
if (_e1450 && !(_e1666)) {
if (_e1617 == -1i) {
phi_2767_ = type_19(_e1663.member, _e1663.member_1, _e1663.member_2, _e1663.member_3, _e1663.member_4, _e1663.member_5, 1f, _e1663.member_7, _e1663.member_8, _e1663.member_9, _e1663.member_10, _e1663.member_11, _e1663.member_12, _e1663.member_13, _e1663.member_14);
} else {
let _e1742 = type_19(vec3<f32>((_e1541.member.x + (_e1541.member_1.x * _e1618)), (_e1541.member.y + (_e1541.member_1.y * _e1618)), (_e1541.member.z + (_e1541.member_1.z * _e1618))), _e1663.member_1, _e1663.member_2, _e1663.member_3, _e1663.member_4, _e1663.member_5, _e1663.member_6, _e1663.member_7, _e1663.member_8, _e1663.member_9, _e1663.member_10, _e1663.member_11, _e1663.member_12, _e1663.member_13, _e1663.member_14);
let _e1758 = type_19(_e1742.member, _e1742.member_1, _e1742.member_2, _e1742.member_3, _e1742.member_4, _e1742.member_5, _e1742.member_6, _e1742.member_7, _e1742.member_8, _e1742.member_9, _e1742.member_10, _e1742.member_11, _e1742.member_12, _e1742.member_13, (_e1618 - _e1618));
let _e1778 = type_19(_e1758.member, _e1758.member_1, _e1758.member_2, _e1758.member_3, _e1758.member_4, _e1758.member_5, _e1758.member_6, _e1758.member_7, _e1758.member_8, _e1758.member_9, (_e1541.member_10 + select(0f, _e1618, (_e1541.member_8 == 0f))), _e1758.member_11, _e1758.member_12, _e1758.member_13, _e1758.member_14);
phi_2767_ = type_19(_e1778.member, _e1778.member_1, _e1778.member_2, _e1778.member_3, _e1778.member_4, _e1778.member_5, 3f, _e1778.member_7, _e1778.member_8, _e1778.member_9, _e1778.member_10, _e1778.member_11, _e1778.member_12, _e1778.member_13, _e1778.member_14);
}
let _e1810 = phi_2767_;
phi_2788_ = _e1810;
} else {
let _e1673 = global_1.member.member_5;
if ((!(_e1450) && (_e1541.member_8 >= f32(bitcast<i32>(_e1673)))) && (select(_e1249, _e1077.member_7, _e1324) != 16i)) {
phi_2787_ = type_19(_e1663.member, _e1663.member_1, _e1663.member_2, _e1663.member_3, _e1663.member_4, _e1663.member_5, 2f, _e1663.member_7, _e1663.member_8, _e1663.member_9, _e1663.member_10, _e1663.member_11, _e1663.member_12, _e1663.member_13, _e1663.member_14);
} else {
if _e1666 {
phi_2786_ = type_19(_e1663.member, _e1663.member_1, _e1663.member_2, _e1663.member_3, _e1663.member_4, _e1663.member_5, 4f, _e1663.member_7, _e1663.member_8, _e1663.member_9, _e1663.member_10, _e1663.member_11, _e1663.member_12, _e1663.member_13, _e1663.member_14);
} else {
phi_2786_ = _e1663;
}
let _e1696 = phi_2786_;
phi_2787_ = _e1696;
}
let _e1713 = phi_2787_;
phi_2788_ = _e1713;
}
let _e1812 = phi_2788_;
let _e1829 = type_19(_e1812.member, _e1812.member_1, _e1812.member_2, _e1812.member_3, _e1812.member_4, _e1812.member_5, _e1812.member_6, select(_e1077.member_7, _e1249, !(_e1324)), _e1812.member_8, _e1812.member_9, _e1812.member_10, _e1812.member_11, _e1812.member_12, _e1812.member_13, _e1812.member_14);
let _e1844 = type_19(_e1829.member, _e1829.member_1, _e1829.member_2, _e1829.member_3, _e1218, _e1829.member_5, _e1829.member_6, _e1829.member_7, _e1829.member_8, _e1829.member_9, _e1829.member_10, _e1829.member_11, _e1829.member_12, _e1829.member_13, _e1829.member_14);
phi_2797_ = type_19(_e1844.member, _e1844.member_1, _e1844.member_2, _e1844.member_3, _e1844.member_4, 0f, _e1844.member_6, _e1844.member_7, _e1844.member_8, _e1844.member_9, _e1844.member_10, _e1844.member_11, _e1844.member_12, _e1844.member_13, _e1844.member_14);
} else {
phi_2797_ = _e1077;
}
let _e1861 = phi_2797_;
phi_2798_ = _e1861;
} else {
phi_2798_ = _e1077;
}
let _e1863 = phi_2798_;
phi_2799_ = _e1863;
}
let _e1865 = phi_2799_;
phi_2800_ = _e1865;
}
let _e1987 = phi_2800_;
phi_849_ = _e1987;
phi_852_ = (_e431 + 1i);
} else {
phi_849_ = type_19();
phi_852_ = i32();
}
let _e1989 = phi_849_;
let _e1991 = phi_852_;
continue;
continuing {
phi_848_ = _e1989;
phi_851_ = _e1991;
break if !(_e435);
}
}
let _e1994 = local;
let _e1998 = local_1;
let _e2002 = local_2;
let _e2006 = local_3;
let _e2010 = local_4;
let _e2014 = local_5;
let _e2018 = local_6;
let _e2022 = local_7;
let _e2026 = local_8;
let _e2030 = local_9;
let _e2034 = local_10;
let _e2038 = local_11;
let _e2042 = local_12;
let _e2046 = local_13;
let _e2050 = local_14;
let _e2054 = local_15;
let _e2057 = local_16;
let _e2061 = local_17;
let _e2064 = local_18;
let _e2067 = local_19;
let _e2070 = local_20;
let _e2073 = local_21;
let _e2077 = local_22;
let _e2081 = local_23;
global_3.member[_e101] = _e1994.member.x;
global_3.member[_e113] = _e1998.member.y;
global_3.member[_e124] = _e2002.member.z;
global_3.member[_e135] = _e2006.member_1.x;
global_3.member[_e146] = _e2010.member_1.y;
global_3.member[_e157] = _e2014.member_1.z;
global_3.member[_e168] = _e2018.member_2.x;
global_3.member[_e179] = _e2022.member_2.y;
global_3.member[_e190] = _e2026.member_2.z;
global_3.member[_e201] = _e2030.member_3.x;
global_3.member[_e212] = _e2034.member_3.y;
global_3.member[_e223] = _e2038.member_3.z;
global_3.member[_e234] = _e2042.member_4.x;
global_3.member[_e245] = _e2046.member_4.y;
global_3.member[_e256] = _e2050.member_4.z;
global_3.member[_e267] = _e2054.member_5;
let _e2118 = local_24;
global_3.member[_e278] = _e2118;
global_3.member[_e289] = f32(_e2057.member_7);
global_3.member[_e300] = _e2061.member_8;
global_3.member[_e311] = _e2064.member_9;
global_3.member[_e322] = _e2067.member_10;
global_3.member[_e333] = _e2070.member_11;
global_3.member[_e344] = f32(_e2073.member_12);
global_3.member[_e355] = f32(_e2077.member_13);
global_3.member[_e366] = _e2081.member_14;
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
