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
member: type_13,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_13,
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
member_17: type_19,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: f32,
}
struct type_21 {
member: type_7,
member_1: u32,
}
struct type_22 {
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
member_10: type_20,
member_11: type_15,
member_12: type_4,
member_13: type_9,
member_14: type_21,
member_15: type_21,
member_16: type_21,
member_17: type_21,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_23 {
member: type_22,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_11;
@group(0) @binding(0)
var<storage> global_2: type_23;
@group(0) @binding(2)
var<storage, read_write> global_3: type_11;
fn function_() {
var local: i32;
var local_1: i32;
let _e33 = global;
let _e39 = global_2.member.member_2;
let _e42 = global_2.member.member;
let _e50 = (_e33.x + _e39.member);
let _e52 = (_e33.y + _e39.member_1);
if (_e50 < _e39.member_2) {
if (_e52 < _e39.member_3) {
let _e55 = (_e42.member * _e42.member_1);
let _e57 = ((_e52 * _e42.member) + _e50);
let _e62 = global_2.member.member_10.member_4.member;
let _e63 = (_e62 + 1u);
let _e68 = global_2.member.member_10.member_4.member_1;
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
let _e172 = local;
let _e174 = local_1;
let _e175 = ((10i * _e172) + _e174);
let _e177 = select(_e77, _e175, (_e175 < _e77));
let _e182 = global_1.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e183 = local;
let _e185 = local_1;
let _e186 = ((11i * _e183) + _e185);
let _e188 = select(_e77, _e186, (_e186 < _e77));
let _e193 = global_1.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e197 = global_2.member.member_5.member_1;
let _e199 = ((_e197 - _e105) / _e138);
let _e201 = (_e84 + (_e116 * _e199));
let _e203 = (_e94 + (_e127 * _e199));
let _e207 = global_2.member.member_10.member_3;
let _e208 = (_e207 != 0u);
let _e209 = select(1f, _e197, _e208);
let _e212 = (1f / select(1e-12f, _e209, (_e209 > 1e-12f)));
let _e217 = global_2.member.member_10.member_5;
let _e222 = global_2.member.member_10.member_8;
let _e228 = global_2.member.member_10.member_6;
let _e235 = (((_e201 * _e201) + (_e203 * _e203)) + (_e197 * _e197));
let _e238 = sqrt(select(0f, _e235, (_e235 > 0f)));
let _e241 = (1f / select(1e-20f, _e238, (_e238 > 1e-20f)));
let _e250 = (((_e116 * _e116) + (_e127 * _e127)) + (_e138 * _e138));
let _e253 = sqrt(select(0f, _e250, (_e250 > 0f)));
let _e256 = (1f / select(1e-20f, _e253, (_e253 > 1e-20f)));
let _e259 = (_e193 == 3f);
let _e265 = (select(1f, (_e197 * _e241), _e208) * (_e253 / select(1e-6f, _e138, (_e138 > 1e-6f))));
let _e267 = select(8f, _e265, (_e265 < 8f));
let _e276 = global_2.member.member_10.member_11;
global_3.member[_e57] = ((((_e201 * _e212) - _e217) * _e222) - _e276);
global_3.member[(_e55 + _e57)] = ((((_e203 * _e212) - _e228) * _e222) - _e276);
global_3.member[((2u * _e55) + _e57)] = select((_e149 * _e267), 0f, _e259);
global_3.member[((3u * _e55) + _e57)] = select((_e160 * _e267), 0f, _e259);
global_3.member[((4u * _e55) + _e57)] = select((_e171 * _e267), 0f, _e259);
global_3.member[((5u * _e55) + _e57)] = ((_e116 * _e256) - select(0f, (_e201 * _e241), _e208));
global_3.member[((6u * _e55) + _e57)] = ((_e127 * _e256) - select(0f, (_e203 * _e241), _e208));
global_3.member[((7u * _e55) + _e57)] = select(select(0f, 1f, (_e182 != 0f)), 2f, (_e193 == 1f));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
