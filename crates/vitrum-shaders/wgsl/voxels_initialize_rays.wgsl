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
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_19;
@group(0) @binding(1)
var<storage, read_write> global_2: type_21;
fn function_() {
var phi_216_: vec3<f32>;
var phi_224_: vec3<f32>;
let _e52 = global;
let _e55 = global_1.member.member;
if (_e52.x < _e55.member) {
if (_e52.y < _e55.member_1) {
let _e62 = (_e55.member * _e55.member_1);
let _e64 = ((_e52.y * _e55.member) + _e52.x);
let _e68 = global_1.member.member.member;
let _e74 = global_1.member.member.member_1;
let _e86 = global_1.member.member_6.member;
let _e87 = (((((f32(bitcast<i32>(_e52.x)) + 0.5f) / f32(bitcast<i32>(_e68))) * 2f) - 1f) * _e86);
let _e97 = global_1.member.member_6.member_1;
let _e98 = ((1f - (((f32(bitcast<i32>(_e52.y)) + 0.5f) / f32(bitcast<i32>(_e74))) * 2f)) * _e97);
let _e101 = global_1.member.member_10;
let _e108 = global_1.member.member_7;
let _e117 = global_1.member.member_8;
let _e124 = ((_e108.member * _e87) + (_e117.member * _e98));
let _e125 = ((_e108.member_1 * _e87) + (_e117.member_1 * _e98));
let _e126 = ((_e108.member_2 * _e87) + (_e117.member_2 * _e98));
let _e130 = global_1.member.member_6.member_3;
let _e131 = (_e130 != 0u);
if _e131 {
let _e134 = global_1.member.member_9;
phi_216_ = vec3<f32>(_e134.member, _e134.member_1, _e134.member_2);
} else {
let _e141 = global_1.member.member_9;
phi_216_ = vec3<f32>((_e141.member + _e124), (_e141.member_1 + _e125), (_e141.member_2 + _e126));
}
let _e150 = phi_216_;
if _e131 {
phi_224_ = vec3<f32>((_e101.member + _e124), (_e101.member_1 + _e125), (_e101.member_2 + _e126));
} else {
phi_224_ = vec3<f32>(_e101.member, _e101.member_1, _e101.member_2);
}
let _e156 = phi_224_;
let _e164 = (((_e150.x * _e150.x) + (_e150.y * _e150.y)) + (_e150.z * _e150.z));
let _e167 = sqrt(select(0f, _e164, (_e164 > 0f)));
let _e170 = (1f / select(1e-20f, _e167, (_e167 > 1e-20f)));
let _e171 = (_e150.x * _e170);
let _e172 = (_e150.y * _e170);
let _e173 = (_e150.z * _e170);
let _e181 = (1f / select(_e171, select(1e-12f, -1e-12f, (_e171 < 0f)), (bitcast<f32>((bitcast<u32>(_e171) & 2147483647u)) < 1e-12f)));
let _e189 = (1f / select(_e172, select(1e-12f, -1e-12f, (_e172 < 0f)), (bitcast<f32>((bitcast<u32>(_e172) & 2147483647u)) < 1e-12f)));
let _e197 = (1f / select(_e173, select(1e-12f, -1e-12f, (_e173 < 0f)), (bitcast<f32>((bitcast<u32>(_e173) & 2147483647u)) < 1e-12f)));
let _e200 = global_1.member.member_14;
let _e206 = global_1.member.member_15;
let _e212 = ((_e200.member - _e156.x) * _e181);
let _e214 = ((_e206.member - _e156.x) * _e181);
let _e217 = ((_e200.member_1 - _e156.y) * _e189);
let _e219 = ((_e206.member_1 - _e156.y) * _e189);
let _e222 = ((_e200.member_2 - _e156.z) * _e197);
let _e224 = ((_e206.member_2 - _e156.z) * _e197);
let _e226 = select(_e214, _e212, (_e212 < _e214));
let _e228 = select(_e219, _e217, (_e217 < _e219));
let _e230 = select(_e228, _e226, (_e226 > _e228));
let _e232 = select(_e224, _e222, (_e222 < _e224));
let _e234 = select(_e232, _e230, (_e230 > _e232));
let _e236 = select(_e214, _e212, (_e212 > _e214));
let _e238 = select(_e219, _e217, (_e217 > _e219));
let _e240 = select(_e238, _e236, (_e236 < _e238));
let _e242 = select(_e224, _e222, (_e222 > _e224));
let _e244 = select(_e242, _e240, (_e240 < _e242));
let _e249 = global_1.member.member_18.member.member;
let _e260 = ((((_e249.member.member * _e156.x) + (_e249.member.member_1 * _e156.y)) + (_e249.member.member_2 * _e156.z)) + _e249.member_1);
let _e266 = -((((_e249.member.member * _e171) + (_e249.member.member_1 * _e172)) + (_e249.member.member_2 * _e173)));
let _e268 = (_e266 > 1e-9f);
let _e272 = ((_e260 / select(1e-9f, _e266, _e268)) - 0.015625f);
let _e275 = select(1e30f, select(0f, _e272, (_e272 > 0f)), ((_e260 > 0f) && _e268));
let _e280 = global_1.member.member_18.member_1.member;
let _e291 = ((((_e280.member.member * _e156.x) + (_e280.member.member_1 * _e156.y)) + (_e280.member.member_2 * _e156.z)) + _e280.member_1);
let _e297 = -((((_e280.member.member * _e171) + (_e280.member.member_1 * _e172)) + (_e280.member.member_2 * _e173)));
let _e299 = (_e297 > 1e-9f);
let _e303 = ((_e291 / select(1e-9f, _e297, _e299)) - 0.015625f);
let _e306 = select(1e30f, select(0f, _e303, (_e303 > 0f)), ((_e291 > 0f) && _e299));
let _e310 = (_e306 < _e275);
let _e312 = select(select(-2i, -3i, _e310), -1i, ((_e275 >= 1e30f) && (_e306 >= 1e30f)));
let _e313 = select(_e275, _e306, _e310);
let _e315 = select(0f, _e234, (_e234 > 0f));
let _e316 = (_e312 != -1i);
let _e322 = (((_e244 <= _e234) || (_e244 <= 0f)) || (_e316 && (_e313 <= _e315)));
let _e324 = select(_e315, select(0f, _e313, _e316), _e322);
let _e327 = global_1.member.member_1;
global_2.member[_e64] = (_e156.x + (_e171 * _e324));
global_2.member[(_e62 + _e64)] = (_e156.y + (_e172 * _e324));
global_2.member[((2u * _e62) + _e64)] = (_e156.z + (_e173 * _e324));
global_2.member[((3u * _e62) + _e64)] = _e171;
global_2.member[((4u * _e62) + _e64)] = _e172;
global_2.member[((5u * _e62) + _e64)] = _e173;
global_2.member[((6u * _e62) + _e64)] = 1f;
global_2.member[((7u * _e62) + _e64)] = 1f;
global_2.member[((8u * _e62) + _e64)] = 1f;
global_2.member[((9u * _e62) + _e64)] = 0f;
global_2.member[((10u * _e62) + _e64)] = 0f;
global_2.member[((11u * _e62) + _e64)] = 0f;
global_2.member[((12u * _e62) + _e64)] = 0f;
global_2.member[((13u * _e62) + _e64)] = 0f;
global_2.member[((14u * _e62) + _e64)] = 0f;
global_2.member[((15u * _e62) + _e64)] = 1e9f;
global_2.member[((16u * _e62) + _e64)] = select(select(0f, 4f, ((_e327 & 2u) != 0u)), select(1f, 3f, _e316), _e322);
global_2.member[((17u * _e62) + _e64)] = 16f;
global_2.member[((18u * _e62) + _e64)] = 0f;
global_2.member[((19u * _e62) + _e64)] = 0f;
global_2.member[((20u * _e62) + _e64)] = _e324;
global_2.member[((21u * _e62) + _e64)] = 0f;
global_2.member[((22u * _e62) + _e64)] = 0f;
global_2.member[((23u * _e62) + _e64)] = 0f;
global_2.member[((24u * _e62) + _e64)] = 0f;
global_2.member[((25u * _e62) + _e64)] = 0f;
global_2.member[((26u * _e62) + _e64)] = 0f;
global_2.member[((27u * _e62) + _e64)] = 0f;
global_2.member[((28u * _e62) + _e64)] = 0f;
global_2.member[((29u * _e62) + _e64)] = 0f;
global_2.member[((30u * _e62) + _e64)] = f32(_e312);
global_2.member[((31u * _e62) + _e64)] = (_e313 - _e324);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
