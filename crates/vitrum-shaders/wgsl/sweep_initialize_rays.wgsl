struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_8 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_9 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_8,
member_6: type_8,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: type_4,
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
member_24: type_4,
member_25: vec4<u32>,
member_26: type_4,
member_27: type_4,
member_28: type_4,
member_29: type_4,
member_30: type_4,
member_31: type_4,
}
struct type_10 {
member: type_9,
}
struct type_11 {
member: u32,
member_1: u32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_10;
@group(0) @binding(1)
var<storage, read_write> global_2: type_6;
fn function_() {
var phi_131_: type_11;
let _e29 = global;
let _e32 = global_1.member.member_1;
let _e35 = (_e29.x + _e32.x);
let _e38 = (_e29.y + _e32.y);
if (_e35 < _e32.z) {
if (_e38 < _e32.w) {
let _e46 = global_1.member.member[0u];
let _e50 = global_1.member.member[1u];
let _e51 = (_e46 * _e50);
let _e53 = ((_e38 * _e46) + _e35);
let _e57 = global_1.member.member_2[0u];
let _e61 = global_1.member.member_2[1u];
let _e62 = (_e35 % 16u);
let _e63 = (_e38 % 4u);
if ((_e35 < (_e57 - (_e57 % 16u))) && (_e38 < (_e61 - (_e61 % 4u)))) {
phi_131_ = type_11((((_e35 - _e62) + (_e63 * 4u)) + (_e62 % 4u)), ((_e38 - _e63) + (_e62 / 4u)));
} else {
phi_131_ = type_11(_e35, _e38);
}
let _e82 = phi_131_;
let _e96 = global_1.member.member_13.member;
let _e97 = (((((f32(bitcast<i32>(_e82.member)) + 0.5f) / f32(bitcast<i32>(_e57))) * 2f) - 1f) * _e96);
let _e109 = global_1.member.member_13.member_1;
let _e110 = ((1f - (((f32(bitcast<i32>(_e82.member_1)) + 0.5f) / f32(bitcast<i32>(_e61))) * 2f)) * _e109);
let _e114 = global_1.member.member_13.member_3;
let _e115 = (_e114 > 0.5f);
let _e119 = global_1.member.member_13.member_2;
let _e120 = select(_e97, 0f, _e115);
let _e121 = select(_e110, 0f, _e115);
let _e122 = select(0f, _e97, _e115);
let _e123 = select(0f, _e110, _e115);
let _e127 = (_e122 + (_e120 * _e119));
let _e128 = (_e123 + (_e121 * _e119));
let _e129 = (0f + (1f * _e119));
let _e134 = (((_e120 * _e120) + (_e121 * _e121)) + (1f * 1f));
let _e138 = (1f / sqrt(select(0f, _e134, (_e134 > 0f))));
let _e144 = global_1.member.member_14;
let _e154 = ((((_e144.member * _e122) + (_e144.member_1 * _e123)) + (_e144.member_2 * 0f)) + _e144.member_3);
let _e160 = ((((_e144.member * _e127) + (_e144.member_1 * _e128)) + (_e144.member_2 * _e129)) + _e144.member_3);
let _e163 = ((_e154 > 0f) && (_e160 <= 0f));
let _e164 = (_e154 - _e160);
let _e167 = (_e154 / select(1e-20f, _e164, (_e164 > 1e-20f)));
let _e170 = global_1.member.member_16;
let _e180 = ((((_e170.member * _e122) + (_e170.member_1 * _e123)) + (_e170.member_2 * 0f)) + _e170.member_3);
let _e186 = ((((_e170.member * _e127) + (_e170.member_1 * _e128)) + (_e170.member_2 * _e129)) + _e170.member_3);
let _e189 = ((_e180 > 0f) && (_e186 <= 0f));
let _e190 = (_e180 - _e186);
let _e193 = (_e180 / select(1e-20f, _e190, (_e190 > 1e-20f)));
let _e197 = (_e189 && (!(_e163) || (_e193 < _e167)));
let _e198 = (_e163 || _e189);
let _e205 = global_1.member.member_17;
let _e208 = global_1.member.member_15;
let _e220 = global_1.member.member_9;
let _e226 = global_1.member.member_10;
let _e240 = (((_e226.member * _e226.member) + (_e226.member_1 * _e226.member_1)) + (_e226.member_2 * _e226.member_2));
let _e243 = sqrt(select(0f, _e240, (_e240 > 0f)));
let _e246 = (-((((select(_e144.member, _e170.member, _e197) * _e226.member) + (select(_e144.member_1, _e170.member_1, _e197) * _e226.member_1)) + (select(_e144.member_2, _e170.member_2, _e197) * _e226.member_2))) / select(1e-20f, _e243, (_e243 > 1e-20f)));
let _e252 = global_1.member.member[3u];
let _e255 = (1e-6f * _e243);
let _e259 = select((_e243 / select(_e255, _e226.member_2, (_e226.member_2 > _e255))), 1f, ((_e252 & 8u) != 0u));
let _e265 = bitcast<f32>((bitcast<u32>(select(0f, _e246, (_e246 > 0f))) & 2147483647u));
let _e271 = global_1.member.member_23;
let _e281 = select(0f, 1f, _e198);
global_2.member[_e53] = _e127;
global_2.member[(_e51 + _e53)] = _e128;
global_2.member[((2u * _e51) + _e53)] = (_e120 * _e138);
global_2.member[((3u * _e51) + _e53)] = (_e121 * _e138);
global_2.member[((4u * _e51) + _e53)] = (1f * _e138);
global_2.member[((5u * _e51) + _e53)] = 0f;
global_2.member[((6u * _e51) + _e53)] = _e281;
global_2.member[((7u * _e51) + _e53)] = select(0f, (select(_e167, _e193, _e197) * _e119), _e198);
global_2.member[((8u * _e51) + _e53)] = select(0f, (select(_e208.member, _e205.member, _e197) * (((_e220.member * _e259) * _e265) + _e271.member)), _e198);
global_2.member[((9u * _e51) + _e53)] = select(0f, (select(_e208.member_1, _e205.member_1, _e197) * (((_e220.member_1 * _e259) * _e265) + _e271.member_1)), _e198);
global_2.member[((10u * _e51) + _e53)] = select(0f, (select(_e208.member_2, _e205.member_2, _e197) * (((_e220.member_2 * _e259) * _e265) + _e271.member_2)), _e198);
global_2.member[((11u * _e51) + _e53)] = _e281;
global_2.member[((12u * _e51) + _e53)] = 1f;
global_2.member[((13u * _e51) + _e53)] = 1f;
global_2.member[((14u * _e51) + _e53)] = 1f;
global_2.member[((15u * _e51) + _e53)] = 1f;
global_2.member[((16u * _e51) + _e53)] = _e129;
global_2.member[((17u * _e51) + _e53)] = -1.2676506e30f;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
