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
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage, read_write> global_2: type_16;
fn function_() {
var phi_207_: vec3<f32>;
var phi_215_: vec3<f32>;
let _e48 = global;
let _e51 = global_1.member.member;
if (_e48.x < _e51.member) {
if (_e48.y < _e51.member_1) {
let _e58 = (_e51.member * _e51.member_1);
let _e60 = ((_e48.y * _e51.member) + _e48.x);
let _e64 = global_1.member.member.member;
let _e70 = global_1.member.member.member_1;
let _e82 = global_1.member.member_6.member;
let _e83 = (((((f32(bitcast<i32>(_e48.x)) + 0.5f) / f32(bitcast<i32>(_e64))) * 2f) - 1f) * _e82);
let _e93 = global_1.member.member_6.member_1;
let _e94 = ((1f - (((f32(bitcast<i32>(_e48.y)) + 0.5f) / f32(bitcast<i32>(_e70))) * 2f)) * _e93);
let _e97 = global_1.member.member_10;
let _e104 = global_1.member.member_7;
let _e113 = global_1.member.member_8;
let _e120 = ((_e104.member * _e83) + (_e113.member * _e94));
let _e121 = ((_e104.member_1 * _e83) + (_e113.member_1 * _e94));
let _e122 = ((_e104.member_2 * _e83) + (_e113.member_2 * _e94));
let _e126 = global_1.member.member_6.member_3;
let _e127 = (_e126 != 0u);
if _e127 {
let _e130 = global_1.member.member_9;
phi_207_ = vec3<f32>(_e130.member, _e130.member_1, _e130.member_2);
} else {
let _e137 = global_1.member.member_9;
phi_207_ = vec3<f32>((_e137.member + _e120), (_e137.member_1 + _e121), (_e137.member_2 + _e122));
}
let _e146 = phi_207_;
if _e127 {
phi_215_ = vec3<f32>((_e97.member + _e120), (_e97.member_1 + _e121), (_e97.member_2 + _e122));
} else {
phi_215_ = vec3<f32>(_e97.member, _e97.member_1, _e97.member_2);
}
let _e152 = phi_215_;
let _e160 = (((_e146.x * _e146.x) + (_e146.y * _e146.y)) + (_e146.z * _e146.z));
let _e163 = sqrt(select(0f, _e160, (_e160 > 0f)));
let _e166 = (1f / select(1e-20f, _e163, (_e163 > 1e-20f)));
let _e167 = (_e146.x * _e166);
let _e168 = (_e146.y * _e166);
let _e169 = (_e146.z * _e166);
let _e177 = (1f / select(_e167, select(1e-12f, -1e-12f, (_e167 < 0f)), (bitcast<f32>((bitcast<u32>(_e167) & 2147483647u)) < 1e-12f)));
let _e185 = (1f / select(_e168, select(1e-12f, -1e-12f, (_e168 < 0f)), (bitcast<f32>((bitcast<u32>(_e168) & 2147483647u)) < 1e-12f)));
let _e193 = (1f / select(_e169, select(1e-12f, -1e-12f, (_e169 < 0f)), (bitcast<f32>((bitcast<u32>(_e169) & 2147483647u)) < 1e-12f)));
let _e196 = global_1.member.member_14;
let _e202 = global_1.member.member_15;
let _e208 = ((_e196.member - _e152.x) * _e177);
let _e210 = ((_e202.member - _e152.x) * _e177);
let _e213 = ((_e196.member_1 - _e152.y) * _e185);
let _e215 = ((_e202.member_1 - _e152.y) * _e185);
let _e218 = ((_e196.member_2 - _e152.z) * _e193);
let _e220 = ((_e202.member_2 - _e152.z) * _e193);
let _e222 = select(_e210, _e208, (_e208 < _e210));
let _e224 = select(_e215, _e213, (_e213 < _e215));
let _e226 = select(_e224, _e222, (_e222 > _e224));
let _e228 = select(_e220, _e218, (_e218 < _e220));
let _e230 = select(_e228, _e226, (_e226 > _e228));
let _e232 = select(_e210, _e208, (_e208 > _e210));
let _e234 = select(_e215, _e213, (_e213 > _e215));
let _e236 = select(_e234, _e232, (_e232 < _e234));
let _e238 = select(_e220, _e218, (_e218 > _e220));
let _e240 = select(_e238, _e236, (_e236 < _e238));
let _e245 = global_1.member.member_18.member.member;
let _e256 = ((((_e245.member.member * _e152.x) + (_e245.member.member_1 * _e152.y)) + (_e245.member.member_2 * _e152.z)) + _e245.member_1);
let _e262 = -((((_e245.member.member * _e167) + (_e245.member.member_1 * _e168)) + (_e245.member.member_2 * _e169)));
let _e264 = (_e262 > 1e-9f);
let _e268 = ((_e256 / select(1e-9f, _e262, _e264)) - 0.015625f);
let _e271 = select(1e30f, select(0f, _e268, (_e268 > 0f)), ((_e256 > 0f) && _e264));
let _e276 = global_1.member.member_18.member_1.member;
let _e287 = ((((_e276.member.member * _e152.x) + (_e276.member.member_1 * _e152.y)) + (_e276.member.member_2 * _e152.z)) + _e276.member_1);
let _e293 = -((((_e276.member.member * _e167) + (_e276.member.member_1 * _e168)) + (_e276.member.member_2 * _e169)));
let _e295 = (_e293 > 1e-9f);
let _e299 = ((_e287 / select(1e-9f, _e293, _e295)) - 0.015625f);
let _e302 = select(1e30f, select(0f, _e299, (_e299 > 0f)), ((_e287 > 0f) && _e295));
let _e306 = (_e302 < _e271);
let _e308 = select(select(-2i, -3i, _e306), -1i, ((_e271 >= 1e30f) && (_e302 >= 1e30f)));
let _e309 = select(_e271, _e302, _e306);
let _e311 = select(0f, _e230, (_e230 > 0f));
let _e312 = (_e308 != -1i);
let _e318 = (((_e240 <= _e230) || (_e240 <= 0f)) || (_e312 && (_e309 <= _e311)));
let _e320 = select(_e311, select(0f, _e309, _e312), _e318);
let _e323 = global_1.member.member_1;
global_2.member[_e60] = (_e152.x + (_e167 * _e320));
global_2.member[(_e58 + _e60)] = (_e152.y + (_e168 * _e320));
global_2.member[((2u * _e58) + _e60)] = (_e152.z + (_e169 * _e320));
global_2.member[((3u * _e58) + _e60)] = _e167;
global_2.member[((4u * _e58) + _e60)] = _e168;
global_2.member[((5u * _e58) + _e60)] = _e169;
global_2.member[((6u * _e58) + _e60)] = 1f;
global_2.member[((7u * _e58) + _e60)] = 1f;
global_2.member[((8u * _e58) + _e60)] = 1f;
global_2.member[((9u * _e58) + _e60)] = 0f;
global_2.member[((10u * _e58) + _e60)] = 0f;
global_2.member[((11u * _e58) + _e60)] = 0f;
global_2.member[((12u * _e58) + _e60)] = 0f;
global_2.member[((13u * _e58) + _e60)] = 0f;
global_2.member[((14u * _e58) + _e60)] = 0f;
global_2.member[((15u * _e58) + _e60)] = 1e9f;
global_2.member[((16u * _e58) + _e60)] = select(select(0f, 4f, ((_e323 & 2u) != 0u)), select(1f, 3f, _e312), _e318);
global_2.member[((17u * _e58) + _e60)] = 16f;
global_2.member[((18u * _e58) + _e60)] = 0f;
global_2.member[((19u * _e58) + _e60)] = 0f;
global_2.member[((20u * _e58) + _e60)] = _e320;
global_2.member[((21u * _e58) + _e60)] = 0f;
global_2.member[((22u * _e58) + _e60)] = 0f;
global_2.member[((23u * _e58) + _e60)] = 0f;
global_2.member[((24u * _e58) + _e60)] = 0f;
global_2.member[((25u * _e58) + _e60)] = 0f;
global_2.member[((26u * _e58) + _e60)] = f32(_e308);
global_2.member[((27u * _e58) + _e60)] = (_e309 - _e320);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
