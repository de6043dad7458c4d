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
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_17 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_19 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_20 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_21 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_22 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_17,
member_12: type_18,
member_13: type_19,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_20,
member_19: type_21,
}
struct type_23 {
member: type_22,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(2)
var<storage, read_write> global_3: type_15;
fn function_() {
let _e38 = global;
let _e45 = global_1.member.member;
if (_e38.x < _e45.member) {
if (_e38.y < _e45.member_1) {
let _e52 = (_e45.member * _e45.member_1);
let _e54 = ((_e38.y * _e45.member) + _e38.x);
let _e55 = bitcast<i32>(_e54);
let _e57 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e59 = select(_e57, _e55, (_e55 < _e57));
let _e65 = global_3.member[bitcast<u32>(select(0i, _e59, (_e59 > 0i)))];
let _e66 = (_e52 + _e54);
let _e67 = bitcast<i32>(_e66);
let _e69 = select(_e57, _e67, (_e67 < _e57));
let _e75 = global_3.member[bitcast<u32>(select(0i, _e69, (_e69 > 0i)))];
let _e77 = ((2u * _e52) + _e54);
let _e78 = bitcast<i32>(_e77);
let _e80 = select(_e57, _e78, (_e78 < _e57));
let _e86 = global_3.member[bitcast<u32>(select(0i, _e80, (_e80 > 0i)))];
let _e88 = ((3u * _e52) + _e54);
let _e89 = bitcast<i32>(_e88);
let _e91 = select(_e57, _e89, (_e89 < _e57));
let _e97 = global_3.member[bitcast<u32>(select(0i, _e91, (_e91 > 0i)))];
let _e99 = ((4u * _e52) + _e54);
let _e100 = bitcast<i32>(_e99);
let _e102 = select(_e57, _e100, (_e100 < _e57));
let _e108 = global_3.member[bitcast<u32>(select(0i, _e102, (_e102 > 0i)))];
let _e110 = ((5u * _e52) + _e54);
let _e111 = bitcast<i32>(_e110);
let _e113 = select(_e57, _e111, (_e111 < _e57));
let _e119 = global_3.member[bitcast<u32>(select(0i, _e113, (_e113 > 0i)))];
let _e121 = ((6u * _e52) + _e54);
let _e122 = bitcast<i32>(_e121);
let _e124 = select(_e57, _e122, (_e122 < _e57));
let _e130 = global_3.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e132 = ((7u * _e52) + _e54);
let _e133 = bitcast<i32>(_e132);
let _e135 = select(_e57, _e133, (_e133 < _e57));
let _e141 = global_3.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
let _e143 = ((8u * _e52) + _e54);
let _e144 = bitcast<i32>(_e143);
let _e146 = select(_e57, _e144, (_e144 < _e57));
let _e152 = global_3.member[bitcast<u32>(select(0i, _e146, (_e146 > 0i)))];
let _e154 = ((9u * _e52) + _e54);
let _e155 = bitcast<i32>(_e154);
let _e157 = select(_e57, _e155, (_e155 < _e57));
let _e163 = global_3.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e165 = ((10u * _e52) + _e54);
let _e166 = bitcast<i32>(_e165);
let _e168 = select(_e57, _e166, (_e166 < _e57));
let _e174 = global_3.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e176 = ((11u * _e52) + _e54);
let _e177 = bitcast<i32>(_e176);
let _e179 = select(_e57, _e177, (_e177 < _e57));
let _e185 = global_3.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e187 = ((12u * _e52) + _e54);
let _e188 = bitcast<i32>(_e187);
let _e190 = select(_e57, _e188, (_e188 < _e57));
let _e196 = global_3.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e198 = ((13u * _e52) + _e54);
let _e199 = bitcast<i32>(_e198);
let _e201 = select(_e57, _e199, (_e199 < _e57));
let _e207 = global_3.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e209 = ((14u * _e52) + _e54);
let _e210 = bitcast<i32>(_e209);
let _e212 = select(_e57, _e210, (_e210 < _e57));
let _e218 = global_3.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e220 = ((15u * _e52) + _e54);
let _e221 = bitcast<i32>(_e220);
let _e223 = select(_e57, _e221, (_e221 < _e57));
let _e229 = global_3.member[bitcast<u32>(select(0i, _e223, (_e223 > 0i)))];
let _e231 = ((16u * _e52) + _e54);
let _e232 = bitcast<i32>(_e231);
let _e234 = select(_e57, _e232, (_e232 < _e57));
let _e240 = global_3.member[bitcast<u32>(select(0i, _e234, (_e234 > 0i)))];
let _e242 = ((17u * _e52) + _e54);
let _e243 = bitcast<i32>(_e242);
let _e245 = select(_e57, _e243, (_e243 < _e57));
let _e251 = global_3.member[bitcast<u32>(select(0i, _e245, (_e245 > 0i)))];
let _e253 = ((22u * _e52) + _e54);
let _e254 = bitcast<i32>(_e253);
let _e256 = select(_e57, _e254, (_e254 < _e57));
let _e262 = global_3.member[bitcast<u32>(select(0i, _e256, (_e256 > 0i)))];
let _e264 = ((23u * _e52) + _e54);
let _e265 = bitcast<i32>(_e264);
let _e267 = select(_e57, _e265, (_e265 < _e57));
let _e273 = global_3.member[bitcast<u32>(select(0i, _e267, (_e267 > 0i)))];
let _e275 = ((24u * _e52) + _e54);
let _e276 = bitcast<i32>(_e275);
let _e278 = select(_e57, _e276, (_e276 < _e57));
let _e284 = global_3.member[bitcast<u32>(select(0i, _e278, (_e278 > 0i)))];
let _e286 = ((25u * _e52) + _e54);
let _e287 = bitcast<i32>(_e286);
let _e289 = select(_e57, _e287, (_e287 < _e57));
let _e295 = global_3.member[bitcast<u32>(select(0i, _e289, (_e289 > 0i)))];
let _e299 = global_1.member.member.member;
let _e302 = bitcast<i32>(((_e38.y * _e299) + _e38.x));
let _e304 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e306 = select(_e304, _e302, (_e302 < _e304));
let _e312 = global_2.member[bitcast<u32>(select(0i, _e306, (_e306 > 0i)))];
if (select(0u, 3u, (_e312 > 0f)) > 1u) {
global_3.member[_e54] = _e65;
global_3.member[_e66] = _e75;
global_3.member[_e77] = _e86;
global_3.member[_e88] = _e97;
global_3.member[_e99] = _e108;
global_3.member[_e110] = _e119;
global_3.member[_e121] = _e130;
global_3.member[_e132] = _e141;
global_3.member[_e143] = _e152;
global_3.member[_e154] = _e163;
global_3.member[_e165] = _e174;
global_3.member[_e176] = _e185;
global_3.member[_e187] = _e196;
global_3.member[_e198] = _e207;
global_3.member[_e209] = _e218;
global_3.member[_e220] = _e229;
global_3.member[_e231] = _e240;
global_3.member[_e242] = _e251;
global_3.member[((18u * _e52) + _e54)] = 0f;
global_3.member[((19u * _e52) + _e54)] = 0f;
global_3.member[((20u * _e52) + _e54)] = 0f;
global_3.member[((21u * _e52) + _e54)] = -(1e30f);
global_3.member[_e253] = _e262;
global_3.member[_e264] = _e273;
global_3.member[_e275] = _e284;
global_3.member[_e286] = f32(select(0i, select(select(i32(_e295), i32(-2147483648), (_e295 < -2147483600f)), 2147483647i, (_e295 > 2147483500f)), (_e295 == _e295)));
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
