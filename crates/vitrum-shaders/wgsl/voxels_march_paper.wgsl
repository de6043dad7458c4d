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
struct type_21 {
member: array<u32>,
}
struct type_24 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(4)
var<storage> global_2: type_16;
@group(0) @binding(5)
var<storage, read_write> global_3: type_16;
@group(0) @binding(6)
var<storage, read_write> global_4: type_24;
@group(0) @binding(1)
var<storage> global_5: type_21;
@group(0) @binding(2)
var<storage> global_6: type_21;
@group(0) @binding(3)
var<storage> global_7: type_16;
fn function_() {
var phi_697_: u32;
var phi_777_: type_19;
var phi_780_: i32;
var phi_1399_: type_19;
var phi_1112_: type_19;
var phi_1400_: type_19;
var phi_2210_: type_19;
var phi_2541_: type_19;
var phi_2594_: type_19;
var phi_2608_: type_19;
var phi_3053_: type_19;
var phi_3054_: type_19;
var phi_3034_: type_19;
var phi_3055_: type_19;
var phi_3063_: type_19;
var phi_3064_: type_19;
var phi_3065_: type_19;
var phi_1732_: type_19;
var phi_3066_: type_19;
var phi_778_: type_19;
var phi_781_: i32;
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
let _e83 = global;
let _e91 = arrayLength((&global_2.member));
let _e98 = global_1.member.member;
if (_e83.x < _e98.member) {
if (_e83.y < _e98.member_1) {
let _e105 = (_e98.member * _e98.member_1);
let _e107 = ((_e83.y * _e98.member) + _e83.x);
let _e108 = bitcast<i32>(_e107);
let _e110 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e112 = select(_e110, _e108, (_e108 < _e110));
let _e118 = global_3.member[bitcast<u32>(select(0i, _e112, (_e112 > 0i)))];
let _e119 = (_e105 + _e107);
let _e120 = bitcast<i32>(_e119);
let _e122 = select(_e110, _e120, (_e120 < _e110));
let _e128 = global_3.member[bitcast<u32>(select(0i, _e122, (_e122 > 0i)))];
let _e130 = ((2u * _e105) + _e107);
let _e131 = bitcast<i32>(_e130);
let _e133 = select(_e110, _e131, (_e131 < _e110));
let _e139 = global_3.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e141 = ((3u * _e105) + _e107);
let _e142 = bitcast<i32>(_e141);
let _e144 = select(_e110, _e142, (_e142 < _e110));
let _e150 = global_3.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((4u * _e105) + _e107);
let _e153 = bitcast<i32>(_e152);
let _e155 = select(_e110, _e153, (_e153 < _e110));
let _e161 = global_3.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e163 = ((5u * _e105) + _e107);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e110, _e164, (_e164 < _e110));
let _e172 = global_3.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((6u * _e105) + _e107);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e110, _e175, (_e175 < _e110));
let _e183 = global_3.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((7u * _e105) + _e107);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e110, _e186, (_e186 < _e110));
let _e194 = global_3.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((8u * _e105) + _e107);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e110, _e197, (_e197 < _e110));
let _e205 = global_3.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((9u * _e105) + _e107);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e110, _e208, (_e208 < _e110));
let _e216 = global_3.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e218 = ((10u * _e105) + _e107);
let _e219 = bitcast<i32>(_e218);
let _e221 = select(_e110, _e219, (_e219 < _e110));
let _e227 = global_3.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e229 = ((11u * _e105) + _e107);
let _e230 = bitcast<i32>(_e229);
let _e232 = select(_e110, _e230, (_e230 < _e110));
let _e238 = global_3.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e240 = ((12u * _e105) + _e107);
let _e241 = bitcast<i32>(_e240);
let _e243 = select(_e110, _e241, (_e241 < _e110));
let _e249 = global_3.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
let _e251 = ((13u * _e105) + _e107);
let _e252 = bitcast<i32>(_e251);
let _e254 = select(_e110, _e252, (_e252 < _e110));
let _e260 = global_3.member[bitcast<u32>(select(0i, _e254, (_e254 > 0i)))];
let _e262 = ((14u * _e105) + _e107);
let _e263 = bitcast<i32>(_e262);
let _e265 = select(_e110, _e263, (_e263 < _e110));
let _e271 = global_3.member[bitcast<u32>(select(0i, _e265, (_e265 > 0i)))];
let _e273 = ((15u * _e105) + _e107);
let _e274 = bitcast<i32>(_e273);
let _e276 = select(_e110, _e274, (_e274 < _e110));
let _e282 = global_3.member[bitcast<u32>(select(0i, _e276, (_e276 > 0i)))];
let _e284 = ((16u * _e105) + _e107);
let _e285 = bitcast<i32>(_e284);
let _e287 = select(_e110, _e285, (_e285 < _e110));
let _e293 = global_3.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e295 = ((17u * _e105) + _e107);
let _e296 = bitcast<i32>(_e295);
let _e298 = select(_e110, _e296, (_e296 < _e110));
let _e304 = global_3.member[bitcast<u32>(select(0i, _e298, (_e298 > 0i)))];
let _e306 = ((18u * _e105) + _e107);
let _e307 = bitcast<i32>(_e306);
let _e309 = select(_e110, _e307, (_e307 < _e110));
let _e315 = global_3.member[bitcast<u32>(select(0i, _e309, (_e309 > 0i)))];
let _e317 = ((19u * _e105) + _e107);
let _e318 = bitcast<i32>(_e317);
let _e320 = select(_e110, _e318, (_e318 < _e110));
let _e326 = global_3.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e328 = ((20u * _e105) + _e107);
let _e329 = bitcast<i32>(_e328);
let _e331 = select(_e110, _e329, (_e329 < _e110));
let _e337 = global_3.member[bitcast<u32>(select(0i, _e331, (_e331 > 0i)))];
let _e339 = ((21u * _e105) + _e107);
let _e340 = bitcast<i32>(_e339);
let _e342 = select(_e110, _e340, (_e340 < _e110));
let _e348 = global_3.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e350 = ((22u * _e105) + _e107);
let _e351 = bitcast<i32>(_e350);
let _e353 = select(_e110, _e351, (_e351 < _e110));
let _e359 = global_3.member[bitcast<u32>(select(0i, _e353, (_e353 > 0i)))];
let _e361 = ((23u * _e105) + _e107);
let _e362 = bitcast<i32>(_e361);
let _e364 = select(_e110, _e362, (_e362 < _e110));
let _e370 = global_3.member[bitcast<u32>(select(0i, _e364, (_e364 > 0i)))];
let _e372 = ((24u * _e105) + _e107);
let _e373 = bitcast<i32>(_e372);
let _e375 = select(_e110, _e373, (_e373 < _e110));
let _e381 = global_3.member[bitcast<u32>(select(0i, _e375, (_e375 > 0i)))];
let _e383 = ((25u * _e105) + _e107);
let _e384 = bitcast<i32>(_e383);
let _e386 = select(_e110, _e384, (_e384 < _e110));
let _e392 = global_3.member[bitcast<u32>(select(0i, _e386, (_e386 > 0i)))];
let _e394 = ((26u * _e105) + _e107);
let _e395 = bitcast<i32>(_e394);
let _e397 = select(_e110, _e395, (_e395 < _e110));
let _e403 = global_3.member[bitcast<u32>(select(0i, _e397, (_e397 > 0i)))];
let _e405 = ((27u * _e105) + _e107);
let _e406 = bitcast<i32>(_e405);
let _e408 = select(_e110, _e406, (_e406 < _e110));
let _e414 = global_3.member[bitcast<u32>(select(0i, _e408, (_e408 > 0i)))];
if (_e293 == 0f) {
phi_697_ = 3u;
} else {
phi_697_ = select(0u, 1u, (_e293 == 4f));
}
let _e419 = phi_697_;
if (_e419 > 0u) {
if (arrayLength((&global_4.member)) >= 3u) {
let _e428 = atomicLoad((&global_4.member[0u]));
if (_e428 == 0u) {
atomicStore((&global_4.member[0u]), ((_e98.member + 7u) / 8u));
atomicStore((&global_4.member[1u]), ((_e98.member_1 + 7u) / 8u));
atomicStore((&global_4.member[2u]), 1u);
}
}
}
if (_e419 > 1u) {
let _e467 = global_1.member.member_2.member;
let _e468 = bitcast<i32>(_e467);
let _e472 = global_1.member.member_2.member_1;
let _e473 = bitcast<i32>(_e472);
let _e477 = global_1.member.member_2.member_2;
let _e478 = bitcast<i32>(_e477);
phi_777_ = type_19(vec3<f32>(_e118, _e128, _e139), vec3<f32>(_e150, _e161, _e172), vec3<f32>(_e183, _e194, _e205), vec3<f32>(_e216, _e227, _e238), vec3<f32>(_e249, _e260, _e271), _e282, _e293, select(0i, select(select(i32(_e304), i32(-2147483648), (_e304 < -2147483600f)), 2147483647i, (_e304 > 2147483500f)), (_e304 == _e304)), _e315, _e326, _e337, _e348, vec3<f32>(_e359, _e370, _e381), select(0i, select(select(i32(_e392), i32(-2147483648), (_e392 < -2147483600f)), 2147483647i, (_e392 > 2147483500f)), (_e392 == _e392)), select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < -2147483600f)), 2147483647i, (_e403 > 2147483500f)), (_e403 == _e403)), _e414);
phi_780_ = 0i;
loop {
let _e483 = phi_777_;
let _e485 = phi_780_;
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
let _e489 = ((_e485 < 256i) && (_e483.member_6 == 0f));
local_27 = _e483.member_6;
if _e489 {
let _e495 = bitcast<f32>((bitcast<u32>(_e483.member_1.x) & 2147483647u));
let _e499 = bitcast<f32>((bitcast<u32>(_e483.member_1.y) & 2147483647u));
let _e501 = select(_e499, _e495, (_e495 > _e499));
let _e505 = bitcast<f32>((bitcast<u32>(_e483.member_1.z) & 2147483647u));
let _e507 = select(_e505, _e501, (_e501 > _e505));
let _e510 = (1f / select(0.5f, _e507, (_e507 > 0.5f)));
let _e512 = (_e483.member_15 <= _e510);
if _e512 {
let _e849 = type_19(vec3<f32>((_e483.member.x + (_e483.member_1.x * _e483.member_15)), (_e483.member.y + (_e483.member_1.y * _e483.member_15)), (_e483.member.z + (_e483.member_1.z * _e483.member_15))), _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, _e483.member_6, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e483.member_15);
let _e867 = type_19(_e849.member, _e849.member_1, _e849.member_2, _e849.member_3, _e849.member_4, (_e483.member_5 + _e483.member_15), _e849.member_6, _e849.member_7, _e849.member_8, _e849.member_9, _e849.member_10, _e849.member_11, _e849.member_12, _e849.member_13, _e849.member_14, _e849.member_15);
let _e884 = type_19(_e867.member, _e867.member_1, _e867.member_2, _e867.member_3, _e867.member_4, _e867.member_5, _e867.member_6, _e867.member_7, _e867.member_8, _e867.member_9, _e867.member_10, _e867.member_11, _e867.member_12, _e867.member_13, _e867.member_14, (_e483.member_15 - _e483.member_15));
let _e905 = type_19(_e884.member, _e884.member_1, _e884.member_2, _e884.member_3, _e884.member_4, _e884.member_5, _e884.member_6, _e884.member_7, _e884.member_8, _e884.member_9, (_e483.member_10 + select(0f, _e483.member_15, (_e483.member_8 == 0f))), _e884.member_11, _e884.member_12, _e884.member_13, _e884.member_14, _e884.member_15);
if (_e483.member_7 != 16i) {
let _e924 = type_19(_e905.member, _e905.member_1, _e905.member_2, _e905.member_3, _e905.member_4, _e905.member_5, _e905.member_6, _e905.member_7, _e905.member_8, (_e483.member_9 + _e483.member_15), _e905.member_10, _e905.member_11, _e905.member_12, _e905.member_13, _e905.member_14, _e905.member_15);
let _e925 = (_e483.member_7 * 4i);
let _e926 = (_e925 + 1i);
let _e928 = (bitcast<i32>(_e91) - 1i);
let _e930 = select(_e928, _e926, (_e926 < _e928));
let _e936 = global_2.member[bitcast<u32>(select(0i, _e930, (_e930 > 0i)))];
let _e938 = -((_e936 * _e483.member_15));
let _e940 = select(-87f, _e938, (_e938 > -87f));
let _e942 = select(88f, _e940, (_e940 < 88f));
let _e944 = ((_e942 * 1.442695f) + 0.5f);
let _e946 = select(-127f, _e944, (_e944 > -127f));
let _e948 = select(128f, _e946, (_e946 < 128f));
let _e955 = select(0i, select(select(i32(_e948), i32(-2147483648), (_e948 < -2147483600f)), 2147483647i, (_e948 > 2147483500f)), (_e948 == _e948));
let _e959 = (_e955 - select(0i, 1i, (_e948 < f32(_e955))));
let _e960 = f32(_e959);
let _e964 = ((_e942 - (_e960 * 0.6933594f)) - (_e960 * -2.1219444e-4f));
let _e985 = (_e925 + 2i);
let _e987 = select(_e928, _e985, (_e985 < _e928));
let _e993 = global_2.member[bitcast<u32>(select(0i, _e987, (_e987 > 0i)))];
let _e995 = -((_e993 * _e483.member_15));
let _e997 = select(-87f, _e995, (_e995 > -87f));
let _e999 = select(88f, _e997, (_e997 < 88f));
let _e1001 = ((_e999 * 1.442695f) + 0.5f);
let _e1003 = select(-127f, _e1001, (_e1001 > -127f));
let _e1005 = select(128f, _e1003, (_e1003 < 128f));
let _e1012 = select(0i, select(select(i32(_e1005), i32(-2147483648), (_e1005 < -2147483600f)), 2147483647i, (_e1005 > 2147483500f)), (_e1005 == _e1005));
let _e1016 = (_e1012 - select(0i, 1i, (_e1005 < f32(_e1012))));
let _e1017 = f32(_e1016);
let _e1021 = ((_e999 - (_e1017 * 0.6933594f)) - (_e1017 * -2.1219444e-4f));
let _e1042 = (_e925 + 3i);
let _e1044 = select(_e928, _e1042, (_e1042 < _e928));
let _e1050 = global_2.member[bitcast<u32>(select(0i, _e1044, (_e1044 > 0i)))];
let _e1052 = -((_e1050 * _e483.member_15));
let _e1054 = select(-87f, _e1052, (_e1052 > -87f));
let _e1056 = select(88f, _e1054, (_e1054 < 88f));
let _e1058 = ((_e1056 * 1.442695f) + 0.5f);
let _e1060 = select(-127f, _e1058, (_e1058 > -127f));
let _e1062 = select(128f, _e1060, (_e1060 < 128f));
let _e1069 = select(0i, select(select(i32(_e1062), i32(-2147483648), (_e1062 < -2147483600f)), 2147483647i, (_e1062 > 2147483500f)), (_e1062 == _e1062));
let _e1073 = (_e1069 - select(0i, 1i, (_e1062 < f32(_e1069))));
let _e1074 = f32(_e1073);
let _e1078 = ((_e1056 - (_e1074 * 0.6933594f)) - (_e1074 * -2.1219444e-4f));
phi_1112_ = type_19(_e924.member, _e924.member_1, vec3<f32>((_e483.member_2.x * ((1f + (_e964 * (1f + (_e964 * (0.5f + (_e964 * (0.16666667f + (_e964 * (0.041666668f + (_e964 * (0.008333334f + (_e964 * (0.001388889f + (_e964 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e959 + 127i)) << bitcast<u32>(23i))))), (_e483.member_2.y * ((1f + (_e1021 * (1f + (_e1021 * (0.5f + (_e1021 * (0.16666667f + (_e1021 * (0.041666668f + (_e1021 * (0.008333334f + (_e1021 * (0.001388889f + (_e1021 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1016 + 127i)) << bitcast<u32>(23i))))), (_e483.member_2.z * ((1f + (_e1078 * (1f + (_e1078 * (0.5f + (_e1078 * (0.16666667f + (_e1078 * (0.041666668f + (_e1078 * (0.008333334f + (_e1078 * (0.001388889f + (_e1078 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1073 + 127i)) << bitcast<u32>(23i)))))), _e924.member_3, _e924.member_4, _e924.member_5, _e924.member_6, _e924.member_7, _e924.member_8, _e924.member_9, _e924.member_10, _e924.member_11, _e924.member_12, _e924.member_13, _e924.member_14, _e924.member_15);
} else {
phi_1112_ = _e905;
}
let _e1126 = phi_1112_;
phi_1400_ = type_19(_e1126.member, _e1126.member_1, _e1126.member_2, _e1126.member_3, _e1126.member_4, _e1126.member_5, 3f, _e1126.member_7, _e1126.member_8, _e1126.member_9, _e1126.member_10, _e1126.member_11, _e1126.member_12, _e1126.member_13, _e1126.member_14, _e1126.member_15);
} else {
let _e542 = type_19(vec3<f32>((_e483.member.x + (_e483.member_1.x * _e510)), (_e483.member.y + (_e483.member_1.y * _e510)), (_e483.member.z + (_e483.member_1.z * _e510))), _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, _e483.member_6, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e483.member_15);
let _e560 = type_19(_e542.member, _e542.member_1, _e542.member_2, _e542.member_3, _e542.member_4, (_e483.member_5 + _e510), _e542.member_6, _e542.member_7, _e542.member_8, _e542.member_9, _e542.member_10, _e542.member_11, _e542.member_12, _e542.member_13, _e542.member_14, _e542.member_15);
let _e577 = type_19(_e560.member, _e560.member_1, _e560.member_2, _e560.member_3, _e560.member_4, _e560.member_5, _e560.member_6, _e560.member_7, _e560.member_8, _e560.member_9, _e560.member_10, _e560.member_11, _e560.member_12, _e560.member_13, _e560.member_14, (_e483.member_15 - _e510));
let _e598 = type_19(_e577.member, _e577.member_1, _e577.member_2, _e577.member_3, _e577.member_4, _e577.member_5, _e577.member_6, _e577.member_7, _e577.member_8, _e577.member_9, (_e483.member_10 + select(0f, _e510, (_e483.member_8 == 0f))), _e577.member_11, _e577.member_12, _e577.member_13, _e577.member_14, _e577.member_15);
if (_e483.member_7 != 16i) {
let _e617 = type_19(_e598.member, _e598.member_1, _e598.member_2, _e598.member_3, _e598.member_4, _e598.member_5, _e598.member_6, _e598.member_7, _e598.member_8, (_e483.member_9 + _e510), _e598.member_10, _e598.member_11, _e598.member_12, _e598.member_13, _e598.member_14, _e598.member_15);
let _e618 = (_e483.member_7 * 4i);
let _e619 = (_e618 + 1i);
let _e621 = (bitcast<i32>(_e91) - 1i);
let _e623 = select(_e621, _e619, (_e619 < _e621));
let _e629 = global_2.member[bitcast<u32>(select(0i, _e623, (_e623 > 0i)))];
let _e631 = -((_e629 * _e510));
let _e633 = select(-87f, _e631, (_e631 > -87f));
let _e635 = select(88f, _e633, (_e633 < 88f));
let _e637 = ((_e635 * 1.442695f) + 0.5f);
let _e639 = select(-127f, _e637, (_e637 > -127f));
let _e641 = select(128f, _e639, (_e639 < 128f));
let _e648 = select(0i, select(select(i32(_e641), i32(-2147483648), (_e641 < -2147483600f)), 2147483647i, (_e641 > 2147483500f)), (_e641 == _e641));
let _e652 = (_e648 - select(0i, 1i, (_e641 < f32(_e648))));
let _e653 = f32(_e652);
let _e657 = ((_e635 - (_e653 * 0.6933594f)) - (_e653 * -2.1219444e-4f));
let _e678 = (_e618 + 2i);
let _e680 = select(_e621, _e678, (_e678 < _e621));
let _e686 = global_2.member[bitcast<u32>(select(0i, _e680, (_e680 > 0i)))];
let _e688 = -((_e686 * _e510));
let _e690 = select(-87f, _e688, (_e688 > -87f));
let _e692 = select(88f, _e690, (_e690 < 88f));
let _e694 = ((_e692 * 1.442695f) + 0.5f);
let _e696 = select(-127f, _e694, (_e694 > -127f));
let _e698 = select(128f, _e696, (_e696 < 128f));
let _e705 = select(0i, select(select(i32(_e698), i32(-2147483648), (_e698 < -2147483600f)), 2147483647i, (_e698 > 2147483500f)), (_e698 == _e698));
let _e709 = (_e705 - select(0i, 1i, (_e698 < f32(_e705))));
let _e710 = f32(_e709);
let _e714 = ((_e692 - (_e710 * 0.6933594f)) - (_e710 * -2.1219444e-4f));
let _e735 = (_e618 + 3i);
let _e737 = select(_e621, _e735, (_e735 < _e621));
let _e743 = global_2.member[bitcast<u32>(select(0i, _e737, (_e737 > 0i)))];
let _e745 = -((_e743 * _e510));
let _e747 = select(-87f, _e745, (_e745 > -87f));
let _e749 = select(88f, _e747, (_e747 < 88f));
let _e751 = ((_e749 * 1.442695f) + 0.5f);
let _e753 = select(-127f, _e751, (_e751 > -127f));
let _e755 = select(128f, _e753, (_e753 < 128f));
let _e762 = select(0i, select(select(i32(_e755), i32(-2147483648), (_e755 < -2147483600f)), 2147483647i, (_e755 > 2147483500f)), (_e755 == _e755));
let _e766 = (_e762 - select(0i, 1i, (_e755 < f32(_e762))));
let _e767 = f32(_e766);
let _e771 = ((_e749 - (_e767 * 0.6933594f)) - (_e767 * -2.1219444e-4f));
phi_1399_ = type_19(_e617.member, _e617.member_1, vec3<f32>((_e483.member_2.x * ((1f + (_e657 * (1f + (_e657 * (0.5f + (_e657 * (0.16666667f + (_e657 * (0.041666668f + (_e657 * (0.008333334f + (_e657 * (0.001388889f + (_e657 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e652 + 127i)) << bitcast<u32>(23i))))), (_e483.member_2.y * ((1f + (_e714 * (1f + (_e714 * (0.5f + (_e714 * (0.16666667f + (_e714 * (0.041666668f + (_e714 * (0.008333334f + (_e714 * (0.001388889f + (_e714 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e709 + 127i)) << bitcast<u32>(23i))))), (_e483.member_2.z * ((1f + (_e771 * (1f + (_e771 * (0.5f + (_e771 * (0.16666667f + (_e771 * (0.041666668f + (_e771 * (0.008333334f + (_e771 * (0.001388889f + (_e771 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e766 + 127i)) << bitcast<u32>(23i)))))), _e617.member_3, _e617.member_4, _e617.member_5, _e617.member_6, _e617.member_7, _e617.member_8, _e617.member_9, _e617.member_10, _e617.member_11, _e617.member_12, _e617.member_13, _e617.member_14, _e617.member_15);
} else {
phi_1399_ = _e598;
}
let _e819 = phi_1399_;
phi_1400_ = _e819;
}
let _e1144 = phi_1400_;
if (!(_e512) && ((((((_e1144.member.x < 0f) || (_e1144.member.y < 0f)) || (_e1144.member.z < 0f)) || (_e1144.member.x >= f32(_e468))) || (_e1144.member.y >= f32(_e473))) || (_e1144.member.z >= f32(_e478)))) {
if (_e1144.member_14 == -1i) {
phi_1732_ = type_19(_e1144.member, _e1144.member_1, _e1144.member_2, _e1144.member_3, _e1144.member_4, _e1144.member_5, 1f, _e1144.member_7, _e1144.member_8, _e1144.member_9, _e1144.member_10, _e1144.member_11, _e1144.member_12, _e1144.member_13, _e1144.member_14, _e1144.member_15);
} else {
let _e2250 = type_19(vec3<f32>((_e1144.member.x + (_e1144.member_1.x * _e1144.member_15)), (_e1144.member.y + (_e1144.member_1.y * _e1144.member_15)), (_e1144.member.z + (_e1144.member_1.z * _e1144.member_15))), _e1144.member_1, _e1144.member_2, _e1144.member_3, _e1144.member_4, _e1144.member_5, _e1144.member_6, _e1144.member_7, _e1144.member_8, _e1144.member_9, _e1144.member_10, _e1144.member_11, _e1144.member_12, _e1144.member_13, _e1144.member_14, _e1144.member_15);
let _e2268 = type_19(_e2250.member, _e2250.member_1, _e2250.member_2, _e2250.member_3, _e2250.member_4, (_e1144.member_5 + _e1144.member_15), _e2250.member_6, _e2250.member_7, _e2250.member_8, _e2250.member_9, _e2250.member_10, _e2250.member_11, _e2250.member_12, _e2250.member_13, _e2250.member_14, _e2250.member_15);
let _e2285 = type_19(_e2268.member, _e2268.member_1, _e2268.member_2, _e2268.member_3, _e2268.member_4, _e2268.member_5, _e2268.member_6, _e2268.member_7, _e2268.member_8, _e2268.member_9, _e2268.member_10, _e2268.member_11, _e2268.member_12, _e2268.member_13, _e2268.member_14, (_e1144.member_15 - _e1144.member_15));
let _e2306 = type_19(_e2285.member, _e2285.member_1, _e2285.member_2, _e2285.member_3, _e2285.member_4, _e2285.member_5, _e2285.member_6, _e2285.member_7, _e2285.member_8, _e2285.member_9, (_e1144.member_10 + select(0f, _e1144.member_15, (_e1144.member_8 == 0f))), _e2285.member_11, _e2285.member_12, _e2285.member_13, _e2285.member_14, _e2285.member_15);
phi_1732_ = type_19(_e2306.member, _e2306.member_1, _e2306.member_2, _e2306.member_3, _e2306.member_4, _e2306.member_5, 3f, _e2306.member_7, _e2306.member_8, _e2306.member_9, _e2306.member_10, _e2306.member_11, _e2306.member_12, _e2306.member_13, _e2306.member_14, _e2306.member_15);
}
let _e2340 = phi_1732_;
phi_3066_ = _e2340;
} else {
if _e512 {
phi_3065_ = _e1144;
} else {
let _e1166 = f32((_e468 - 1i));
let _e1168 = select(0f, _e1144.member.x, (_e1144.member.x > 0f));
let _e1170 = select(_e1166, _e1168, (_e1168 < _e1166));
let _e1177 = select(0i, select(select(i32(_e1170), i32(-2147483648), (_e1170 < -2147483600f)), 2147483647i, (_e1170 > 2147483500f)), (_e1170 == _e1170));
let _e1181 = (_e1177 - select(0i, 1i, (_e1170 < f32(_e1177))));
let _e1183 = f32((_e473 - 1i));
let _e1185 = select(0f, _e1144.member.y, (_e1144.member.y > 0f));
let _e1187 = select(_e1183, _e1185, (_e1185 < _e1183));
let _e1194 = select(0i, select(select(i32(_e1187), i32(-2147483648), (_e1187 < -2147483600f)), 2147483647i, (_e1187 > 2147483500f)), (_e1187 == _e1187));
let _e1200 = f32((_e478 - 1i));
let _e1202 = select(0f, _e1144.member.z, (_e1144.member.z > 0f));
let _e1204 = select(_e1200, _e1202, (_e1202 < _e1200));
let _e1211 = select(0i, select(select(i32(_e1204), i32(-2147483648), (_e1204 < -2147483600f)), 2147483647i, (_e1204 > 2147483500f)), (_e1204 == _e1204));
let _e1221 = (((((_e1211 - select(0i, 1i, (_e1204 < f32(_e1211)))) * _e473) + (_e1194 - select(0i, 1i, (_e1187 < f32(_e1194))))) * ((_e468 + 31i) >> bitcast<u32>(5i))) + (_e1181 >> bitcast<u32>(5i)));
let _e1223 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1225 = select(_e1223, _e1221, (_e1221 < _e1223));
let _e1231 = global_5.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1234 = (bitcast<u32>((_e1181 & 31i)) & 31u);
if (((_e1231 >> bitcast<u32>(_e1234)) & 1u) == 1u) {
let _e1240 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e1242 = select(_e1240, _e1221, (_e1221 < _e1240));
let _e1248 = global_6.member[bitcast<u32>(select(0i, _e1242, (_e1242 > 0i)))];
let _e1256 = (bitcast<i32>((_e1248 + countOneBits((_e1231 & ((1u << bitcast<u32>(_e1234)) - 1u))))) * 4i);
let _e1258 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1260 = select(_e1258, _e1256, (_e1256 < _e1258));
let _e1266 = global_7.member[bitcast<u32>(select(0i, _e1260, (_e1260 > 0i)))];
let _e1267 = (_e1256 + 1i);
let _e1269 = select(_e1258, _e1267, (_e1267 < _e1258));
let _e1275 = global_7.member[bitcast<u32>(select(0i, _e1269, (_e1269 > 0i)))];
let _e1276 = (_e1256 + 2i);
let _e1278 = select(_e1258, _e1276, (_e1276 < _e1258));
let _e1284 = global_7.member[bitcast<u32>(select(0i, _e1278, (_e1278 > 0i)))];
let _e1285 = vec3<f32>(_e1266, _e1275, _e1284);
let _e1286 = (_e1256 + 3i);
let _e1288 = select(_e1258, _e1286, (_e1286 < _e1258));
let _e1294 = global_7.member[bitcast<u32>(select(0i, _e1288, (_e1288 > 0i)))];
let _e1296 = select(0f, _e1294, (_e1294 > 0f));
let _e1298 = select(16f, _e1296, (_e1296 < 16f));
let _e1305 = select(0i, select(select(i32(_e1298), i32(-2147483648), (_e1298 < -2147483600f)), 2147483647i, (_e1298 > 2147483500f)), (_e1298 == _e1298));
let _e1314 = (((_e483.member_1.x * _e1266) + (_e483.member_1.y * _e1275)) + (_e483.member_1.z * _e1284));
let _e1316 = select(16i, (_e1305 - select(0i, 1i, (_e1298 < f32(_e1305)))), (_e1314 < 0f));
let _e1330 = global_1.member.member_12;
if ((!(((_e1144.member_8 > 0f) && ((((_e1266 * _e1144.member_4.x) + (_e1275 * _e1144.member_4.y)) + (_e1284 * _e1144.member_4.z)) > _e1330))) && (_e1314 != 0f)) && (_e1316 != _e1144.member_7)) {
let _e1340 = (_e1144.member_7 * 4i);
let _e1342 = (bitcast<i32>(_e91) - 1i);
let _e1344 = select(_e1342, _e1340, (_e1340 < _e1342));
let _e1350 = global_2.member[bitcast<u32>(select(0i, _e1344, (_e1344 > 0i)))];
let _e1351 = (_e1144.member_7 == 16i);
let _e1352 = select(_e1350, 1f, _e1351);
let _e1353 = (_e1316 * 4i);
let _e1355 = select(_e1342, _e1353, (_e1353 < _e1342));
let _e1361 = global_2.member[bitcast<u32>(select(0i, _e1355, (_e1355 > 0i)))];
let _e1363 = select(_e1361, 1f, (_e1316 == 16i));
let _e1373 = select(1f, -1f, ((((_e1144.member_1.x * _e1266) + (_e1144.member_1.y * _e1275)) + (_e1144.member_1.z * _e1284)) > 0f));
let _e1374 = (_e1266 * _e1373);
let _e1375 = (_e1275 * _e1373);
let _e1376 = (_e1284 * _e1373);
let _e1382 = -((((_e1144.member_1.x * _e1374) + (_e1144.member_1.y * _e1375)) + (_e1144.member_1.z * _e1376)));
let _e1384 = select(0f, _e1382, (_e1382 > 0f));
let _e1385 = (_e1352 / _e1363);
let _e1387 = (_e1384 * _e1384);
let _e1390 = (1f - ((_e1385 * _e1385) * (1f - _e1387)));
let _e1391 = (_e1390 <= 0f);
let _e1399 = ((_e1385 * _e1384) - sqrt(select(0f, _e1390, (_e1390 > 0f))));
let _e1406 = (2f * _e1384);
let _e1413 = select(((_e1144.member_1.x * _e1385) + (_e1374 * _e1399)), (_e1144.member_1.x + (_e1374 * _e1406)), _e1391);
let _e1414 = select(((_e1144.member_1.y * _e1385) + (_e1375 * _e1399)), (_e1144.member_1.y + (_e1375 * _e1406)), _e1391);
let _e1415 = select(((_e1144.member_1.z * _e1385) + (_e1376 * _e1399)), (_e1144.member_1.z + (_e1376 * _e1406)), _e1391);
let _e1420 = (((_e1413 * _e1413) + (_e1414 * _e1414)) + (_e1415 * _e1415));
let _e1423 = sqrt(select(0f, _e1420, (_e1420 > 0f)));
let _e1426 = (1f / select(1e-20f, _e1423, (_e1423 > 1e-20f)));
let _e1431 = (_e1363 / _e1352);
let _e1434 = (((_e1431 * _e1431) - 1f) + _e1387);
let _e1437 = sqrt(select(0f, _e1434, (_e1434 > 0f)));
let _e1438 = (_e1437 - _e1384);
let _e1439 = (_e1437 + _e1384);
let _e1442 = (_e1438 / select(1e-6f, _e1439, (_e1439 > 1e-6f)));
let _e1446 = ((_e1384 * _e1438) + 1f);
let _e1449 = (((_e1384 * _e1439) - 1f) / select(1e-6f, _e1446, (_e1446 > 1e-6f)));
let _e1459 = (_e1144.member_8 == 0f);
let _e1462 = global_1.member.member_1;
let _e1465 = select(0f, select(select((((0.5f * _e1442) * _e1442) * (1f + (_e1449 * _e1449))), 1f, (_e1434 <= 0f)), 0f, (_e1352 == _e1363)), ((_e1462 & 1u) != 0u));
let _e1466 = (_e1459 && _e1351);
if _e1459 {
let _e1482 = type_19(_e1144.member, _e1144.member_1, _e1144.member_2, _e1285, _e1144.member_4, _e1144.member_5, _e1144.member_6, _e1144.member_7, _e1144.member_8, _e1144.member_9, _e1144.member_10, _e1144.member_11, _e1144.member_12, _e1144.member_13, _e1144.member_14, _e1144.member_15);
phi_2210_ = type_19(_e1482.member, _e1482.member_1, _e1482.member_2, _e1482.member_3, _e1482.member_4, _e1482.member_5, _e1482.member_6, _e1482.member_7, _e1482.member_8, _e1482.member_9, _e1482.member_10, select(0f, _e1465, _e1466), _e1482.member_12, _e1482.member_13, _e1482.member_14, _e1482.member_15);
} else {
phi_2210_ = _e1144;
}
let _e1501 = phi_2210_;
let _e1503 = !(_e1391);
if (!(_e1466) && _e1503) {
let _e1509 = select(_e1501.member_5, _e1501.member_9, (_e1501.member_8 == 0f));
let _e1510 = (_e1340 + 1i);
let _e1512 = select(_e1342, _e1510, (_e1510 < _e1342));
let _e1518 = global_2.member[bitcast<u32>(select(0i, _e1512, (_e1512 > 0i)))];
let _e1520 = -((_e1518 * _e1509));
let _e1522 = select(-87f, _e1520, (_e1520 > -87f));
let _e1524 = select(88f, _e1522, (_e1522 < 88f));
let _e1526 = ((_e1524 * 1.442695f) + 0.5f);
let _e1528 = select(-127f, _e1526, (_e1526 > -127f));
let _e1530 = select(128f, _e1528, (_e1528 < 128f));
let _e1537 = select(0i, select(select(i32(_e1530), i32(-2147483648), (_e1530 < -2147483600f)), 2147483647i, (_e1530 > 2147483500f)), (_e1530 == _e1530));
let _e1541 = (_e1537 - select(0i, 1i, (_e1530 < f32(_e1537))));
let _e1542 = f32(_e1541);
let _e1546 = ((_e1524 - (_e1542 * 0.6933594f)) - (_e1542 * -2.1219444e-4f));
let _e1567 = (_e1340 + 2i);
let _e1569 = select(_e1342, _e1567, (_e1567 < _e1342));
let _e1575 = global_2.member[bitcast<u32>(select(0i, _e1569, (_e1569 > 0i)))];
let _e1577 = -((_e1575 * _e1509));
let _e1579 = select(-87f, _e1577, (_e1577 > -87f));
let _e1581 = select(88f, _e1579, (_e1579 < 88f));
let _e1583 = ((_e1581 * 1.442695f) + 0.5f);
let _e1585 = select(-127f, _e1583, (_e1583 > -127f));
let _e1587 = select(128f, _e1585, (_e1585 < 128f));
let _e1594 = select(0i, select(select(i32(_e1587), i32(-2147483648), (_e1587 < -2147483600f)), 2147483647i, (_e1587 > 2147483500f)), (_e1587 == _e1587));
let _e1598 = (_e1594 - select(0i, 1i, (_e1587 < f32(_e1594))));
let _e1599 = f32(_e1598);
let _e1603 = ((_e1581 - (_e1599 * 0.6933594f)) - (_e1599 * -2.1219444e-4f));
let _e1624 = (_e1340 + 3i);
let _e1626 = select(_e1342, _e1624, (_e1624 < _e1342));
let _e1632 = global_2.member[bitcast<u32>(select(0i, _e1626, (_e1626 > 0i)))];
let _e1634 = -((_e1632 * _e1509));
let _e1636 = select(-87f, _e1634, (_e1634 > -87f));
let _e1638 = select(88f, _e1636, (_e1636 < 88f));
let _e1640 = ((_e1638 * 1.442695f) + 0.5f);
let _e1642 = select(-127f, _e1640, (_e1640 > -127f));
let _e1644 = select(128f, _e1642, (_e1642 < 128f));
let _e1651 = select(0i, select(select(i32(_e1644), i32(-2147483648), (_e1644 < -2147483600f)), 2147483647i, (_e1644 > 2147483500f)), (_e1644 == _e1644));
let _e1655 = (_e1651 - select(0i, 1i, (_e1644 < f32(_e1651))));
let _e1656 = f32(_e1655);
let _e1660 = ((_e1638 - (_e1656 * 0.6933594f)) - (_e1656 * -2.1219444e-4f));
let _e1682 = select(((1f + (_e1546 * (1f + (_e1546 * (0.5f + (_e1546 * (0.16666667f + (_e1546 * (0.041666668f + (_e1546 * (0.008333334f + (_e1546 * (0.001388889f + (_e1546 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1541 + 127i)) << bitcast<u32>(23i)))), 1f, _e1351);
let _e1684 = (1f - (_e1465 * _e1682));
let _e1686 = (1f - _e1465);
let _e1692 = select(((1f + (_e1603 * (1f + (_e1603 * (0.5f + (_e1603 * (0.16666667f + (_e1603 * (0.041666668f + (_e1603 * (0.008333334f + (_e1603 * (0.001388889f + (_e1603 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1598 + 127i)) << bitcast<u32>(23i)))), 1f, _e1351);
let _e1694 = (1f - (_e1465 * _e1692));
let _e1701 = select(((1f + (_e1660 * (1f + (_e1660 * (0.5f + (_e1660 * (0.16666667f + (_e1660 * (0.041666668f + (_e1660 * (0.008333334f + (_e1660 * (0.001388889f + (_e1660 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1655 + 127i)) << bitcast<u32>(23i)))), 1f, _e1351);
let _e1703 = (1f - (_e1465 * _e1701));
phi_2541_ = type_19(_e1501.member, _e1501.member_1, _e1501.member_2, _e1501.member_3, _e1501.member_4, _e1501.member_5, _e1501.member_6, _e1501.member_7, _e1501.member_8, _e1501.member_9, _e1501.member_10, _e1501.member_11, vec3<f32>((_e1501.member_12.x + ((_e1501.member_2.x * select(1f, ((_e1686 * _e1682) / select(1e-9f, _e1684, (_e1684 > 1e-9f))), (_e1684 > 0f))) * _e1465)), (_e1501.member_12.y + ((_e1501.member_2.y * select(1f, ((_e1686 * _e1692) / select(1e-9f, _e1694, (_e1694 > 1e-9f))), (_e1694 > 0f))) * _e1465)), (_e1501.member_12.z + ((_e1501.member_2.z * select(1f, ((_e1686 * _e1701) / select(1e-9f, _e1703, (_e1703 > 1e-9f))), (_e1703 > 0f))) * _e1465))), _e1501.member_13, _e1501.member_14, _e1501.member_15);
} else {
phi_2541_ = _e1501;
}
let _e1746 = phi_2541_;
let _e1748 = (_e1746.member_8 + 1f);
let _e1764 = type_19(_e1746.member, _e1746.member_1, _e1746.member_2, _e1746.member_3, _e1746.member_4, _e1746.member_5, _e1746.member_6, _e1746.member_7, _e1748, _e1746.member_9, _e1746.member_10, _e1746.member_11, _e1746.member_12, _e1746.member_13, _e1746.member_14, _e1746.member_15);
let _e1767 = ((_e98.member_2 == 0u) && (_e1748 >= 2f));
if (_e1391 && _e1767) {
let _e1793 = (((_e1746.member_1.x * _e1266) + (_e1746.member_1.y * _e1275)) + (_e1746.member_1.z * _e1284));
let _e1797 = (_e1746.member_1.x - (_e1266 * _e1793));
let _e1798 = (_e1746.member_1.y - (_e1275 * _e1793));
let _e1799 = (_e1746.member_1.z - (_e1284 * _e1793));
let _e1804 = (((_e1797 * _e1797) + (_e1798 * _e1798)) + (_e1799 * _e1799));
let _e1807 = sqrt(select(0f, _e1804, (_e1804 > 0f)));
let _e1810 = (1f / select(1e-20f, _e1807, (_e1807 > 1e-20f)));
phi_2594_ = type_19(_e1764.member, vec3<f32>((_e1797 * _e1810), (_e1798 * _e1810), (_e1799 * _e1810)), _e1764.member_2, _e1764.member_3, _e1764.member_4, _e1764.member_5, _e1764.member_6, _e1764.member_7, _e1764.member_8, _e1764.member_9, _e1764.member_10, _e1764.member_11, _e1764.member_12, _e1764.member_13, _e1764.member_14, _e1764.member_15);
} else {
phi_2594_ = type_19(_e1764.member, vec3<f32>((_e1413 * _e1426), (_e1414 * _e1426), (_e1415 * _e1426)), _e1764.member_2, _e1764.member_3, _e1764.member_4, _e1764.member_5, _e1764.member_6, _e1764.member_7, _e1764.member_8, _e1764.member_9, _e1764.member_10, _e1764.member_11, _e1764.member_12, _e1764.member_13, _e1764.member_14, _e1764.member_15);
}
let _e1832 = phi_2594_;
if _e1391 {
phi_2608_ = _e1832;
} else {
let _e1833 = (1f - _e1465);
phi_2608_ = type_19(_e1832.member, _e1832.member_1, vec3<f32>((_e1832.member_2.x * _e1833), (_e1832.member_2.y * _e1833), (_e1832.member_2.z * _e1833)), _e1832.member_3, _e1832.member_4, _e1832.member_5, _e1832.member_6, _e1832.member_7, _e1832.member_8, _e1832.member_9, _e1832.member_10, _e1832.member_11, _e1832.member_12, _e1832.member_13, _e1832.member_14, _e1832.member_15);
}
let _e1861 = phi_2608_;
let _e1877 = type_19(_e1861.member, _e1861.member_1, _e1861.member_2, _e1861.member_3, _e1861.member_4, 0f, _e1861.member_6, _e1861.member_7, _e1861.member_8, _e1861.member_9, _e1861.member_10, _e1861.member_11, _e1861.member_12, _e1861.member_13, _e1861.member_14, _e1861.member_15);
let _e1884 = global_1.member.member_18.member.member;
let _e1898 = ((((_e1884.member.member * _e1861.member.x) + (_e1884.member.member_1 * _e1861.member.y)) + (_e1884.member.member_2 * _e1861.member.z)) + _e1884.member_1);
let _e1907 = -((((_e1884.member.member * _e1861.member_1.x) + (_e1884.member.member_1 * _e1861.member_1.y)) + (_e1884.member.member_2 * _e1861.member_1.z)));
let _e1909 = (_e1907 > 1e-9f);
let _e1913 = ((_e1898 / select(1e-9f, _e1907, _e1909)) - 0.015625f);
let _e1916 = select(1e30f, select(0f, _e1913, (_e1913 > 0f)), ((_e1898 > 0f) && _e1909));
let _e1921 = global_1.member.member_18.member_1.member;
let _e1932 = ((((_e1921.member.member * _e1861.member.x) + (_e1921.member.member_1 * _e1861.member.y)) + (_e1921.member.member_2 * _e1861.member.z)) + _e1921.member_1);
let _e1938 = -((((_e1921.member.member * _e1861.member_1.x) + (_e1921.member.member_1 * _e1861.member_1.y)) + (_e1921.member.member_2 * _e1861.member_1.z)));
let _e1940 = (_e1938 > 1e-9f);
let _e1944 = ((_e1932 / select(1e-9f, _e1938, _e1940)) - 0.015625f);
let _e1947 = select(1e30f, select(0f, _e1944, (_e1944 > 0f)), ((_e1932 > 0f) && _e1940));
let _e1951 = (_e1947 < _e1916);
let _e1953 = select(select(-2i, -3i, _e1951), -1i, ((_e1916 >= 1e30f) && (_e1947 >= 1e30f)));
let _e1954 = select(_e1916, _e1947, _e1951);
let _e1970 = type_19(_e1877.member, _e1877.member_1, _e1877.member_2, _e1877.member_3, _e1877.member_4, _e1877.member_5, _e1877.member_6, _e1877.member_7, _e1877.member_8, _e1877.member_9, _e1877.member_10, _e1877.member_11, _e1877.member_12, 0i, _e1877.member_14, _e1877.member_15);
let _e1986 = type_19(_e1970.member, _e1970.member_1, _e1970.member_2, _e1970.member_3, _e1970.member_4, _e1970.member_5, _e1970.member_6, _e1970.member_7, _e1970.member_8, _e1970.member_9, _e1970.member_10, _e1970.member_11, _e1970.member_12, _e1970.member_13, _e1953, _e1970.member_15);
let _e2002 = type_19(_e1986.member, _e1986.member_1, _e1986.member_2, _e1986.member_3, _e1986.member_4, _e1986.member_5, _e1986.member_6, _e1986.member_7, _e1986.member_8, _e1986.member_9, _e1986.member_10, _e1986.member_11, _e1986.member_12, _e1986.member_13, _e1986.member_14, _e1954);
let _e2005 = ((_e1462 & 2u) != 0u);
if (_e1767 && !(_e2005)) {
if (_e1953 == -1i) {
phi_3034_ = type_19(_e2002.member, _e2002.member_1, _e2002.member_2, _e2002.member_3, _e2002.member_4, _e2002.member_5, 1f, _e2002.member_7, _e2002.member_8, _e2002.member_9, _e2002.member_10, _e2002.member_11, _e2002.member_12, _e2002.member_13, _e2002.member_14, _e2002.member_15);
} else {
let _e2084 = type_19(vec3<f32>((_e1861.member.x + (_e1861.member_1.x * _e1954)), (_e1861.member.y + (_e1861.member_1.y * _e1954)), (_e1861.member.z + (_e1861.member_1.z * _e1954))), _e2002.member_1, _e2002.member_2, _e2002.member_3, _e2002.member_4, _e2002.member_5, _e2002.member_6, _e2002.member_7, _e2002.member_8, _e2002.member_9, _e2002.member_10, _e2002.member_11, _e2002.member_12, _e2002.member_13, _e2002.member_14, _e2002.member_15);
let _e2101 = type_19(_e2084.member, _e2084.member_1, _e2084.member_2, _e2084.member_3, _e2084.member_4, (0f + _e1954), _e2084.member_6, _e2084.member_7, _e2084.member_8, _e2084.member_9, _e2084.member_10, _e2084.member_11, _e2084.member_12, _e2084.member_13, _e2084.member_14, _e2084.member_15);
let _e2118 = type_19(_e2101.member, _e2101.member_1, _e2101.member_2, _e2101.member_3, _e2101.member_4, _e2101.member_5, _e2101.member_6, _e2101.member_7, _e2101.member_8, _e2101.member_9, _e2101.member_10, _e2101.member_11, _e2101.member_12, _e2101.member_13, _e2101.member_14, (_e1954 - _e1954));
let _e2139 = type_19(_e2118.member, _e2118.member_1, _e2118.member_2, _e2118.member_3, _e2118.member_4, _e2118.member_5, _e2118.member_6, _e2118.member_7, _e2118.member_8, _e2118.member_9, (_e1861.member_10 + select(0f, _e1954, (_e1861.member_8 == 0f))), _e2118.member_11, _e2118.member_12, _e2118.member_13, _e2118.member_14, _e2118.member_15);
phi_3034_ = type_19(_e2139.member, _e2139.member_1, _e2139.member_2, _e2139.member_3, _e2139.member_4, _e2139.member_5, 3f, _e2139.member_7, _e2139.member_8, _e2139.member_9, _e2139.member_10, _e2139.member_11, _e2139.member_12, _e2139.member_13, _e2139.member_14, _e2139.member_15);
}
let _e2173 = phi_3034_;
phi_3055_ = _e2173;
} else {
let _e2012 = global_1.member.member_5;
if ((!(_e1767) && (_e1861.member_8 >= f32(bitcast<i32>(_e2012)))) && (select(_e1316, _e1144.member_7, _e1391) != 16i)) {
phi_3054_ = type_19(_e2002.member, _e2002.member_1, _e2002.member_2, _e2002.member_3, _e2002.member_4, _e2002.member_5, 2f, _e2002.member_7, _e2002.member_8, _e2002.member_9, _e2002.member_10, _e2002.member_11, _e2002.member_12, _e2002.member_13, _e2002.member_14, _e2002.member_15);
} else {
if _e2005 {
phi_3053_ = type_19(_e2002.member, _e2002.member_1, _e2002.member_2, _e2002.member_3, _e2002.member_4, _e2002.member_5, 4f, _e2002.member_7, _e2002.member_8, _e2002.member_9, _e2002.member_10, _e2002.member_11, _e2002.member_12, _e2002.member_13, _e2002.member_14, _e2002.member_15);
} else {
phi_3053_ = _e2002;
}
let _e2036 = phi_3053_;
phi_3054_ = _e2036;
}
let _e2054 = phi_3054_;
phi_3055_ = _e2054;
}
let _e2175 = phi_3055_;
let _e2192 = type_19(_e2175.member, _e2175.member_1, _e2175.member_2, _e2175.member_3, _e2175.member_4, _e2175.member_5, _e2175.member_6, select(_e1144.member_7, _e1316, _e1503), _e2175.member_8, _e2175.member_9, _e2175.member_10, _e2175.member_11, _e2175.member_12, _e2175.member_13, _e2175.member_14, _e2175.member_15);
phi_3063_ = type_19(_e2192.member, _e2192.member_1, _e2192.member_2, _e2192.member_3, _e1285, _e2192.member_5, _e2192.member_6, _e2192.member_7, _e2192.member_8, _e2192.member_9, _e2192.member_10, _e2192.member_11, _e2192.member_12, _e2192.member_13, _e2192.member_14, _e2192.member_15);
} else {
phi_3063_ = _e1144;
}
let _e2210 = phi_3063_;
phi_3064_ = _e2210;
} else {
phi_3064_ = _e1144;
}
let _e2212 = phi_3064_;
phi_3065_ = _e2212;
}
let _e2214 = phi_3065_;
phi_3066_ = _e2214;
}
let _e2342 = phi_3066_;
phi_778_ = _e2342;
phi_781_ = (_e485 + 1i);
} else {
phi_778_ = type_19();
phi_781_ = i32();
}
let _e2344 = phi_778_;
let _e2346 = phi_781_;
continue;
continuing {
phi_777_ = _e2344;
phi_780_ = _e2346;
break if !(_e489);
}
}
let _e2349 = local;
let _e2353 = local_1;
let _e2357 = local_2;
let _e2361 = local_3;
let _e2365 = local_4;
let _e2369 = local_5;
let _e2373 = local_6;
let _e2377 = local_7;
let _e2381 = local_8;
let _e2385 = local_9;
let _e2389 = local_10;
let _e2393 = local_11;
let _e2397 = local_12;
let _e2401 = local_13;
let _e2405 = local_14;
let _e2409 = local_15;
let _e2412 = local_16;
let _e2416 = local_17;
let _e2419 = local_18;
let _e2422 = local_19;
let _e2425 = local_20;
let _e2428 = local_21;
let _e2432 = local_22;
let _e2436 = local_23;
let _e2440 = local_24;
let _e2444 = local_25;
let _e2448 = local_26;
global_3.member[_e107] = _e2349.member.x;
global_3.member[_e119] = _e2353.member.y;
global_3.member[_e130] = _e2357.member.z;
global_3.member[_e141] = _e2361.member_1.x;
global_3.member[_e152] = _e2365.member_1.y;
global_3.member[_e163] = _e2369.member_1.z;
global_3.member[_e174] = _e2373.member_2.x;
global_3.member[_e185] = _e2377.member_2.y;
global_3.member[_e196] = _e2381.member_2.z;
global_3.member[_e207] = _e2385.member_3.x;
global_3.member[_e218] = _e2389.member_3.y;
global_3.member[_e229] = _e2393.member_3.z;
global_3.member[_e240] = _e2397.member_4.x;
global_3.member[_e251] = _e2401.member_4.y;
global_3.member[_e262] = _e2405.member_4.z;
global_3.member[_e273] = _e2409.member_5;
let _e2485 = local_27;
global_3.member[_e284] = _e2485;
global_3.member[_e295] = f32(_e2412.member_7);
global_3.member[_e306] = _e2416.member_8;
global_3.member[_e317] = _e2419.member_9;
global_3.member[_e328] = _e2422.member_10;
global_3.member[_e339] = _e2425.member_11;
global_3.member[_e350] = _e2428.member_12.x;
global_3.member[_e361] = _e2432.member_12.y;
global_3.member[_e372] = _e2436.member_12.z;
global_3.member[_e383] = f32(_e2440.member_13);
global_3.member[_e394] = f32(_e2444.member_14);
global_3.member[_e405] = _e2448.member_15;
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
