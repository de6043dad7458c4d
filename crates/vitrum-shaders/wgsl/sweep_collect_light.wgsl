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
struct type_15 {
member: array<u32>,
}
struct type_16 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_17 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_18 {
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
struct type_19 {
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
struct type_20 {
member: type_5,
member_1: type_5,
}
struct type_21 {
member: type_7,
member_1: u32,
}
struct type_22 {
member: type_2,
member_1: u32,
member_2: type_16,
member_3: type_13,
member_4: u32,
member_5: type_17,
member_6: type_18,
member_7: type_18,
member_8: type_19,
member_9: type_20,
member_10: f32,
member_11: type_17,
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
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(2)
var<storage, read_write> global_2: type_11;
@group(0) @binding(1)
var<storage> global_3: type_15;
fn function_() {
var local: i32;
var phi_183_: u32;
var phi_189_: u32;
var phi_264_: u32;
var phi_270_: u32;
var phi_345_: u32;
var phi_351_: u32;
var phi_450_: u32;
var phi_456_: u32;
var phi_526_: u32;
var phi_532_: u32;
let _e37 = global;
let _e43 = global_1.member.member_2;
let _e46 = global_1.member.member;
let _e54 = (_e37.x + _e43.member);
let _e56 = (_e37.y + _e43.member_1);
if (_e54 < _e43.member_2) {
if (_e56 < _e43.member_3) {
let _e59 = (_e46.member * _e46.member_1);
let _e61 = ((_e56 * _e46.member) + _e54);
let _e65 = global_1.member.member_8.member;
local = bitcast<i32>((((_e56 * _e65) + _e54) * 10u));
let _e70 = local;
let _e72 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e74 = select(_e72, _e70, (_e70 < _e72));
let _e79 = global_3.member[bitcast<u32>(select(0i, _e74, (_e74 > 0i)))];
let _e80 = (_e70 + 1i);
let _e82 = select(_e72, _e80, (_e80 < _e72));
let _e87 = global_3.member[bitcast<u32>(select(0i, _e82, (_e82 > 0i)))];
let _e90 = ((_e87 >> bitcast<u32>(31i)) != 0u);
if _e90 {
phi_183_ = (~(_e79) + 1u);
} else {
phi_183_ = _e79;
}
let _e96 = phi_183_;
if _e90 {
phi_189_ = (~(_e87) + select(0u, 1u, (_e79 == 0u)));
} else {
phi_189_ = _e87;
}
let _e100 = phi_189_;
let _e122 = ((((f32(bitcast<i32>(((_e100 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e100 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e96 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e96 & 65535u)))));
let _e128 = (1f / 16777216f);
let _e130 = (1f + (select(_e122, -(bitcast<f32>((bitcast<u32>(_e122) & 2147483647u))), _e90) * _e128));
let _e132 = select(0f, _e130, (_e130 > 0f));
let _e133 = local;
let _e134 = (_e133 + 2i);
let _e136 = select(_e72, _e134, (_e134 < _e72));
let _e141 = global_3.member[bitcast<u32>(select(0i, _e136, (_e136 > 0i)))];
let _e142 = (_e133 + 3i);
let _e144 = select(_e72, _e142, (_e142 < _e72));
let _e149 = global_3.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((_e149 >> bitcast<u32>(31i)) != 0u);
if _e152 {
phi_264_ = (~(_e141) + 1u);
} else {
phi_264_ = _e141;
}
let _e158 = phi_264_;
if _e152 {
phi_270_ = (~(_e149) + select(0u, 1u, (_e141 == 0u)));
} else {
phi_270_ = _e149;
}
let _e162 = phi_270_;
let _e184 = ((((f32(bitcast<i32>(((_e162 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e162 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e158 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e158 & 65535u)))));
let _e191 = (1f + (select(_e184, -(bitcast<f32>((bitcast<u32>(_e184) & 2147483647u))), _e152) * _e128));
let _e193 = select(0f, _e191, (_e191 > 0f));
let _e194 = local;
let _e195 = (_e194 + 4i);
let _e197 = select(_e72, _e195, (_e195 < _e72));
let _e202 = global_3.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e203 = (_e194 + 5i);
let _e205 = select(_e72, _e203, (_e203 < _e72));
let _e210 = global_3.member[bitcast<u32>(select(0i, _e205, (_e205 > 0i)))];
let _e213 = ((_e210 >> bitcast<u32>(31i)) != 0u);
if _e213 {
phi_345_ = (~(_e202) + 1u);
} else {
phi_345_ = _e202;
}
let _e219 = phi_345_;
if _e213 {
phi_351_ = (~(_e210) + select(0u, 1u, (_e202 == 0u)));
} else {
phi_351_ = _e210;
}
let _e223 = phi_351_;
let _e245 = ((((f32(bitcast<i32>(((_e223 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e223 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e219 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e219 & 65535u)))));
let _e252 = (1f + (select(_e245, -(bitcast<f32>((bitcast<u32>(_e245) & 2147483647u))), _e213) * _e128));
let _e254 = select(0f, _e252, (_e252 > 0f));
let _e258 = (((_e132 + _e193) + _e254) * (1f / 3f));
let _e259 = (_e258 > 1e-6f);
let _e262 = select(0f, (1f / select(1e-6f, _e258, _e259)), _e259);
let _e267 = global_1.member.member_9.member.member;
let _e272 = global_1.member.member_9.member.member_1;
let _e277 = global_1.member.member_9.member.member_2;
let _e278 = local;
let _e279 = (_e278 + 6i);
let _e281 = select(_e72, _e279, (_e279 < _e72));
let _e286 = global_3.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e287 = (_e278 + 7i);
let _e289 = select(_e72, _e287, (_e287 < _e72));
let _e294 = global_3.member[bitcast<u32>(select(0i, _e289, (_e289 > 0i)))];
let _e297 = ((_e294 >> bitcast<u32>(31i)) != 0u);
if _e297 {
phi_450_ = (~(_e286) + 1u);
} else {
phi_450_ = _e286;
}
let _e303 = phi_450_;
if _e297 {
phi_456_ = (~(_e294) + select(0u, 1u, (_e286 == 0u)));
} else {
phi_456_ = _e294;
}
let _e307 = phi_456_;
let _e329 = ((((f32(bitcast<i32>(((_e307 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e307 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e303 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e303 & 65535u)))));
let _e335 = (1f / 8388608f);
let _e338 = local;
let _e339 = (_e338 + 8i);
let _e341 = select(_e72, _e339, (_e339 < _e72));
let _e346 = global_3.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
let _e347 = (_e338 + 9i);
let _e349 = select(_e72, _e347, (_e347 < _e72));
let _e354 = global_3.member[bitcast<u32>(select(0i, _e349, (_e349 > 0i)))];
let _e357 = ((_e354 >> bitcast<u32>(31i)) != 0u);
if _e357 {
phi_526_ = (~(_e346) + 1u);
} else {
phi_526_ = _e346;
}
let _e363 = phi_526_;
if _e357 {
phi_532_ = (~(_e354) + select(0u, 1u, (_e346 == 0u)));
} else {
phi_532_ = _e354;
}
let _e367 = phi_532_;
let _e389 = ((((f32(bitcast<i32>(((_e367 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e367 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e363 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e363 & 65535u)))));
global_2.member[_e61] = _e132;
global_2.member[(_e59 + _e61)] = _e193;
global_2.member[((2u * _e59) + _e61)] = _e254;
global_2.member[((3u * _e59) + _e61)] = (_e267 + (((select(_e329, -(bitcast<f32>((bitcast<u32>(_e329) & 2147483647u))), _e297) * _e335) * _e262) * _e277));
global_2.member[((4u * _e59) + _e61)] = (_e272 + (((select(_e389, -(bitcast<f32>((bitcast<u32>(_e389) & 2147483647u))), _e357) * _e335) * _e262) * _e277));
global_2.member[((5u * _e59) + _e61)] = _e277;
global_2.member[((6u * _e59) + _e61)] = 0f;
global_2.member[((7u * _e59) + _e61)] = 0f;
global_2.member[((8u * _e59) + _e61)] = 1f;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
