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
struct type_20 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_22 {
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
struct type_23 {
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
struct type_24 {
member: type_5,
member_1: type_5,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
member: type_2,
member_1: u32,
member_2: type_20,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_21,
member_8: type_22,
member_9: type_22,
member_10: type_23,
member_11: type_24,
member_12: type_14,
member_13: type_21,
member_14: type_4,
member_15: type_9,
member_16: type_25,
member_17: type_25,
member_18: type_25,
member_19: type_25,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_27 {
member: type_26,
}
struct type_28 {
member: vec3<f32>,
member_1: f32,
member_2: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_16;
@group(0) @binding(0)
var<storage> global_2: type_27;
@group(0) @binding(2)
var<storage> global_3: type_16;
@group(0) @binding(3)
var<storage, read_write> global_4: type_16;
fn function_() {
var phi_164_: i32;
var phi_331_: type_28;
var phi_335_: vec3<f32>;
var phi_338_: i32;
var phi_340_: f32;
var phi_397_: i32;
var phi_564_: type_28;
var phi_336_: vec3<f32>;
var phi_339_: i32;
var phi_341_: f32;
var local: vec3<f32>;
var local_1: vec3<f32>;
var local_2: vec3<f32>;
var local_3: f32;
var local_4: f32;
let _e29 = global;
let _e33 = arrayLength((&global_3.member));
let _e36 = global_2.member.member_2;
let _e39 = global_2.member.member;
let _e47 = (_e29.x + _e36.member);
let _e49 = (_e29.y + _e36.member_1);
if (_e47 < _e36.member_2) {
if (_e49 < _e36.member_3) {
let _e52 = (_e39.member * _e39.member_1);
let _e54 = ((_e49 * _e39.member) + _e47);
let _e56 = bitcast<i32>(_e47);
let _e57 = bitcast<i32>(_e49);
let _e62 = global_2.member.member_12.member_4.member;
let _e63 = bitcast<i32>(_e62);
let _e68 = global_2.member.member_12.member_4.member_1;
let _e69 = bitcast<i32>(_e68);
let _e76 = ((((_e56 >= 0i) && (_e56 <= _e63)) && (_e57 >= 0i)) && (_e57 <= _e69));
let _e77 = (_e62 + 1u);
let _e80 = bitcast<i32>((_e77 * (_e68 + 1u)));
if _e76 {
phi_164_ = ((_e57 * bitcast<i32>(_e77)) + _e56);
} else {
phi_164_ = 0i;
}
let _e85 = phi_164_;
let _e86 = (11i * _e80);
let _e87 = (_e86 + _e85);
let _e89 = (bitcast<i32>(arrayLength((&global_1.member))) - 1i);
let _e91 = select(_e89, _e87, (_e87 < _e89));
let _e97 = global_1.member[bitcast<u32>(select(0i, _e91, (_e91 > 0i)))];
let _e99 = (_e76 && (_e97 == 0f));
let _e100 = (_e39.member_2 == 0u);
if _e100 {
let _e102 = ((6i * _e80) + _e85);
let _e104 = select(_e89, _e102, (_e102 < _e89));
let _e110 = global_1.member[bitcast<u32>(select(0i, _e104, (_e104 > 0i)))];
let _e111 = (_e102 + _e80);
let _e113 = select(_e89, _e111, (_e111 < _e89));
let _e119 = global_1.member[bitcast<u32>(select(0i, _e113, (_e113 > 0i)))];
let _e121 = (_e102 + (2i * _e80));
let _e123 = select(_e89, _e121, (_e121 < _e89));
let _e129 = global_1.member[bitcast<u32>(select(0i, _e123, (_e123 > 0i)))];
let _e132 = ((12i * _e80) + _e85);
let _e134 = select(_e89, _e132, (_e132 < _e89));
let _e140 = global_1.member[bitcast<u32>(select(0i, _e134, (_e134 > 0i)))];
phi_331_ = type_28(vec3<f32>(_e110, _e119, _e129), _e140, _e99);
} else {
let _e143 = (bitcast<i32>(_e33) - 1i);
let _e145 = select(_e143, _e85, (_e85 < _e143));
let _e151 = global_3.member[bitcast<u32>(select(0i, _e145, (_e145 > 0i)))];
let _e152 = (_e85 + _e80);
let _e154 = select(_e143, _e152, (_e152 < _e143));
let _e160 = global_3.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e162 = (_e85 + (2i * _e80));
let _e164 = select(_e143, _e162, (_e162 < _e143));
let _e170 = global_3.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e173 = ((3i * _e80) + _e85);
let _e175 = select(_e143, _e173, (_e173 < _e143));
let _e181 = global_3.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
phi_331_ = type_28(vec3<f32>(_e151, _e160, _e170), _e181, _e99);
}
let _e184 = phi_331_;
phi_335_ = _e184.member;
phi_338_ = 0i;
phi_340_ = _e184.member_1;
loop {
let _e188 = phi_335_;
let _e190 = phi_338_;
let _e192 = phi_340_;
local = _e188;
local_1 = _e188;
local_2 = _e188;
local_3 = _e192;
local_4 = _e192;
let _e193 = (_e190 < 4i);
if _e193 {
let _e196 = select(1i, -1i, ((_e190 & 1i) == 0i));
let _e198 = select(0i, _e196, (_e190 < 2i));
let _e199 = (_e56 + _e198);
let _e201 = (_e57 + (_e196 - _e198));
let _e208 = ((((_e199 >= 0i) && (_e199 <= _e63)) && (_e201 >= 0i)) && (_e201 <= _e69));
if _e208 {
phi_397_ = ((_e201 * bitcast<i32>(_e77)) + _e199);
} else {
phi_397_ = 0i;
}
let _e213 = phi_397_;
let _e214 = (_e86 + _e213);
let _e216 = select(_e89, _e214, (_e214 < _e89));
let _e222 = global_1.member[bitcast<u32>(select(0i, _e216, (_e216 > 0i)))];
let _e224 = (_e208 && (_e222 == 0f));
if _e100 {
let _e226 = ((6i * _e80) + _e213);
let _e228 = select(_e89, _e226, (_e226 < _e89));
let _e234 = global_1.member[bitcast<u32>(select(0i, _e228, (_e228 > 0i)))];
let _e235 = (_e226 + _e80);
let _e237 = select(_e89, _e235, (_e235 < _e89));
let _e243 = global_1.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e245 = (_e226 + (2i * _e80));
let _e247 = select(_e89, _e245, (_e245 < _e89));
let _e253 = global_1.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e256 = ((12i * _e80) + _e213);
let _e258 = select(_e89, _e256, (_e256 < _e89));
let _e264 = global_1.member[bitcast<u32>(select(0i, _e258, (_e258 > 0i)))];
phi_564_ = type_28(vec3<f32>(_e234, _e243, _e253), _e264, _e224);
} else {
let _e267 = (bitcast<i32>(_e33) - 1i);
let _e269 = select(_e267, _e213, (_e213 < _e267));
let _e275 = global_3.member[bitcast<u32>(select(0i, _e269, (_e269 > 0i)))];
let _e276 = (_e213 + _e80);
let _e278 = select(_e267, _e276, (_e276 < _e267));
let _e284 = global_3.member[bitcast<u32>(select(0i, _e278, (_e278 > 0i)))];
let _e286 = (_e213 + (2i * _e80));
let _e288 = select(_e267, _e286, (_e286 < _e267));
let _e294 = global_3.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e297 = ((3i * _e80) + _e213);
let _e299 = select(_e267, _e297, (_e297 < _e267));
let _e305 = global_3.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
phi_564_ = type_28(vec3<f32>(_e275, _e284, _e294), _e305, _e224);
}
let _e308 = phi_564_;
let _e317 = (1f / 3f);
let _e330 = ((1f - (((_e184.member.x + _e184.member.y) + _e184.member.z) * _e317)) + (1f - (((_e308.member.x + _e308.member.y) + _e308.member.z) * _e317)));
let _e333 = (_e330 > 1e-6f);
let _e335 = ((_e184.member_1 + _e308.member_1) / select(1e-6f, _e330, _e333));
let _e339 = global_2.member.member_7.member;
let _e340 = (_e339 - _e335);
let _e342 = select(0f, _e340, (_e340 > 0f));
let _e346 = global_2.member.member_7.member_1;
let _e347 = (_e346 - _e335);
let _e349 = select(0f, _e347, (_e347 > 0f));
let _e353 = global_2.member.member_12.member_23;
let _e357 = global_2.member.member_12.member_7;
let _e361 = global_2.member.member_12.member_3;
let _e367 = global_2.member.member_12.member_19.member_2;
let _e371 = (_e353 / (_e357 * select(1f, (_e346 - _e367), (_e361 != 0u))));
let _e381 = global_2.member.member_12.member_24;
let _e382 = (((0.125f * (_e371 * _e371)) * ((_e349 * _e349) - (_e342 * _e342))) * _e381);
let _e388 = select(0f, _e382, (_e382 > 0f));
let _e391 = select(0f, select(0.2f, _e388, (_e388 < 0.2f)), ((_e184.member_2 && _e308.member_2) && _e333));
phi_336_ = vec3<f32>((_e188.x + ((_e308.member.x - _e184.member.x) * _e391)), (_e188.y + ((_e308.member.y - _e184.member.y) * _e391)), (_e188.z + ((_e308.member.z - _e184.member.z) * _e391)));
phi_339_ = (_e190 + 1i);
phi_341_ = (_e192 + ((_e308.member_1 - _e184.member_1) * _e391));
} else {
phi_336_ = vec3<f32>();
phi_339_ = i32();
phi_341_ = f32();
}
let _e417 = phi_336_;
let _e419 = phi_339_;
let _e421 = phi_341_;
continue;
continuing {
phi_335_ = _e417;
phi_338_ = _e419;
phi_340_ = _e421;
break if !(_e193);
}
}
let _e424 = local;
let _e432 = local_1;
let _e440 = local_2;
let _e448 = local_3;
let _e454 = local_4;
global_4.member[_e54] = select(_e424.x, 0f, (bitcast<f32>((bitcast<u32>(_e424.x) & 2147483647u)) < 1e-12f));
global_4.member[(_e52 + _e54)] = select(_e432.y, 0f, (bitcast<f32>((bitcast<u32>(_e432.y) & 2147483647u)) < 1e-12f));
global_4.member[((2u * _e52) + _e54)] = select(_e440.z, 0f, (bitcast<f32>((bitcast<u32>(_e440.z) & 2147483647u)) < 1e-12f));
global_4.member[((3u * _e52) + _e54)] = select(_e454, 0f, (bitcast<f32>((bitcast<u32>(_e448) & 2147483647u)) < 1e-12f));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
