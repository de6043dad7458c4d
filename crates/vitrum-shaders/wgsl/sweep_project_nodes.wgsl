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
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
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
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_18 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_18,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_19,
member_8: type_20,
member_9: type_20,
member_10: type_21,
member_11: type_22,
member_12: type_14,
member_13: type_19,
member_14: type_4,
member_15: type_9,
member_16: type_23,
member_17: type_23,
member_18: type_23,
member_19: type_23,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_25 {
member: type_24,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_16;
@group(0) @binding(0)
var<storage> global_2: type_25;
@group(0) @binding(2)
var<storage, read_write> global_3: type_16;
fn function_() {
var local: i32;
var local_1: i32;
var phi_390_: f32;
var phi_478_: f32;
let _e33 = global;
let _e39 = global_2.member.member_2;
let _e42 = global_2.member.member;
let _e50 = (_e33.x + _e39.member);
let _e52 = (_e33.y + _e39.member_1);
if (_e50 < _e39.member_2) {
if (_e52 < _e39.member_3) {
let _e55 = (_e42.member * _e42.member_1);
let _e57 = ((_e52 * _e42.member) + _e50);
let _e62 = global_2.member.member_12.member_4.member;
let _e63 = (_e62 + 1u);
let _e68 = global_2.member.member_12.member_4.member_1;
local = bitcast<i32>((_e63 * (_e68 + 1u)));
local_1 = bitcast<i32>(((_e52 * _e63) + _e50));
let _e75 = local_1;
let _e77 = (bitcast<i32>(arrayLength((&global_1.member))) - 1i);
let _e79 = select(_e77, _e75, (_e75 < _e77));
let _e84 = global_1.member[bitcast<u32>(select(0i, _e79, (_e79 > 0i)))];
let _e85 = local;
let _e86 = local_1;
let _e87 = (_e85 + _e86);
let _e89 = select(_e77, _e87, (_e87 < _e77));
let _e94 = global_1.member[bitcast<u32>(select(0i, _e89, (_e89 > 0i)))];
let _e95 = local;
let _e97 = local_1;
let _e98 = ((2i * _e95) + _e97);
let _e100 = select(_e77, _e98, (_e98 < _e77));
let _e105 = global_1.member[bitcast<u32>(select(0i, _e100, (_e100 > 0i)))];
let _e106 = local;
let _e108 = local_1;
let _e109 = ((3i * _e106) + _e108);
let _e111 = select(_e77, _e109, (_e109 < _e77));
let _e116 = global_1.member[bitcast<u32>(select(0i, _e111, (_e111 > 0i)))];
let _e117 = local;
let _e119 = local_1;
let _e120 = ((4i * _e117) + _e119);
let _e122 = select(_e77, _e120, (_e120 < _e77));
let _e127 = global_1.member[bitcast<u32>(select(0i, _e122, (_e122 > 0i)))];
let _e128 = local;
let _e130 = local_1;
let _e131 = ((5i * _e128) + _e130);
let _e133 = select(_e77, _e131, (_e131 < _e77));
let _e138 = global_1.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e139 = local;
let _e141 = local_1;
let _e142 = ((6i * _e139) + _e141);
let _e144 = select(_e77, _e142, (_e142 < _e77));
let _e149 = global_1.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e150 = local;
let _e152 = local_1;
let _e153 = ((7i * _e150) + _e152);
let _e155 = select(_e77, _e153, (_e153 < _e77));
let _e160 = global_1.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e161 = local;
let _e163 = local_1;
let _e164 = ((8i * _e161) + _e163);
let _e166 = select(_e77, _e164, (_e164 < _e77));
let _e171 = global_1.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e173 = f32(bitcast<i32>(_e50));
let _e175 = f32(bitcast<i32>(_e52));
let _e179 = global_2.member.member_12.member_3;
let _e180 = (_e179 == 0u);
if _e180 {
phi_390_ = 1f;
} else {
let _e184 = global_2.member.member_12.member_5;
let _e188 = global_2.member.member_12.member_7;
let _e190 = (_e184 + (_e173 * _e188));
let _e194 = global_2.member.member_12.member_6;
let _e196 = (_e194 + (_e175 * _e188));
let _e201 = (((_e190 * _e190) + (_e196 * _e196)) + (1f * 1f));
let _e205 = (1f / sqrt(select(0f, _e201, (_e201 > 0f))));
phi_390_ = ((_e205 * _e205) * _e205);
}
let _e209 = phi_390_;
if _e180 {
phi_478_ = 1f;
} else {
let _e213 = global_2.member.member_12.member_5;
let _e217 = global_2.member.member_12.member_7;
let _e219 = (_e213 + (_e173 * _e217));
let _e223 = global_2.member.member_12.member_6;
let _e225 = (_e223 + (_e175 * _e217));
let _e230 = global_2.member.member_12.member_20.member;
let _e238 = (((_e230.member * _e219) + (_e230.member_1 * _e225)) + (_e230.member_2 * 1f));
let _e242 = (_e219 - (_e230.member * _e238));
let _e243 = (_e225 - (_e230.member_1 * _e238));
let _e244 = (1f - (_e230.member_2 * _e238));
let _e249 = (((_e242 * _e242) + (_e243 * _e243)) + (_e244 * _e244));
let _e260 = global_2.member.member_12.member_20.member_1;
let _e266 = global_2.member.member_12.member_20.member_2;
let _e267 = ((_e260 - (sqrt(select(0f, _e249, (_e249 > 0f))) / select(1e-20f, _e238, (_e238 > 1e-20f)))) * _e266);
let _e269 = select(0f, _e267, (_e267 > 0f));
let _e271 = select(1f, _e269, (_e269 < 1f));
phi_478_ = select(1f, select(0f, ((_e271 * _e271) * (3f - (2f * _e271))), (_e238 > 0f)), (_e266 > 0f));
}
let _e281 = phi_478_;
let _e282 = (_e209 * _e281);
let _e286 = local;
let _e288 = local_1;
let _e289 = ((10i * _e286) + _e288);
let _e291 = select(_e77, _e289, (_e289 < _e77));
let _e296 = global_1.member[bitcast<u32>(select(0i, _e291, (_e291 > 0i)))];
let _e297 = local;
let _e299 = local_1;
let _e300 = ((11i * _e297) + _e299);
let _e302 = select(_e77, _e300, (_e300 < _e77));
let _e307 = global_1.member[bitcast<u32>(select(0i, _e302, (_e302 > 0i)))];
let _e311 = global_2.member.member_7.member_1;
let _e313 = ((_e311 - _e105) / _e138);
let _e315 = (_e84 + (_e116 * _e313));
let _e317 = (_e94 + (_e127 * _e313));
let _e318 = (_e179 != 0u);
let _e326 = global_2.member.member_12.member_19.member_2;
let _e328 = select(1f, (_e311 - _e326), _e318);
let _e331 = (1f / select(1e-12f, _e328, (_e328 > 1e-12f)));
let _e336 = global_2.member.member_12.member_5;
let _e341 = global_2.member.member_12.member_8;
let _e347 = global_2.member.member_12.member_6;
let _e350 = global_2.member.member_12.member_19;
let _e354 = (_e315 - _e350.member);
let _e355 = (_e317 - _e350.member_1);
let _e356 = (_e311 - _e350.member_2);
let _e361 = (((_e354 * _e354) + (_e355 * _e355)) + (_e356 * _e356));
let _e364 = sqrt(select(0f, _e361, (_e361 > 0f)));
let _e367 = (1f / select(1e-20f, _e364, (_e364 > 1e-20f)));
let _e376 = (((_e116 * _e116) + (_e127 * _e127)) + (_e138 * _e138));
let _e379 = sqrt(select(0f, _e376, (_e376 > 0f)));
let _e382 = (1f / select(1e-20f, _e379, (_e379 > 1e-20f)));
let _e385 = (_e307 == 3f);
let _e391 = (select(1f, (_e356 * _e367), _e318) * (_e379 / select(1e-6f, _e138, (_e138 > 1e-6f))));
let _e393 = select(8f, _e391, (_e391 < 8f));
let _e402 = global_2.member.member_12.member_11;
global_3.member[_e57] = ((((_e315 * _e331) - _e336) * _e341) - _e402);
global_3.member[(_e55 + _e57)] = ((((_e317 * _e331) - _e347) * _e341) - _e402);
global_3.member[((2u * _e55) + _e57)] = select(((_e149 * _e282) * _e393), 0f, _e385);
global_3.member[((3u * _e55) + _e57)] = select(((_e160 * _e282) * _e393), 0f, _e385);
global_3.member[((4u * _e55) + _e57)] = select(((_e171 * _e282) * _e393), 0f, _e385);
global_3.member[((5u * _e55) + _e57)] = ((_e116 * _e382) - select(0f, (_e354 * _e367), _e318));
global_3.member[((6u * _e55) + _e57)] = ((_e127 * _e382) - select(0f, (_e355 * _e367), _e318));
global_3.member[((7u * _e55) + _e57)] = select(select(0f, 1f, (_e296 != 0f)), 2f, (_e307 == 1f));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
