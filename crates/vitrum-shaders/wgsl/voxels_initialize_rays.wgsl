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
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_6;
@group(0) @binding(1)
var<storage, read_write> global_2: type_8;
fn function_() {
var phi_195_: vec3<f32>;
var phi_203_: vec3<f32>;
let _e46 = global;
let _e50 = global_1.member.member[0u];
let _e54 = global_1.member.member[1u];
if (_e46.x < _e50) {
if (_e46.y < _e54) {
let _e59 = (_e50 * _e54);
let _e61 = ((_e46.y * _e50) + _e46.x);
let _e75 = global_1.member.member_3.member;
let _e76 = (((((f32(bitcast<i32>(_e46.x)) + 0.5f) / f32(bitcast<i32>(_e50))) * 2f) - 1f) * _e75);
let _e86 = global_1.member.member_3.member_1;
let _e87 = ((1f - (((f32(bitcast<i32>(_e46.y)) + 0.5f) / f32(bitcast<i32>(_e54))) * 2f)) * _e86);
let _e93 = global_1.member.member_4.member_3;
let _e99 = global_1.member.member_5.member_3;
let _e105 = global_1.member.member_6.member_3;
let _e107 = global_1.member.member_4;
let _e114 = global_1.member.member_5;
let _e121 = ((_e107.member * _e76) + (_e114.member * _e87));
let _e122 = ((_e107.member_1 * _e76) + (_e114.member_1 * _e87));
let _e123 = ((_e107.member_2 * _e76) + (_e114.member_2 * _e87));
let _e127 = global_1.member.member_3.member_3;
let _e128 = (_e127 > 0.5f);
if _e128 {
let _e129 = global_1.member.member_6;
phi_195_ = vec3<f32>(_e129.member, _e129.member_1, _e129.member_2);
} else {
let _e134 = global_1.member.member_6;
phi_195_ = vec3<f32>((_e134.member + _e121), (_e134.member_1 + _e122), (_e134.member_2 + _e123));
}
let _e143 = phi_195_;
if _e128 {
phi_203_ = vec3<f32>((_e93 + _e121), (_e99 + _e122), (_e105 + _e123));
} else {
phi_203_ = vec3<f32>(_e93, _e99, _e105);
}
let _e149 = phi_203_;
let _e157 = (((_e143.x * _e143.x) + (_e143.y * _e143.y)) + (_e143.z * _e143.z));
let _e160 = sqrt(select(0f, _e157, (_e157 > 0f)));
let _e163 = (1f / select(1e-20f, _e160, (_e160 > 1e-20f)));
let _e164 = (_e143.x * _e163);
let _e165 = (_e143.y * _e163);
let _e166 = (_e143.z * _e163);
let _e174 = (1f / select(_e164, select(1e-12f, -1e-12f, (_e164 < 0f)), (bitcast<f32>((bitcast<u32>(_e164) & 2147483647u)) < 1e-12f)));
let _e182 = (1f / select(_e165, select(1e-12f, -1e-12f, (_e165 < 0f)), (bitcast<f32>((bitcast<u32>(_e165) & 2147483647u)) < 1e-12f)));
let _e190 = (1f / select(_e166, select(1e-12f, -1e-12f, (_e166 < 0f)), (bitcast<f32>((bitcast<u32>(_e166) & 2147483647u)) < 1e-12f)));
let _e193 = global_1.member.member_8;
let _e199 = global_1.member.member_9;
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
let _e240 = global_1.member.member_17;
let _e250 = ((((_e240.member * _e149.x) + (_e240.member_1 * _e149.y)) + (_e240.member_2 * _e149.z)) + _e240.member_3);
let _e256 = -((((_e240.member * _e164) + (_e240.member_1 * _e165)) + (_e240.member_2 * _e166)));
let _e258 = (_e256 > 1e-9f);
let _e262 = ((_e250 / select(1e-9f, _e256, _e258)) - 0.015625f);
let _e265 = select(1e30f, select(0f, _e262, (_e262 > 0f)), ((_e250 > 0f) && _e258));
let _e268 = global_1.member.member_19;
let _e278 = ((((_e268.member * _e149.x) + (_e268.member_1 * _e149.y)) + (_e268.member_2 * _e149.z)) + _e268.member_3);
let _e284 = -((((_e268.member * _e164) + (_e268.member_1 * _e165)) + (_e268.member_2 * _e166)));
let _e286 = (_e284 > 1e-9f);
let _e290 = ((_e278 / select(1e-9f, _e284, _e286)) - 0.015625f);
let _e293 = select(1e30f, select(0f, _e290, (_e290 > 0f)), ((_e278 > 0f) && _e286));
let _e297 = (_e293 < _e265);
let _e299 = select(select(-2i, -3i, _e297), -1i, ((_e265 >= 1e30f) && (_e293 >= 1e30f)));
let _e300 = select(_e265, _e293, _e297);
let _e302 = select(0f, _e227, (_e227 > 0f));
let _e303 = (_e299 != -1i);
let _e309 = (((_e237 <= _e227) || (_e237 <= 0f)) || (_e303 && (_e300 <= _e302)));
let _e311 = select(_e302, select(0f, _e300, _e303), _e309);
let _e315 = global_1.member.member[3u];
global_2.member[_e61] = (_e149.x + (_e164 * _e311));
global_2.member[(_e59 + _e61)] = (_e149.y + (_e165 * _e311));
global_2.member[((2u * _e59) + _e61)] = (_e149.z + (_e166 * _e311));
global_2.member[((3u * _e59) + _e61)] = _e164;
global_2.member[((4u * _e59) + _e61)] = _e165;
global_2.member[((5u * _e59) + _e61)] = _e166;
global_2.member[((6u * _e59) + _e61)] = 1f;
global_2.member[((7u * _e59) + _e61)] = 1f;
global_2.member[((8u * _e59) + _e61)] = 1f;
global_2.member[((9u * _e59) + _e61)] = 0f;
global_2.member[((10u * _e59) + _e61)] = 0f;
global_2.member[((11u * _e59) + _e61)] = 0f;
global_2.member[((12u * _e59) + _e61)] = 0f;
global_2.member[((13u * _e59) + _e61)] = 0f;
global_2.member[((14u * _e59) + _e61)] = 0f;
global_2.member[((15u * _e59) + _e61)] = 1e9f;
global_2.member[((16u * _e59) + _e61)] = select(select(0f, 4f, ((_e315 & 2u) != 0u)), select(1f, 3f, _e303), _e309);
global_2.member[((17u * _e59) + _e61)] = 16f;
global_2.member[((18u * _e59) + _e61)] = 0f;
global_2.member[((19u * _e59) + _e61)] = 0f;
global_2.member[((20u * _e59) + _e61)] = _e311;
global_2.member[((21u * _e59) + _e61)] = 0f;
global_2.member[((22u * _e59) + _e61)] = 0f;
global_2.member[((23u * _e59) + _e61)] = f32(_e299);
global_2.member[((24u * _e59) + _e61)] = (_e300 - _e311);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
