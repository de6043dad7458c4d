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
struct type_11 {
member: array<f32>,
}
struct type_13 {
member: u32,
member_1: u32,
}
struct type_14 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_15 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_16 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_18 {
member: type_5,
member_1: type_5,
}
struct type_19 {
member: type_7,
member_1: u32,
}
struct type_20 {
member: type_2,
member_1: u32,
member_2: type_14,
member_3: type_13,
member_4: u32,
member_5: type_15,
member_6: type_16,
member_7: type_16,
member_8: type_17,
member_9: type_18,
member_10: f32,
member_11: type_15,
member_12: type_4,
member_13: type_9,
member_14: type_19,
member_15: type_19,
member_16: type_19,
member_17: type_19,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_21 {
member: type_20,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_21;
@group(0) @binding(1)
var<storage, read_write> global_2: type_11;
fn function_() {
var phi_146_: type_13;
let _e28 = global;
let _e31 = global_1.member.member_2;
let _e34 = global_1.member.member;
let _e42 = (_e28.x + _e31.member);
let _e44 = (_e28.y + _e31.member_1);
if (_e42 < _e31.member_2) {
if (_e44 < _e31.member_3) {
let _e47 = (_e34.member * _e34.member_1);
let _e49 = ((_e44 * _e34.member) + _e42);
let _e53 = global_1.member.member_3.member;
let _e57 = global_1.member.member_3.member_1;
let _e58 = (_e42 % 16u);
let _e59 = (_e44 % 4u);
if ((_e42 < (_e53 - (_e53 % 16u))) && (_e44 < (_e57 - (_e57 % 4u)))) {
phi_146_ = type_13((((_e42 - _e58) + (_e59 * 4u)) + (_e58 % 4u)), ((_e44 - _e59) + (_e58 / 4u)));
} else {
phi_146_ = type_13(_e42, _e44);
}
let _e78 = phi_146_;
let _e92 = global_1.member.member_12.member;
let _e93 = (((((f32(bitcast<i32>(_e78.member)) + 0.5f) / f32(bitcast<i32>(_e53))) * 2f) - 1f) * _e92);
let _e105 = global_1.member.member_12.member_1;
let _e106 = ((1f - (((f32(bitcast<i32>(_e78.member_1)) + 0.5f) / f32(bitcast<i32>(_e57))) * 2f)) * _e105);
let _e110 = global_1.member.member_12.member_3;
let _e111 = (_e110 != 0u);
let _e115 = global_1.member.member_12.member_2;
let _e116 = select(_e93, 0f, _e111);
let _e117 = select(_e106, 0f, _e111);
let _e118 = select(0f, _e93, _e111);
let _e119 = select(0f, _e106, _e111);
let _e123 = (_e118 + (_e116 * _e115));
let _e124 = (_e119 + (_e117 * _e115));
let _e125 = (0f + (1f * _e115));
let _e130 = (((_e116 * _e116) + (_e117 * _e117)) + (1f * 1f));
let _e133 = sqrt(select(0f, _e130, (_e130 > 0f)));
let _e136 = (1f / select(1e-20f, _e133, (_e133 > 1e-20f)));
let _e144 = global_1.member.member_13.member.member;
let _e155 = ((((_e144.member.member * _e118) + (_e144.member.member_1 * _e119)) + (_e144.member.member_2 * 0f)) + _e144.member_1);
let _e161 = ((((_e144.member.member * _e123) + (_e144.member.member_1 * _e124)) + (_e144.member.member_2 * _e125)) + _e144.member_1);
let _e164 = ((_e155 > 0f) && (_e161 <= 0f));
let _e165 = (_e155 - _e161);
let _e168 = (_e155 / select(1e-20f, _e165, (_e165 > 1e-20f)));
let _e173 = global_1.member.member_13.member_1.member;
let _e184 = ((((_e173.member.member * _e118) + (_e173.member.member_1 * _e119)) + (_e173.member.member_2 * 0f)) + _e173.member_1);
let _e190 = ((((_e173.member.member * _e123) + (_e173.member.member_1 * _e124)) + (_e173.member.member_2 * _e125)) + _e173.member_1);
let _e193 = ((_e184 > 0f) && (_e190 <= 0f));
let _e194 = (_e184 - _e190);
let _e197 = (_e184 / select(1e-20f, _e194, (_e194 > 1e-20f)));
let _e201 = (_e193 && (!(_e164) || (_e197 < _e168)));
let _e207 = global_1.member.member_13.member_1.member.member;
let _e212 = global_1.member.member_13.member_1.member_1;
let _e218 = global_1.member.member_13.member.member.member;
let _e223 = global_1.member.member_13.member.member_1;
let _e242 = (_e164 || _e193);
let _e247 = global_1.member.member_9.member_1;
let _e254 = global_1.member.member_9.member;
let _e262 = (((_e254.member * _e254.member) + (_e254.member_1 * _e254.member_1)) + (_e254.member_2 * _e254.member_2));
let _e265 = sqrt(select(0f, _e262, (_e262 > 0f)));
let _e268 = global_1.member.member_1;
let _e271 = (1e-6f * _e265);
let _e275 = select((_e265 / select(_e271, _e254.member_2, (_e254.member_2 > _e271))), 1f, ((_e268 & 8u) != 0u));
let _e281 = global_1.member.member_18;
let _e293 = (-((((select(_e218.member, _e207.member, _e201) * _e254.member) + (select(_e218.member_1, _e207.member_1, _e201) * _e254.member_1)) + (select(_e218.member_2, _e207.member_2, _e201) * _e254.member_2))) / select(1e-20f, _e265, (_e265 > 1e-20f)));
let _e298 = bitcast<f32>((bitcast<u32>(select(0f, _e293, (_e293 > 0f))) & 2147483647u));
let _e308 = select(0f, 1f, _e242);
global_2.member[_e49] = _e123;
global_2.member[(_e47 + _e49)] = _e124;
global_2.member[((2u * _e47) + _e49)] = _e125;
global_2.member[((3u * _e47) + _e49)] = (_e116 * _e136);
global_2.member[((4u * _e47) + _e49)] = (_e117 * _e136);
global_2.member[((5u * _e47) + _e49)] = (1f * _e136);
global_2.member[((6u * _e47) + _e49)] = 0f;
global_2.member[((7u * _e47) + _e49)] = _e308;
global_2.member[((8u * _e47) + _e49)] = select(0f, (select(_e168, _e197, _e201) * _e115), _e242);
global_2.member[((9u * _e47) + _e49)] = select(0f, (select(_e223.member, _e212.member, _e201) * (((_e247.member * _e275) * _e298) + _e281.member)), _e242);
global_2.member[((10u * _e47) + _e49)] = select(0f, (select(_e223.member_1, _e212.member_1, _e201) * (((_e247.member_1 * _e275) * _e298) + _e281.member_1)), _e242);
global_2.member[((11u * _e47) + _e49)] = select(0f, (select(_e223.member_2, _e212.member_2, _e201) * (((_e247.member_2 * _e275) * _e298) + _e281.member_2)), _e242);
global_2.member[((12u * _e47) + _e49)] = _e308;
global_2.member[((13u * _e47) + _e49)] = 1f;
global_2.member[((14u * _e47) + _e49)] = 1f;
global_2.member[((15u * _e47) + _e49)] = 1f;
global_2.member[((16u * _e47) + _e49)] = 0f;
global_2.member[((17u * _e47) + _e49)] = -1.2676506e30f;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
