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
struct type_26 {
member: array<u32>,
}
struct type_29 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_19;
@group(0) @binding(4)
var<storage> global_2: type_21;
@group(0) @binding(5)
var<storage, read_write> global_3: type_21;
@group(0) @binding(6)
var<storage, read_write> global_4: type_29;
@group(0) @binding(1)
var<storage> global_5: type_26;
@group(0) @binding(2)
var<storage> global_6: type_26;
@group(0) @binding(3)
var<storage> global_7: type_21;
fn function_() {
var phi_778_: u32;
var phi_868_: type_24;
var phi_871_: i32;
var phi_1490_: type_24;
var phi_1203_: type_24;
var phi_1491_: type_24;
var phi_2301_: type_24;
var phi_2699_: i32;
var phi_2701_: i32;
var phi_2729_: type_24;
var phi_2730_: type_24;
var phi_2810_: type_24;
var phi_2811_: type_24;
var phi_2829_: type_24;
var phi_3277_: type_24;
var phi_3278_: type_24;
var phi_3256_: type_24;
var phi_3279_: type_24;
var phi_3287_: type_24;
var phi_3288_: type_24;
var phi_3289_: type_24;
var phi_1823_: type_24;
var phi_3290_: type_24;
var phi_869_: type_24;
var phi_872_: i32;
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
let _e88 = global;
let _e96 = arrayLength((&global_2.member));
let _e103 = global_1.member.member;
if (_e88.x < _e103.member) {
if (_e88.y < _e103.member_1) {
let _e110 = (_e103.member * _e103.member_1);
let _e112 = ((_e88.y * _e103.member) + _e88.x);
let _e113 = bitcast<i32>(_e112);
let _e115 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e117 = select(_e115, _e113, (_e113 < _e115));
let _e123 = global_3.member[bitcast<u32>(select(0i, _e117, (_e117 > 0i)))];
let _e124 = (_e110 + _e112);
let _e125 = bitcast<i32>(_e124);
let _e127 = select(_e115, _e125, (_e125 < _e115));
let _e133 = global_3.member[bitcast<u32>(select(0i, _e127, (_e127 > 0i)))];
let _e135 = ((2u * _e110) + _e112);
let _e136 = bitcast<i32>(_e135);
let _e138 = select(_e115, _e136, (_e136 < _e115));
let _e144 = global_3.member[bitcast<u32>(select(0i, _e138, (_e138 > 0i)))];
let _e146 = ((3u * _e110) + _e112);
let _e147 = bitcast<i32>(_e146);
let _e149 = select(_e115, _e147, (_e147 < _e115));
let _e155 = global_3.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e157 = ((4u * _e110) + _e112);
let _e158 = bitcast<i32>(_e157);
let _e160 = select(_e115, _e158, (_e158 < _e115));
let _e166 = global_3.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e168 = ((5u * _e110) + _e112);
let _e169 = bitcast<i32>(_e168);
let _e171 = select(_e115, _e169, (_e169 < _e115));
let _e177 = global_3.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e179 = ((6u * _e110) + _e112);
let _e180 = bitcast<i32>(_e179);
let _e182 = select(_e115, _e180, (_e180 < _e115));
let _e188 = global_3.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e190 = ((7u * _e110) + _e112);
let _e191 = bitcast<i32>(_e190);
let _e193 = select(_e115, _e191, (_e191 < _e115));
let _e199 = global_3.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e201 = ((8u * _e110) + _e112);
let _e202 = bitcast<i32>(_e201);
let _e204 = select(_e115, _e202, (_e202 < _e115));
let _e210 = global_3.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e212 = ((9u * _e110) + _e112);
let _e213 = bitcast<i32>(_e212);
let _e215 = select(_e115, _e213, (_e213 < _e115));
let _e221 = global_3.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e223 = ((10u * _e110) + _e112);
let _e224 = bitcast<i32>(_e223);
let _e226 = select(_e115, _e224, (_e224 < _e115));
let _e232 = global_3.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e234 = ((11u * _e110) + _e112);
let _e235 = bitcast<i32>(_e234);
let _e237 = select(_e115, _e235, (_e235 < _e115));
let _e243 = global_3.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e245 = ((12u * _e110) + _e112);
let _e246 = bitcast<i32>(_e245);
let _e248 = select(_e115, _e246, (_e246 < _e115));
let _e254 = global_3.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e256 = ((13u * _e110) + _e112);
let _e257 = bitcast<i32>(_e256);
let _e259 = select(_e115, _e257, (_e257 < _e115));
let _e265 = global_3.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e267 = ((14u * _e110) + _e112);
let _e268 = bitcast<i32>(_e267);
let _e270 = select(_e115, _e268, (_e268 < _e115));
let _e276 = global_3.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e278 = ((15u * _e110) + _e112);
let _e279 = bitcast<i32>(_e278);
let _e281 = select(_e115, _e279, (_e279 < _e115));
let _e287 = global_3.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e289 = ((16u * _e110) + _e112);
let _e290 = bitcast<i32>(_e289);
let _e292 = select(_e115, _e290, (_e290 < _e115));
let _e298 = global_3.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e300 = ((17u * _e110) + _e112);
let _e301 = bitcast<i32>(_e300);
let _e303 = select(_e115, _e301, (_e301 < _e115));
let _e309 = global_3.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e311 = ((18u * _e110) + _e112);
let _e312 = bitcast<i32>(_e311);
let _e314 = select(_e115, _e312, (_e312 < _e115));
let _e320 = global_3.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e322 = ((19u * _e110) + _e112);
let _e323 = bitcast<i32>(_e322);
let _e325 = select(_e115, _e323, (_e323 < _e115));
let _e331 = global_3.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e333 = ((20u * _e110) + _e112);
let _e334 = bitcast<i32>(_e333);
let _e336 = select(_e115, _e334, (_e334 < _e115));
let _e342 = global_3.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e344 = ((21u * _e110) + _e112);
let _e345 = bitcast<i32>(_e344);
let _e347 = select(_e115, _e345, (_e345 < _e115));
let _e353 = global_3.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e355 = ((22u * _e110) + _e112);
let _e356 = bitcast<i32>(_e355);
let _e358 = select(_e115, _e356, (_e356 < _e115));
let _e364 = global_3.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e366 = ((23u * _e110) + _e112);
let _e367 = bitcast<i32>(_e366);
let _e369 = select(_e115, _e367, (_e367 < _e115));
let _e375 = global_3.member[bitcast<u32>(select(0i, _e369, (_e369 > 0i)))];
let _e377 = ((24u * _e110) + _e112);
let _e378 = bitcast<i32>(_e377);
let _e380 = select(_e115, _e378, (_e378 < _e115));
let _e386 = global_3.member[bitcast<u32>(select(0i, _e380, (_e380 > 0i)))];
let _e388 = ((25u * _e110) + _e112);
let _e389 = bitcast<i32>(_e388);
let _e391 = select(_e115, _e389, (_e389 < _e115));
let _e397 = global_3.member[bitcast<u32>(select(0i, _e391, (_e391 > 0i)))];
let _e399 = ((26u * _e110) + _e112);
let _e400 = bitcast<i32>(_e399);
let _e402 = select(_e115, _e400, (_e400 < _e115));
let _e408 = global_3.member[bitcast<u32>(select(0i, _e402, (_e402 > 0i)))];
let _e410 = ((27u * _e110) + _e112);
let _e411 = bitcast<i32>(_e410);
let _e413 = select(_e115, _e411, (_e411 < _e115));
let _e419 = global_3.member[bitcast<u32>(select(0i, _e413, (_e413 > 0i)))];
let _e421 = ((28u * _e110) + _e112);
let _e422 = bitcast<i32>(_e421);
let _e424 = select(_e115, _e422, (_e422 < _e115));
let _e430 = global_3.member[bitcast<u32>(select(0i, _e424, (_e424 > 0i)))];
let _e432 = ((29u * _e110) + _e112);
let _e433 = bitcast<i32>(_e432);
let _e435 = select(_e115, _e433, (_e433 < _e115));
let _e441 = global_3.member[bitcast<u32>(select(0i, _e435, (_e435 > 0i)))];
let _e443 = ((30u * _e110) + _e112);
let _e444 = bitcast<i32>(_e443);
let _e446 = select(_e115, _e444, (_e444 < _e115));
let _e452 = global_3.member[bitcast<u32>(select(0i, _e446, (_e446 > 0i)))];
let _e454 = ((31u * _e110) + _e112);
let _e455 = bitcast<i32>(_e454);
let _e457 = select(_e115, _e455, (_e455 < _e115));
let _e463 = global_3.member[bitcast<u32>(select(0i, _e457, (_e457 > 0i)))];
if (_e298 == 0f) {
phi_778_ = 3u;
} else {
phi_778_ = select(0u, 1u, (_e298 == 4f));
}
let _e468 = phi_778_;
if (_e468 > 0u) {
if (arrayLength((&global_4.member)) >= 3u) {
let _e477 = atomicLoad((&global_4.member[0u]));
if (_e477 == 0u) {
atomicStore((&global_4.member[0u]), ((_e103.member + 7u) / 8u));
atomicStore((&global_4.member[1u]), ((_e103.member_1 + 7u) / 8u));
atomicStore((&global_4.member[2u]), 1u);
}
}
}
if (_e468 > 1u) {
let _e524 = global_1.member.member_2.member;
let _e525 = bitcast<i32>(_e524);
let _e529 = global_1.member.member_2.member_1;
let _e530 = bitcast<i32>(_e529);
let _e534 = global_1.member.member_2.member_2;
let _e535 = bitcast<i32>(_e534);
phi_868_ = type_24(vec3<f32>(_e123, _e133, _e144), vec3<f32>(_e155, _e166, _e177), vec3<f32>(_e188, _e199, _e210), vec3<f32>(_e221, _e232, _e243), vec3<f32>(_e254, _e265, _e276), _e287, _e298, select(0i, select(select(i32(_e309), i32(-2147483648), (_e309 < -2147483600f)), 2147483647i, (_e309 > 2147483500f)), (_e309 == _e309)), _e320, _e331, _e342, _e353, vec3<f32>(_e364, _e375, _e386), vec3<f32>(_e397, _e408, _e419), select(0i, select(select(i32(_e430), i32(-2147483648), (_e430 < -2147483600f)), 2147483647i, (_e430 > 2147483500f)), (_e430 == _e430)), select(0i, select(select(i32(_e441), i32(-2147483648), (_e441 < -2147483600f)), 2147483647i, (_e441 > 2147483500f)), (_e441 == _e441)), select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < -2147483600f)), 2147483647i, (_e452 > 2147483500f)), (_e452 == _e452)), _e463);
phi_871_ = 0i;
loop {
let _e540 = phi_868_;
let _e542 = phi_871_;
local = _e540;
local_1 = _e540;
local_2 = _e540;
local_3 = _e540;
local_4 = _e540;
local_5 = _e540;
local_6 = _e540;
local_7 = _e540;
local_8 = _e540;
local_9 = _e540;
local_10 = _e540;
local_11 = _e540;
local_12 = _e540;
local_13 = _e540;
local_14 = _e540;
local_15 = _e540;
local_16 = _e540;
local_17 = _e540;
local_18 = _e540;
local_19 = _e540;
local_20 = _e540;
local_21 = _e540;
local_22 = _e540;
local_23 = _e540;
local_24 = _e540;
local_25 = _e540;
local_26 = _e540;
local_27 = _e540;
local_28 = _e540;
local_29 = _e540;
local_30 = _e540;
let _e546 = ((_e542 < 256i) && (_e540.member_6 == 0f));
local_31 = _e540.member_6;
if _e546 {
let _e552 = bitcast<f32>((bitcast<u32>(_e540.member_1.x) & 2147483647u));
let _e556 = bitcast<f32>((bitcast<u32>(_e540.member_1.y) & 2147483647u));
let _e558 = select(_e556, _e552, (_e552 > _e556));
let _e562 = bitcast<f32>((bitcast<u32>(_e540.member_1.z) & 2147483647u));
let _e564 = select(_e562, _e558, (_e558 > _e562));
let _e567 = (1f / select(0.5f, _e564, (_e564 > 0.5f)));
let _e569 = (_e540.member_17 <= _e567);
if _e569 {
let _e920 = type_24(vec3<f32>((_e540.member.x + (_e540.member_1.x * _e540.member_17)), (_e540.member.y + (_e540.member_1.y * _e540.member_17)), (_e540.member.z + (_e540.member_1.z * _e540.member_17))), _e540.member_1, _e540.member_2, _e540.member_3, _e540.member_4, _e540.member_5, _e540.member_6, _e540.member_7, _e540.member_8, _e540.member_9, _e540.member_10, _e540.member_11, _e540.member_12, _e540.member_13, _e540.member_14, _e540.member_15, _e540.member_16, _e540.member_17);
let _e940 = type_24(_e920.member, _e920.member_1, _e920.member_2, _e920.member_3, _e920.member_4, (_e540.member_5 + _e540.member_17), _e920.member_6, _e920.member_7, _e920.member_8, _e920.member_9, _e920.member_10, _e920.member_11, _e920.member_12, _e920.member_13, _e920.member_14, _e920.member_15, _e920.member_16, _e920.member_17);
let _e959 = type_24(_e940.member, _e940.member_1, _e940.member_2, _e940.member_3, _e940.member_4, _e940.member_5, _e940.member_6, _e940.member_7, _e940.member_8, _e940.member_9, _e940.member_10, _e940.member_11, _e940.member_12, _e940.member_13, _e940.member_14, _e940.member_15, _e940.member_16, (_e540.member_17 - _e540.member_17));
let _e982 = type_24(_e959.member, _e959.member_1, _e959.member_2, _e959.member_3, _e959.member_4, _e959.member_5, _e959.member_6, _e959.member_7, _e959.member_8, _e959.member_9, (_e540.member_10 + select(0f, _e540.member_17, (_e540.member_8 == 0f))), _e959.member_11, _e959.member_12, _e959.member_13, _e959.member_14, _e959.member_15, _e959.member_16, _e959.member_17);
if (_e540.member_7 != 16i) {
let _e1003 = type_24(_e982.member, _e982.member_1, _e982.member_2, _e982.member_3, _e982.member_4, _e982.member_5, _e982.member_6, _e982.member_7, _e982.member_8, (_e540.member_9 + _e540.member_17), _e982.member_10, _e982.member_11, _e982.member_12, _e982.member_13, _e982.member_14, _e982.member_15, _e982.member_16, _e982.member_17);
let _e1004 = (_e540.member_7 * 4i);
let _e1005 = (_e1004 + 1i);
let _e1007 = (bitcast<i32>(_e96) - 1i);
let _e1009 = select(_e1007, _e1005, (_e1005 < _e1007));
let _e1015 = global_2.member[bitcast<u32>(select(0i, _e1009, (_e1009 > 0i)))];
let _e1017 = -((_e1015 * _e540.member_17));
let _e1019 = select(-87f, _e1017, (_e1017 > -87f));
let _e1021 = select(88f, _e1019, (_e1019 < 88f));
let _e1023 = ((_e1021 * 1.442695f) + 0.5f);
let _e1025 = select(-127f, _e1023, (_e1023 > -127f));
let _e1027 = select(128f, _e1025, (_e1025 < 128f));
let _e1034 = select(0i, select(select(i32(_e1027), i32(-2147483648), (_e1027 < -2147483600f)), 2147483647i, (_e1027 > 2147483500f)), (_e1027 == _e1027));
let _e1038 = (_e1034 - select(0i, 1i, (_e1027 < f32(_e1034))));
let _e1039 = f32(_e1038);
let _e1043 = ((_e1021 - (_e1039 * 0.6933594f)) - (_e1039 * -2.1219444e-4f));
let _e1064 = (_e1004 + 2i);
let _e1066 = select(_e1007, _e1064, (_e1064 < _e1007));
let _e1072 = global_2.member[bitcast<u32>(select(0i, _e1066, (_e1066 > 0i)))];
let _e1074 = -((_e1072 * _e540.member_17));
let _e1076 = select(-87f, _e1074, (_e1074 > -87f));
let _e1078 = select(88f, _e1076, (_e1076 < 88f));
let _e1080 = ((_e1078 * 1.442695f) + 0.5f);
let _e1082 = select(-127f, _e1080, (_e1080 > -127f));
let _e1084 = select(128f, _e1082, (_e1082 < 128f));
let _e1091 = select(0i, select(select(i32(_e1084), i32(-2147483648), (_e1084 < -2147483600f)), 2147483647i, (_e1084 > 2147483500f)), (_e1084 == _e1084));
let _e1095 = (_e1091 - select(0i, 1i, (_e1084 < f32(_e1091))));
let _e1096 = f32(_e1095);
let _e1100 = ((_e1078 - (_e1096 * 0.6933594f)) - (_e1096 * -2.1219444e-4f));
let _e1121 = (_e1004 + 3i);
let _e1123 = select(_e1007, _e1121, (_e1121 < _e1007));
let _e1129 = global_2.member[bitcast<u32>(select(0i, _e1123, (_e1123 > 0i)))];
let _e1131 = -((_e1129 * _e540.member_17));
let _e1133 = select(-87f, _e1131, (_e1131 > -87f));
let _e1135 = select(88f, _e1133, (_e1133 < 88f));
let _e1137 = ((_e1135 * 1.442695f) + 0.5f);
let _e1139 = select(-127f, _e1137, (_e1137 > -127f));
let _e1141 = select(128f, _e1139, (_e1139 < 128f));
let _e1148 = select(0i, select(select(i32(_e1141), i32(-2147483648), (_e1141 < -2147483600f)), 2147483647i, (_e1141 > 2147483500f)), (_e1141 == _e1141));
let _e1152 = (_e1148 - select(0i, 1i, (_e1141 < f32(_e1148))));
let _e1153 = f32(_e1152);
let _e1157 = ((_e1135 - (_e1153 * 0.6933594f)) - (_e1153 * -2.1219444e-4f));
phi_1203_ = type_24(_e1003.member, _e1003.member_1, vec3<f32>((_e540.member_2.x * ((1f + (_e1043 * (1f + (_e1043 * (0.5f + (_e1043 * (0.16666667f + (_e1043 * (0.041666668f + (_e1043 * (0.008333334f + (_e1043 * (0.001388889f + (_e1043 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1038 + 127i)) << bitcast<u32>(23i))))), (_e540.member_2.y * ((1f + (_e1100 * (1f + (_e1100 * (0.5f + (_e1100 * (0.16666667f + (_e1100 * (0.041666668f + (_e1100 * (0.008333334f + (_e1100 * (0.001388889f + (_e1100 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1095 + 127i)) << bitcast<u32>(23i))))), (_e540.member_2.z * ((1f + (_e1157 * (1f + (_e1157 * (0.5f + (_e1157 * (0.16666667f + (_e1157 * (0.041666668f + (_e1157 * (0.008333334f + (_e1157 * (0.001388889f + (_e1157 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1152 + 127i)) << bitcast<u32>(23i)))))), _e1003.member_3, _e1003.member_4, _e1003.member_5, _e1003.member_6, _e1003.member_7, _e1003.member_8, _e1003.member_9, _e1003.member_10, _e1003.member_11, _e1003.member_12, _e1003.member_13, _e1003.member_14, _e1003.member_15, _e1003.member_16, _e1003.member_17);
} else {
phi_1203_ = _e982;
}
let _e1207 = phi_1203_;
phi_1491_ = type_24(_e1207.member, _e1207.member_1, _e1207.member_2, _e1207.member_3, _e1207.member_4, _e1207.member_5, 3f, _e1207.member_7, _e1207.member_8, _e1207.member_9, _e1207.member_10, _e1207.member_11, _e1207.member_12, _e1207.member_13, _e1207.member_14, _e1207.member_15, _e1207.member_16, _e1207.member_17);
} else {
let _e601 = type_24(vec3<f32>((_e540.member.x + (_e540.member_1.x * _e567)), (_e540.member.y + (_e540.member_1.y * _e567)), (_e540.member.z + (_e540.member_1.z * _e567))), _e540.member_1, _e540.member_2, _e540.member_3, _e540.member_4, _e540.member_5, _e540.member_6, _e540.member_7, _e540.member_8, _e540.member_9, _e540.member_10, _e540.member_11, _e540.member_12, _e540.member_13, _e540.member_14, _e540.member_15, _e540.member_16, _e540.member_17);
let _e621 = type_24(_e601.member, _e601.member_1, _e601.member_2, _e601.member_3, _e601.member_4, (_e540.member_5 + _e567), _e601.member_6, _e601.member_7, _e601.member_8, _e601.member_9, _e601.member_10, _e601.member_11, _e601.member_12, _e601.member_13, _e601.member_14, _e601.member_15, _e601.member_16, _e601.member_17);
let _e640 = type_24(_e621.member, _e621.member_1, _e621.member_2, _e621.member_3, _e621.member_4, _e621.member_5, _e621.member_6, _e621.member_7, _e621.member_8, _e621.member_9, _e621.member_10, _e621.member_11, _e621.member_12, _e621.member_13, _e621.member_14, _e621.member_15, _e621.member_16, (_e540.member_17 - _e567));
let _e663 = type_24(_e640.member, _e640.member_1, _e640.member_2, _e640.member_3, _e640.member_4, _e640.member_5, _e640.member_6, _e640.member_7, _e640.member_8, _e640.member_9, (_e540.member_10 + select(0f, _e567, (_e540.member_8 == 0f))), _e640.member_11, _e640.member_12, _e640.member_13, _e640.member_14, _e640.member_15, _e640.member_16, _e640.member_17);
if (_e540.member_7 != 16i) {
let _e684 = type_24(_e663.member, _e663.member_1, _e663.member_2, _e663.member_3, _e663.member_4, _e663.member_5, _e663.member_6, _e663.member_7, _e663.member_8, (_e540.member_9 + _e567), _e663.member_10, _e663.member_11, _e663.member_12, _e663.member_13, _e663.member_14, _e663.member_15, _e663.member_16, _e663.member_17);
let _e685 = (_e540.member_7 * 4i);
let _e686 = (_e685 + 1i);
let _e688 = (bitcast<i32>(_e96) - 1i);
let _e690 = select(_e688, _e686, (_e686 < _e688));
let _e696 = global_2.member[bitcast<u32>(select(0i, _e690, (_e690 > 0i)))];
let _e698 = -((_e696 * _e567));
let _e700 = select(-87f, _e698, (_e698 > -87f));
let _e702 = select(88f, _e700, (_e700 < 88f));
let _e704 = ((_e702 * 1.442695f) + 0.5f);
let _e706 = select(-127f, _e704, (_e704 > -127f));
let _e708 = select(128f, _e706, (_e706 < 128f));
let _e715 = select(0i, select(select(i32(_e708), i32(-2147483648), (_e708 < -2147483600f)), 2147483647i, (_e708 > 2147483500f)), (_e708 == _e708));
let _e719 = (_e715 - select(0i, 1i, (_e708 < f32(_e715))));
let _e720 = f32(_e719);
let _e724 = ((_e702 - (_e720 * 0.6933594f)) - (_e720 * -2.1219444e-4f));
let _e745 = (_e685 + 2i);
let _e747 = select(_e688, _e745, (_e745 < _e688));
let _e753 = global_2.member[bitcast<u32>(select(0i, _e747, (_e747 > 0i)))];
let _e755 = -((_e753 * _e567));
let _e757 = select(-87f, _e755, (_e755 > -87f));
let _e759 = select(88f, _e757, (_e757 < 88f));
let _e761 = ((_e759 * 1.442695f) + 0.5f);
let _e763 = select(-127f, _e761, (_e761 > -127f));
let _e765 = select(128f, _e763, (_e763 < 128f));
let _e772 = select(0i, select(select(i32(_e765), i32(-2147483648), (_e765 < -2147483600f)), 2147483647i, (_e765 > 2147483500f)), (_e765 == _e765));
let _e776 = (_e772 - select(0i, 1i, (_e765 < f32(_e772))));
let _e777 = f32(_e776);
let _e781 = ((_e759 - (_e777 * 0.6933594f)) - (_e777 * -2.1219444e-4f));
let _e802 = (_e685 + 3i);
let _e804 = select(_e688, _e802, (_e802 < _e688));
let _e810 = global_2.member[bitcast<u32>(select(0i, _e804, (_e804 > 0i)))];
let _e812 = -((_e810 * _e567));
let _e814 = select(-87f, _e812, (_e812 > -87f));
let _e816 = select(88f, _e814, (_e814 < 88f));
let _e818 = ((_e816 * 1.442695f) + 0.5f);
let _e820 = select(-127f, _e818, (_e818 > -127f));
let _e822 = select(128f, _e820, (_e820 < 128f));
let _e829 = select(0i, select(select(i32(_e822), i32(-2147483648), (_e822 < -2147483600f)), 2147483647i, (_e822 > 2147483500f)), (_e822 == _e822));
let _e833 = (_e829 - select(0i, 1i, (_e822 < f32(_e829))));
let _e834 = f32(_e833);
let _e838 = ((_e816 - (_e834 * 0.6933594f)) - (_e834 * -2.1219444e-4f));
phi_1490_ = type_24(_e684.member, _e684.member_1, vec3<f32>((_e540.member_2.x * ((1f + (_e724 * (1f + (_e724 * (0.5f + (_e724 * (0.16666667f + (_e724 * (0.041666668f + (_e724 * (0.008333334f + (_e724 * (0.001388889f + (_e724 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e719 + 127i)) << bitcast<u32>(23i))))), (_e540.member_2.y * ((1f + (_e781 * (1f + (_e781 * (0.5f + (_e781 * (0.16666667f + (_e781 * (0.041666668f + (_e781 * (0.008333334f + (_e781 * (0.001388889f + (_e781 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e776 + 127i)) << bitcast<u32>(23i))))), (_e540.member_2.z * ((1f + (_e838 * (1f + (_e838 * (0.5f + (_e838 * (0.16666667f + (_e838 * (0.041666668f + (_e838 * (0.008333334f + (_e838 * (0.001388889f + (_e838 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e833 + 127i)) << bitcast<u32>(23i)))))), _e684.member_3, _e684.member_4, _e684.member_5, _e684.member_6, _e684.member_7, _e684.member_8, _e684.member_9, _e684.member_10, _e684.member_11, _e684.member_12, _e684.member_13, _e684.member_14, _e684.member_15, _e684.member_16, _e684.member_17);
} else {
phi_1490_ = _e663;
}
let _e888 = phi_1490_;
phi_1491_ = _e888;
}
let _e1227 = phi_1491_;
if (!(_e569) && ((((((_e1227.member.x < 0f) || (_e1227.member.y < 0f)) || (_e1227.member.z < 0f)) || (_e1227.member.x >= f32(_e525))) || (_e1227.member.y >= f32(_e530))) || (_e1227.member.z >= f32(_e535)))) {
if (_e1227.member_16 == -1i) {
phi_1823_ = type_24(_e1227.member, _e1227.member_1, _e1227.member_2, _e1227.member_3, _e1227.member_4, _e1227.member_5, 1f, _e1227.member_7, _e1227.member_8, _e1227.member_9, _e1227.member_10, _e1227.member_11, _e1227.member_12, _e1227.member_13, _e1227.member_14, _e1227.member_15, _e1227.member_16, _e1227.member_17);
} else {
let _e2543 = type_24(vec3<f32>((_e1227.member.x + (_e1227.member_1.x * _e1227.member_17)), (_e1227.member.y + (_e1227.member_1.y * _e1227.member_17)), (_e1227.member.z + (_e1227.member_1.z * _e1227.member_17))), _e1227.member_1, _e1227.member_2, _e1227.member_3, _e1227.member_4, _e1227.member_5, _e1227.member_6, _e1227.member_7, _e1227.member_8, _e1227.member_9, _e1227.member_10, _e1227.member_11, _e1227.member_12, _e1227.member_13, _e1227.member_14, _e1227.member_15, _e1227.member_16, _e1227.member_17);
let _e2563 = type_24(_e2543.member, _e2543.member_1, _e2543.member_2, _e2543.member_3, _e2543.member_4, (_e1227.member_5 + _e1227.member_17), _e2543.member_6, _e2543.member_7, _e2543.member_8, _e2543.member_9, _e2543.member_10, _e2543.member_11, _e2543.member_12, _e2543.member_13, _e2543.member_14, _e2543.member_15, _e2543.member_16, _e2543.member_17);
let _e2582 = type_24(_e2563.member, _e2563.member_1, _e2563.member_2, _e2563.member_3, _e2563.member_4, _e2563.member_5, _e2563.member_6, _e2563.member_7, _e2563.member_8, _e2563.member_9, _e2563.member_10, _e2563.member_11, _e2563.member_12, _e2563.member_13, _e2563.member_14, _e2563.member_15, _e2563.member_16, (_e1227.member_17 - _e1227.member_17));
let _e2605 = type_24(_e2582.member, _e2582.member_1, _e2582.member_2, _e2582.member_3, _e2582.member_4, _e2582.member_5, _e2582.member_6, _e2582.member_7, _e2582.member_8, _e2582.member_9, (_e1227.member_10 + select(0f, _e1227.member_17, (_e1227.member_8 == 0f))), _e2582.member_11, _e2582.member_12, _e2582.member_13, _e2582.member_14, _e2582.member_15, _e2582.member_16, _e2582.member_17);
phi_1823_ = type_24(_e2605.member, _e2605.member_1, _e2605.member_2, _e2605.member_3, _e2605.member_4, _e2605.member_5, 3f, _e2605.member_7, _e2605.member_8, _e2605.member_9, _e2605.member_10, _e2605.member_11, _e2605.member_12, _e2605.member_13, _e2605.member_14, _e2605.member_15, _e2605.member_16, _e2605.member_17);
}
let _e2643 = phi_1823_;
phi_3290_ = _e2643;
} else {
if _e569 {
phi_3289_ = _e1227;
} else {
let _e1249 = f32((_e525 - 1i));
let _e1251 = select(0f, _e1227.member.x, (_e1227.member.x > 0f));
let _e1253 = select(_e1249, _e1251, (_e1251 < _e1249));
let _e1260 = select(0i, select(select(i32(_e1253), i32(-2147483648), (_e1253 < -2147483600f)), 2147483647i, (_e1253 > 2147483500f)), (_e1253 == _e1253));
let _e1264 = (_e1260 - select(0i, 1i, (_e1253 < f32(_e1260))));
let _e1266 = f32((_e530 - 1i));
let _e1268 = select(0f, _e1227.member.y, (_e1227.member.y > 0f));
let _e1270 = select(_e1266, _e1268, (_e1268 < _e1266));
let _e1277 = select(0i, select(select(i32(_e1270), i32(-2147483648), (_e1270 < -2147483600f)), 2147483647i, (_e1270 > 2147483500f)), (_e1270 == _e1270));
let _e1283 = f32((_e535 - 1i));
let _e1285 = select(0f, _e1227.member.z, (_e1227.member.z > 0f));
let _e1287 = select(_e1283, _e1285, (_e1285 < _e1283));
let _e1294 = select(0i, select(select(i32(_e1287), i32(-2147483648), (_e1287 < -2147483600f)), 2147483647i, (_e1287 > 2147483500f)), (_e1287 == _e1287));
let _e1304 = (((((_e1294 - select(0i, 1i, (_e1287 < f32(_e1294)))) * _e530) + (_e1277 - select(0i, 1i, (_e1270 < f32(_e1277))))) * ((_e525 + 31i) >> bitcast<u32>(5i))) + (_e1264 >> bitcast<u32>(5i)));
let _e1306 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1308 = select(_e1306, _e1304, (_e1304 < _e1306));
let _e1314 = global_5.member[bitcast<u32>(select(0i, _e1308, (_e1308 > 0i)))];
let _e1317 = (bitcast<u32>((_e1264 & 31i)) & 31u);
if (((_e1314 >> bitcast<u32>(_e1317)) & 1u) == 1u) {
let _e1323 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e1325 = select(_e1323, _e1304, (_e1304 < _e1323));
let _e1331 = global_6.member[bitcast<u32>(select(0i, _e1325, (_e1325 > 0i)))];
let _e1339 = (bitcast<i32>((_e1331 + countOneBits((_e1314 & ((1u << bitcast<u32>(_e1317)) - 1u))))) * 4i);
let _e1341 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1343 = select(_e1341, _e1339, (_e1339 < _e1341));
let _e1349 = global_7.member[bitcast<u32>(select(0i, _e1343, (_e1343 > 0i)))];
let _e1350 = (_e1339 + 1i);
let _e1352 = select(_e1341, _e1350, (_e1350 < _e1341));
let _e1358 = global_7.member[bitcast<u32>(select(0i, _e1352, (_e1352 > 0i)))];
let _e1359 = (_e1339 + 2i);
let _e1361 = select(_e1341, _e1359, (_e1359 < _e1341));
let _e1367 = global_7.member[bitcast<u32>(select(0i, _e1361, (_e1361 > 0i)))];
let _e1368 = vec3<f32>(_e1349, _e1358, _e1367);
let _e1369 = (_e1339 + 3i);
let _e1371 = select(_e1341, _e1369, (_e1369 < _e1341));
let _e1377 = global_7.member[bitcast<u32>(select(0i, _e1371, (_e1371 > 0i)))];
let _e1379 = select(0f, _e1377, (_e1377 > 0f));
let _e1381 = select(16f, _e1379, (_e1379 < 16f));
let _e1388 = select(0i, select(select(i32(_e1381), i32(-2147483648), (_e1381 < -2147483600f)), 2147483647i, (_e1381 > 2147483500f)), (_e1381 == _e1381));
let _e1397 = (((_e540.member_1.x * _e1349) + (_e540.member_1.y * _e1358)) + (_e540.member_1.z * _e1367));
let _e1399 = select(16i, (_e1388 - select(0i, 1i, (_e1381 < f32(_e1388)))), (_e1397 < 0f));
let _e1413 = global_1.member.member_12;
if ((!(((_e1227.member_8 > 0f) && ((((_e1349 * _e1227.member_4.x) + (_e1358 * _e1227.member_4.y)) + (_e1367 * _e1227.member_4.z)) > _e1413))) && (_e1397 != 0f)) && (_e1399 != _e1227.member_7)) {
let _e1423 = (_e1227.member_7 * 4i);
let _e1425 = (bitcast<i32>(_e96) - 1i);
let _e1427 = select(_e1425, _e1423, (_e1423 < _e1425));
let _e1433 = global_2.member[bitcast<u32>(select(0i, _e1427, (_e1427 > 0i)))];
let _e1434 = (_e1227.member_7 == 16i);
let _e1435 = select(_e1433, 1f, _e1434);
let _e1436 = (_e1399 * 4i);
let _e1438 = select(_e1425, _e1436, (_e1436 < _e1425));
let _e1444 = global_2.member[bitcast<u32>(select(0i, _e1438, (_e1438 > 0i)))];
let _e1446 = select(_e1444, 1f, (_e1399 == 16i));
let _e1456 = select(1f, -1f, ((((_e1227.member_1.x * _e1349) + (_e1227.member_1.y * _e1358)) + (_e1227.member_1.z * _e1367)) > 0f));
let _e1457 = (_e1349 * _e1456);
let _e1458 = (_e1358 * _e1456);
let _e1459 = (_e1367 * _e1456);
let _e1465 = -((((_e1227.member_1.x * _e1457) + (_e1227.member_1.y * _e1458)) + (_e1227.member_1.z * _e1459)));
let _e1467 = select(0f, _e1465, (_e1465 > 0f));
let _e1468 = (_e1435 / _e1446);
let _e1470 = (_e1467 * _e1467);
let _e1473 = (1f - ((_e1468 * _e1468) * (1f - _e1470)));
let _e1474 = (_e1473 <= 0f);
let _e1482 = ((_e1468 * _e1467) - sqrt(select(0f, _e1473, (_e1473 > 0f))));
let _e1489 = (2f * _e1467);
let _e1493 = (_e1227.member_1.x + (_e1457 * _e1489));
let _e1494 = (_e1227.member_1.y + (_e1458 * _e1489));
let _e1495 = (_e1227.member_1.z + (_e1459 * _e1489));
let _e1496 = select(((_e1227.member_1.x * _e1468) + (_e1457 * _e1482)), _e1493, _e1474);
let _e1497 = select(((_e1227.member_1.y * _e1468) + (_e1458 * _e1482)), _e1494, _e1474);
let _e1498 = select(((_e1227.member_1.z * _e1468) + (_e1459 * _e1482)), _e1495, _e1474);
let _e1503 = (((_e1496 * _e1496) + (_e1497 * _e1497)) + (_e1498 * _e1498));
let _e1506 = sqrt(select(0f, _e1503, (_e1503 > 0f)));
let _e1509 = (1f / select(1e-20f, _e1506, (_e1506 > 1e-20f)));
let _e1514 = (_e1446 / _e1435);
let _e1517 = (((_e1514 * _e1514) - 1f) + _e1470);
let _e1520 = sqrt(select(0f, _e1517, (_e1517 > 0f)));
let _e1521 = (_e1520 - _e1467);
let _e1522 = (_e1520 + _e1467);
let _e1525 = (_e1521 / select(1e-6f, _e1522, (_e1522 > 1e-6f)));
let _e1529 = ((_e1467 * _e1521) + 1f);
let _e1532 = (((_e1467 * _e1522) - 1f) / select(1e-6f, _e1529, (_e1529 > 1e-6f)));
let _e1542 = (_e1227.member_8 == 0f);
let _e1545 = global_1.member.member_1;
let _e1548 = select(0f, select(select((((0.5f * _e1525) * _e1525) * (1f + (_e1532 * _e1532))), 1f, (_e1517 <= 0f)), 0f, (_e1435 == _e1446)), ((_e1545 & 1u) != 0u));
let _e1549 = (_e1542 && _e1434);
if _e1542 {
let _e1567 = type_24(_e1227.member, _e1227.member_1, _e1227.member_2, _e1368, _e1227.member_4, _e1227.member_5, _e1227.member_6, _e1227.member_7, _e1227.member_8, _e1227.member_9, _e1227.member_10, _e1227.member_11, _e1227.member_12, _e1227.member_13, _e1227.member_14, _e1227.member_15, _e1227.member_16, _e1227.member_17);
phi_2301_ = type_24(_e1567.member, _e1567.member_1, _e1567.member_2, _e1567.member_3, _e1567.member_4, _e1567.member_5, _e1567.member_6, _e1567.member_7, _e1567.member_8, _e1567.member_9, _e1567.member_10, select(0f, _e1548, _e1549), _e1567.member_12, _e1567.member_13, _e1567.member_14, _e1567.member_15, _e1567.member_16, _e1567.member_17);
} else {
phi_2301_ = _e1227;
}
let _e1588 = phi_2301_;
let _e1592 = select(24f, _e1588.member_8, (_e1588.member_8 < 24f));
let _e1602 = (_e1588.member_14 >> bitcast<u32>((select(0i, select(select(i32(_e1592), i32(-2147483648), (_e1592 < -2147483600f)), 2147483647i, (_e1592 > 2147483500f)), (_e1592 == _e1592)) & 31i)));
let _e1604 = ((_e1602 & 1i) == 1i);
if ((!(_e1549) && !(_e1474)) && (_e1602 == 0i)) {
let _e1613 = select(_e1588.member_5, _e1588.member_9, (_e1588.member_8 == 0f));
let _e1614 = (_e1423 + 1i);
let _e1616 = select(_e1425, _e1614, (_e1614 < _e1425));
let _e1622 = global_2.member[bitcast<u32>(select(0i, _e1616, (_e1616 > 0i)))];
let _e1624 = -((_e1622 * _e1613));
let _e1626 = select(-87f, _e1624, (_e1624 > -87f));
let _e1628 = select(88f, _e1626, (_e1626 < 88f));
let _e1630 = ((_e1628 * 1.442695f) + 0.5f);
let _e1632 = select(-127f, _e1630, (_e1630 > -127f));
let _e1634 = select(128f, _e1632, (_e1632 < 128f));
let _e1641 = select(0i, select(select(i32(_e1634), i32(-2147483648), (_e1634 < -2147483600f)), 2147483647i, (_e1634 > 2147483500f)), (_e1634 == _e1634));
let _e1645 = (_e1641 - select(0i, 1i, (_e1634 < f32(_e1641))));
let _e1646 = f32(_e1645);
let _e1650 = ((_e1628 - (_e1646 * 0.6933594f)) - (_e1646 * -2.1219444e-4f));
let _e1671 = (_e1423 + 2i);
let _e1673 = select(_e1425, _e1671, (_e1671 < _e1425));
let _e1679 = global_2.member[bitcast<u32>(select(0i, _e1673, (_e1673 > 0i)))];
let _e1681 = -((_e1679 * _e1613));
let _e1683 = select(-87f, _e1681, (_e1681 > -87f));
let _e1685 = select(88f, _e1683, (_e1683 < 88f));
let _e1687 = ((_e1685 * 1.442695f) + 0.5f);
let _e1689 = select(-127f, _e1687, (_e1687 > -127f));
let _e1691 = select(128f, _e1689, (_e1689 < 128f));
let _e1698 = select(0i, select(select(i32(_e1691), i32(-2147483648), (_e1691 < -2147483600f)), 2147483647i, (_e1691 > 2147483500f)), (_e1691 == _e1691));
let _e1702 = (_e1698 - select(0i, 1i, (_e1691 < f32(_e1698))));
let _e1703 = f32(_e1702);
let _e1707 = ((_e1685 - (_e1703 * 0.6933594f)) - (_e1703 * -2.1219444e-4f));
let _e1728 = (_e1423 + 3i);
let _e1730 = select(_e1425, _e1728, (_e1728 < _e1425));
let _e1736 = global_2.member[bitcast<u32>(select(0i, _e1730, (_e1730 > 0i)))];
let _e1738 = -((_e1736 * _e1613));
let _e1740 = select(-87f, _e1738, (_e1738 > -87f));
let _e1742 = select(88f, _e1740, (_e1740 < 88f));
let _e1744 = ((_e1742 * 1.442695f) + 0.5f);
let _e1746 = select(-127f, _e1744, (_e1744 > -127f));
let _e1748 = select(128f, _e1746, (_e1746 < 128f));
let _e1755 = select(0i, select(select(i32(_e1748), i32(-2147483648), (_e1748 < -2147483600f)), 2147483647i, (_e1748 > 2147483500f)), (_e1748 == _e1748));
let _e1759 = (_e1755 - select(0i, 1i, (_e1748 < f32(_e1755))));
let _e1760 = f32(_e1759);
let _e1764 = ((_e1742 - (_e1760 * 0.6933594f)) - (_e1760 * -2.1219444e-4f));
let _e1786 = select(((1f + (_e1650 * (1f + (_e1650 * (0.5f + (_e1650 * (0.16666667f + (_e1650 * (0.041666668f + (_e1650 * (0.008333334f + (_e1650 * (0.001388889f + (_e1650 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1645 + 127i)) << bitcast<u32>(23i)))), 1f, _e1434);
let _e1788 = (1f - (_e1548 * _e1786));
let _e1790 = (1f - _e1548);
let _e1796 = select(((1f + (_e1707 * (1f + (_e1707 * (0.5f + (_e1707 * (0.16666667f + (_e1707 * (0.041666668f + (_e1707 * (0.008333334f + (_e1707 * (0.001388889f + (_e1707 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1702 + 127i)) << bitcast<u32>(23i)))), 1f, _e1434);
let _e1798 = (1f - (_e1548 * _e1796));
let _e1805 = select(((1f + (_e1764 * (1f + (_e1764 * (0.5f + (_e1764 * (0.16666667f + (_e1764 * (0.041666668f + (_e1764 * (0.008333334f + (_e1764 * (0.001388889f + (_e1764 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1759 + 127i)) << bitcast<u32>(23i)))), 1f, _e1434);
let _e1807 = (1f - (_e1548 * _e1805));
let _e1820 = ((_e1588.member_2.x * select(1f, ((_e1790 * _e1786) / select(1e-9f, _e1788, (_e1788 > 1e-9f))), (_e1788 > 0f))) * _e1548);
let _e1821 = ((_e1588.member_2.y * select(1f, ((_e1790 * _e1796) / select(1e-9f, _e1798, (_e1798 > 1e-9f))), (_e1798 > 0f))) * _e1548);
let _e1822 = ((_e1588.member_2.z * select(1f, ((_e1790 * _e1805) / select(1e-9f, _e1807, (_e1807 > 1e-9f))), (_e1807 > 0f))) * _e1548);
let _e1830 = select(0i, select(select(i32(_e1588.member_8), i32(-2147483648), (_e1588.member_8 < -2147483600f)), 2147483647i, (_e1588.member_8 > 2147483500f)), (_e1588.member_8 == _e1588.member_8));
let _e1842 = ((_e1588.member_13.x + _e1588.member_13.y) + _e1588.member_13.z);
if ((((_e1545 & 8u) != 0u) && (_e1830 < 24i)) && (((_e1820 + _e1821) + _e1822) > _e1842)) {
if (_e1842 > 0f) {
if (_e1588.member_14 == 0i) {
phi_2699_ = 0i;
} else {
phi_2699_ = (_e1588.member_14 - (1i << bitcast<u32>(((bitcast<i32>((bitcast<u32>(f32(_e1588.member_14)) >> bitcast<u32>(23i))) - 127i) & 31i))));
}
let _e1886 = phi_2699_;
phi_2701_ = _e1886;
} else {
phi_2701_ = _e1588.member_14;
}
let _e1888 = phi_2701_;
let _e1910 = type_24(_e1588.member, _e1588.member_1, _e1588.member_2, _e1588.member_3, _e1588.member_4, _e1588.member_5, _e1588.member_6, _e1588.member_7, _e1588.member_8, _e1588.member_9, _e1588.member_10, _e1588.member_11, _e1588.member_12, _e1588.member_13, (_e1888 | (1i << bitcast<u32>((_e1830 & 31i)))), _e1588.member_15, _e1588.member_16, _e1588.member_17);
let _e1938 = type_24(_e1910.member, _e1910.member_1, _e1910.member_2, _e1910.member_3, _e1910.member_4, _e1910.member_5, _e1910.member_6, _e1910.member_7, _e1910.member_8, _e1910.member_9, _e1910.member_10, _e1910.member_11, vec3<f32>((_e1588.member_12.x + _e1588.member_13.x), (_e1588.member_12.y + _e1588.member_13.y), (_e1588.member_12.z + _e1588.member_13.z)), _e1910.member_13, _e1910.member_14, _e1910.member_15, _e1910.member_16, _e1910.member_17);
phi_2729_ = type_24(_e1938.member, _e1938.member_1, _e1938.member_2, _e1938.member_3, _e1938.member_4, _e1938.member_5, _e1938.member_6, _e1938.member_7, _e1938.member_8, _e1938.member_9, _e1938.member_10, _e1938.member_11, _e1938.member_12, vec3<f32>(_e1820, _e1821, _e1822), _e1938.member_14, _e1938.member_15, _e1938.member_16, _e1938.member_17);
} else {
phi_2729_ = type_24(_e1588.member, _e1588.member_1, _e1588.member_2, _e1588.member_3, _e1588.member_4, _e1588.member_5, _e1588.member_6, _e1588.member_7, _e1588.member_8, _e1588.member_9, _e1588.member_10, _e1588.member_11, vec3<f32>((_e1588.member_12.x + _e1820), (_e1588.member_12.y + _e1821), (_e1588.member_12.z + _e1822)), _e1588.member_13, _e1588.member_14, _e1588.member_15, _e1588.member_16, _e1588.member_17);
}
let _e1958 = phi_2729_;
phi_2730_ = _e1958;
} else {
phi_2730_ = _e1588;
}
let _e1960 = phi_2730_;
let _e1962 = (_e1960.member_8 + 1f);
let _e1980 = type_24(_e1960.member, _e1960.member_1, _e1960.member_2, _e1960.member_3, _e1960.member_4, _e1960.member_5, _e1960.member_6, _e1960.member_7, _e1962, _e1960.member_9, _e1960.member_10, _e1960.member_11, _e1960.member_12, _e1960.member_13, _e1960.member_14, _e1960.member_15, _e1960.member_16, _e1960.member_17);
let _e1984 = !(_e1604);
let _e1985 = (((_e103.member_2 == 0u) && (_e1962 >= 2f)) && _e1984);
if (_e1474 && _e1985) {
let _e2048 = (((_e1960.member_1.x * _e1349) + (_e1960.member_1.y * _e1358)) + (_e1960.member_1.z * _e1367));
let _e2052 = (_e1960.member_1.x - (_e1349 * _e2048));
let _e2053 = (_e1960.member_1.y - (_e1358 * _e2048));
let _e2054 = (_e1960.member_1.z - (_e1367 * _e2048));
let _e2059 = (((_e2052 * _e2052) + (_e2053 * _e2053)) + (_e2054 * _e2054));
let _e2062 = sqrt(select(0f, _e2059, (_e2059 > 0f)));
let _e2065 = (1f / select(1e-20f, _e2062, (_e2062 > 1e-20f)));
phi_2811_ = type_24(_e1980.member, vec3<f32>((_e2052 * _e2065), (_e2053 * _e2065), (_e2054 * _e2065)), _e1980.member_2, _e1980.member_3, _e1980.member_4, _e1980.member_5, _e1980.member_6, _e1980.member_7, _e1980.member_8, _e1980.member_9, _e1980.member_10, _e1980.member_11, _e1980.member_12, _e1980.member_13, _e1980.member_14, _e1980.member_15, _e1980.member_16, _e1980.member_17);
} else {
if _e1604 {
let _e2009 = (((_e1493 * _e1493) + (_e1494 * _e1494)) + (_e1495 * _e1495));
let _e2012 = sqrt(select(0f, _e2009, (_e2009 > 0f)));
let _e2015 = (1f / select(1e-20f, _e2012, (_e2012 > 1e-20f)));
phi_2810_ = type_24(_e1980.member, vec3<f32>((_e1493 * _e2015), (_e1494 * _e2015), (_e1495 * _e2015)), _e1980.member_2, _e1980.member_3, _e1980.member_4, _e1980.member_5, _e1980.member_6, _e1980.member_7, _e1980.member_8, _e1980.member_9, _e1980.member_10, _e1980.member_11, _e1980.member_12, _e1980.member_13, _e1980.member_14, _e1980.member_15, _e1980.member_16, _e1980.member_17);
} else {
phi_2810_ = type_24(_e1980.member, vec3<f32>((_e1496 * _e1509), (_e1497 * _e1509), (_e1498 * _e1509)), _e1980.member_2, _e1980.member_3, _e1980.member_4, _e1980.member_5, _e1980.member_6, _e1980.member_7, _e1980.member_8, _e1980.member_9, _e1980.member_10, _e1980.member_11, _e1980.member_12, _e1980.member_13, _e1980.member_14, _e1980.member_15, _e1980.member_16, _e1980.member_17);
}
let _e2039 = phi_2810_;
phi_2811_ = _e2039;
}
let _e2089 = phi_2811_;
if _e1474 {
phi_2829_ = _e2089;
} else {
let _e2091 = select((1f - _e1548), _e1548, _e1604);
phi_2829_ = type_24(_e2089.member, _e2089.member_1, vec3<f32>((_e2089.member_2.x * _e2091), (_e2089.member_2.y * _e2091), (_e2089.member_2.z * _e2091)), _e2089.member_3, _e2089.member_4, _e2089.member_5, _e2089.member_6, _e2089.member_7, _e2089.member_8, _e2089.member_9, _e2089.member_10, _e2089.member_11, _e2089.member_12, _e2089.member_13, _e2089.member_14, _e2089.member_15, _e2089.member_16, _e2089.member_17);
}
let _e2121 = phi_2829_;
let _e2139 = type_24(_e2121.member, _e2121.member_1, _e2121.member_2, _e2121.member_3, _e2121.member_4, 0f, _e2121.member_6, _e2121.member_7, _e2121.member_8, _e2121.member_9, _e2121.member_10, _e2121.member_11, _e2121.member_12, _e2121.member_13, _e2121.member_14, _e2121.member_15, _e2121.member_16, _e2121.member_17);
let _e2146 = global_1.member.member_18.member.member;
let _e2160 = ((((_e2146.member.member * _e2121.member.x) + (_e2146.member.member_1 * _e2121.member.y)) + (_e2146.member.member_2 * _e2121.member.z)) + _e2146.member_1);
let _e2169 = -((((_e2146.member.member * _e2121.member_1.x) + (_e2146.member.member_1 * _e2121.member_1.y)) + (_e2146.member.member_2 * _e2121.member_1.z)));
let _e2171 = (_e2169 > 1e-9f);
let _e2175 = ((_e2160 / select(1e-9f, _e2169, _e2171)) - 0.015625f);
let _e2178 = select(1e30f, select(0f, _e2175, (_e2175 > 0f)), ((_e2160 > 0f) && _e2171));
let _e2183 = global_1.member.member_18.member_1.member;
let _e2194 = ((((_e2183.member.member * _e2121.member.x) + (_e2183.member.member_1 * _e2121.member.y)) + (_e2183.member.member_2 * _e2121.member.z)) + _e2183.member_1);
let _e2200 = -((((_e2183.member.member * _e2121.member_1.x) + (_e2183.member.member_1 * _e2121.member_1.y)) + (_e2183.member.member_2 * _e2121.member_1.z)));
let _e2202 = (_e2200 > 1e-9f);
let _e2206 = ((_e2194 / select(1e-9f, _e2200, _e2202)) - 0.015625f);
let _e2209 = select(1e30f, select(0f, _e2206, (_e2206 > 0f)), ((_e2194 > 0f) && _e2202));
let _e2213 = (_e2209 < _e2178);
let _e2215 = select(select(-2i, -3i, _e2213), -1i, ((_e2178 >= 1e30f) && (_e2209 >= 1e30f)));
let _e2216 = select(_e2178, _e2209, _e2213);
let _e2234 = type_24(_e2139.member, _e2139.member_1, _e2139.member_2, _e2139.member_3, _e2139.member_4, _e2139.member_5, _e2139.member_6, _e2139.member_7, _e2139.member_8, _e2139.member_9, _e2139.member_10, _e2139.member_11, _e2139.member_12, _e2139.member_13, _e2139.member_14, 0i, _e2139.member_16, _e2139.member_17);
let _e2252 = type_24(_e2234.member, _e2234.member_1, _e2234.member_2, _e2234.member_3, _e2234.member_4, _e2234.member_5, _e2234.member_6, _e2234.member_7, _e2234.member_8, _e2234.member_9, _e2234.member_10, _e2234.member_11, _e2234.member_12, _e2234.member_13, _e2234.member_14, _e2234.member_15, _e2215, _e2234.member_17);
let _e2270 = type_24(_e2252.member, _e2252.member_1, _e2252.member_2, _e2252.member_3, _e2252.member_4, _e2252.member_5, _e2252.member_6, _e2252.member_7, _e2252.member_8, _e2252.member_9, _e2252.member_10, _e2252.member_11, _e2252.member_12, _e2252.member_13, _e2252.member_14, _e2252.member_15, _e2252.member_16, _e2216);
let _e2271 = (_e1474 || _e1604);
let _e2274 = ((_e1545 & 2u) != 0u);
if (_e1985 && !(_e2274)) {
if (_e2215 == -1i) {
phi_3256_ = type_24(_e2270.member, _e2270.member_1, _e2270.member_2, _e2270.member_3, _e2270.member_4, _e2270.member_5, 1f, _e2270.member_7, _e2270.member_8, _e2270.member_9, _e2270.member_10, _e2270.member_11, _e2270.member_12, _e2270.member_13, _e2270.member_14, _e2270.member_15, _e2270.member_16, _e2270.member_17);
} else {
let _e2360 = type_24(vec3<f32>((_e2121.member.x + (_e2121.member_1.x * _e2216)), (_e2121.member.y + (_e2121.member_1.y * _e2216)), (_e2121.member.z + (_e2121.member_1.z * _e2216))), _e2270.member_1, _e2270.member_2, _e2270.member_3, _e2270.member_4, _e2270.member_5, _e2270.member_6, _e2270.member_7, _e2270.member_8, _e2270.member_9, _e2270.member_10, _e2270.member_11, _e2270.member_12, _e2270.member_13, _e2270.member_14, _e2270.member_15, _e2270.member_16, _e2270.member_17);
let _e2379 = type_24(_e2360.member, _e2360.member_1, _e2360.member_2, _e2360.member_3, _e2360.member_4, (0f + _e2216), _e2360.member_6, _e2360.member_7, _e2360.member_8, _e2360.member_9, _e2360.member_10, _e2360.member_11, _e2360.member_12, _e2360.member_13, _e2360.member_14, _e2360.member_15, _e2360.member_16, _e2360.member_17);
let _e2398 = type_24(_e2379.member, _e2379.member_1, _e2379.member_2, _e2379.member_3, _e2379.member_4, _e2379.member_5, _e2379.member_6, _e2379.member_7, _e2379.member_8, _e2379.member_9, _e2379.member_10, _e2379.member_11, _e2379.member_12, _e2379.member_13, _e2379.member_14, _e2379.member_15, _e2379.member_16, (_e2216 - _e2216));
let _e2421 = type_24(_e2398.member, _e2398.member_1, _e2398.member_2, _e2398.member_3, _e2398.member_4, _e2398.member_5, _e2398.member_6, _e2398.member_7, _e2398.member_8, _e2398.member_9, (_e2121.member_10 + select(0f, _e2216, (_e2121.member_8 == 0f))), _e2398.member_11, _e2398.member_12, _e2398.member_13, _e2398.member_14, _e2398.member_15, _e2398.member_16, _e2398.member_17);
phi_3256_ = type_24(_e2421.member, _e2421.member_1, _e2421.member_2, _e2421.member_3, _e2421.member_4, _e2421.member_5, 3f, _e2421.member_7, _e2421.member_8, _e2421.member_9, _e2421.member_10, _e2421.member_11, _e2421.member_12, _e2421.member_13, _e2421.member_14, _e2421.member_15, _e2421.member_16, _e2421.member_17);
}
let _e2459 = phi_3256_;
phi_3279_ = _e2459;
} else {
let _e2282 = global_1.member.member_5;
if (((!(_e1985) && _e1984) && (_e2121.member_8 >= f32(bitcast<i32>(_e2282)))) && (select(_e1399, _e1227.member_7, _e2271) != 16i)) {
phi_3278_ = type_24(_e2270.member, _e2270.member_1, _e2270.member_2, _e2270.member_3, _e2270.member_4, _e2270.member_5, 2f, _e2270.member_7, _e2270.member_8, _e2270.member_9, _e2270.member_10, _e2270.member_11, _e2270.member_12, _e2270.member_13, _e2270.member_14, _e2270.member_15, _e2270.member_16, _e2270.member_17);
} else {
if _e2274 {
phi_3277_ = type_24(_e2270.member, _e2270.member_1, _e2270.member_2, _e2270.member_3, _e2270.member_4, _e2270.member_5, 4f, _e2270.member_7, _e2270.member_8, _e2270.member_9, _e2270.member_10, _e2270.member_11, _e2270.member_12, _e2270.member_13, _e2270.member_14, _e2270.member_15, _e2270.member_16, _e2270.member_17);
} else {
phi_3277_ = _e2270;
}
let _e2308 = phi_3277_;
phi_3278_ = _e2308;
}
let _e2328 = phi_3278_;
phi_3279_ = _e2328;
}
let _e2461 = phi_3279_;
let _e2481 = type_24(_e2461.member, _e2461.member_1, _e2461.member_2, _e2461.member_3, _e2461.member_4, _e2461.member_5, _e2461.member_6, select(_e1227.member_7, _e1399, !(_e2271)), _e2461.member_8, _e2461.member_9, _e2461.member_10, _e2461.member_11, _e2461.member_12, _e2461.member_13, _e2461.member_14, _e2461.member_15, _e2461.member_16, _e2461.member_17);
phi_3287_ = type_24(_e2481.member, _e2481.member_1, _e2481.member_2, _e2481.member_3, _e1368, _e2481.member_5, _e2481.member_6, _e2481.member_7, _e2481.member_8, _e2481.member_9, _e2481.member_10, _e2481.member_11, _e2481.member_12, _e2481.member_13, _e2481.member_14, _e2481.member_15, _e2481.member_16, _e2481.member_17);
} else {
phi_3287_ = _e1227;
}
let _e2501 = phi_3287_;
phi_3288_ = _e2501;
} else {
phi_3288_ = _e1227;
}
let _e2503 = phi_3288_;
phi_3289_ = _e2503;
}
let _e2505 = phi_3289_;
phi_3290_ = _e2505;
}
let _e2645 = phi_3290_;
phi_869_ = _e2645;
phi_872_ = (_e542 + 1i);
} else {
phi_869_ = type_24();
phi_872_ = i32();
}
let _e2647 = phi_869_;
let _e2649 = phi_872_;
continue;
continuing {
phi_868_ = _e2647;
phi_871_ = _e2649;
break if !(_e546);
}
}
let _e2652 = local;
let _e2656 = local_1;
let _e2660 = local_2;
let _e2664 = local_3;
let _e2668 = local_4;
let _e2672 = local_5;
let _e2676 = local_6;
let _e2680 = local_7;
let _e2684 = local_8;
let _e2688 = local_9;
let _e2692 = local_10;
let _e2696 = local_11;
let _e2700 = local_12;
let _e2704 = local_13;
let _e2708 = local_14;
let _e2712 = local_15;
let _e2715 = local_16;
let _e2719 = local_17;
let _e2722 = local_18;
let _e2725 = local_19;
let _e2728 = local_20;
let _e2731 = local_21;
let _e2735 = local_22;
let _e2739 = local_23;
let _e2743 = local_24;
let _e2747 = local_25;
let _e2751 = local_26;
let _e2755 = local_27;
let _e2759 = local_28;
let _e2763 = local_29;
let _e2767 = local_30;
global_3.member[_e112] = _e2652.member.x;
global_3.member[_e124] = _e2656.member.y;
global_3.member[_e135] = _e2660.member.z;
global_3.member[_e146] = _e2664.member_1.x;
global_3.member[_e157] = _e2668.member_1.y;
global_3.member[_e168] = _e2672.member_1.z;
global_3.member[_e179] = _e2676.member_2.x;
global_3.member[_e190] = _e2680.member_2.y;
global_3.member[_e201] = _e2684.member_2.z;
global_3.member[_e212] = _e2688.member_3.x;
global_3.member[_e223] = _e2692.member_3.y;
global_3.member[_e234] = _e2696.member_3.z;
global_3.member[_e245] = _e2700.member_4.x;
global_3.member[_e256] = _e2704.member_4.y;
global_3.member[_e267] = _e2708.member_4.z;
global_3.member[_e278] = _e2712.member_5;
let _e2804 = local_31;
global_3.member[_e289] = _e2804;
global_3.member[_e300] = f32(_e2715.member_7);
global_3.member[_e311] = _e2719.member_8;
global_3.member[_e322] = _e2722.member_9;
global_3.member[_e333] = _e2725.member_10;
global_3.member[_e344] = _e2728.member_11;
global_3.member[_e355] = _e2731.member_12.x;
global_3.member[_e366] = _e2735.member_12.y;
global_3.member[_e377] = _e2739.member_12.z;
global_3.member[_e388] = _e2743.member_13.x;
global_3.member[_e399] = _e2747.member_13.y;
global_3.member[_e410] = _e2751.member_13.z;
global_3.member[_e421] = f32(_e2755.member_14);
global_3.member[_e432] = f32(_e2759.member_15);
global_3.member[_e443] = f32(_e2763.member_16);
global_3.member[_e454] = _e2767.member_17;
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
