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
struct type_18 {
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
struct type_19 {
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
struct type_20 {
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
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_23 {
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
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_21,
member_19: type_22,
}
struct type_24 {
member: type_23,
}
struct type_25 {
member: f32,
member_1: f32,
}
struct type_26 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: vec3<f32>,
member_6: vec3<f32>,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: i32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_24;
@group(0) @binding(2)
var<storage, read_write> global_2: type_15;
@group(0) @binding(1)
var<storage> global_3: type_15;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var phi_830_: type_26;
var phi_1385_: type_25;
let _e64 = global;
let _e70 = global_1.member.member;
if (_e64.x < _e70.member) {
if (_e64.y < _e70.member_1) {
let _e77 = (_e70.member * _e70.member_1);
let _e79 = ((_e64.y * _e70.member) + _e64.x);
let _e83 = global_1.member.member.member;
let _e87 = global_1.member.member.member_1;
let _e89 = bitcast<i32>((_e83 * _e87));
let _e93 = global_1.member.member_12.member_4;
let _e97 = global_1.member.member_12.member_6;
let _e99 = bitcast<i32>((_e93 * _e97));
let _e102 = bitcast<i32>(((_e64.y * _e83) + _e64.x));
local_3 = _e99;
local_4 = _e102;
local_5 = _e89;
let _e103 = local_3;
let _e104 = local_4;
let _e105 = (_e103 + _e104);
let _e107 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e109 = select(_e107, _e105, (_e105 < _e107));
let _e114 = global_3.member[bitcast<u32>(select(0i, _e109, (_e109 > 0i)))];
let _e115 = local_3;
let _e116 = local_5;
let _e118 = local_4;
let _e119 = ((_e115 + _e116) + _e118);
let _e121 = select(_e107, _e119, (_e119 < _e107));
let _e126 = global_3.member[bitcast<u32>(select(0i, _e121, (_e121 > 0i)))];
let _e127 = local_3;
let _e128 = local_5;
let _e131 = local_4;
let _e132 = ((_e127 + (2i * _e128)) + _e131);
let _e134 = select(_e107, _e132, (_e132 < _e107));
let _e139 = global_3.member[bitcast<u32>(select(0i, _e134, (_e134 > 0i)))];
let _e140 = vec3<f32>(_e114, _e126, _e139);
let _e141 = local_3;
let _e142 = local_5;
let _e145 = local_4;
let _e146 = ((_e141 + (3i * _e142)) + _e145);
let _e148 = select(_e107, _e146, (_e146 < _e107));
let _e153 = global_3.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e154 = local_3;
let _e155 = local_5;
let _e158 = local_4;
let _e159 = ((_e154 + (4i * _e155)) + _e158);
let _e161 = select(_e107, _e159, (_e159 < _e107));
let _e166 = global_3.member[bitcast<u32>(select(0i, _e161, (_e161 > 0i)))];
let _e167 = local_3;
let _e168 = local_5;
let _e171 = local_4;
let _e172 = ((_e167 + (5i * _e168)) + _e171);
let _e174 = select(_e107, _e172, (_e172 < _e107));
let _e179 = global_3.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e180 = vec3<f32>(_e153, _e166, _e179);
let _e181 = local_3;
let _e182 = local_5;
let _e185 = local_4;
let _e186 = ((_e181 + (6i * _e182)) + _e185);
let _e188 = select(_e107, _e186, (_e186 < _e107));
let _e193 = global_3.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e194 = local_3;
let _e195 = local_5;
let _e198 = local_4;
let _e199 = ((_e194 + (7i * _e195)) + _e198);
let _e201 = select(_e107, _e199, (_e199 < _e107));
let _e206 = global_3.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e207 = local_3;
let _e208 = local_5;
let _e211 = local_4;
let _e212 = ((_e207 + (8i * _e208)) + _e211);
let _e214 = select(_e107, _e212, (_e212 < _e107));
let _e219 = global_3.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e221 = local_3;
let _e222 = local_5;
let _e225 = local_4;
let _e226 = ((_e221 + (9i * _e222)) + _e225);
let _e228 = select(_e107, _e226, (_e226 < _e107));
let _e233 = global_3.member[bitcast<u32>(select(0i, _e228, (_e228 > 0i)))];
let _e234 = local_3;
let _e235 = local_5;
let _e238 = local_4;
let _e239 = ((_e234 + (10i * _e235)) + _e238);
let _e241 = select(_e107, _e239, (_e239 < _e107));
let _e246 = global_3.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e247 = local_3;
let _e248 = local_5;
let _e251 = local_4;
let _e252 = ((_e247 + (11i * _e248)) + _e251);
let _e254 = select(_e107, _e252, (_e252 < _e107));
let _e259 = global_3.member[bitcast<u32>(select(0i, _e254, (_e254 > 0i)))];
let _e261 = local_3;
let _e262 = local_5;
let _e265 = local_4;
let _e266 = ((_e261 + (12i * _e262)) + _e265);
let _e268 = select(_e107, _e266, (_e266 < _e107));
let _e273 = global_3.member[bitcast<u32>(select(0i, _e268, (_e268 > 0i)))];
let _e274 = local_3;
let _e275 = local_5;
let _e278 = local_4;
let _e279 = ((_e274 + (13i * _e275)) + _e278);
let _e281 = select(_e107, _e279, (_e279 < _e107));
let _e286 = global_3.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e287 = local_3;
let _e288 = local_5;
let _e291 = local_4;
let _e292 = ((_e287 + (14i * _e288)) + _e291);
let _e294 = select(_e107, _e292, (_e292 < _e107));
let _e299 = global_3.member[bitcast<u32>(select(0i, _e294, (_e294 > 0i)))];
let _e301 = local_3;
let _e302 = local_5;
let _e305 = local_4;
let _e306 = ((_e301 + (15i * _e302)) + _e305);
let _e308 = select(_e107, _e306, (_e306 < _e107));
let _e313 = global_3.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e314 = local_3;
let _e315 = local_5;
let _e318 = local_4;
let _e319 = ((_e314 + (16i * _e315)) + _e318);
let _e321 = select(_e107, _e319, (_e319 < _e107));
let _e326 = global_3.member[bitcast<u32>(select(0i, _e321, (_e321 > 0i)))];
let _e327 = local_3;
let _e328 = local_5;
let _e331 = local_4;
let _e332 = ((_e327 + (17i * _e328)) + _e331);
let _e334 = select(_e107, _e332, (_e332 < _e107));
let _e339 = global_3.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e341 = local_3;
let _e342 = local_5;
let _e345 = local_4;
let _e346 = ((_e341 + (18i * _e342)) + _e345);
let _e348 = select(_e107, _e346, (_e346 < _e107));
let _e353 = global_3.member[bitcast<u32>(select(0i, _e348, (_e348 > 0i)))];
let _e354 = local_3;
let _e355 = local_5;
let _e358 = local_4;
let _e359 = ((_e354 + (19i * _e355)) + _e358);
let _e361 = select(_e107, _e359, (_e359 < _e107));
let _e366 = global_3.member[bitcast<u32>(select(0i, _e361, (_e361 > 0i)))];
let _e367 = local_3;
let _e368 = local_5;
let _e371 = local_4;
let _e372 = ((_e367 + (20i * _e368)) + _e371);
let _e374 = select(_e107, _e372, (_e372 < _e107));
let _e379 = global_3.member[bitcast<u32>(select(0i, _e374, (_e374 > 0i)))];
let _e380 = vec3<f32>(_e353, _e366, _e379);
let _e381 = local_3;
let _e382 = local_5;
let _e385 = local_4;
let _e386 = ((_e381 + (21i * _e382)) + _e385);
let _e388 = select(_e107, _e386, (_e386 < _e107));
let _e393 = global_3.member[bitcast<u32>(select(0i, _e388, (_e388 > 0i)))];
let _e394 = local_3;
let _e395 = local_5;
let _e398 = local_4;
let _e399 = ((_e394 + (22i * _e395)) + _e398);
let _e401 = select(_e107, _e399, (_e399 < _e107));
let _e406 = global_3.member[bitcast<u32>(select(0i, _e401, (_e401 > 0i)))];
let _e407 = local_3;
let _e408 = local_5;
let _e411 = local_4;
let _e412 = ((_e407 + (23i * _e408)) + _e411);
let _e414 = select(_e107, _e412, (_e412 < _e107));
let _e419 = global_3.member[bitcast<u32>(select(0i, _e414, (_e414 > 0i)))];
let _e420 = local_3;
let _e421 = local_5;
let _e424 = local_4;
let _e425 = ((_e420 + (24i * _e421)) + _e424);
let _e427 = select(_e107, _e425, (_e425 < _e107));
let _e432 = global_3.member[bitcast<u32>(select(0i, _e427, (_e427 > 0i)))];
let _e433 = local_3;
let _e434 = local_5;
let _e437 = local_4;
let _e438 = ((_e433 + (25i * _e434)) + _e437);
let _e440 = select(_e107, _e438, (_e438 < _e107));
let _e445 = global_3.member[bitcast<u32>(select(0i, _e440, (_e440 > 0i)))];
let _e452 = select(0i, select(select(i32(_e445), i32(-2147483648), (_e445 < -2147483600f)), 2147483647i, (_e445 > 2147483500f)), (_e445 == _e445));
let _e457 = global_1.member.member_12.member_11;
if (_e457 != 0u) {
phi_830_ = type_26(_e140, _e180, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), _e380, _e393, _e406, _e419, _e432, _e452);
} else {
phi_830_ = type_26(_e140, _e180, vec3<f32>(_e193, _e206, _e219), vec3<f32>(_e233, _e246, _e259), vec3<f32>(_e273, _e286, _e299), vec3<f32>(_e313, _e326, _e339), _e380, _e393, _e406, _e419, _e432, _e452);
}
let _e461 = phi_830_;
let _e465 = global_1.member.member_6;
let _e470 = (_e461.member.x - _e465.member);
let _e472 = (_e461.member.y - _e465.member_1);
let _e474 = (_e461.member.z - _e465.member_2);
let _e480 = ((_e472 * _e461.member_1.z) - (_e474 * _e461.member_1.y));
let _e484 = ((_e474 * _e461.member_1.x) - (_e470 * _e461.member_1.z));
let _e487 = ((_e470 * _e461.member_1.y) - (_e472 * _e461.member_1.x));
let _e490 = global_1.member.member_3;
let _e496 = global_1.member.member_4;
let _e502 = global_1.member.member_5;
let _e509 = global_1.member.member_2.member_3;
let _e510 = (_e509 != 0u);
let _e513 = ((_e502.member_1 * _e490.member_2) - (_e502.member_2 * _e490.member_1));
let _e516 = ((_e502.member_2 * _e490.member) - (_e502.member * _e490.member_2));
let _e519 = ((_e502.member * _e490.member_1) - (_e502.member_1 * _e490.member));
let _e531 = select((((_e490.member * _e480) + (_e490.member_1 * _e484)) + (_e490.member_2 * _e487)), -((((_e513 * _e461.member_1.x) + (_e516 * _e461.member_1.y)) + (_e519 * _e461.member_1.z))), _e510);
let _e534 = ((_e502.member_1 * _e496.member_2) - (_e502.member_2 * _e496.member_1));
let _e537 = ((_e502.member_2 * _e496.member) - (_e502.member * _e496.member_2));
let _e540 = ((_e502.member * _e496.member_1) - (_e502.member_1 * _e496.member));
let _e552 = select((((_e496.member * _e480) + (_e496.member_1 * _e484)) + (_e496.member_2 * _e487)), -((((_e534 * _e461.member_1.x) + (_e537 * _e461.member_1.y)) + (_e540 * _e461.member_1.z))), _e510);
let _e561 = global_1.member.member_1.member;
let _e563 = f32(bitcast<i32>(_e561));
let _e567 = global_1.member.member_1.member_1;
let _e569 = f32(bitcast<i32>(_e567));
let _e573 = global_1.member.member_2.member;
let _e577 = global_1.member.member_2.member_1;
let _e579 = ((2f * _e573) / _e563);
let _e580 = (_e531 * _e579);
let _e582 = ((-2f * _e577) / _e569);
let _e583 = (_e552 * _e582);
let _e585 = ((_e573 / _e563) - _e573);
let _e589 = (_e577 - (_e577 / _e569));
let _e618 = (((_e461.member_2.y * _e461.member_1.z) - (_e461.member_2.z * _e461.member_1.y)) + ((_e472 * _e461.member_4.z) - (_e474 * _e461.member_4.y)));
let _e619 = (((_e461.member_2.z * _e461.member_1.x) - (_e461.member_2.x * _e461.member_1.z)) + ((_e474 * _e461.member_4.x) - (_e470 * _e461.member_4.z)));
let _e620 = (((_e461.member_2.x * _e461.member_1.y) - (_e461.member_2.y * _e461.member_1.x)) + ((_e470 * _e461.member_4.y) - (_e472 * _e461.member_4.x)));
let _e632 = select((((_e490.member * _e618) + (_e490.member_1 * _e619)) + (_e490.member_2 * _e620)), -((((_e513 * _e461.member_4.x) + (_e516 * _e461.member_4.y)) + (_e519 * _e461.member_4.z))), _e510);
let _e644 = select((((_e496.member * _e618) + (_e496.member_1 * _e619)) + (_e496.member_2 * _e620)), -((((_e534 * _e461.member_4.x) + (_e537 * _e461.member_4.y)) + (_e540 * _e461.member_4.z))), _e510);
let _e650 = (_e632 * _e579);
let _e651 = (_e644 * _e582);
let _e655 = (((((_e502.member * _e618) + (_e502.member_1 * _e619)) + (_e502.member_2 * _e620)) + (_e632 * _e585)) + (_e644 * _e589));
let _e682 = (((_e461.member_3.y * _e461.member_1.z) - (_e461.member_3.z * _e461.member_1.y)) + ((_e472 * _e461.member_5.z) - (_e474 * _e461.member_5.y)));
let _e683 = (((_e461.member_3.z * _e461.member_1.x) - (_e461.member_3.x * _e461.member_1.z)) + ((_e474 * _e461.member_5.x) - (_e470 * _e461.member_5.z)));
let _e684 = (((_e461.member_3.x * _e461.member_1.y) - (_e461.member_3.y * _e461.member_1.x)) + ((_e470 * _e461.member_5.y) - (_e472 * _e461.member_5.x)));
let _e696 = select((((_e490.member * _e682) + (_e490.member_1 * _e683)) + (_e490.member_2 * _e684)), -((((_e513 * _e461.member_5.x) + (_e516 * _e461.member_5.y)) + (_e519 * _e461.member_5.z))), _e510);
let _e708 = select((((_e496.member * _e682) + (_e496.member_1 * _e683)) + (_e496.member_2 * _e684)), -((((_e534 * _e461.member_5.x) + (_e537 * _e461.member_5.y)) + (_e540 * _e461.member_5.z))), _e510);
let _e714 = (_e696 * _e579);
let _e715 = (_e708 * _e582);
let _e719 = (((((_e502.member * _e682) + (_e502.member_1 * _e683)) + (_e502.member_2 * _e684)) + (_e696 * _e585)) + (_e708 * _e589));
let _e726 = (bitcast<f32>((bitcast<u32>(_e580) & 2147483647u)) > bitcast<f32>((bitcast<u32>(_e583) & 2147483647u)));
let _e727 = select(_e580, _e583, _e726);
let _e728 = select(_e583, _e580, _e726);
let _e729 = select(_e650, _e651, _e726);
let _e730 = select(_e651, _e650, _e726);
let _e731 = select(_e714, _e715, _e726);
let _e732 = select(_e715, _e714, _e726);
let _e735 = bitcast<f32>((bitcast<u32>(_e728) & 2147483647u));
let _e741 = ((((_e502.member * _e470) + (_e502.member_1 * _e472)) + (_e502.member_2 * _e474)) - 1e-3f);
let _e746 = (((_e502.member * _e461.member_1.x) + (_e502.member_1 * _e461.member_1.y)) + (_e502.member_2 * _e461.member_1.z));
if (_e509 == 0u) {
let _e749 = (_e746 == 0f);
let _e751 = (-(_e741) / select(_e746, 1e-30f, _e749));
phi_1385_ = type_25(select(0f, select(0f, _e751, (_e751 > 0f)), (_e746 > 0f)), select(select(_e461.member_9, select(_e461.member_9, _e751, (_e751 < _e461.member_9)), (_e746 < 0f)), -1f, (_e749 && (_e741 < 0f))));
} else {
phi_1385_ = type_25(0f, _e461.member_9);
}
let _e768 = phi_1385_;
let _e777 = ((_e461.member.x + (_e461.member_1.x * _e768.member)) - _e465.member);
let _e778 = ((_e461.member.y + (_e461.member_1.y * _e768.member)) - _e465.member_1);
let _e779 = ((_e461.member.z + (_e461.member_1.z * _e768.member)) - _e465.member_2);
let _e784 = (((_e502.member * _e777) + (_e502.member_1 * _e778)) + (_e502.member_2 * _e779));
let _e788 = select((1f / select(1e-3f, _e784, (_e784 > 1e-3f))), 1f, _e510);
let _e797 = (0.5f * _e563);
let _e799 = ((((((((_e490.member * _e777) + (_e490.member_1 * _e778)) + (_e490.member_2 * _e779)) * _e788) / _e573) + 1f) * _e797) - 0.5f);
let _e808 = (0.5f * _e569);
let _e810 = (((1f - (((((_e496.member * _e777) + (_e496.member_1 * _e778)) + (_e496.member_2 * _e779)) * _e788) / _e577)) * _e808) - 0.5f);
let _e811 = -(1e6f);
let _e813 = select(_e811, _e799, (_e799 > _e811));
let _e815 = select(1e6f, _e813, (_e813 < 1e6f));
let _e817 = select(_e811, _e810, (_e810 > _e811));
let _e819 = select(1e6f, _e817, (_e817 < 1e6f));
let _e820 = select(_e815, _e819, _e726);
let _e821 = select(_e819, _e815, _e726);
let _e839 = (bitcast<f32>((bitcast<u32>(_e727) & 2147483647u)) / _e735);
let _e843 = (0.5f * 1f);
let _e846 = ((2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e729 * _e820) + ((_e730 * _e821) + _e655))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e731 * _e820) + ((_e732 * _e821) + _e719))) & 2147483647u)))) / _e735) + _e843)) * _e839);
let _e849 = (select(1e6f, _e846, (_e846 < 1e6f)) + 1f);
let _e856 = ((_e461.member.x + (_e461.member_1.x * _e768.member_1)) - _e465.member);
let _e857 = ((_e461.member.y + (_e461.member_1.y * _e768.member_1)) - _e465.member_1);
let _e858 = ((_e461.member.z + (_e461.member_1.z * _e768.member_1)) - _e465.member_2);
let _e863 = (((_e502.member * _e856) + (_e502.member_1 * _e857)) + (_e502.member_2 * _e858));
let _e867 = select((1f / select(1e-3f, _e863, (_e863 > 1e-3f))), 1f, _e510);
let _e877 = ((((((((_e490.member * _e856) + (_e490.member_1 * _e857)) + (_e490.member_2 * _e858)) * _e867) / _e573) + 1f) * _e797) - 0.5f);
let _e887 = (((1f - (((((_e496.member * _e856) + (_e496.member_1 * _e857)) + (_e496.member_2 * _e858)) * _e867) / _e577)) * _e808) - 0.5f);
let _e889 = select(_e811, _e877, (_e877 > _e811));
let _e891 = select(1e6f, _e889, (_e889 < 1e6f));
let _e893 = select(_e811, _e887, (_e887 > _e811));
let _e895 = select(1e6f, _e893, (_e893 < 1e6f));
let _e896 = select(_e891, _e895, _e726);
let _e897 = select(_e895, _e891, _e726);
let _e917 = ((2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e729 * _e896) + ((_e730 * _e897) + _e655))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e731 * _e896) + ((_e732 * _e897) + _e719))) & 2147483647u)))) / _e735) + _e843)) * _e839);
let _e920 = (select(1e6f, _e917, (_e917 < 1e6f)) + 1f);
let _e921 = (_e896 < _e820);
let _e922 = (_e820 - _e849);
let _e923 = (_e896 - _e920);
let _e926 = (_e820 + _e849);
let _e927 = (_e896 + _e920);
local = _e99;
local_1 = _e102;
local_2 = _e89;
let _e930 = local;
let _e931 = local_2;
let _e934 = local_1;
let _e935 = ((_e930 + (18i * _e931)) + _e934);
let _e937 = select(_e107, _e935, (_e935 < _e107));
let _e942 = global_3.member[bitcast<u32>(select(0i, _e937, (_e937 > 0i)))];
let _e943 = local;
let _e944 = local_2;
let _e947 = local_1;
let _e948 = ((_e943 + (19i * _e944)) + _e947);
let _e950 = select(_e107, _e948, (_e948 < _e107));
let _e955 = global_3.member[bitcast<u32>(select(0i, _e950, (_e950 > 0i)))];
let _e957 = local;
let _e958 = local_2;
let _e961 = local_1;
let _e962 = ((_e957 + (20i * _e958)) + _e961);
let _e964 = select(_e107, _e962, (_e962 < _e107));
let _e969 = global_3.member[bitcast<u32>(select(0i, _e964, (_e964 > 0i)))];
let _e975 = (((((_e942 + _e955) + _e969) > 0f) && (_e735 > 0f)) && (_e768.member_1 > _e768.member));
global_2.member[_e79] = select(0f, 1f, (_e975 && _e726));
global_2.member[(_e77 + _e79)] = select(0f, _e727, _e975);
global_2.member[((2u * _e77) + _e79)] = select(0f, _e728, _e975);
global_2.member[((3u * _e77) + _e79)] = select(0f, (((((_e502.member * _e480) + (_e502.member_1 * _e484)) + (_e502.member_2 * _e487)) + (_e531 * _e585)) + (_e552 * _e589)), _e975);
global_2.member[((4u * _e77) + _e79)] = select(0f, _e729, _e975);
global_2.member[((5u * _e77) + _e79)] = select(0f, _e730, _e975);
global_2.member[((6u * _e77) + _e79)] = select(0f, _e655, _e975);
global_2.member[((7u * _e77) + _e79)] = select(0f, _e731, _e975);
global_2.member[((8u * _e77) + _e79)] = select(0f, _e732, _e975);
global_2.member[((9u * _e77) + _e79)] = select(0f, _e719, _e975);
global_2.member[((10u * _e77) + _e79)] = select(0f, select(_e923, _e922, (_e922 < _e923)), _e975);
global_2.member[((11u * _e77) + _e79)] = select(-1f, select(_e927, _e926, (_e926 > _e927)), _e975);
global_2.member[((12u * _e77) + _e79)] = select(0f, select(_e926, _e927, _e921), _e975);
global_2.member[((13u * _e77) + _e79)] = select(0f, select(_e923, _e922, _e921), _e975);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
