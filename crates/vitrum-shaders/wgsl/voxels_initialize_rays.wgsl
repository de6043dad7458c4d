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
var phi_223_: vec3<f32>;
var phi_231_: vec3<f32>;
let _e64 = global;
let _e67 = global_1.member.member;
if (_e64.x < _e67.member) {
if (_e64.y < _e67.member_1) {
let _e74 = (_e67.member * _e67.member_1);
let _e76 = ((_e64.y * _e67.member) + _e64.x);
let _e80 = global_1.member.member.member;
let _e86 = global_1.member.member.member_1;
let _e98 = global_1.member.member_6.member;
let _e99 = (((((f32(bitcast<i32>(_e64.x)) + 0.5f) / f32(bitcast<i32>(_e80))) * 2f) - 1f) * _e98);
let _e109 = global_1.member.member_6.member_1;
let _e110 = ((1f - (((f32(bitcast<i32>(_e64.y)) + 0.5f) / f32(bitcast<i32>(_e86))) * 2f)) * _e109);
let _e113 = global_1.member.member_10;
let _e120 = global_1.member.member_7;
let _e129 = global_1.member.member_8;
let _e136 = ((_e120.member * _e99) + (_e129.member * _e110));
let _e137 = ((_e120.member_1 * _e99) + (_e129.member_1 * _e110));
let _e138 = ((_e120.member_2 * _e99) + (_e129.member_2 * _e110));
let _e142 = global_1.member.member_6.member_3;
let _e143 = (_e142 != 0u);
if _e143 {
let _e146 = global_1.member.member_9;
phi_223_ = vec3<f32>(_e146.member, _e146.member_1, _e146.member_2);
} else {
let _e153 = global_1.member.member_9;
phi_223_ = vec3<f32>((_e153.member + _e136), (_e153.member_1 + _e137), (_e153.member_2 + _e138));
}
let _e162 = phi_223_;
if _e143 {
phi_231_ = vec3<f32>((_e113.member + _e136), (_e113.member_1 + _e137), (_e113.member_2 + _e138));
} else {
phi_231_ = vec3<f32>(_e113.member, _e113.member_1, _e113.member_2);
}
let _e168 = phi_231_;
let _e176 = (((_e162.x * _e162.x) + (_e162.y * _e162.y)) + (_e162.z * _e162.z));
let _e179 = sqrt(select(0f, _e176, (_e176 > 0f)));
let _e182 = (1f / select(1e-20f, _e179, (_e179 > 1e-20f)));
let _e183 = (_e162.x * _e182);
let _e184 = (_e162.y * _e182);
let _e185 = (_e162.z * _e182);
let _e193 = (1f / select(_e183, select(1e-12f, -1e-12f, (_e183 < 0f)), (bitcast<f32>((bitcast<u32>(_e183) & 2147483647u)) < 1e-12f)));
let _e201 = (1f / select(_e184, select(1e-12f, -1e-12f, (_e184 < 0f)), (bitcast<f32>((bitcast<u32>(_e184) & 2147483647u)) < 1e-12f)));
let _e209 = (1f / select(_e185, select(1e-12f, -1e-12f, (_e185 < 0f)), (bitcast<f32>((bitcast<u32>(_e185) & 2147483647u)) < 1e-12f)));
let _e212 = global_1.member.member_14;
let _e218 = global_1.member.member_15;
let _e224 = ((_e212.member - _e168.x) * _e193);
let _e226 = ((_e218.member - _e168.x) * _e193);
let _e229 = ((_e212.member_1 - _e168.y) * _e201);
let _e231 = ((_e218.member_1 - _e168.y) * _e201);
let _e234 = ((_e212.member_2 - _e168.z) * _e209);
let _e236 = ((_e218.member_2 - _e168.z) * _e209);
let _e238 = select(_e226, _e224, (_e224 < _e226));
let _e240 = select(_e231, _e229, (_e229 < _e231));
let _e242 = select(_e240, _e238, (_e238 > _e240));
let _e244 = select(_e236, _e234, (_e234 < _e236));
let _e246 = select(_e244, _e242, (_e242 > _e244));
let _e248 = select(_e226, _e224, (_e224 > _e226));
let _e250 = select(_e231, _e229, (_e229 > _e231));
let _e252 = select(_e250, _e248, (_e248 < _e250));
let _e254 = select(_e236, _e234, (_e234 > _e236));
let _e256 = select(_e254, _e252, (_e252 < _e254));
let _e261 = global_1.member.member_18.member.member;
let _e272 = ((((_e261.member.member * _e168.x) + (_e261.member.member_1 * _e168.y)) + (_e261.member.member_2 * _e168.z)) + _e261.member_1);
let _e278 = -((((_e261.member.member * _e183) + (_e261.member.member_1 * _e184)) + (_e261.member.member_2 * _e185)));
let _e280 = (_e278 > 1e-9f);
let _e284 = ((_e272 / select(1e-9f, _e278, _e280)) - 0.015625f);
let _e287 = select(1e30f, select(0f, _e284, (_e284 > 0f)), ((_e272 > 0f) && _e280));
let _e292 = global_1.member.member_18.member_1.member;
let _e303 = ((((_e292.member.member * _e168.x) + (_e292.member.member_1 * _e168.y)) + (_e292.member.member_2 * _e168.z)) + _e292.member_1);
let _e309 = -((((_e292.member.member * _e183) + (_e292.member.member_1 * _e184)) + (_e292.member.member_2 * _e185)));
let _e311 = (_e309 > 1e-9f);
let _e315 = ((_e303 / select(1e-9f, _e309, _e311)) - 0.015625f);
let _e318 = select(1e30f, select(0f, _e315, (_e315 > 0f)), ((_e303 > 0f) && _e311));
let _e322 = (_e318 < _e287);
let _e324 = select(select(-2i, -3i, _e322), -1i, ((_e287 >= 1e30f) && (_e318 >= 1e30f)));
let _e325 = select(_e287, _e318, _e322);
let _e327 = select(0f, _e246, (_e246 > 0f));
let _e328 = (_e324 != -1i);
let _e334 = (((_e256 <= _e246) || (_e256 <= 0f)) || (_e328 && (_e325 <= _e327)));
let _e336 = select(_e327, select(0f, _e325, _e328), _e334);
let _e339 = global_1.member.member_1;
global_2.member[_e76] = (_e168.x + (_e183 * _e336));
global_2.member[(_e74 + _e76)] = (_e168.y + (_e184 * _e336));
global_2.member[((2u * _e74) + _e76)] = (_e168.z + (_e185 * _e336));
global_2.member[((3u * _e74) + _e76)] = _e183;
global_2.member[((4u * _e74) + _e76)] = _e184;
global_2.member[((5u * _e74) + _e76)] = _e185;
global_2.member[((6u * _e74) + _e76)] = 1f;
global_2.member[((7u * _e74) + _e76)] = 1f;
global_2.member[((8u * _e74) + _e76)] = 1f;
global_2.member[((9u * _e74) + _e76)] = 0f;
global_2.member[((10u * _e74) + _e76)] = 0f;
global_2.member[((11u * _e74) + _e76)] = 0f;
global_2.member[((12u * _e74) + _e76)] = 0f;
global_2.member[((13u * _e74) + _e76)] = 0f;
global_2.member[((14u * _e74) + _e76)] = 0f;
global_2.member[((15u * _e74) + _e76)] = 1e9f;
global_2.member[((16u * _e74) + _e76)] = select(select(0f, 4f, ((_e339 & 2u) != 0u)), select(1f, 3f, _e328), _e334);
global_2.member[((17u * _e74) + _e76)] = 16f;
global_2.member[((18u * _e74) + _e76)] = 0f;
global_2.member[((19u * _e74) + _e76)] = 0f;
global_2.member[((20u * _e74) + _e76)] = _e336;
global_2.member[((21u * _e74) + _e76)] = 0f;
global_2.member[((22u * _e74) + _e76)] = 0f;
global_2.member[((23u * _e74) + _e76)] = 0f;
global_2.member[((24u * _e74) + _e76)] = 0f;
global_2.member[((25u * _e74) + _e76)] = 0f;
global_2.member[((26u * _e74) + _e76)] = 0f;
global_2.member[((27u * _e74) + _e76)] = 0f;
global_2.member[((28u * _e74) + _e76)] = 0f;
global_2.member[((29u * _e74) + _e76)] = 0f;
global_2.member[((30u * _e74) + _e76)] = 0f;
global_2.member[((31u * _e74) + _e76)] = 0f;
global_2.member[((32u * _e74) + _e76)] = 0f;
global_2.member[((33u * _e74) + _e76)] = 0f;
global_2.member[((34u * _e74) + _e76)] = 0f;
global_2.member[((35u * _e74) + _e76)] = 0f;
global_2.member[((36u * _e74) + _e76)] = 0f;
global_2.member[((37u * _e74) + _e76)] = 0f;
global_2.member[((38u * _e74) + _e76)] = 0f;
global_2.member[((39u * _e74) + _e76)] = 0f;
global_2.member[((40u * _e74) + _e76)] = 16f;
global_2.member[((41u * _e74) + _e76)] = 0f;
global_2.member[((42u * _e74) + _e76)] = f32(_e324);
global_2.member[((43u * _e74) + _e76)] = (_e325 - _e336);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
