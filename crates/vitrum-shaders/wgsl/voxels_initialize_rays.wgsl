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
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage, read_write> global_2: type_16;
fn function_() {
var phi_204_: vec3<f32>;
var phi_212_: vec3<f32>;
let _e45 = global;
let _e48 = global_1.member.member;
if (_e45.x < _e48.member) {
if (_e45.y < _e48.member_1) {
let _e55 = (_e48.member * _e48.member_1);
let _e57 = ((_e45.y * _e48.member) + _e45.x);
let _e61 = global_1.member.member.member;
let _e67 = global_1.member.member.member_1;
let _e79 = global_1.member.member_6.member;
let _e80 = (((((f32(bitcast<i32>(_e45.x)) + 0.5f) / f32(bitcast<i32>(_e61))) * 2f) - 1f) * _e79);
let _e90 = global_1.member.member_6.member_1;
let _e91 = ((1f - (((f32(bitcast<i32>(_e45.y)) + 0.5f) / f32(bitcast<i32>(_e67))) * 2f)) * _e90);
let _e94 = global_1.member.member_10;
let _e101 = global_1.member.member_7;
let _e110 = global_1.member.member_8;
let _e117 = ((_e101.member * _e80) + (_e110.member * _e91));
let _e118 = ((_e101.member_1 * _e80) + (_e110.member_1 * _e91));
let _e119 = ((_e101.member_2 * _e80) + (_e110.member_2 * _e91));
let _e123 = global_1.member.member_6.member_3;
let _e124 = (_e123 != 0u);
if _e124 {
let _e127 = global_1.member.member_9;
phi_204_ = vec3<f32>(_e127.member, _e127.member_1, _e127.member_2);
} else {
let _e134 = global_1.member.member_9;
phi_204_ = vec3<f32>((_e134.member + _e117), (_e134.member_1 + _e118), (_e134.member_2 + _e119));
}
let _e143 = phi_204_;
if _e124 {
phi_212_ = vec3<f32>((_e94.member + _e117), (_e94.member_1 + _e118), (_e94.member_2 + _e119));
} else {
phi_212_ = vec3<f32>(_e94.member, _e94.member_1, _e94.member_2);
}
let _e149 = phi_212_;
let _e157 = (((_e143.x * _e143.x) + (_e143.y * _e143.y)) + (_e143.z * _e143.z));
let _e160 = sqrt(select(0f, _e157, (_e157 > 0f)));
let _e163 = (1f / select(1e-20f, _e160, (_e160 > 1e-20f)));
let _e164 = (_e143.x * _e163);
let _e165 = (_e143.y * _e163);
let _e166 = (_e143.z * _e163);
let _e174 = (1f / select(_e164, select(1e-12f, -1e-12f, (_e164 < 0f)), (bitcast<f32>((bitcast<u32>(_e164) & 2147483647u)) < 1e-12f)));
let _e182 = (1f / select(_e165, select(1e-12f, -1e-12f, (_e165 < 0f)), (bitcast<f32>((bitcast<u32>(_e165) & 2147483647u)) < 1e-12f)));
let _e190 = (1f / select(_e166, select(1e-12f, -1e-12f, (_e166 < 0f)), (bitcast<f32>((bitcast<u32>(_e166) & 2147483647u)) < 1e-12f)));
let _e193 = global_1.member.member_14;
let _e199 = global_1.member.member_15;
let _e205 = ((_e193.member - _e149.x) * _e174);
let _e207 = ((_e199.member - _e149.x) * _e174);
let _e210 = ((_e193.member_1 - _e149.y) * _e182);
let _e212 = ((_e199.member_1 - _e149.y) * _e182);
let _e215 = ((_e193.member_2 - _e149.z) * _e190);
let _e217 = ((_e199.member_2 - _e149.z) * _e190);
let _e219 = select(_e207, _e205, (_e205 < _e207));
let _e221 = select(_e212, _e210, (_e210 < _e212));
let _e223 = select(_e221, _e219, (_e219 > _e221));
let _e225 = select(_e217, _e215, (_e215 < _e217));
let _e227 = select(_e225, _e223, (_e223 > _e225));
let _e229 = select(_e207, _e205, (_e205 > _e207));
let _e231 = select(_e212, _e210, (_e210 > _e212));
let _e233 = select(_e231, _e229, (_e229 < _e231));
let _e235 = select(_e217, _e215, (_e215 > _e217));
let _e237 = select(_e235, _e233, (_e233 < _e235));
let _e242 = global_1.member.member_17.member.member;
let _e253 = ((((_e242.member.member * _e149.x) + (_e242.member.member_1 * _e149.y)) + (_e242.member.member_2 * _e149.z)) + _e242.member_1);
let _e259 = -((((_e242.member.member * _e164) + (_e242.member.member_1 * _e165)) + (_e242.member.member_2 * _e166)));
let _e261 = (_e259 > 1e-9f);
let _e265 = ((_e253 / select(1e-9f, _e259, _e261)) - 0.015625f);
let _e268 = select(1e30f, select(0f, _e265, (_e265 > 0f)), ((_e253 > 0f) && _e261));
let _e273 = global_1.member.member_17.member_1.member;
let _e284 = ((((_e273.member.member * _e149.x) + (_e273.member.member_1 * _e149.y)) + (_e273.member.member_2 * _e149.z)) + _e273.member_1);
let _e290 = -((((_e273.member.member * _e164) + (_e273.member.member_1 * _e165)) + (_e273.member.member_2 * _e166)));
let _e292 = (_e290 > 1e-9f);
let _e296 = ((_e284 / select(1e-9f, _e290, _e292)) - 0.015625f);
let _e299 = select(1e30f, select(0f, _e296, (_e296 > 0f)), ((_e284 > 0f) && _e292));
let _e303 = (_e299 < _e268);
let _e305 = select(select(-2i, -3i, _e303), -1i, ((_e268 >= 1e30f) && (_e299 >= 1e30f)));
let _e306 = select(_e268, _e299, _e303);
let _e308 = select(0f, _e227, (_e227 > 0f));
let _e309 = (_e305 != -1i);
let _e315 = (((_e237 <= _e227) || (_e237 <= 0f)) || (_e309 && (_e306 <= _e308)));
let _e317 = select(_e308, select(0f, _e306, _e309), _e315);
let _e320 = global_1.member.member_1;
global_2.member[_e57] = (_e149.x + (_e164 * _e317));
global_2.member[(_e55 + _e57)] = (_e149.y + (_e165 * _e317));
global_2.member[((2u * _e55) + _e57)] = (_e149.z + (_e166 * _e317));
global_2.member[((3u * _e55) + _e57)] = _e164;
global_2.member[((4u * _e55) + _e57)] = _e165;
global_2.member[((5u * _e55) + _e57)] = _e166;
global_2.member[((6u * _e55) + _e57)] = 1f;
global_2.member[((7u * _e55) + _e57)] = 1f;
global_2.member[((8u * _e55) + _e57)] = 1f;
global_2.member[((9u * _e55) + _e57)] = 0f;
global_2.member[((10u * _e55) + _e57)] = 0f;
global_2.member[((11u * _e55) + _e57)] = 0f;
global_2.member[((12u * _e55) + _e57)] = 0f;
global_2.member[((13u * _e55) + _e57)] = 0f;
global_2.member[((14u * _e55) + _e57)] = 0f;
global_2.member[((15u * _e55) + _e57)] = 1e9f;
global_2.member[((16u * _e55) + _e57)] = select(select(0f, 4f, ((_e320 & 2u) != 0u)), select(1f, 3f, _e309), _e315);
global_2.member[((17u * _e55) + _e57)] = 16f;
global_2.member[((18u * _e55) + _e57)] = 0f;
global_2.member[((19u * _e55) + _e57)] = 0f;
global_2.member[((20u * _e55) + _e57)] = _e317;
global_2.member[((21u * _e55) + _e57)] = 0f;
global_2.member[((22u * _e55) + _e57)] = 0f;
global_2.member[((23u * _e55) + _e57)] = f32(_e305);
global_2.member[((24u * _e55) + _e57)] = (_e306 - _e317);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
