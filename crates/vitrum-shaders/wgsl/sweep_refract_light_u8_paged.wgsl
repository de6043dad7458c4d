struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_3 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_4 {
member: u32,
member_1: u32,
}
struct type_6 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_7 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_8 {
member: type_7,
member_1: f32,
}
struct type_10 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: type_7,
member_4: type_7,
member_5: type_7,
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
struct type_11 {
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
struct type_12 {
member: type_7,
member_1: type_7,
}
struct type_13 {
member: type_4,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_14 {
member: type_7,
member_1: f32,
member_2: f32,
}
struct type_15 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: u32,
member_4: type_4,
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
member_17: type_4,
member_18: type_13,
member_19: type_7,
member_20: type_14,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_17 {
member: type_8,
member_1: type_7,
}
struct type_18 {
member: type_17,
member_1: type_17,
}
struct type_19 {
member: type_8,
member_1: u32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_7,
member_8: type_7,
member_9: type_7,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_7,
member_8: type_7,
member_9: type_7,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_22 {
member: type_2,
member_1: u32,
member_2: type_3,
member_3: type_4,
member_4: type_4,
member_5: u32,
member_6: u32,
member_7: type_6,
member_8: type_10,
member_9: type_10,
member_10: type_11,
member_11: type_12,
member_12: type_15,
member_13: type_6,
member_14: type_16,
member_15: type_18,
member_16: type_19,
member_17: type_19,
member_18: type_19,
member_19: type_19,
member_20: type_20,
member_21: f32,
member_22: f32,
member_23: type_21,
}
struct type_23 {
member: type_22,
}
struct type_25 {
member: array<u32>,
}
struct type_27 {
member: array<f32>,
}
struct type_30 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_33 {
member: f32,
member_1: f32,
}
struct type_34 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_35 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: f32,
member_4: vec3<f32>,
member_5: vec3<f32>,
}
struct type_36 {
member: type_33,
member_1: type_33,
member_2: f32,
}
struct type_37 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: f32,
member_5: f32,
member_6: vec3<f32>,
}
struct type_38 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(1)
var<storage> global_2: type_25;
@group(0) @binding(4)
var<storage> global_3: type_25;
@group(0) @binding(6)
var<storage, read_write> global_4: type_27;
@group(0) @binding(3)
var<storage> global_5: type_25;
@group(0) @binding(5)
var<storage> global_6: type_27;
fn function_() {
var local: f32;
var local_1: f32;
var local_2: type_30;
var local_3: vec3<f32>;
var local_4: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var local_8: type_30;
var local_9: vec3<f32>;
var local_10: type_30;
var local_11: vec3<f32>;
var local_12: type_30;
var local_13: vec3<f32>;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var local_17: f32;
var local_18: f32;
var local_19: f32;
var local_20: f32;
var local_21: f32;
var local_22: f32;
var local_23: f32;
var local_24: f32;
var local_25: f32;
var local_26: f32;
var local_27: f32;
var local_28: type_30;
var local_29: vec3<f32>;
var phi_958_: bool;
var phi_1148_: bool;
var phi_1151_: bool;
var phi_1345_: bool;
var phi_1681_: u32;
var phi_2054_: vec3<f32>;
var phi_7375_: type_34;
var phi_7722_: vec3<f32>;
var phi_9225_: vec3<f32>;
var phi_9694_: f32;
var phi_9695_: vec3<f32>;
var phi_9697_: type_35;
var phi_9843_: vec3<f32>;
var phi_10832_: type_36;
var phi_14776_: type_38;
var phi_15174_: f32;
var phi_16499_: type_37;
var phi_16512_: vec3<f32>;
var phi_16513_: f32;
var phi_16743_: vec3<f32>;
var phi_19294_: type_37;
var phi_19446_: vec3<f32>;
var phi_19447_: f32;
let _e173 = global;
let _e176 = arrayLength((&global_2.member));
let _e181 = arrayLength((&global_3.member));
let _e183 = arrayLength((&global_6.member));
let _e188 = global_1.member.member_2;
let _e191 = global_1.member.member;
let _e199 = (_e173.x + _e188.member);
let _e201 = (_e173.y + _e188.member_1);
if (_e199 < _e188.member_2) {
if (_e201 < _e188.member_3) {
let _e204 = (_e191.member * _e191.member_1);
let _e206 = ((_e201 * _e191.member) + _e199);
let _e207 = bitcast<i32>(_e206);
let _e209 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e211 = select(_e209, _e207, (_e207 < _e209));
let _e217 = global_4.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e218 = (_e204 + _e206);
let _e219 = bitcast<i32>(_e218);
let _e221 = select(_e209, _e219, (_e219 < _e209));
let _e227 = global_4.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e229 = ((2u * _e204) + _e206);
let _e230 = bitcast<i32>(_e229);
let _e232 = select(_e209, _e230, (_e230 < _e209));
let _e238 = global_4.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e240 = ((3u * _e204) + _e206);
let _e241 = bitcast<i32>(_e240);
let _e243 = select(_e209, _e241, (_e241 < _e209));
let _e249 = global_4.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
let _e251 = ((4u * _e204) + _e206);
let _e252 = bitcast<i32>(_e251);
let _e254 = select(_e209, _e252, (_e252 < _e209));
let _e260 = global_4.member[bitcast<u32>(select(0i, _e254, (_e254 > 0i)))];
let _e262 = ((5u * _e204) + _e206);
let _e263 = bitcast<i32>(_e262);
let _e265 = select(_e209, _e263, (_e263 < _e209));
let _e271 = global_4.member[bitcast<u32>(select(0i, _e265, (_e265 > 0i)))];
let _e273 = ((6u * _e204) + _e206);
let _e274 = bitcast<i32>(_e273);
let _e276 = select(_e209, _e274, (_e274 < _e209));
let _e282 = global_4.member[bitcast<u32>(select(0i, _e276, (_e276 > 0i)))];
let _e284 = ((7u * _e204) + _e206);
let _e285 = bitcast<i32>(_e284);
let _e287 = select(_e209, _e285, (_e285 < _e209));
let _e293 = global_4.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e295 = ((8u * _e204) + _e206);
let _e296 = bitcast<i32>(_e295);
let _e298 = select(_e209, _e296, (_e296 < _e209));
let _e304 = global_4.member[bitcast<u32>(select(0i, _e298, (_e298 > 0i)))];
let _e309 = global_1.member.member_10.member;
let _e313 = global_1.member.member_10.member_1;
let _e314 = (_e309 * _e313);
if (_e183 >= (_e314 * 4u)) {
let _e318 = bitcast<i32>((_e201 * _e309));
let _e320 = bitcast<i32>(_e199);
let _e325 = global_6.member[bitcast<u32>((_e318 + _e320))];
let _e331 = global_6.member[bitcast<u32>(((bitcast<i32>(_e314) + _e318) + _e320))];
let _e332 = f32(_e320);
let _e334 = f32(bitcast<i32>(_e201));
let _e340 = global_1.member.member_7.member;
let _e344 = global_1.member.member_10.member_8;
let _e345 = (_e340 - _e344);
let _e349 = global_1.member.member_10.member_2;
let _e353 = global_1.member.member_10.member_6;
let _e360 = global_1.member.member_10.member_4;
let _e362 = ((_e349 + (_e353 * _e345)) + (((_e332 - _e325) + 0.5f) * _e360));
let _e366 = global_1.member.member_10.member_3;
let _e370 = global_1.member.member_10.member_7;
let _e375 = ((_e366 + (_e370 * _e345)) + (((_e334 - _e331) + 0.5f) * _e360));
let _e379 = global_1.member.member_7.member_1;
let _e380 = (_e379 - _e344);
let _e385 = ((_e349 + (_e353 * _e380)) + ((_e332 + 0.5f) * _e360));
let _e390 = ((_e366 + (_e370 * _e380)) + ((_e334 + 0.5f) * _e360));
let _e396 = global_1.member.member_8.member.member;
let _e404 = (((_e396.member * _e396.member) + (_e396.member_1 * _e396.member_1)) + (_e396.member_2 * _e396.member_2));
let _e407 = sqrt(select(0f, _e404, (_e404 > 0f)));
let _e408 = ((1.5f * _e360) * _e407);
let _e412 = (select(1f, _e408, (_e408 < 1f)) + (1f / 64f));
let _e414 = select(_e412, 0.5f, (0.5f > _e412));
let _e418 = global_1.member.member_7.member_2;
let _e421 = (_e418 / select(1e-6f, _e271, (_e271 > 1e-6f)));
let _e425 = (_e385 + (_e249 * _e421));
let _e426 = (_e390 + (_e260 * _e421));
let _e427 = (_e379 + (_e271 * _e421));
let _e431 = global_1.member.member_8.member;
let _e442 = ((((_e431.member.member * _e362) + (_e431.member.member_1 * _e375)) + (_e431.member.member_2 * _e340)) + _e431.member_1);
let _e446 = global_1.member.member_8.member_1;
let _e457 = ((((_e446.member.member * _e362) + (_e446.member.member_1 * _e375)) + (_e446.member.member_2 * _e340)) + _e446.member_1);
let _e461 = global_1.member.member_8.member_2;
let _e472 = ((((_e461.member.member * _e362) + (_e461.member.member_1 * _e375)) + (_e461.member.member_2 * _e340)) + _e461.member_1);
let _e478 = ((((_e431.member.member * _e385) + (_e431.member.member_1 * _e390)) + (_e431.member.member_2 * _e379)) + _e431.member_1);
let _e484 = ((((_e446.member.member * _e385) + (_e446.member.member_1 * _e390)) + (_e446.member.member_2 * _e379)) + _e446.member_1);
let _e490 = ((((_e461.member.member * _e385) + (_e461.member.member_1 * _e390)) + (_e461.member.member_2 * _e379)) + _e461.member_1);
let _e495 = global_1.member.member_8.member_4.member;
let _e496 = (_e495 + 0.5f);
let _e502 = global_1.member.member_8.member_5.member;
let _e503 = (_e502 - 0.5f);
let _e510 = global_1.member.member_8.member_4.member_1;
let _e511 = (_e510 + 0.5f);
let _e518 = global_1.member.member_8.member_5.member_1;
let _e519 = (_e518 - 0.5f);
let _e526 = global_1.member.member_8.member_4.member_2;
let _e527 = (_e526 + 0.5f);
let _e534 = global_1.member.member_8.member_5.member_2;
let _e535 = (_e534 - 0.5f);
let _e549 = (((((((_e442 >= _e496) && (_e442 <= _e503)) && (_e457 >= _e511)) && (_e457 <= _e519)) && (_e472 >= _e527)) && (_e472 <= _e535)) && ((((((_e478 >= _e496) && (_e478 <= _e503)) && (_e484 >= _e511)) && (_e484 <= _e519)) && (_e490 >= _e527)) && (_e490 <= _e535)));
let _e558 = ((((_e191.member_2 == 1u) || (_e191.member_2 == 5u)) || (_e191.member_2 == 6u)) || ((_e191.member_2 == 2u) || (_e191.member_2 == 7u)));
if _e558 {
let _e559 = (_e495 + _e414);
let _e561 = (_e502 - _e414);
let _e564 = (_e510 + _e414);
let _e566 = (_e518 - _e414);
let _e570 = (_e526 + _e414);
let _e572 = (_e534 - _e414);
let _e575 = ((((_e442 >= _e559) && (_e442 <= _e561)) && ((_e457 >= _e564) && (_e457 <= _e566))) && ((_e472 >= _e570) && (_e472 <= _e572)));
let _e578 = global_1.member.member_1;
let _e580 = ((_e578 & 16u) == 0u);
if _e580 {
phi_958_ = _e575;
} else {
let _e585 = global_1.member.member_16.member;
let _e597 = -((_e414 / _e407));
let _e602 = global_1.member.member_16.member_1;
let _e608 = global_1.member.member_17.member;
let _e624 = global_1.member.member_17.member_1;
let _e631 = global_1.member.member_18.member;
let _e647 = global_1.member.member_18.member_1;
let _e654 = global_1.member.member_19.member;
let _e670 = global_1.member.member_19.member_1;
phi_958_ = (_e575 && (((((((((_e585.member.member * _e362) + (_e585.member.member_1 * _e375)) + (_e585.member.member_2 * _e340)) + _e585.member_1) <= _e597) || (_e602 == 0u)) && ((((((_e608.member.member * _e362) + (_e608.member.member_1 * _e375)) + (_e608.member.member_2 * _e340)) + _e608.member_1) <= _e597) || (_e624 == 0u))) && ((((((_e631.member.member * _e362) + (_e631.member.member_1 * _e375)) + (_e631.member.member_2 * _e340)) + _e631.member_1) <= _e597) || (_e647 == 0u))) && ((((((_e654.member.member * _e362) + (_e654.member.member_1 * _e375)) + (_e654.member.member_2 * _e340)) + _e654.member_1) <= _e597) || (_e670 == 0u))));
}
let _e676 = phi_958_;
let _e680 = (_e385 + (_e385 - _e362));
let _e681 = (_e390 + (_e390 - _e375));
let _e682 = (_e379 + (_e379 - _e340));
let _e688 = ((((_e431.member.member * _e680) + (_e431.member.member_1 * _e681)) + (_e431.member.member_2 * _e682)) + _e431.member_1);
let _e694 = ((((_e446.member.member * _e680) + (_e446.member.member_1 * _e681)) + (_e446.member.member_2 * _e682)) + _e446.member_1);
let _e700 = ((((_e461.member.member * _e680) + (_e461.member.member_1 * _e681)) + (_e461.member.member_2 * _e682)) + _e461.member_1);
let _e711 = ((((_e688 >= _e559) && (_e688 <= _e561)) && ((_e694 >= _e564) && (_e694 <= _e566))) && ((_e700 >= _e570) && (_e700 <= _e572)));
if _e580 {
phi_1148_ = _e711;
} else {
let _e716 = global_1.member.member_16.member;
let _e728 = -((_e414 / _e407));
let _e733 = global_1.member.member_16.member_1;
let _e739 = global_1.member.member_17.member;
let _e755 = global_1.member.member_17.member_1;
let _e762 = global_1.member.member_18.member;
let _e778 = global_1.member.member_18.member_1;
let _e785 = global_1.member.member_19.member;
let _e801 = global_1.member.member_19.member_1;
phi_1148_ = (_e711 && (((((((((_e716.member.member * _e680) + (_e716.member.member_1 * _e681)) + (_e716.member.member_2 * _e682)) + _e716.member_1) <= _e728) || (_e733 == 0u)) && ((((((_e739.member.member * _e680) + (_e739.member.member_1 * _e681)) + (_e739.member.member_2 * _e682)) + _e739.member_1) <= _e728) || (_e755 == 0u))) && ((((((_e762.member.member * _e680) + (_e762.member.member_1 * _e681)) + (_e762.member.member_2 * _e682)) + _e762.member_1) <= _e728) || (_e778 == 0u))) && ((((((_e785.member.member * _e680) + (_e785.member.member_1 * _e681)) + (_e785.member.member_2 * _e682)) + _e785.member_1) <= _e728) || (_e801 == 0u))));
}
let _e807 = phi_1148_;
phi_1151_ = (_e549 && (_e676 && _e807));
} else {
phi_1151_ = _e549;
}
let _e811 = phi_1151_;
let _e818 = ((((_e431.member.member * _e425) + (_e431.member.member_1 * _e426)) + (_e431.member.member_2 * _e427)) + _e431.member_1);
let _e824 = ((((_e446.member.member * _e425) + (_e446.member.member_1 * _e426)) + (_e446.member.member_2 * _e427)) + _e446.member_1);
let _e830 = ((((_e461.member.member * _e425) + (_e461.member.member_1 * _e426)) + (_e461.member.member_2 * _e427)) + _e461.member_1);
let _e847 = ((((_e818 >= (_e495 + _e414)) && (_e818 <= (_e502 - _e414))) && ((_e824 >= (_e510 + _e414)) && (_e824 <= (_e518 - _e414)))) && ((_e830 >= (_e526 + _e414)) && (_e830 <= (_e534 - _e414))));
let _e850 = global_1.member.member_1;
if ((_e850 & 16u) == 0u) {
phi_1345_ = _e847;
} else {
let _e857 = global_1.member.member_16.member;
let _e869 = -((_e414 / _e407));
let _e874 = global_1.member.member_16.member_1;
let _e880 = global_1.member.member_17.member;
let _e896 = global_1.member.member_17.member_1;
let _e903 = global_1.member.member_18.member;
let _e919 = global_1.member.member_18.member_1;
let _e926 = global_1.member.member_19.member;
let _e942 = global_1.member.member_19.member_1;
phi_1345_ = (_e847 && (((((((((_e857.member.member * _e425) + (_e857.member.member_1 * _e426)) + (_e857.member.member_2 * _e427)) + _e857.member_1) <= _e869) || (_e874 == 0u)) && ((((((_e880.member.member * _e425) + (_e880.member.member_1 * _e426)) + (_e880.member.member_2 * _e427)) + _e880.member_1) <= _e869) || (_e896 == 0u))) && ((((((_e903.member.member * _e425) + (_e903.member.member_1 * _e426)) + (_e903.member.member_2 * _e427)) + _e903.member_1) <= _e869) || (_e919 == 0u))) && ((((((_e926.member.member * _e425) + (_e926.member.member_1 * _e426)) + (_e926.member.member_2 * _e427)) + _e926.member_1) <= _e869) || (_e942 == 0u))));
}
let _e948 = phi_1345_;
let _e959 = global_1.member.member_8.member_6;
let _e961 = select(_e495, _e478, (_e478 > _e495));
let _e963 = select(_e502, _e961, (_e961 < _e502));
let _e965 = select(_e510, _e484, (_e484 > _e510));
let _e967 = select(_e518, _e965, (_e965 < _e518));
let _e969 = select(_e526, _e490, (_e490 > _e526));
let _e971 = select(_e534, _e969, (_e969 < _e534));
let _e977 = bitcast<f32>((bitcast<u32>((_e478 - _e442)) & 2147483647u));
let _e980 = bitcast<f32>((bitcast<u32>((_e484 - _e457)) & 2147483647u));
let _e982 = select(_e980, _e977, (_e977 > _e980));
let _e985 = bitcast<f32>((bitcast<u32>((_e490 - _e472)) & 2147483647u));
let _e994 = bitcast<f32>((bitcast<u32>((_e478 - _e963)) & 2147483647u));
let _e997 = bitcast<f32>((bitcast<u32>((_e484 - _e967)) & 2147483647u));
let _e999 = select(_e997, _e994, (_e994 > _e997));
let _e1002 = bitcast<f32>((bitcast<u32>((_e490 - _e971)) & 2147483647u));
let _e1010 = global_1.member.member_8.member_3.member;
let _e1011 = (_e963 + 0.5f);
let _e1012 = (_e1010 - 1f);
let _e1014 = select(0f, _e1011, (_e1011 > 0f));
let _e1016 = select(_e1012, _e1014, (_e1014 < _e1012));
let _e1023 = select(0i, select(select(i32(_e1016), i32(-2147483648), (_e1016 < -2147483600f)), 2147483647i, (_e1016 > 2147483500f)), (_e1016 == _e1016));
let _e1031 = global_1.member.member_8.member_14;
let _e1032 = (_e1031 & 31u);
let _e1039 = global_1.member.member_8.member_3.member_1;
let _e1040 = (_e967 + 0.5f);
let _e1041 = (_e1039 - 1f);
let _e1043 = select(0f, _e1040, (_e1040 > 0f));
let _e1045 = select(_e1041, _e1043, (_e1043 < _e1041));
let _e1052 = select(0i, select(select(i32(_e1045), i32(-2147483648), (_e1045 < -2147483600f)), 2147483647i, (_e1045 > 2147483500f)), (_e1045 == _e1045));
let _e1063 = global_1.member.member_8.member_3.member_2;
let _e1064 = (_e971 + 0.5f);
let _e1065 = (_e1063 - 1f);
let _e1067 = select(0f, _e1064, (_e1064 > 0f));
let _e1069 = select(_e1065, _e1067, (_e1067 < _e1065));
let _e1076 = select(0i, select(select(i32(_e1069), i32(-2147483648), (_e1069 < -2147483600f)), 2147483647i, (_e1069 > 2147483500f)), (_e1069 == _e1069));
let _e1087 = global_1.member.member_8.member_11.member;
let _e1093 = global_1.member.member_8.member_11.member_1;
let _e1098 = global_1.member.member_8.member_12;
let _e1104 = ((bitcast<i32>(_e1098) + ((_e1023 - select(0i, 1i, (_e1016 < f32(_e1023)))) >> bitcast<u32>(_e1032))) + (bitcast<i32>(_e1087) * (((_e1052 - select(0i, 1i, (_e1045 < f32(_e1052)))) >> bitcast<u32>(_e1032)) + (bitcast<i32>(_e1093) * ((_e1076 - select(0i, 1i, (_e1069 < f32(_e1076)))) >> bitcast<u32>(_e1032))))));
let _e1106 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1108 = select(_e1106, _e1104, (_e1104 < _e1106));
let _e1114 = global_5.member[bitcast<u32>(select(0i, _e1108, (_e1108 > 0i)))];
phi_1681_ = select(select(7u, 3u, ((_e811 && (!(_e558) || _e948)) && (true && ((_e850 & 1024u) == 0u)))), 1u, (((_e850 & 64u) != 0u) || ((((select(_e985, _e982, (_e982 > _e985)) <= _e959) && ((select(_e1002, _e999, (_e999 > _e1002)) > _e959) || (_e1114 != 0u))) && true) && ((_e850 & 32u) != 0u))));
} else {
phi_1681_ = 7u;
}
let _e1127 = phi_1681_;
if (_e1127 > 1u) {
let _e1132 = bitcast<i32>(((_e201 * _e309) + _e199));
let _e1135 = (bitcast<i32>(_e183) - 1i);
let _e1137 = select(_e1135, _e1132, (_e1132 < _e1135));
let _e1143 = global_6.member[bitcast<u32>(select(0i, _e1137, (_e1137 > 0i)))];
let _e1144 = (bitcast<i32>(_e314) + _e1132);
let _e1146 = select(_e1135, _e1144, (_e1144 < _e1135));
let _e1152 = global_6.member[bitcast<u32>(select(0i, _e1146, (_e1146 > 0i)))];
let _e1154 = f32(bitcast<i32>(_e199));
let _e1156 = f32(bitcast<i32>(_e201));
let _e1162 = global_1.member.member_7.member;
let _e1166 = global_1.member.member_10.member_8;
let _e1167 = (_e1162 - _e1166);
let _e1171 = global_1.member.member_10.member_2;
let _e1175 = global_1.member.member_10.member_6;
let _e1182 = global_1.member.member_10.member_4;
let _e1184 = ((_e1171 + (_e1175 * _e1167)) + (((_e1154 - _e1143) + 0.5f) * _e1182));
let _e1188 = global_1.member.member_10.member_3;
let _e1192 = global_1.member.member_10.member_7;
let _e1197 = ((_e1188 + (_e1192 * _e1167)) + (((_e1156 - _e1152) + 0.5f) * _e1182));
let _e1201 = global_1.member.member_7.member_1;
let _e1202 = (_e1201 - _e1166);
let _e1207 = ((_e1171 + (_e1175 * _e1202)) + ((_e1154 + 0.5f) * _e1182));
let _e1212 = ((_e1188 + (_e1192 * _e1202)) + ((_e1156 + 0.5f) * _e1182));
let _e1216 = global_1.member.member_8.member;
let _e1227 = ((((_e1216.member.member * _e1184) + (_e1216.member.member_1 * _e1197)) + (_e1216.member.member_2 * _e1162)) + _e1216.member_1);
let _e1231 = global_1.member.member_8.member_1;
let _e1242 = ((((_e1231.member.member * _e1184) + (_e1231.member.member_1 * _e1197)) + (_e1231.member.member_2 * _e1162)) + _e1231.member_1);
let _e1246 = global_1.member.member_8.member_2;
let _e1257 = ((((_e1246.member.member * _e1184) + (_e1246.member.member_1 * _e1197)) + (_e1246.member.member_2 * _e1162)) + _e1246.member_1);
let _e1263 = ((((_e1216.member.member * _e1207) + (_e1216.member.member_1 * _e1212)) + (_e1216.member.member_2 * _e1201)) + _e1216.member_1);
let _e1269 = ((((_e1231.member.member * _e1207) + (_e1231.member.member_1 * _e1212)) + (_e1231.member.member_2 * _e1201)) + _e1231.member_1);
let _e1275 = ((((_e1246.member.member * _e1207) + (_e1246.member.member_1 * _e1212)) + (_e1246.member.member_2 * _e1201)) + _e1246.member_1);
let _e1277 = (_e191.member_2 == 5u);
let _e1283 = ((_e191.member_2 == 2u) || (_e191.member_2 == 7u));
let _e1284 = ((((_e191.member_2 == 1u) || _e1277) || (_e191.member_2 == 6u)) || _e1283);
if _e1284 {
let _e1289 = global_1.member.member_8.member_4.member;
let _e1294 = global_1.member.member_8.member_5.member;
let _e1296 = select(_e1289, _e1263, (_e1263 > _e1289));
let _e1298 = select(_e1294, _e1296, (_e1296 < _e1294));
let _e1303 = global_1.member.member_8.member_4.member_1;
let _e1308 = global_1.member.member_8.member_5.member_1;
let _e1310 = select(_e1303, _e1269, (_e1269 > _e1303));
let _e1312 = select(_e1308, _e1310, (_e1310 < _e1308));
let _e1317 = global_1.member.member_8.member_4.member_2;
let _e1322 = global_1.member.member_8.member_5.member_2;
let _e1324 = select(_e1317, _e1275, (_e1275 > _e1317));
let _e1326 = select(_e1322, _e1324, (_e1324 < _e1322));
let _e1331 = global_1.member.member_8.member_15;
if (_e1331 == 0u) {
phi_2054_ = vec3<f32>(_e1298, _e1312, _e1326);
} else {
let _e1333 = (_e1298 + 0.5f);
let _e1338 = global_1.member.member_8.member_3.member;
let _e1339 = (_e1338 - 1f);
let _e1341 = select(0f, _e1333, (_e1333 > 0f));
let _e1343 = select(_e1339, _e1341, (_e1341 < _e1339));
let _e1350 = select(0i, select(select(i32(_e1343), i32(-2147483648), (_e1343 < -2147483600f)), 2147483647i, (_e1343 > 2147483500f)), (_e1343 == _e1343));
let _e1356 = (_e1312 + 0.5f);
let _e1361 = global_1.member.member_8.member_3.member_1;
let _e1362 = (_e1361 - 1f);
let _e1364 = select(0f, _e1356, (_e1356 > 0f));
let _e1366 = select(_e1362, _e1364, (_e1364 < _e1362));
let _e1373 = select(0i, select(select(i32(_e1366), i32(-2147483648), (_e1366 < -2147483600f)), 2147483647i, (_e1366 > 2147483500f)), (_e1366 == _e1366));
let _e1379 = (_e1326 + 0.5f);
let _e1384 = global_1.member.member_8.member_3.member_2;
let _e1385 = (_e1384 - 1f);
let _e1387 = select(0f, _e1379, (_e1379 > 0f));
let _e1389 = select(_e1385, _e1387, (_e1387 < _e1385));
let _e1396 = select(0i, select(select(i32(_e1389), i32(-2147483648), (_e1389 < -2147483600f)), 2147483647i, (_e1389 > 2147483500f)), (_e1389 == _e1389));
phi_2054_ = vec3<f32>(f32((_e1350 - select(0i, 1i, (_e1343 < f32(_e1350))))), f32((_e1373 - select(0i, 1i, (_e1366 < f32(_e1373))))), f32((_e1396 - select(0i, 1i, (_e1389 < f32(_e1396))))));
}
let _e1404 = phi_2054_;
let _e1410 = global_1.member.member_8.member_3.member;
let _e1412 = select(-1f, _e1404.x, (_e1404.x > -1f));
let _e1414 = select(_e1410, _e1412, (_e1412 < _e1410));
let _e1421 = select(0i, select(select(i32(_e1414), i32(-2147483648), (_e1414 < -2147483600f)), 2147483647i, (_e1414 > 2147483500f)), (_e1414 == _e1414));
let _e1425 = (_e1421 - select(0i, 1i, (_e1414 < f32(_e1421))));
let _e1431 = global_1.member.member_8.member_3.member_1;
let _e1433 = select(-1f, _e1404.y, (_e1404.y > -1f));
let _e1435 = select(_e1431, _e1433, (_e1433 < _e1431));
let _e1442 = select(0i, select(select(i32(_e1435), i32(-2147483648), (_e1435 < -2147483600f)), 2147483647i, (_e1435 > 2147483500f)), (_e1435 == _e1435));
let _e1446 = (_e1442 - select(0i, 1i, (_e1435 < f32(_e1442))));
let _e1452 = global_1.member.member_8.member_3.member_2;
let _e1454 = select(-1f, _e1404.z, (_e1404.z > -1f));
let _e1456 = select(_e1452, _e1454, (_e1454 < _e1452));
let _e1463 = select(0i, select(select(i32(_e1456), i32(-2147483648), (_e1456 < -2147483600f)), 2147483647i, (_e1456 > 2147483500f)), (_e1456 == _e1456));
let _e1467 = (_e1463 - select(0i, 1i, (_e1456 < f32(_e1463))));
let _e1471 = global_1.member.member_8.member_9;
let _e1475 = global_1.member.member_8.member_10;
let _e1476 = (_e1425 + 1i);
let _e1477 = (_e1446 + 1i);
let _e1478 = (_e1467 + 1i);
let _e1483 = global_1.member.member_8.member_13.member;
let _e1489 = global_1.member.member_8.member_13.member_1;
let _e1500 = ((_e1476 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1483) * ((_e1477 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1489) * (_e1478 >> bitcast<u32>(4i))))));
let _e1502 = (bitcast<i32>(_e176) - 1i);
let _e1504 = select(_e1502, _e1500, (_e1500 < _e1502));
let _e1510 = global_2.member[bitcast<u32>(select(0i, _e1504, (_e1504 > 0i)))];
let _e1512 = (_e1476 & 15i);
let _e1515 = ((_e1477 & 15i) * _e1471);
let _e1517 = (bitcast<i32>(_e1510) + ((_e1478 & 15i) * _e1475));
let _e1518 = (_e1515 + _e1471);
let _e1520 = (_e1515 + (2i * _e1471));
let _e1522 = (_e1515 + (3i * _e1471));
let _e1523 = (_e1517 + _e1475);
let _e1525 = (_e1517 + (2i * _e1475));
let _e1527 = (_e1517 + (3i * _e1475));
local_28 = type_30(array<i32, 4>(_e1512, _e1512, _e1512, _e1512), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_29 = (_e1404 - vec3<f32>(f32(_e1425), f32(_e1446), f32(_e1467)));
let _e1539 = local_28.member[0u];
let _e1540 = ((_e1523 + _e1518) + _e1539);
let _e1542 = (_e1540 >> bitcast<u32>(2i));
let _e1545 = bitcast<u32>(((_e1540 & 3i) * 8i));
let _e1547 = select(_e1502, _e1542, (_e1542 < _e1502));
let _e1552 = global_2.member[bitcast<u32>(select(0i, _e1547, (_e1547 > 0i)))];
let _e1556 = (_e1542 + 1i);
let _e1558 = select(_e1502, _e1556, (_e1556 < _e1502));
let _e1563 = global_2.member[bitcast<u32>(select(0i, _e1558, (_e1558 > 0i)))];
let _e1570 = ((_e1552 >> bitcast<u32>((_e1545 & 31u))) | ((_e1563 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1545) & 31u))));
let _e1573 = local_28.member_1[0u];
let _e1579 = f32(bitcast<i32>(((_e1570 >> bitcast<u32>((_e1573 & 31u))) & 255u)));
let _e1582 = local_28.member_1[1u];
let _e1588 = f32(bitcast<i32>(((_e1570 >> bitcast<u32>((_e1582 & 31u))) & 255u)));
let _e1591 = local_28.member_1[2u];
let _e1597 = f32(bitcast<i32>(((_e1570 >> bitcast<u32>((_e1591 & 31u))) & 255u)));
let _e1600 = local_28.member_1[3u];
let _e1607 = local_29[0u];
let _e1610 = (_e1579 + ((_e1588 - _e1579) * _e1607));
let _e1611 = local_29[0u];
let _e1614 = (_e1588 + ((_e1597 - _e1588) * _e1611));
let _e1615 = local_29[0u];
let _e1618 = (_e1597 + ((f32(bitcast<i32>(((_e1570 >> bitcast<u32>((_e1600 & 31u))) & 255u))) - _e1597) * _e1615));
let _e1620 = local_28.member[0u];
let _e1621 = ((_e1523 + _e1520) + _e1620);
let _e1623 = (_e1621 >> bitcast<u32>(2i));
let _e1626 = bitcast<u32>(((_e1621 & 3i) * 8i));
let _e1628 = select(_e1502, _e1623, (_e1623 < _e1502));
let _e1633 = global_2.member[bitcast<u32>(select(0i, _e1628, (_e1628 > 0i)))];
let _e1637 = (_e1623 + 1i);
let _e1639 = select(_e1502, _e1637, (_e1637 < _e1502));
let _e1644 = global_2.member[bitcast<u32>(select(0i, _e1639, (_e1639 > 0i)))];
let _e1651 = ((_e1633 >> bitcast<u32>((_e1626 & 31u))) | ((_e1644 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1626) & 31u))));
let _e1652 = local_28.member_1[0u];
let _e1658 = f32(bitcast<i32>(((_e1651 >> bitcast<u32>((_e1652 & 31u))) & 255u)));
let _e1659 = local_28.member_1[1u];
let _e1665 = f32(bitcast<i32>(((_e1651 >> bitcast<u32>((_e1659 & 31u))) & 255u)));
let _e1666 = local_28.member_1[2u];
let _e1672 = f32(bitcast<i32>(((_e1651 >> bitcast<u32>((_e1666 & 31u))) & 255u)));
let _e1673 = local_28.member_1[3u];
let _e1680 = local_29[0u];
let _e1684 = local_29[0u];
let _e1687 = (_e1665 + ((_e1672 - _e1665) * _e1684));
let _e1688 = local_29[0u];
let _e1693 = local_28.member[0u];
let _e1694 = ((_e1525 + _e1518) + _e1693);
let _e1696 = (_e1694 >> bitcast<u32>(2i));
let _e1699 = bitcast<u32>(((_e1694 & 3i) * 8i));
let _e1701 = select(_e1502, _e1696, (_e1696 < _e1502));
let _e1706 = global_2.member[bitcast<u32>(select(0i, _e1701, (_e1701 > 0i)))];
let _e1710 = (_e1696 + 1i);
let _e1712 = select(_e1502, _e1710, (_e1710 < _e1502));
let _e1717 = global_2.member[bitcast<u32>(select(0i, _e1712, (_e1712 > 0i)))];
let _e1724 = ((_e1706 >> bitcast<u32>((_e1699 & 31u))) | ((_e1717 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1699) & 31u))));
let _e1725 = local_28.member_1[0u];
let _e1731 = f32(bitcast<i32>(((_e1724 >> bitcast<u32>((_e1725 & 31u))) & 255u)));
let _e1732 = local_28.member_1[1u];
let _e1738 = f32(bitcast<i32>(((_e1724 >> bitcast<u32>((_e1732 & 31u))) & 255u)));
let _e1739 = local_28.member_1[2u];
let _e1745 = f32(bitcast<i32>(((_e1724 >> bitcast<u32>((_e1739 & 31u))) & 255u)));
let _e1746 = local_28.member_1[3u];
let _e1753 = local_29[0u];
let _e1756 = (_e1731 + ((_e1738 - _e1731) * _e1753));
let _e1757 = local_29[0u];
let _e1760 = (_e1738 + ((_e1745 - _e1738) * _e1757));
let _e1761 = local_29[0u];
let _e1764 = (_e1745 + ((f32(bitcast<i32>(((_e1724 >> bitcast<u32>((_e1746 & 31u))) & 255u))) - _e1745) * _e1761));
let _e1766 = local_28.member[0u];
let _e1767 = ((_e1525 + _e1520) + _e1766);
let _e1769 = (_e1767 >> bitcast<u32>(2i));
let _e1772 = bitcast<u32>(((_e1767 & 3i) * 8i));
let _e1774 = select(_e1502, _e1769, (_e1769 < _e1502));
let _e1779 = global_2.member[bitcast<u32>(select(0i, _e1774, (_e1774 > 0i)))];
let _e1783 = (_e1769 + 1i);
let _e1785 = select(_e1502, _e1783, (_e1783 < _e1502));
let _e1790 = global_2.member[bitcast<u32>(select(0i, _e1785, (_e1785 > 0i)))];
let _e1797 = ((_e1779 >> bitcast<u32>((_e1772 & 31u))) | ((_e1790 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1772) & 31u))));
let _e1798 = local_28.member_1[0u];
let _e1804 = f32(bitcast<i32>(((_e1797 >> bitcast<u32>((_e1798 & 31u))) & 255u)));
let _e1805 = local_28.member_1[1u];
let _e1811 = f32(bitcast<i32>(((_e1797 >> bitcast<u32>((_e1805 & 31u))) & 255u)));
let _e1812 = local_28.member_1[2u];
let _e1818 = f32(bitcast<i32>(((_e1797 >> bitcast<u32>((_e1812 & 31u))) & 255u)));
let _e1819 = local_28.member_1[3u];
let _e1826 = local_29[0u];
let _e1830 = local_29[0u];
let _e1833 = (_e1811 + ((_e1818 - _e1811) * _e1830));
let _e1834 = local_29[0u];
let _e1839 = local_28.member[0u];
let _e1840 = ((_e1523 + _e1515) + _e1839);
let _e1842 = (_e1840 >> bitcast<u32>(2i));
let _e1845 = bitcast<u32>(((_e1840 & 3i) * 8i));
let _e1847 = select(_e1502, _e1842, (_e1842 < _e1502));
let _e1852 = global_2.member[bitcast<u32>(select(0i, _e1847, (_e1847 > 0i)))];
let _e1856 = (_e1842 + 1i);
let _e1858 = select(_e1502, _e1856, (_e1856 < _e1502));
let _e1863 = global_2.member[bitcast<u32>(select(0i, _e1858, (_e1858 > 0i)))];
let _e1870 = ((_e1852 >> bitcast<u32>((_e1845 & 31u))) | ((_e1863 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1845) & 31u))));
let _e1871 = local_28.member_1[1u];
let _e1877 = f32(bitcast<i32>(((_e1870 >> bitcast<u32>((_e1871 & 31u))) & 255u)));
let _e1878 = local_28.member_1[2u];
let _e1885 = local_29[0u];
let _e1888 = (_e1877 + ((f32(bitcast<i32>(((_e1870 >> bitcast<u32>((_e1878 & 31u))) & 255u))) - _e1877) * _e1885));
let _e1890 = local_28.member[0u];
let _e1891 = ((_e1523 + _e1522) + _e1890);
let _e1893 = (_e1891 >> bitcast<u32>(2i));
let _e1896 = bitcast<u32>(((_e1891 & 3i) * 8i));
let _e1898 = select(_e1502, _e1893, (_e1893 < _e1502));
let _e1903 = global_2.member[bitcast<u32>(select(0i, _e1898, (_e1898 > 0i)))];
let _e1907 = (_e1893 + 1i);
let _e1909 = select(_e1502, _e1907, (_e1907 < _e1502));
let _e1914 = global_2.member[bitcast<u32>(select(0i, _e1909, (_e1909 > 0i)))];
let _e1921 = ((_e1903 >> bitcast<u32>((_e1896 & 31u))) | ((_e1914 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1896) & 31u))));
let _e1922 = local_28.member_1[1u];
let _e1928 = f32(bitcast<i32>(((_e1921 >> bitcast<u32>((_e1922 & 31u))) & 255u)));
let _e1929 = local_28.member_1[2u];
let _e1936 = local_29[0u];
let _e1941 = local_28.member[0u];
let _e1942 = ((_e1525 + _e1515) + _e1941);
let _e1944 = (_e1942 >> bitcast<u32>(2i));
let _e1947 = bitcast<u32>(((_e1942 & 3i) * 8i));
let _e1949 = select(_e1502, _e1944, (_e1944 < _e1502));
let _e1954 = global_2.member[bitcast<u32>(select(0i, _e1949, (_e1949 > 0i)))];
let _e1958 = (_e1944 + 1i);
let _e1960 = select(_e1502, _e1958, (_e1958 < _e1502));
let _e1965 = global_2.member[bitcast<u32>(select(0i, _e1960, (_e1960 > 0i)))];
let _e1972 = ((_e1954 >> bitcast<u32>((_e1947 & 31u))) | ((_e1965 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1947) & 31u))));
let _e1973 = local_28.member_1[1u];
let _e1979 = f32(bitcast<i32>(((_e1972 >> bitcast<u32>((_e1973 & 31u))) & 255u)));
let _e1980 = local_28.member_1[2u];
let _e1987 = local_29[0u];
let _e1990 = (_e1979 + ((f32(bitcast<i32>(((_e1972 >> bitcast<u32>((_e1980 & 31u))) & 255u))) - _e1979) * _e1987));
let _e1992 = local_28.member[0u];
let _e1993 = ((_e1525 + _e1522) + _e1992);
let _e1995 = (_e1993 >> bitcast<u32>(2i));
let _e1998 = bitcast<u32>(((_e1993 & 3i) * 8i));
let _e2000 = select(_e1502, _e1995, (_e1995 < _e1502));
let _e2005 = global_2.member[bitcast<u32>(select(0i, _e2000, (_e2000 > 0i)))];
let _e2009 = (_e1995 + 1i);
let _e2011 = select(_e1502, _e2009, (_e2009 < _e1502));
let _e2016 = global_2.member[bitcast<u32>(select(0i, _e2011, (_e2011 > 0i)))];
let _e2023 = ((_e2005 >> bitcast<u32>((_e1998 & 31u))) | ((_e2016 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1998) & 31u))));
let _e2024 = local_28.member_1[1u];
let _e2030 = f32(bitcast<i32>(((_e2023 >> bitcast<u32>((_e2024 & 31u))) & 255u)));
let _e2031 = local_28.member_1[2u];
let _e2038 = local_29[0u];
let _e2043 = local_28.member[0u];
let _e2044 = ((_e1517 + _e1518) + _e2043);
let _e2046 = (_e2044 >> bitcast<u32>(2i));
let _e2049 = bitcast<u32>(((_e2044 & 3i) * 8i));
let _e2051 = select(_e1502, _e2046, (_e2046 < _e1502));
let _e2056 = global_2.member[bitcast<u32>(select(0i, _e2051, (_e2051 > 0i)))];
let _e2060 = (_e2046 + 1i);
let _e2062 = select(_e1502, _e2060, (_e2060 < _e1502));
let _e2067 = global_2.member[bitcast<u32>(select(0i, _e2062, (_e2062 > 0i)))];
let _e2074 = ((_e2056 >> bitcast<u32>((_e2049 & 31u))) | ((_e2067 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2049) & 31u))));
let _e2075 = local_28.member_1[1u];
let _e2081 = f32(bitcast<i32>(((_e2074 >> bitcast<u32>((_e2075 & 31u))) & 255u)));
let _e2082 = local_28.member_1[2u];
let _e2089 = local_29[0u];
let _e2092 = (_e2081 + ((f32(bitcast<i32>(((_e2074 >> bitcast<u32>((_e2082 & 31u))) & 255u))) - _e2081) * _e2089));
let _e2094 = local_28.member[0u];
let _e2095 = ((_e1527 + _e1518) + _e2094);
let _e2097 = (_e2095 >> bitcast<u32>(2i));
let _e2100 = bitcast<u32>(((_e2095 & 3i) * 8i));
let _e2102 = select(_e1502, _e2097, (_e2097 < _e1502));
let _e2107 = global_2.member[bitcast<u32>(select(0i, _e2102, (_e2102 > 0i)))];
let _e2111 = (_e2097 + 1i);
let _e2113 = select(_e1502, _e2111, (_e2111 < _e1502));
let _e2118 = global_2.member[bitcast<u32>(select(0i, _e2113, (_e2113 > 0i)))];
let _e2125 = ((_e2107 >> bitcast<u32>((_e2100 & 31u))) | ((_e2118 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2100) & 31u))));
let _e2126 = local_28.member_1[1u];
let _e2132 = f32(bitcast<i32>(((_e2125 >> bitcast<u32>((_e2126 & 31u))) & 255u)));
let _e2133 = local_28.member_1[2u];
let _e2140 = local_29[0u];
let _e2143 = (_e2132 + ((f32(bitcast<i32>(((_e2125 >> bitcast<u32>((_e2133 & 31u))) & 255u))) - _e2132) * _e2140));
let _e2145 = local_28.member[0u];
let _e2146 = ((_e1517 + _e1520) + _e2145);
let _e2148 = (_e2146 >> bitcast<u32>(2i));
let _e2151 = bitcast<u32>(((_e2146 & 3i) * 8i));
let _e2153 = select(_e1502, _e2148, (_e2148 < _e1502));
let _e2158 = global_2.member[bitcast<u32>(select(0i, _e2153, (_e2153 > 0i)))];
let _e2162 = (_e2148 + 1i);
let _e2164 = select(_e1502, _e2162, (_e2162 < _e1502));
let _e2169 = global_2.member[bitcast<u32>(select(0i, _e2164, (_e2164 > 0i)))];
let _e2176 = ((_e2158 >> bitcast<u32>((_e2151 & 31u))) | ((_e2169 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2151) & 31u))));
let _e2177 = local_28.member_1[1u];
let _e2183 = f32(bitcast<i32>(((_e2176 >> bitcast<u32>((_e2177 & 31u))) & 255u)));
let _e2184 = local_28.member_1[2u];
let _e2191 = local_29[0u];
let _e2196 = local_28.member[0u];
let _e2197 = ((_e1527 + _e1520) + _e2196);
let _e2199 = (_e2197 >> bitcast<u32>(2i));
let _e2202 = bitcast<u32>(((_e2197 & 3i) * 8i));
let _e2204 = select(_e1502, _e2199, (_e2199 < _e1502));
let _e2209 = global_2.member[bitcast<u32>(select(0i, _e2204, (_e2204 > 0i)))];
let _e2213 = (_e2199 + 1i);
let _e2215 = select(_e1502, _e2213, (_e2213 < _e1502));
let _e2220 = global_2.member[bitcast<u32>(select(0i, _e2215, (_e2215 > 0i)))];
let _e2227 = ((_e2209 >> bitcast<u32>((_e2202 & 31u))) | ((_e2220 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2202) & 31u))));
let _e2228 = local_28.member_1[1u];
let _e2234 = f32(bitcast<i32>(((_e2227 >> bitcast<u32>((_e2228 & 31u))) & 255u)));
let _e2235 = local_28.member_1[2u];
let _e2242 = local_29[0u];
let _e2247 = local_29[1u];
let _e2250 = (_e1614 + ((_e1687 - _e1614) * _e2247));
let _e2251 = local_29[1u];
let _e2254 = (_e1760 + ((_e1833 - _e1760) * _e2251));
let _e2255 = local_29[1u];
let _e2258 = (_e1610 + (((_e1658 + ((_e1665 - _e1658) * _e1680)) - _e1610) * _e2255));
let _e2259 = local_29[1u];
let _e2264 = local_29[2u];
let _e2268 = local_29[1u];
let _e2271 = (_e1618 + (((_e1672 + ((f32(bitcast<i32>(((_e1651 >> bitcast<u32>((_e1673 & 31u))) & 255u))) - _e1672) * _e1688)) - _e1618) * _e2268));
let _e2272 = local_29[1u];
let _e2276 = local_29[2u];
let _e2280 = local_29[1u];
let _e2283 = (_e1888 + ((_e1614 - _e1888) * _e2280));
let _e2284 = local_29[1u];
let _e2288 = local_29[2u];
let _e2292 = local_29[1u];
let _e2295 = (_e1687 + (((_e1928 + ((f32(bitcast<i32>(((_e1921 >> bitcast<u32>((_e1929 & 31u))) & 255u))) - _e1928) * _e1936)) - _e1687) * _e2292));
let _e2296 = local_29[1u];
let _e2300 = local_29[2u];
let _e2304 = local_29[1u];
let _e2307 = (_e2092 + (((_e2183 + ((f32(bitcast<i32>(((_e2176 >> bitcast<u32>((_e2184 & 31u))) & 255u))) - _e2183) * _e2191)) - _e2092) * _e2304));
let _e2308 = local_29[2u];
let _e2312 = local_29[1u];
let _e2316 = local_29[2u];
let _e2320 = local_29[2u];
let _e2327 = global_1.member.member_8.member_8;
let _e2331 = global_1.member.member_8.member_7;
let _e2333 = (((_e2250 + ((_e2254 - _e2250) * _e2320)) - _e2327) * _e2331);
let _e2334 = -(1e9f);
let _e2336 = select(_e2334, _e2333, (_e2333 > _e2334));
let _e2338 = select(1e9f, _e2336, (_e2336 < 1e9f));
let _e2340 = (((_e2258 + (((_e1756 + (((_e1804 + ((_e1811 - _e1804) * _e1826)) - _e1756) * _e2259)) - _e2258) * _e2264)) - _e2327) * _e2331);
let _e2342 = select(_e2334, _e2340, (_e2340 > _e2334));
let _e2344 = select(1e9f, _e2342, (_e2342 < 1e9f));
let _e2346 = (((_e2271 + (((_e1764 + (((_e1818 + ((f32(bitcast<i32>(((_e1797 >> bitcast<u32>((_e1819 & 31u))) & 255u))) - _e1818) * _e1834)) - _e1764) * _e2272)) - _e2271) * _e2276)) - _e2327) * _e2331);
let _e2348 = select(_e2334, _e2346, (_e2346 > _e2334));
let _e2350 = select(1e9f, _e2348, (_e2348 < 1e9f));
let _e2352 = (((_e2283 + (((_e1990 + ((_e1760 - _e1990) * _e2284)) - _e2283) * _e2288)) - _e2327) * _e2331);
let _e2354 = select(_e2334, _e2352, (_e2352 > _e2334));
let _e2356 = select(1e9f, _e2354, (_e2354 < 1e9f));
let _e2358 = (((_e2295 + (((_e1833 + (((_e2030 + ((f32(bitcast<i32>(((_e2023 >> bitcast<u32>((_e2031 & 31u))) & 255u))) - _e2030) * _e2038)) - _e1833) * _e2296)) - _e2295) * _e2300)) - _e2327) * _e2331);
let _e2360 = select(_e2334, _e2358, (_e2358 > _e2334));
let _e2362 = select(1e9f, _e2360, (_e2360 < 1e9f));
let _e2364 = (((_e2307 + ((_e2250 - _e2307) * _e2308)) - _e2327) * _e2331);
let _e2366 = select(_e2334, _e2364, (_e2364 > _e2334));
let _e2368 = select(1e9f, _e2366, (_e2366 < 1e9f));
let _e2370 = (((_e2254 + (((_e2143 + (((_e2234 + ((f32(bitcast<i32>(((_e2227 >> bitcast<u32>((_e2235 & 31u))) & 255u))) - _e2234) * _e2242)) - _e2143) * _e2312)) - _e2254) * _e2316)) - _e2327) * _e2331);
let _e2372 = select(_e2334, _e2370, (_e2370 > _e2334));
let _e2374 = select(1e9f, _e2372, (_e2372 < 1e9f));
local_26 = _e2338;
let _e2375 = local_26;
local_27 = _e2375;
let _e2376 = local_27;
let _e2378 = (bitcast<i32>(_e181) - 1i);
let _e2380 = select(_e2378, 263197i, (263197i < _e2378));
let _e2385 = global_3.member[bitcast<u32>(select(0i, _e2380, (_e2380 > 0i)))];
let _e2386 = bitcast<f32>(_e2385);
let _e2388 = select(_e2378, 263198i, (263198i < _e2378));
let _e2391 = bitcast<u32>(select(0i, _e2388, (_e2388 > 0i)));
let _e2393 = global_3.member[_e2391];
let _e2394 = bitcast<f32>(_e2393);
let _e2396 = select(_e2378, 263199i, (263199i < _e2378));
let _e2401 = global_3.member[bitcast<u32>(select(0i, _e2396, (_e2396 > 0i)))];
let _e2402 = bitcast<f32>(_e2401);
let _e2404 = ((_e2376 - _e2386) * _e2394);
let _e2406 = select(0f, _e2404, (_e2404 > 0f));
let _e2409 = local_27;
let _e2411 = select(_e2378, 263200i, (263200i < _e2378));
let _e2416 = global_3.member[bitcast<u32>(select(0i, _e2411, (_e2411 > 0i)))];
let _e2417 = bitcast<f32>(_e2416);
let _e2419 = select(_e2378, 263201i, (263201i < _e2378));
let _e2424 = global_3.member[bitcast<u32>(select(0i, _e2419, (_e2419 > 0i)))];
let _e2425 = bitcast<f32>(_e2424);
let _e2427 = select(_e2378, 263202i, (263202i < _e2378));
let _e2432 = global_3.member[bitcast<u32>(select(0i, _e2427, (_e2427 > 0i)))];
let _e2433 = bitcast<f32>(_e2432);
let _e2435 = ((_e2409 - _e2417) * _e2425);
let _e2437 = select(0f, _e2435, (_e2435 > 0f));
let _e2441 = local_27;
let _e2443 = select(_e2378, 263203i, (263203i < _e2378));
let _e2448 = global_3.member[bitcast<u32>(select(0i, _e2443, (_e2443 > 0i)))];
let _e2449 = bitcast<f32>(_e2448);
let _e2451 = select(_e2378, 263204i, (263204i < _e2378));
let _e2456 = global_3.member[bitcast<u32>(select(0i, _e2451, (_e2451 > 0i)))];
let _e2457 = bitcast<f32>(_e2456);
let _e2459 = select(_e2378, 263205i, (263205i < _e2378));
let _e2464 = global_3.member[bitcast<u32>(select(0i, _e2459, (_e2459 > 0i)))];
let _e2465 = bitcast<f32>(_e2464);
let _e2467 = ((_e2441 - _e2449) * _e2457);
let _e2469 = select(0f, _e2467, (_e2467 > 0f));
let _e2472 = local_27;
let _e2474 = select(_e2378, 263206i, (263206i < _e2378));
let _e2479 = global_3.member[bitcast<u32>(select(0i, _e2474, (_e2474 > 0i)))];
let _e2480 = bitcast<f32>(_e2479);
let _e2482 = select(_e2378, 263207i, (263207i < _e2378));
let _e2487 = global_3.member[bitcast<u32>(select(0i, _e2482, (_e2482 > 0i)))];
let _e2488 = bitcast<f32>(_e2487);
let _e2490 = select(_e2378, 263208i, (263208i < _e2378));
let _e2495 = global_3.member[bitcast<u32>(select(0i, _e2490, (_e2490 > 0i)))];
let _e2496 = bitcast<f32>(_e2495);
let _e2498 = ((_e2472 - _e2480) * _e2488);
let _e2500 = select(0f, _e2498, (_e2498 > 0f));
let _e2504 = ((select(_e2402, _e2406, (_e2406 < _e2402)) + select(_e2433, _e2437, (_e2437 < _e2433))) + (select(_e2465, _e2469, (_e2469 < _e2465)) + select(_e2496, _e2500, (_e2500 < _e2496))));
let _e2506 = select(0f, _e2504, (_e2504 > 0f));
let _e2508 = select(1023f, _e2506, (_e2506 < 1023f));
let _e2515 = select(0i, select(select(i32(_e2508), i32(-2147483648), (_e2508 < -2147483600f)), 2147483647i, (_e2508 > 2147483500f)), (_e2508 == _e2508));
let _e2519 = (_e2515 - select(0i, 1i, (_e2508 < f32(_e2515))));
let _e2520 = (262147i + _e2519);
let _e2522 = select(_e2378, _e2520, (_e2520 < _e2378));
let _e2528 = global_3.member[bitcast<u32>(select(0i, _e2522, (_e2522 > 0i)))];
let _e2538 = select(_e2378, 262146i, (262146i < _e2378));
let _e2544 = global_3.member[bitcast<u32>(select(0i, _e2538, (_e2538 > 0i)))];
let _e2545 = bitcast<f32>(_e2544);
let _e2546 = (f32((bitcast<i32>((_e2528 & 4095u)) - 2048i)) * _e2545);
let _e2548 = select(_e2378, 262144i, (262144i < _e2378));
let _e2554 = global_3.member[bitcast<u32>(select(0i, _e2548, (_e2548 > 0i)))];
let _e2555 = bitcast<f32>(_e2554);
let _e2557 = select(_e2378, 262145i, (262145i < _e2378));
let _e2563 = global_3.member[bitcast<u32>(select(0i, _e2557, (_e2557 > 0i)))];
let _e2564 = bitcast<f32>(_e2563);
let _e2570 = ((_e2555 + (f32(bitcast<i32>((_e2528 >> bitcast<u32>(12u)))) * _e2564)) + (_e2546 * (_e2504 - f32(_e2519))));
let _e2573 = global_3.member[_e2391];
let _e2575 = local_26;
let _e2578 = local_26;
let _e2581 = local_26;
let _e2585 = select(_e2378, 263209i, (263209i < _e2378));
let _e2591 = global_3.member[bitcast<u32>(select(0i, _e2585, (_e2585 > 0i)))];
let _e2593 = local_26;
let _e2596 = select(_e2378, 263210i, (263210i < _e2378));
let _e2602 = global_3.member[bitcast<u32>(select(0i, _e2596, (_e2596 > 0i)))];
let _e2604 = local_26;
let _e2608 = (_e2546 * select(0f, select(select(select(bitcast<f32>(_e2573), _e2425, (_e2575 >= _e2417)), _e2457, (_e2578 >= _e2449)), _e2488, (_e2581 >= _e2480)), ((_e2593 >= bitcast<f32>(_e2591)) && (_e2604 <= bitcast<f32>(_e2602)))));
if _e1283 {
let _e2615 = ((0.5f * (_e2350 - _e2344)) * _e2608);
let _e2616 = ((0.5f * (_e2362 - _e2356)) * _e2608);
let _e2617 = ((0.5f * (_e2374 - _e2368)) * _e2608);
phi_7375_ = type_34(_e2570, vec3<f32>(_e2615, _e2616, _e2617), vec3<f32>((_e2615 * _e2570), (_e2616 * _e2570), (_e2617 * _e2570)));
} else {
local_24 = _e2344;
let _e2624 = local_24;
local_25 = _e2624;
let _e2625 = local_25;
let _e2627 = ((_e2625 - _e2386) * _e2394);
let _e2629 = select(0f, _e2627, (_e2627 > 0f));
let _e2632 = local_25;
let _e2634 = ((_e2632 - _e2417) * _e2425);
let _e2636 = select(0f, _e2634, (_e2634 > 0f));
let _e2640 = local_25;
let _e2642 = ((_e2640 - _e2449) * _e2457);
let _e2644 = select(0f, _e2642, (_e2642 > 0f));
let _e2647 = local_25;
let _e2649 = ((_e2647 - _e2480) * _e2488);
let _e2651 = select(0f, _e2649, (_e2649 > 0f));
let _e2655 = ((select(_e2402, _e2629, (_e2629 < _e2402)) + select(_e2433, _e2636, (_e2636 < _e2433))) + (select(_e2465, _e2644, (_e2644 < _e2465)) + select(_e2496, _e2651, (_e2651 < _e2496))));
let _e2657 = select(0f, _e2655, (_e2655 > 0f));
let _e2659 = select(1023f, _e2657, (_e2657 < 1023f));
let _e2666 = select(0i, select(select(i32(_e2659), i32(-2147483648), (_e2659 < -2147483600f)), 2147483647i, (_e2659 > 2147483500f)), (_e2659 == _e2659));
let _e2670 = (_e2666 - select(0i, 1i, (_e2659 < f32(_e2666))));
let _e2671 = (262147i + _e2670);
let _e2673 = select(_e2378, _e2671, (_e2671 < _e2378));
let _e2679 = global_3.member[bitcast<u32>(select(0i, _e2673, (_e2673 > 0i)))];
let _e2694 = ((_e2555 + (f32(bitcast<i32>((_e2679 >> bitcast<u32>(12u)))) * _e2564)) + ((f32((bitcast<i32>((_e2679 & 4095u)) - 2048i)) * _e2545) * (_e2655 - f32(_e2670))));
local_22 = _e2350;
let _e2695 = local_22;
local_23 = _e2695;
let _e2696 = local_23;
let _e2698 = ((_e2696 - _e2386) * _e2394);
let _e2700 = select(0f, _e2698, (_e2698 > 0f));
let _e2703 = local_23;
let _e2705 = ((_e2703 - _e2417) * _e2425);
let _e2707 = select(0f, _e2705, (_e2705 > 0f));
let _e2711 = local_23;
let _e2713 = ((_e2711 - _e2449) * _e2457);
let _e2715 = select(0f, _e2713, (_e2713 > 0f));
let _e2718 = local_23;
let _e2720 = ((_e2718 - _e2480) * _e2488);
let _e2722 = select(0f, _e2720, (_e2720 > 0f));
let _e2726 = ((select(_e2402, _e2700, (_e2700 < _e2402)) + select(_e2433, _e2707, (_e2707 < _e2433))) + (select(_e2465, _e2715, (_e2715 < _e2465)) + select(_e2496, _e2722, (_e2722 < _e2496))));
let _e2728 = select(0f, _e2726, (_e2726 > 0f));
let _e2730 = select(1023f, _e2728, (_e2728 < 1023f));
let _e2737 = select(0i, select(select(i32(_e2730), i32(-2147483648), (_e2730 < -2147483600f)), 2147483647i, (_e2730 > 2147483500f)), (_e2730 == _e2730));
let _e2741 = (_e2737 - select(0i, 1i, (_e2730 < f32(_e2737))));
let _e2742 = (262147i + _e2741);
let _e2744 = select(_e2378, _e2742, (_e2742 < _e2378));
let _e2750 = global_3.member[bitcast<u32>(select(0i, _e2744, (_e2744 > 0i)))];
let _e2765 = ((_e2555 + (f32(bitcast<i32>((_e2750 >> bitcast<u32>(12u)))) * _e2564)) + ((f32((bitcast<i32>((_e2750 & 4095u)) - 2048i)) * _e2545) * (_e2726 - f32(_e2741))));
local_20 = _e2356;
let _e2766 = local_20;
local_21 = _e2766;
let _e2767 = local_21;
let _e2769 = ((_e2767 - _e2386) * _e2394);
let _e2771 = select(0f, _e2769, (_e2769 > 0f));
let _e2774 = local_21;
let _e2776 = ((_e2774 - _e2417) * _e2425);
let _e2778 = select(0f, _e2776, (_e2776 > 0f));
let _e2782 = local_21;
let _e2784 = ((_e2782 - _e2449) * _e2457);
let _e2786 = select(0f, _e2784, (_e2784 > 0f));
let _e2789 = local_21;
let _e2791 = ((_e2789 - _e2480) * _e2488);
let _e2793 = select(0f, _e2791, (_e2791 > 0f));
let _e2797 = ((select(_e2402, _e2771, (_e2771 < _e2402)) + select(_e2433, _e2778, (_e2778 < _e2433))) + (select(_e2465, _e2786, (_e2786 < _e2465)) + select(_e2496, _e2793, (_e2793 < _e2496))));
let _e2799 = select(0f, _e2797, (_e2797 > 0f));
let _e2801 = select(1023f, _e2799, (_e2799 < 1023f));
let _e2808 = select(0i, select(select(i32(_e2801), i32(-2147483648), (_e2801 < -2147483600f)), 2147483647i, (_e2801 > 2147483500f)), (_e2801 == _e2801));
let _e2812 = (_e2808 - select(0i, 1i, (_e2801 < f32(_e2808))));
let _e2813 = (262147i + _e2812);
let _e2815 = select(_e2378, _e2813, (_e2813 < _e2378));
let _e2821 = global_3.member[bitcast<u32>(select(0i, _e2815, (_e2815 > 0i)))];
let _e2836 = ((_e2555 + (f32(bitcast<i32>((_e2821 >> bitcast<u32>(12u)))) * _e2564)) + ((f32((bitcast<i32>((_e2821 & 4095u)) - 2048i)) * _e2545) * (_e2797 - f32(_e2812))));
local_18 = _e2362;
let _e2837 = local_18;
local_19 = _e2837;
let _e2838 = local_19;
let _e2840 = ((_e2838 - _e2386) * _e2394);
let _e2842 = select(0f, _e2840, (_e2840 > 0f));
let _e2845 = local_19;
let _e2847 = ((_e2845 - _e2417) * _e2425);
let _e2849 = select(0f, _e2847, (_e2847 > 0f));
let _e2853 = local_19;
let _e2855 = ((_e2853 - _e2449) * _e2457);
let _e2857 = select(0f, _e2855, (_e2855 > 0f));
let _e2860 = local_19;
let _e2862 = ((_e2860 - _e2480) * _e2488);
let _e2864 = select(0f, _e2862, (_e2862 > 0f));
let _e2868 = ((select(_e2402, _e2842, (_e2842 < _e2402)) + select(_e2433, _e2849, (_e2849 < _e2433))) + (select(_e2465, _e2857, (_e2857 < _e2465)) + select(_e2496, _e2864, (_e2864 < _e2496))));
let _e2870 = select(0f, _e2868, (_e2868 > 0f));
let _e2872 = select(1023f, _e2870, (_e2870 < 1023f));
let _e2879 = select(0i, select(select(i32(_e2872), i32(-2147483648), (_e2872 < -2147483600f)), 2147483647i, (_e2872 > 2147483500f)), (_e2872 == _e2872));
let _e2883 = (_e2879 - select(0i, 1i, (_e2872 < f32(_e2879))));
let _e2884 = (262147i + _e2883);
let _e2886 = select(_e2378, _e2884, (_e2884 < _e2378));
let _e2892 = global_3.member[bitcast<u32>(select(0i, _e2886, (_e2886 > 0i)))];
let _e2907 = ((_e2555 + (f32(bitcast<i32>((_e2892 >> bitcast<u32>(12u)))) * _e2564)) + ((f32((bitcast<i32>((_e2892 & 4095u)) - 2048i)) * _e2545) * (_e2868 - f32(_e2883))));
local_16 = _e2368;
let _e2908 = local_16;
local_17 = _e2908;
let _e2909 = local_17;
let _e2911 = ((_e2909 - _e2386) * _e2394);
let _e2913 = select(0f, _e2911, (_e2911 > 0f));
let _e2916 = local_17;
let _e2918 = ((_e2916 - _e2417) * _e2425);
let _e2920 = select(0f, _e2918, (_e2918 > 0f));
let _e2924 = local_17;
let _e2926 = ((_e2924 - _e2449) * _e2457);
let _e2928 = select(0f, _e2926, (_e2926 > 0f));
let _e2931 = local_17;
let _e2933 = ((_e2931 - _e2480) * _e2488);
let _e2935 = select(0f, _e2933, (_e2933 > 0f));
let _e2939 = ((select(_e2402, _e2913, (_e2913 < _e2402)) + select(_e2433, _e2920, (_e2920 < _e2433))) + (select(_e2465, _e2928, (_e2928 < _e2465)) + select(_e2496, _e2935, (_e2935 < _e2496))));
let _e2941 = select(0f, _e2939, (_e2939 > 0f));
let _e2943 = select(1023f, _e2941, (_e2941 < 1023f));
let _e2950 = select(0i, select(select(i32(_e2943), i32(-2147483648), (_e2943 < -2147483600f)), 2147483647i, (_e2943 > 2147483500f)), (_e2943 == _e2943));
let _e2954 = (_e2950 - select(0i, 1i, (_e2943 < f32(_e2950))));
let _e2955 = (262147i + _e2954);
let _e2957 = select(_e2378, _e2955, (_e2955 < _e2378));
let _e2963 = global_3.member[bitcast<u32>(select(0i, _e2957, (_e2957 > 0i)))];
let _e2978 = ((_e2555 + (f32(bitcast<i32>((_e2963 >> bitcast<u32>(12u)))) * _e2564)) + ((f32((bitcast<i32>((_e2963 & 4095u)) - 2048i)) * _e2545) * (_e2939 - f32(_e2954))));
local_14 = _e2374;
let _e2979 = local_14;
local_15 = _e2979;
let _e2980 = local_15;
let _e2982 = ((_e2980 - _e2386) * _e2394);
let _e2984 = select(0f, _e2982, (_e2982 > 0f));
let _e2987 = local_15;
let _e2989 = ((_e2987 - _e2417) * _e2425);
let _e2991 = select(0f, _e2989, (_e2989 > 0f));
let _e2995 = local_15;
let _e2997 = ((_e2995 - _e2449) * _e2457);
let _e2999 = select(0f, _e2997, (_e2997 > 0f));
let _e3002 = local_15;
let _e3004 = ((_e3002 - _e2480) * _e2488);
let _e3006 = select(0f, _e3004, (_e3004 > 0f));
let _e3010 = ((select(_e2402, _e2984, (_e2984 < _e2402)) + select(_e2433, _e2991, (_e2991 < _e2433))) + (select(_e2465, _e2999, (_e2999 < _e2465)) + select(_e2496, _e3006, (_e3006 < _e2496))));
let _e3012 = select(0f, _e3010, (_e3010 > 0f));
let _e3014 = select(1023f, _e3012, (_e3012 < 1023f));
let _e3021 = select(0i, select(select(i32(_e3014), i32(-2147483648), (_e3014 < -2147483600f)), 2147483647i, (_e3014 > 2147483500f)), (_e3014 == _e3014));
let _e3025 = (_e3021 - select(0i, 1i, (_e3014 < f32(_e3021))));
let _e3026 = (262147i + _e3025);
let _e3028 = select(_e2378, _e3026, (_e3026 < _e2378));
let _e3034 = global_3.member[bitcast<u32>(select(0i, _e3028, (_e3028 > 0i)))];
let _e3049 = ((_e2555 + (f32(bitcast<i32>((_e3034 >> bitcast<u32>(12u)))) * _e2564)) + ((f32((bitcast<i32>((_e3034 & 4095u)) - 2048i)) * _e2545) * (_e3010 - f32(_e3025))));
let _e3050 = (_e2765 - _e2694);
let _e3052 = (_e2907 - _e2836);
let _e3054 = (_e3049 - _e2978);
phi_7375_ = type_34(_e2570, vec3<f32>((0.5f * _e3050), (0.5f * _e3052), (0.5f * _e3054)), vec3<f32>((0.25f * (_e3050 * (_e2765 + _e2694))), (0.25f * (_e3052 * (_e2907 + _e2836))), (0.25f * (_e3054 * (_e3049 + _e2978)))));
}
let _e3069 = phi_7375_;
let _e3084 = select(0f, 1f, ((((((_e1263 >= _e1289) && (_e1263 <= _e1294)) && (_e1269 >= _e1303)) && (_e1269 <= _e1308)) && (_e1275 >= _e1317)) && (_e1275 <= _e1322)));
let _e3086 = (0.5f * (_e2350 - _e2344));
let _e3088 = (0.5f * (_e2362 - _e2356));
let _e3090 = (0.5f * (_e2374 - _e2368));
let _e3096 = global_1.member.member_8.member.member.member;
let _e3102 = global_1.member.member_8.member.member.member_1;
let _e3108 = global_1.member.member_8.member.member.member_2;
let _e3114 = global_1.member.member_8.member_1.member.member;
let _e3120 = global_1.member.member_8.member_1.member.member_1;
let _e3126 = global_1.member.member_8.member_1.member.member_2;
let _e3132 = global_1.member.member_8.member_2.member.member;
let _e3138 = global_1.member.member_8.member_2.member.member_1;
let _e3144 = global_1.member.member_8.member_2.member.member_2;
let _e3149 = (((_e3096 * _e3086) + (_e3114 * _e3088)) + (_e3132 * _e3090));
let _e3154 = (((_e3102 * _e3086) + (_e3120 * _e3088)) + (_e3138 * _e3090));
let _e3159 = (((_e3108 * _e3086) + (_e3126 * _e3088)) + (_e3144 * _e3090));
phi_9697_ = type_35(_e2338, vec3<f32>((_e3149 * _e3084), (_e3154 * _e3084), (_e3159 * _e3084)), vec3<f32>(_e3149, _e3154, _e3159), _e3069.member, vec3<f32>(((((_e3096 * _e3069.member_2.x) + (_e3114 * _e3069.member_2.y)) + (_e3132 * _e3069.member_2.z)) * _e3084), ((((_e3102 * _e3069.member_2.x) + (_e3120 * _e3069.member_2.y)) + (_e3138 * _e3069.member_2.z)) * _e3084), ((((_e3108 * _e3069.member_2.x) + (_e3126 * _e3069.member_2.y)) + (_e3144 * _e3069.member_2.z)) * _e3084)), vec3<f32>(((((_e3096 * _e3069.member_1.x) + (_e3114 * _e3069.member_1.y)) + (_e3132 * _e3069.member_1.z)) * _e3084), ((((_e3102 * _e3069.member_1.x) + (_e3120 * _e3069.member_1.y)) + (_e3138 * _e3069.member_1.z)) * _e3084), ((((_e3108 * _e3069.member_1.x) + (_e3126 * _e3069.member_1.y)) + (_e3144 * _e3069.member_1.z)) * _e3084)));
} else {
if (_e191.member_2 == 8u) {
let _e3215 = global_1.member.member_8.member_4.member;
let _e3220 = global_1.member.member_8.member_5.member;
let _e3222 = select(_e3215, _e1263, (_e1263 > _e3215));
let _e3224 = select(_e3220, _e3222, (_e3222 < _e3220));
let _e3229 = global_1.member.member_8.member_4.member_1;
let _e3234 = global_1.member.member_8.member_5.member_1;
let _e3236 = select(_e3229, _e1269, (_e1269 > _e3229));
let _e3238 = select(_e3234, _e3236, (_e3236 < _e3234));
let _e3243 = global_1.member.member_8.member_4.member_2;
let _e3248 = global_1.member.member_8.member_5.member_2;
let _e3250 = select(_e3243, _e1275, (_e1275 > _e3243));
let _e3252 = select(_e3248, _e3250, (_e3250 < _e3248));
let _e3257 = global_1.member.member_8.member_15;
if (_e3257 == 0u) {
phi_7722_ = vec3<f32>(_e3224, _e3238, _e3252);
} else {
let _e3259 = (_e3224 + 0.5f);
let _e3264 = global_1.member.member_8.member_3.member;
let _e3265 = (_e3264 - 1f);
let _e3267 = select(0f, _e3259, (_e3259 > 0f));
let _e3269 = select(_e3265, _e3267, (_e3267 < _e3265));
let _e3276 = select(0i, select(select(i32(_e3269), i32(-2147483648), (_e3269 < -2147483600f)), 2147483647i, (_e3269 > 2147483500f)), (_e3269 == _e3269));
let _e3282 = (_e3238 + 0.5f);
let _e3287 = global_1.member.member_8.member_3.member_1;
let _e3288 = (_e3287 - 1f);
let _e3290 = select(0f, _e3282, (_e3282 > 0f));
let _e3292 = select(_e3288, _e3290, (_e3290 < _e3288));
let _e3299 = select(0i, select(select(i32(_e3292), i32(-2147483648), (_e3292 < -2147483600f)), 2147483647i, (_e3292 > 2147483500f)), (_e3292 == _e3292));
let _e3305 = (_e3252 + 0.5f);
let _e3310 = global_1.member.member_8.member_3.member_2;
let _e3311 = (_e3310 - 1f);
let _e3313 = select(0f, _e3305, (_e3305 > 0f));
let _e3315 = select(_e3311, _e3313, (_e3313 < _e3311));
let _e3322 = select(0i, select(select(i32(_e3315), i32(-2147483648), (_e3315 < -2147483600f)), 2147483647i, (_e3315 > 2147483500f)), (_e3315 == _e3315));
phi_7722_ = vec3<f32>(f32((_e3276 - select(0i, 1i, (_e3269 < f32(_e3276))))), f32((_e3299 - select(0i, 1i, (_e3292 < f32(_e3299))))), f32((_e3322 - select(0i, 1i, (_e3315 < f32(_e3322))))));
}
let _e3330 = phi_7722_;
let _e3336 = global_1.member.member_8.member_3.member;
let _e3338 = select(-1f, _e3330.x, (_e3330.x > -1f));
let _e3340 = select(_e3336, _e3338, (_e3338 < _e3336));
let _e3347 = select(0i, select(select(i32(_e3340), i32(-2147483648), (_e3340 < -2147483600f)), 2147483647i, (_e3340 > 2147483500f)), (_e3340 == _e3340));
let _e3351 = (_e3347 - select(0i, 1i, (_e3340 < f32(_e3347))));
let _e3357 = global_1.member.member_8.member_3.member_1;
let _e3359 = select(-1f, _e3330.y, (_e3330.y > -1f));
let _e3361 = select(_e3357, _e3359, (_e3359 < _e3357));
let _e3368 = select(0i, select(select(i32(_e3361), i32(-2147483648), (_e3361 < -2147483600f)), 2147483647i, (_e3361 > 2147483500f)), (_e3361 == _e3361));
let _e3372 = (_e3368 - select(0i, 1i, (_e3361 < f32(_e3368))));
let _e3378 = global_1.member.member_8.member_3.member_2;
let _e3380 = select(-1f, _e3330.z, (_e3330.z > -1f));
let _e3382 = select(_e3378, _e3380, (_e3380 < _e3378));
let _e3389 = select(0i, select(select(i32(_e3382), i32(-2147483648), (_e3382 < -2147483600f)), 2147483647i, (_e3382 > 2147483500f)), (_e3382 == _e3382));
let _e3393 = (_e3389 - select(0i, 1i, (_e3382 < f32(_e3389))));
let _e3397 = global_1.member.member_8.member_9;
let _e3401 = global_1.member.member_8.member_10;
let _e3402 = (_e3351 + 1i);
let _e3403 = (_e3372 + 1i);
let _e3404 = (_e3393 + 1i);
let _e3409 = global_1.member.member_8.member_13.member;
let _e3415 = global_1.member.member_8.member_13.member_1;
let _e3426 = ((_e3402 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3409) * ((_e3403 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3415) * (_e3404 >> bitcast<u32>(4i))))));
let _e3428 = (bitcast<i32>(_e176) - 1i);
let _e3430 = select(_e3428, _e3426, (_e3426 < _e3428));
let _e3436 = global_2.member[bitcast<u32>(select(0i, _e3430, (_e3430 > 0i)))];
let _e3438 = (_e3402 & 15i);
let _e3441 = ((_e3403 & 15i) * _e3397);
let _e3443 = (bitcast<i32>(_e3436) + ((_e3404 & 15i) * _e3401));
let _e3444 = (_e3441 + _e3397);
let _e3446 = (_e3441 + (2i * _e3397));
let _e3448 = (_e3441 + (3i * _e3397));
let _e3449 = (_e3443 + _e3401);
let _e3451 = (_e3443 + (2i * _e3401));
let _e3453 = (_e3443 + (3i * _e3401));
local_12 = type_30(array<i32, 4>(_e3438, _e3438, _e3438, _e3438), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_13 = (_e3330 - vec3<f32>(f32(_e3351), f32(_e3372), f32(_e3393)));
let _e3465 = local_12.member[0u];
let _e3466 = ((_e3449 + _e3444) + _e3465);
let _e3468 = (_e3466 >> bitcast<u32>(2i));
let _e3471 = bitcast<u32>(((_e3466 & 3i) * 8i));
let _e3473 = select(_e3428, _e3468, (_e3468 < _e3428));
let _e3478 = global_2.member[bitcast<u32>(select(0i, _e3473, (_e3473 > 0i)))];
let _e3482 = (_e3468 + 1i);
let _e3484 = select(_e3428, _e3482, (_e3482 < _e3428));
let _e3489 = global_2.member[bitcast<u32>(select(0i, _e3484, (_e3484 > 0i)))];
let _e3496 = ((_e3478 >> bitcast<u32>((_e3471 & 31u))) | ((_e3489 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3471) & 31u))));
let _e3499 = local_12.member_1[0u];
let _e3505 = f32(bitcast<i32>(((_e3496 >> bitcast<u32>((_e3499 & 31u))) & 255u)));
let _e3508 = local_12.member_1[1u];
let _e3514 = f32(bitcast<i32>(((_e3496 >> bitcast<u32>((_e3508 & 31u))) & 255u)));
let _e3517 = local_12.member_1[2u];
let _e3523 = f32(bitcast<i32>(((_e3496 >> bitcast<u32>((_e3517 & 31u))) & 255u)));
let _e3526 = local_12.member_1[3u];
let _e3533 = local_13[0u];
let _e3536 = (_e3505 + ((_e3514 - _e3505) * _e3533));
let _e3537 = local_13[0u];
let _e3540 = (_e3514 + ((_e3523 - _e3514) * _e3537));
let _e3541 = local_13[0u];
let _e3544 = (_e3523 + ((f32(bitcast<i32>(((_e3496 >> bitcast<u32>((_e3526 & 31u))) & 255u))) - _e3523) * _e3541));
let _e3546 = local_12.member[0u];
let _e3547 = ((_e3449 + _e3446) + _e3546);
let _e3549 = (_e3547 >> bitcast<u32>(2i));
let _e3552 = bitcast<u32>(((_e3547 & 3i) * 8i));
let _e3554 = select(_e3428, _e3549, (_e3549 < _e3428));
let _e3559 = global_2.member[bitcast<u32>(select(0i, _e3554, (_e3554 > 0i)))];
let _e3563 = (_e3549 + 1i);
let _e3565 = select(_e3428, _e3563, (_e3563 < _e3428));
let _e3570 = global_2.member[bitcast<u32>(select(0i, _e3565, (_e3565 > 0i)))];
let _e3577 = ((_e3559 >> bitcast<u32>((_e3552 & 31u))) | ((_e3570 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3552) & 31u))));
let _e3578 = local_12.member_1[0u];
let _e3584 = f32(bitcast<i32>(((_e3577 >> bitcast<u32>((_e3578 & 31u))) & 255u)));
let _e3585 = local_12.member_1[1u];
let _e3591 = f32(bitcast<i32>(((_e3577 >> bitcast<u32>((_e3585 & 31u))) & 255u)));
let _e3592 = local_12.member_1[2u];
let _e3598 = f32(bitcast<i32>(((_e3577 >> bitcast<u32>((_e3592 & 31u))) & 255u)));
let _e3599 = local_12.member_1[3u];
let _e3606 = local_13[0u];
let _e3610 = local_13[0u];
let _e3613 = (_e3591 + ((_e3598 - _e3591) * _e3610));
let _e3614 = local_13[0u];
let _e3619 = local_12.member[0u];
let _e3620 = ((_e3451 + _e3444) + _e3619);
let _e3622 = (_e3620 >> bitcast<u32>(2i));
let _e3625 = bitcast<u32>(((_e3620 & 3i) * 8i));
let _e3627 = select(_e3428, _e3622, (_e3622 < _e3428));
let _e3632 = global_2.member[bitcast<u32>(select(0i, _e3627, (_e3627 > 0i)))];
let _e3636 = (_e3622 + 1i);
let _e3638 = select(_e3428, _e3636, (_e3636 < _e3428));
let _e3643 = global_2.member[bitcast<u32>(select(0i, _e3638, (_e3638 > 0i)))];
let _e3650 = ((_e3632 >> bitcast<u32>((_e3625 & 31u))) | ((_e3643 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3625) & 31u))));
let _e3651 = local_12.member_1[0u];
let _e3657 = f32(bitcast<i32>(((_e3650 >> bitcast<u32>((_e3651 & 31u))) & 255u)));
let _e3658 = local_12.member_1[1u];
let _e3664 = f32(bitcast<i32>(((_e3650 >> bitcast<u32>((_e3658 & 31u))) & 255u)));
let _e3665 = local_12.member_1[2u];
let _e3671 = f32(bitcast<i32>(((_e3650 >> bitcast<u32>((_e3665 & 31u))) & 255u)));
let _e3672 = local_12.member_1[3u];
let _e3679 = local_13[0u];
let _e3682 = (_e3657 + ((_e3664 - _e3657) * _e3679));
let _e3683 = local_13[0u];
let _e3686 = (_e3664 + ((_e3671 - _e3664) * _e3683));
let _e3687 = local_13[0u];
let _e3690 = (_e3671 + ((f32(bitcast<i32>(((_e3650 >> bitcast<u32>((_e3672 & 31u))) & 255u))) - _e3671) * _e3687));
let _e3692 = local_12.member[0u];
let _e3693 = ((_e3451 + _e3446) + _e3692);
let _e3695 = (_e3693 >> bitcast<u32>(2i));
let _e3698 = bitcast<u32>(((_e3693 & 3i) * 8i));
let _e3700 = select(_e3428, _e3695, (_e3695 < _e3428));
let _e3705 = global_2.member[bitcast<u32>(select(0i, _e3700, (_e3700 > 0i)))];
let _e3709 = (_e3695 + 1i);
let _e3711 = select(_e3428, _e3709, (_e3709 < _e3428));
let _e3716 = global_2.member[bitcast<u32>(select(0i, _e3711, (_e3711 > 0i)))];
let _e3723 = ((_e3705 >> bitcast<u32>((_e3698 & 31u))) | ((_e3716 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3698) & 31u))));
let _e3724 = local_12.member_1[0u];
let _e3730 = f32(bitcast<i32>(((_e3723 >> bitcast<u32>((_e3724 & 31u))) & 255u)));
let _e3731 = local_12.member_1[1u];
let _e3737 = f32(bitcast<i32>(((_e3723 >> bitcast<u32>((_e3731 & 31u))) & 255u)));
let _e3738 = local_12.member_1[2u];
let _e3744 = f32(bitcast<i32>(((_e3723 >> bitcast<u32>((_e3738 & 31u))) & 255u)));
let _e3745 = local_12.member_1[3u];
let _e3752 = local_13[0u];
let _e3756 = local_13[0u];
let _e3759 = (_e3737 + ((_e3744 - _e3737) * _e3756));
let _e3760 = local_13[0u];
let _e3765 = local_12.member[0u];
let _e3766 = ((_e3449 + _e3441) + _e3765);
let _e3768 = (_e3766 >> bitcast<u32>(2i));
let _e3771 = bitcast<u32>(((_e3766 & 3i) * 8i));
let _e3773 = select(_e3428, _e3768, (_e3768 < _e3428));
let _e3778 = global_2.member[bitcast<u32>(select(0i, _e3773, (_e3773 > 0i)))];
let _e3782 = (_e3768 + 1i);
let _e3784 = select(_e3428, _e3782, (_e3782 < _e3428));
let _e3789 = global_2.member[bitcast<u32>(select(0i, _e3784, (_e3784 > 0i)))];
let _e3796 = ((_e3778 >> bitcast<u32>((_e3771 & 31u))) | ((_e3789 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3771) & 31u))));
let _e3797 = local_12.member_1[1u];
let _e3803 = f32(bitcast<i32>(((_e3796 >> bitcast<u32>((_e3797 & 31u))) & 255u)));
let _e3804 = local_12.member_1[2u];
let _e3811 = local_13[0u];
let _e3814 = (_e3803 + ((f32(bitcast<i32>(((_e3796 >> bitcast<u32>((_e3804 & 31u))) & 255u))) - _e3803) * _e3811));
let _e3816 = local_12.member[0u];
let _e3817 = ((_e3449 + _e3448) + _e3816);
let _e3819 = (_e3817 >> bitcast<u32>(2i));
let _e3822 = bitcast<u32>(((_e3817 & 3i) * 8i));
let _e3824 = select(_e3428, _e3819, (_e3819 < _e3428));
let _e3829 = global_2.member[bitcast<u32>(select(0i, _e3824, (_e3824 > 0i)))];
let _e3833 = (_e3819 + 1i);
let _e3835 = select(_e3428, _e3833, (_e3833 < _e3428));
let _e3840 = global_2.member[bitcast<u32>(select(0i, _e3835, (_e3835 > 0i)))];
let _e3847 = ((_e3829 >> bitcast<u32>((_e3822 & 31u))) | ((_e3840 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3822) & 31u))));
let _e3848 = local_12.member_1[1u];
let _e3854 = f32(bitcast<i32>(((_e3847 >> bitcast<u32>((_e3848 & 31u))) & 255u)));
let _e3855 = local_12.member_1[2u];
let _e3862 = local_13[0u];
let _e3867 = local_12.member[0u];
let _e3868 = ((_e3451 + _e3441) + _e3867);
let _e3870 = (_e3868 >> bitcast<u32>(2i));
let _e3873 = bitcast<u32>(((_e3868 & 3i) * 8i));
let _e3875 = select(_e3428, _e3870, (_e3870 < _e3428));
let _e3880 = global_2.member[bitcast<u32>(select(0i, _e3875, (_e3875 > 0i)))];
let _e3884 = (_e3870 + 1i);
let _e3886 = select(_e3428, _e3884, (_e3884 < _e3428));
let _e3891 = global_2.member[bitcast<u32>(select(0i, _e3886, (_e3886 > 0i)))];
let _e3898 = ((_e3880 >> bitcast<u32>((_e3873 & 31u))) | ((_e3891 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3873) & 31u))));
let _e3899 = local_12.member_1[1u];
let _e3905 = f32(bitcast<i32>(((_e3898 >> bitcast<u32>((_e3899 & 31u))) & 255u)));
let _e3906 = local_12.member_1[2u];
let _e3913 = local_13[0u];
let _e3916 = (_e3905 + ((f32(bitcast<i32>(((_e3898 >> bitcast<u32>((_e3906 & 31u))) & 255u))) - _e3905) * _e3913));
let _e3918 = local_12.member[0u];
let _e3919 = ((_e3451 + _e3448) + _e3918);
let _e3921 = (_e3919 >> bitcast<u32>(2i));
let _e3924 = bitcast<u32>(((_e3919 & 3i) * 8i));
let _e3926 = select(_e3428, _e3921, (_e3921 < _e3428));
let _e3931 = global_2.member[bitcast<u32>(select(0i, _e3926, (_e3926 > 0i)))];
let _e3935 = (_e3921 + 1i);
let _e3937 = select(_e3428, _e3935, (_e3935 < _e3428));
let _e3942 = global_2.member[bitcast<u32>(select(0i, _e3937, (_e3937 > 0i)))];
let _e3949 = ((_e3931 >> bitcast<u32>((_e3924 & 31u))) | ((_e3942 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3924) & 31u))));
let _e3950 = local_12.member_1[1u];
let _e3956 = f32(bitcast<i32>(((_e3949 >> bitcast<u32>((_e3950 & 31u))) & 255u)));
let _e3957 = local_12.member_1[2u];
let _e3964 = local_13[0u];
let _e3969 = local_12.member[0u];
let _e3970 = ((_e3443 + _e3444) + _e3969);
let _e3972 = (_e3970 >> bitcast<u32>(2i));
let _e3975 = bitcast<u32>(((_e3970 & 3i) * 8i));
let _e3977 = select(_e3428, _e3972, (_e3972 < _e3428));
let _e3982 = global_2.member[bitcast<u32>(select(0i, _e3977, (_e3977 > 0i)))];
let _e3986 = (_e3972 + 1i);
let _e3988 = select(_e3428, _e3986, (_e3986 < _e3428));
let _e3993 = global_2.member[bitcast<u32>(select(0i, _e3988, (_e3988 > 0i)))];
let _e4000 = ((_e3982 >> bitcast<u32>((_e3975 & 31u))) | ((_e3993 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3975) & 31u))));
let _e4001 = local_12.member_1[1u];
let _e4007 = f32(bitcast<i32>(((_e4000 >> bitcast<u32>((_e4001 & 31u))) & 255u)));
let _e4008 = local_12.member_1[2u];
let _e4015 = local_13[0u];
let _e4018 = (_e4007 + ((f32(bitcast<i32>(((_e4000 >> bitcast<u32>((_e4008 & 31u))) & 255u))) - _e4007) * _e4015));
let _e4020 = local_12.member[0u];
let _e4021 = ((_e3453 + _e3444) + _e4020);
let _e4023 = (_e4021 >> bitcast<u32>(2i));
let _e4026 = bitcast<u32>(((_e4021 & 3i) * 8i));
let _e4028 = select(_e3428, _e4023, (_e4023 < _e3428));
let _e4033 = global_2.member[bitcast<u32>(select(0i, _e4028, (_e4028 > 0i)))];
let _e4037 = (_e4023 + 1i);
let _e4039 = select(_e3428, _e4037, (_e4037 < _e3428));
let _e4044 = global_2.member[bitcast<u32>(select(0i, _e4039, (_e4039 > 0i)))];
let _e4051 = ((_e4033 >> bitcast<u32>((_e4026 & 31u))) | ((_e4044 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4026) & 31u))));
let _e4052 = local_12.member_1[1u];
let _e4058 = f32(bitcast<i32>(((_e4051 >> bitcast<u32>((_e4052 & 31u))) & 255u)));
let _e4059 = local_12.member_1[2u];
let _e4066 = local_13[0u];
let _e4069 = (_e4058 + ((f32(bitcast<i32>(((_e4051 >> bitcast<u32>((_e4059 & 31u))) & 255u))) - _e4058) * _e4066));
let _e4071 = local_12.member[0u];
let _e4072 = ((_e3443 + _e3446) + _e4071);
let _e4074 = (_e4072 >> bitcast<u32>(2i));
let _e4077 = bitcast<u32>(((_e4072 & 3i) * 8i));
let _e4079 = select(_e3428, _e4074, (_e4074 < _e3428));
let _e4084 = global_2.member[bitcast<u32>(select(0i, _e4079, (_e4079 > 0i)))];
let _e4088 = (_e4074 + 1i);
let _e4090 = select(_e3428, _e4088, (_e4088 < _e3428));
let _e4095 = global_2.member[bitcast<u32>(select(0i, _e4090, (_e4090 > 0i)))];
let _e4102 = ((_e4084 >> bitcast<u32>((_e4077 & 31u))) | ((_e4095 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4077) & 31u))));
let _e4103 = local_12.member_1[1u];
let _e4109 = f32(bitcast<i32>(((_e4102 >> bitcast<u32>((_e4103 & 31u))) & 255u)));
let _e4110 = local_12.member_1[2u];
let _e4117 = local_13[0u];
let _e4122 = local_12.member[0u];
let _e4123 = ((_e3453 + _e3446) + _e4122);
let _e4125 = (_e4123 >> bitcast<u32>(2i));
let _e4128 = bitcast<u32>(((_e4123 & 3i) * 8i));
let _e4130 = select(_e3428, _e4125, (_e4125 < _e3428));
let _e4135 = global_2.member[bitcast<u32>(select(0i, _e4130, (_e4130 > 0i)))];
let _e4139 = (_e4125 + 1i);
let _e4141 = select(_e3428, _e4139, (_e4139 < _e3428));
let _e4146 = global_2.member[bitcast<u32>(select(0i, _e4141, (_e4141 > 0i)))];
let _e4153 = ((_e4135 >> bitcast<u32>((_e4128 & 31u))) | ((_e4146 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4128) & 31u))));
let _e4154 = local_12.member_1[1u];
let _e4160 = f32(bitcast<i32>(((_e4153 >> bitcast<u32>((_e4154 & 31u))) & 255u)));
let _e4161 = local_12.member_1[2u];
let _e4168 = local_13[0u];
let _e4173 = local_13[1u];
let _e4176 = (_e3540 + ((_e3613 - _e3540) * _e4173));
let _e4177 = local_13[1u];
let _e4180 = (_e3686 + ((_e3759 - _e3686) * _e4177));
let _e4181 = local_13[1u];
let _e4184 = (_e3536 + (((_e3584 + ((_e3591 - _e3584) * _e3606)) - _e3536) * _e4181));
let _e4185 = local_13[1u];
let _e4190 = local_13[2u];
let _e4194 = local_13[1u];
let _e4197 = (_e3544 + (((_e3598 + ((f32(bitcast<i32>(((_e3577 >> bitcast<u32>((_e3599 & 31u))) & 255u))) - _e3598) * _e3614)) - _e3544) * _e4194));
let _e4198 = local_13[1u];
let _e4202 = local_13[2u];
let _e4206 = local_13[1u];
let _e4209 = (_e3814 + ((_e3540 - _e3814) * _e4206));
let _e4210 = local_13[1u];
let _e4214 = local_13[2u];
let _e4218 = local_13[1u];
let _e4221 = (_e3613 + (((_e3854 + ((f32(bitcast<i32>(((_e3847 >> bitcast<u32>((_e3855 & 31u))) & 255u))) - _e3854) * _e3862)) - _e3613) * _e4218));
let _e4222 = local_13[1u];
let _e4226 = local_13[2u];
let _e4230 = local_13[1u];
let _e4233 = (_e4018 + (((_e4109 + ((f32(bitcast<i32>(((_e4102 >> bitcast<u32>((_e4110 & 31u))) & 255u))) - _e4109) * _e4117)) - _e4018) * _e4230));
let _e4234 = local_13[2u];
let _e4238 = local_13[1u];
let _e4242 = local_13[2u];
let _e4246 = local_13[2u];
let _e4253 = global_1.member.member_8.member_8;
let _e4257 = global_1.member.member_8.member_7;
let _e4259 = (((_e4176 + ((_e4180 - _e4176) * _e4246)) - _e4253) * _e4257);
let _e4260 = -(1e9f);
let _e4262 = select(_e4260, _e4259, (_e4259 > _e4260));
let _e4266 = (((_e4184 + (((_e3682 + (((_e3730 + ((_e3737 - _e3730) * _e3752)) - _e3682) * _e4185)) - _e4184) * _e4190)) - _e4253) * _e4257);
let _e4268 = select(_e4260, _e4266, (_e4266 > _e4260));
let _e4272 = (((_e4197 + (((_e3690 + (((_e3744 + ((f32(bitcast<i32>(((_e3723 >> bitcast<u32>((_e3745 & 31u))) & 255u))) - _e3744) * _e3760)) - _e3690) * _e4198)) - _e4197) * _e4202)) - _e4253) * _e4257);
let _e4274 = select(_e4260, _e4272, (_e4272 > _e4260));
let _e4278 = (((_e4209 + (((_e3916 + ((_e3686 - _e3916) * _e4210)) - _e4209) * _e4214)) - _e4253) * _e4257);
let _e4280 = select(_e4260, _e4278, (_e4278 > _e4260));
let _e4284 = (((_e4221 + (((_e3759 + (((_e3956 + ((f32(bitcast<i32>(((_e3949 >> bitcast<u32>((_e3957 & 31u))) & 255u))) - _e3956) * _e3964)) - _e3759) * _e4222)) - _e4221) * _e4226)) - _e4253) * _e4257);
let _e4286 = select(_e4260, _e4284, (_e4284 > _e4260));
let _e4290 = (((_e4233 + ((_e4176 - _e4233) * _e4234)) - _e4253) * _e4257);
let _e4292 = select(_e4260, _e4290, (_e4290 > _e4260));
let _e4296 = (((_e4180 + (((_e4069 + (((_e4160 + ((f32(bitcast<i32>(((_e4153 >> bitcast<u32>((_e4161 & 31u))) & 255u))) - _e4160) * _e4168)) - _e4069) * _e4238)) - _e4180) * _e4242)) - _e4253) * _e4257);
let _e4298 = select(_e4260, _e4296, (_e4296 > _e4260));
let _e4302 = (0.5f * (select(1e9f, _e4274, (_e4274 < 1e9f)) - select(1e9f, _e4268, (_e4268 < 1e9f))));
let _e4304 = (0.5f * (select(1e9f, _e4286, (_e4286 < 1e9f)) - select(1e9f, _e4280, (_e4280 < 1e9f))));
let _e4306 = (0.5f * (select(1e9f, _e4298, (_e4298 < 1e9f)) - select(1e9f, _e4292, (_e4292 < 1e9f))));
let _e4312 = global_1.member.member_8.member.member.member;
let _e4318 = global_1.member.member_8.member.member.member_1;
let _e4324 = global_1.member.member_8.member.member.member_2;
let _e4330 = global_1.member.member_8.member_1.member.member;
let _e4336 = global_1.member.member_8.member_1.member.member_1;
let _e4342 = global_1.member.member_8.member_1.member.member_2;
let _e4348 = global_1.member.member_8.member_2.member.member;
let _e4354 = global_1.member.member_8.member_2.member.member_1;
let _e4360 = global_1.member.member_8.member_2.member.member_2;
phi_9694_ = select(1e9f, _e4262, (_e4262 < 1e9f));
phi_9695_ = vec3<f32>((((_e4312 * _e4302) + (_e4330 * _e4304)) + (_e4348 * _e4306)), (((_e4318 * _e4302) + (_e4336 * _e4304)) + (_e4354 * _e4306)), (((_e4324 * _e4302) + (_e4342 * _e4304)) + (_e4360 * _e4306)));
} else {
let _e4381 = global_1.member.member_8.member_4.member;
let _e4386 = global_1.member.member_8.member_5.member;
let _e4388 = select(_e4381, _e1263, (_e1263 > _e4381));
let _e4390 = select(_e4386, _e4388, (_e4388 < _e4386));
let _e4395 = global_1.member.member_8.member_4.member_1;
let _e4400 = global_1.member.member_8.member_5.member_1;
let _e4402 = select(_e4395, _e1269, (_e1269 > _e4395));
let _e4404 = select(_e4400, _e4402, (_e4402 < _e4400));
let _e4409 = global_1.member.member_8.member_4.member_2;
let _e4414 = global_1.member.member_8.member_5.member_2;
let _e4416 = select(_e4409, _e1275, (_e1275 > _e4409));
let _e4418 = select(_e4414, _e4416, (_e4416 < _e4414));
let _e4423 = global_1.member.member_8.member_15;
if (_e4423 == 0u) {
phi_9225_ = vec3<f32>(_e4390, _e4404, _e4418);
} else {
let _e4425 = (_e4390 + 0.5f);
let _e4430 = global_1.member.member_8.member_3.member;
let _e4431 = (_e4430 - 1f);
let _e4433 = select(0f, _e4425, (_e4425 > 0f));
let _e4435 = select(_e4431, _e4433, (_e4433 < _e4431));
let _e4442 = select(0i, select(select(i32(_e4435), i32(-2147483648), (_e4435 < -2147483600f)), 2147483647i, (_e4435 > 2147483500f)), (_e4435 == _e4435));
let _e4448 = (_e4404 + 0.5f);
let _e4453 = global_1.member.member_8.member_3.member_1;
let _e4454 = (_e4453 - 1f);
let _e4456 = select(0f, _e4448, (_e4448 > 0f));
let _e4458 = select(_e4454, _e4456, (_e4456 < _e4454));
let _e4465 = select(0i, select(select(i32(_e4458), i32(-2147483648), (_e4458 < -2147483600f)), 2147483647i, (_e4458 > 2147483500f)), (_e4458 == _e4458));
let _e4471 = (_e4418 + 0.5f);
let _e4476 = global_1.member.member_8.member_3.member_2;
let _e4477 = (_e4476 - 1f);
let _e4479 = select(0f, _e4471, (_e4471 > 0f));
let _e4481 = select(_e4477, _e4479, (_e4479 < _e4477));
let _e4488 = select(0i, select(select(i32(_e4481), i32(-2147483648), (_e4481 < -2147483600f)), 2147483647i, (_e4481 > 2147483500f)), (_e4481 == _e4481));
phi_9225_ = vec3<f32>(f32((_e4442 - select(0i, 1i, (_e4435 < f32(_e4442))))), f32((_e4465 - select(0i, 1i, (_e4458 < f32(_e4465))))), f32((_e4488 - select(0i, 1i, (_e4481 < f32(_e4488))))));
}
let _e4496 = phi_9225_;
let _e4502 = global_1.member.member_8.member_3.member;
let _e4504 = select(-1f, _e4496.x, (_e4496.x > -1f));
let _e4506 = select(_e4502, _e4504, (_e4504 < _e4502));
let _e4513 = select(0i, select(select(i32(_e4506), i32(-2147483648), (_e4506 < -2147483600f)), 2147483647i, (_e4506 > 2147483500f)), (_e4506 == _e4506));
let _e4517 = (_e4513 - select(0i, 1i, (_e4506 < f32(_e4513))));
let _e4523 = global_1.member.member_8.member_3.member_1;
let _e4525 = select(-1f, _e4496.y, (_e4496.y > -1f));
let _e4527 = select(_e4523, _e4525, (_e4525 < _e4523));
let _e4534 = select(0i, select(select(i32(_e4527), i32(-2147483648), (_e4527 < -2147483600f)), 2147483647i, (_e4527 > 2147483500f)), (_e4527 == _e4527));
let _e4538 = (_e4534 - select(0i, 1i, (_e4527 < f32(_e4534))));
let _e4544 = global_1.member.member_8.member_3.member_2;
let _e4546 = select(-1f, _e4496.z, (_e4496.z > -1f));
let _e4548 = select(_e4544, _e4546, (_e4546 < _e4544));
let _e4555 = select(0i, select(select(i32(_e4548), i32(-2147483648), (_e4548 < -2147483600f)), 2147483647i, (_e4548 > 2147483500f)), (_e4548 == _e4548));
let _e4559 = (_e4555 - select(0i, 1i, (_e4548 < f32(_e4555))));
let _e4563 = global_1.member.member_8.member_9;
let _e4567 = global_1.member.member_8.member_10;
let _e4568 = (_e4517 + 1i);
let _e4569 = (_e4538 + 1i);
let _e4570 = (_e4559 + 1i);
let _e4575 = global_1.member.member_8.member_13.member;
let _e4581 = global_1.member.member_8.member_13.member_1;
let _e4592 = ((_e4568 >> bitcast<u32>(4i)) + (bitcast<i32>(_e4575) * ((_e4569 >> bitcast<u32>(4i)) + (bitcast<i32>(_e4581) * (_e4570 >> bitcast<u32>(4i))))));
let _e4594 = (bitcast<i32>(_e176) - 1i);
let _e4596 = select(_e4594, _e4592, (_e4592 < _e4594));
let _e4602 = global_2.member[bitcast<u32>(select(0i, _e4596, (_e4596 > 0i)))];
let _e4604 = (_e4568 & 15i);
let _e4607 = ((_e4569 & 15i) * _e4563);
let _e4609 = (bitcast<i32>(_e4602) + ((_e4570 & 15i) * _e4567));
let _e4610 = (_e4607 + _e4563);
let _e4612 = (_e4607 + (2i * _e4563));
let _e4613 = (_e4609 + _e4567);
let _e4615 = (_e4609 + (2i * _e4567));
local_10 = type_30(array<i32, 4>(_e4604, _e4604, _e4604, _e4604), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_11 = (_e4496 - vec3<f32>(f32(_e4517), f32(_e4538), f32(_e4559)));
let _e4627 = local_10.member[0u];
let _e4628 = ((_e4613 + _e4610) + _e4627);
let _e4630 = (_e4628 >> bitcast<u32>(2i));
let _e4633 = bitcast<u32>(((_e4628 & 3i) * 8i));
let _e4635 = select(_e4594, _e4630, (_e4630 < _e4594));
let _e4640 = global_2.member[bitcast<u32>(select(0i, _e4635, (_e4635 > 0i)))];
let _e4644 = (_e4630 + 1i);
let _e4646 = select(_e4594, _e4644, (_e4644 < _e4594));
let _e4651 = global_2.member[bitcast<u32>(select(0i, _e4646, (_e4646 > 0i)))];
let _e4658 = ((_e4640 >> bitcast<u32>((_e4633 & 31u))) | ((_e4651 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4633) & 31u))));
let _e4661 = local_10.member_1[1u];
let _e4667 = f32(bitcast<i32>(((_e4658 >> bitcast<u32>((_e4661 & 31u))) & 255u)));
let _e4670 = local_10.member_1[2u];
let _e4677 = local_11[0u];
let _e4680 = (_e4667 + ((f32(bitcast<i32>(((_e4658 >> bitcast<u32>((_e4670 & 31u))) & 255u))) - _e4667) * _e4677));
let _e4682 = local_10.member[0u];
let _e4683 = ((_e4613 + _e4612) + _e4682);
let _e4685 = (_e4683 >> bitcast<u32>(2i));
let _e4688 = bitcast<u32>(((_e4683 & 3i) * 8i));
let _e4690 = select(_e4594, _e4685, (_e4685 < _e4594));
let _e4695 = global_2.member[bitcast<u32>(select(0i, _e4690, (_e4690 > 0i)))];
let _e4699 = (_e4685 + 1i);
let _e4701 = select(_e4594, _e4699, (_e4699 < _e4594));
let _e4706 = global_2.member[bitcast<u32>(select(0i, _e4701, (_e4701 > 0i)))];
let _e4713 = ((_e4695 >> bitcast<u32>((_e4688 & 31u))) | ((_e4706 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4688) & 31u))));
let _e4714 = local_10.member_1[1u];
let _e4720 = f32(bitcast<i32>(((_e4713 >> bitcast<u32>((_e4714 & 31u))) & 255u)));
let _e4721 = local_10.member_1[2u];
let _e4728 = local_11[0u];
let _e4733 = local_11[1u];
let _e4736 = (_e4680 + (((_e4720 + ((f32(bitcast<i32>(((_e4713 >> bitcast<u32>((_e4721 & 31u))) & 255u))) - _e4720) * _e4728)) - _e4680) * _e4733));
let _e4738 = local_10.member[0u];
let _e4739 = ((_e4615 + _e4610) + _e4738);
let _e4741 = (_e4739 >> bitcast<u32>(2i));
let _e4744 = bitcast<u32>(((_e4739 & 3i) * 8i));
let _e4746 = select(_e4594, _e4741, (_e4741 < _e4594));
let _e4751 = global_2.member[bitcast<u32>(select(0i, _e4746, (_e4746 > 0i)))];
let _e4755 = (_e4741 + 1i);
let _e4757 = select(_e4594, _e4755, (_e4755 < _e4594));
let _e4762 = global_2.member[bitcast<u32>(select(0i, _e4757, (_e4757 > 0i)))];
let _e4769 = ((_e4751 >> bitcast<u32>((_e4744 & 31u))) | ((_e4762 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4744) & 31u))));
let _e4770 = local_10.member_1[1u];
let _e4776 = f32(bitcast<i32>(((_e4769 >> bitcast<u32>((_e4770 & 31u))) & 255u)));
let _e4777 = local_10.member_1[2u];
let _e4784 = local_11[0u];
let _e4787 = (_e4776 + ((f32(bitcast<i32>(((_e4769 >> bitcast<u32>((_e4777 & 31u))) & 255u))) - _e4776) * _e4784));
let _e4789 = local_10.member[0u];
let _e4790 = ((_e4615 + _e4612) + _e4789);
let _e4792 = (_e4790 >> bitcast<u32>(2i));
let _e4795 = bitcast<u32>(((_e4790 & 3i) * 8i));
let _e4797 = select(_e4594, _e4792, (_e4792 < _e4594));
let _e4802 = global_2.member[bitcast<u32>(select(0i, _e4797, (_e4797 > 0i)))];
let _e4806 = (_e4792 + 1i);
let _e4808 = select(_e4594, _e4806, (_e4806 < _e4594));
let _e4813 = global_2.member[bitcast<u32>(select(0i, _e4808, (_e4808 > 0i)))];
let _e4820 = ((_e4802 >> bitcast<u32>((_e4795 & 31u))) | ((_e4813 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4795) & 31u))));
let _e4821 = local_10.member_1[1u];
let _e4827 = f32(bitcast<i32>(((_e4820 >> bitcast<u32>((_e4821 & 31u))) & 255u)));
let _e4828 = local_10.member_1[2u];
let _e4835 = local_11[0u];
let _e4839 = local_11[1u];
let _e4844 = local_11[2u];
let _e4851 = global_1.member.member_8.member_8;
let _e4855 = global_1.member.member_8.member_7;
let _e4857 = (((_e4736 + (((_e4787 + (((_e4827 + ((f32(bitcast<i32>(((_e4820 >> bitcast<u32>((_e4828 & 31u))) & 255u))) - _e4827) * _e4835)) - _e4787) * _e4839)) - _e4736) * _e4844)) - _e4851) * _e4855);
let _e4858 = -(1e9f);
let _e4860 = select(_e4858, _e4857, (_e4857 > _e4858));
phi_9694_ = select(1e9f, _e4860, (_e4860 < 1e9f));
phi_9695_ = vec3<f32>(0f, 0f, 0f);
}
let _e4864 = phi_9694_;
let _e4866 = phi_9695_;
phi_9697_ = type_35(_e4864, vec3<f32>(0f, 0f, 0f), _e4866, 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e4869 = phi_9697_;
let _e4874 = global_1.member.member_8.member_4.member;
let _e4879 = global_1.member.member_8.member_5.member;
let _e4881 = select(_e4874, _e1227, (_e1227 > _e4874));
let _e4883 = select(_e4879, _e4881, (_e4881 < _e4879));
let _e4888 = global_1.member.member_8.member_4.member_1;
let _e4893 = global_1.member.member_8.member_5.member_1;
let _e4895 = select(_e4888, _e1242, (_e1242 > _e4888));
let _e4897 = select(_e4893, _e4895, (_e4895 < _e4893));
let _e4902 = global_1.member.member_8.member_4.member_2;
let _e4907 = global_1.member.member_8.member_5.member_2;
let _e4909 = select(_e4902, _e1257, (_e1257 > _e4902));
let _e4911 = select(_e4907, _e4909, (_e4909 < _e4907));
let _e4916 = global_1.member.member_8.member_15;
let _e4917 = (_e4916 == 0u);
if _e4917 {
phi_9843_ = vec3<f32>(_e4883, _e4897, _e4911);
} else {
let _e4918 = (_e4883 + 0.5f);
let _e4923 = global_1.member.member_8.member_3.member;
let _e4924 = (_e4923 - 1f);
let _e4926 = select(0f, _e4918, (_e4918 > 0f));
let _e4928 = select(_e4924, _e4926, (_e4926 < _e4924));
let _e4935 = select(0i, select(select(i32(_e4928), i32(-2147483648), (_e4928 < -2147483600f)), 2147483647i, (_e4928 > 2147483500f)), (_e4928 == _e4928));
let _e4941 = (_e4897 + 0.5f);
let _e4946 = global_1.member.member_8.member_3.member_1;
let _e4947 = (_e4946 - 1f);
let _e4949 = select(0f, _e4941, (_e4941 > 0f));
let _e4951 = select(_e4947, _e4949, (_e4949 < _e4947));
let _e4958 = select(0i, select(select(i32(_e4951), i32(-2147483648), (_e4951 < -2147483600f)), 2147483647i, (_e4951 > 2147483500f)), (_e4951 == _e4951));
let _e4964 = (_e4911 + 0.5f);
let _e4969 = global_1.member.member_8.member_3.member_2;
let _e4970 = (_e4969 - 1f);
let _e4972 = select(0f, _e4964, (_e4964 > 0f));
let _e4974 = select(_e4970, _e4972, (_e4972 < _e4970));
let _e4981 = select(0i, select(select(i32(_e4974), i32(-2147483648), (_e4974 < -2147483600f)), 2147483647i, (_e4974 > 2147483500f)), (_e4974 == _e4974));
phi_9843_ = vec3<f32>(f32((_e4935 - select(0i, 1i, (_e4928 < f32(_e4935))))), f32((_e4958 - select(0i, 1i, (_e4951 < f32(_e4958))))), f32((_e4981 - select(0i, 1i, (_e4974 < f32(_e4981))))));
}
let _e4989 = phi_9843_;
let _e4995 = global_1.member.member_8.member_3.member;
let _e4997 = select(-1f, _e4989.x, (_e4989.x > -1f));
let _e4999 = select(_e4995, _e4997, (_e4997 < _e4995));
let _e5006 = select(0i, select(select(i32(_e4999), i32(-2147483648), (_e4999 < -2147483600f)), 2147483647i, (_e4999 > 2147483500f)), (_e4999 == _e4999));
let _e5010 = (_e5006 - select(0i, 1i, (_e4999 < f32(_e5006))));
let _e5016 = global_1.member.member_8.member_3.member_1;
let _e5018 = select(-1f, _e4989.y, (_e4989.y > -1f));
let _e5020 = select(_e5016, _e5018, (_e5018 < _e5016));
let _e5027 = select(0i, select(select(i32(_e5020), i32(-2147483648), (_e5020 < -2147483600f)), 2147483647i, (_e5020 > 2147483500f)), (_e5020 == _e5020));
let _e5031 = (_e5027 - select(0i, 1i, (_e5020 < f32(_e5027))));
let _e5037 = global_1.member.member_8.member_3.member_2;
let _e5039 = select(-1f, _e4989.z, (_e4989.z > -1f));
let _e5041 = select(_e5037, _e5039, (_e5039 < _e5037));
let _e5048 = select(0i, select(select(i32(_e5041), i32(-2147483648), (_e5041 < -2147483600f)), 2147483647i, (_e5041 > 2147483500f)), (_e5041 == _e5041));
let _e5052 = (_e5048 - select(0i, 1i, (_e5041 < f32(_e5048))));
let _e5056 = global_1.member.member_8.member_9;
let _e5060 = global_1.member.member_8.member_10;
let _e5061 = (_e5010 + 1i);
let _e5062 = (_e5031 + 1i);
let _e5063 = (_e5052 + 1i);
let _e5068 = global_1.member.member_8.member_13.member;
let _e5069 = bitcast<i32>(_e5068);
let _e5074 = global_1.member.member_8.member_13.member_1;
let _e5075 = bitcast<i32>(_e5074);
let _e5085 = ((_e5061 >> bitcast<u32>(4i)) + (_e5069 * ((_e5062 >> bitcast<u32>(4i)) + (_e5075 * (_e5063 >> bitcast<u32>(4i))))));
let _e5087 = (bitcast<i32>(_e176) - 1i);
let _e5089 = select(_e5087, _e5085, (_e5085 < _e5087));
let _e5095 = global_2.member[bitcast<u32>(select(0i, _e5089, (_e5089 > 0i)))];
let _e5097 = (_e5061 & 15i);
let _e5100 = ((_e5062 & 15i) * _e5056);
let _e5102 = (bitcast<i32>(_e5095) + ((_e5063 & 15i) * _e5060));
let _e5103 = (_e5100 + _e5056);
let _e5104 = (2i * _e5056);
let _e5105 = (_e5100 + _e5104);
let _e5106 = (_e5102 + _e5060);
let _e5107 = (2i * _e5060);
let _e5108 = (_e5102 + _e5107);
local_8 = type_30(array<i32, 4>(_e5097, _e5097, _e5097, _e5097), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_9 = (_e4989 - vec3<f32>(f32(_e5010), f32(_e5031), f32(_e5052)));
let _e5120 = local_8.member[0u];
let _e5121 = ((_e5106 + _e5103) + _e5120);
let _e5123 = (_e5121 >> bitcast<u32>(2i));
let _e5126 = bitcast<u32>(((_e5121 & 3i) * 8i));
let _e5128 = select(_e5087, _e5123, (_e5123 < _e5087));
let _e5133 = global_2.member[bitcast<u32>(select(0i, _e5128, (_e5128 > 0i)))];
let _e5137 = (_e5123 + 1i);
let _e5139 = select(_e5087, _e5137, (_e5137 < _e5087));
let _e5144 = global_2.member[bitcast<u32>(select(0i, _e5139, (_e5139 > 0i)))];
let _e5151 = ((_e5133 >> bitcast<u32>((_e5126 & 31u))) | ((_e5144 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5126) & 31u))));
let _e5154 = local_8.member_1[1u];
let _e5160 = f32(bitcast<i32>(((_e5151 >> bitcast<u32>((_e5154 & 31u))) & 255u)));
let _e5163 = local_8.member_1[2u];
let _e5170 = local_9[0u];
let _e5173 = (_e5160 + ((f32(bitcast<i32>(((_e5151 >> bitcast<u32>((_e5163 & 31u))) & 255u))) - _e5160) * _e5170));
let _e5175 = local_8.member[0u];
let _e5176 = ((_e5106 + _e5105) + _e5175);
let _e5178 = (_e5176 >> bitcast<u32>(2i));
let _e5181 = bitcast<u32>(((_e5176 & 3i) * 8i));
let _e5183 = select(_e5087, _e5178, (_e5178 < _e5087));
let _e5188 = global_2.member[bitcast<u32>(select(0i, _e5183, (_e5183 > 0i)))];
let _e5192 = (_e5178 + 1i);
let _e5194 = select(_e5087, _e5192, (_e5192 < _e5087));
let _e5199 = global_2.member[bitcast<u32>(select(0i, _e5194, (_e5194 > 0i)))];
let _e5206 = ((_e5188 >> bitcast<u32>((_e5181 & 31u))) | ((_e5199 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5181) & 31u))));
let _e5207 = local_8.member_1[1u];
let _e5213 = f32(bitcast<i32>(((_e5206 >> bitcast<u32>((_e5207 & 31u))) & 255u)));
let _e5214 = local_8.member_1[2u];
let _e5221 = local_9[0u];
let _e5226 = local_9[1u];
let _e5229 = (_e5173 + (((_e5213 + ((f32(bitcast<i32>(((_e5206 >> bitcast<u32>((_e5214 & 31u))) & 255u))) - _e5213) * _e5221)) - _e5173) * _e5226));
let _e5231 = local_8.member[0u];
let _e5232 = ((_e5108 + _e5103) + _e5231);
let _e5234 = (_e5232 >> bitcast<u32>(2i));
let _e5237 = bitcast<u32>(((_e5232 & 3i) * 8i));
let _e5239 = select(_e5087, _e5234, (_e5234 < _e5087));
let _e5244 = global_2.member[bitcast<u32>(select(0i, _e5239, (_e5239 > 0i)))];
let _e5248 = (_e5234 + 1i);
let _e5250 = select(_e5087, _e5248, (_e5248 < _e5087));
let _e5255 = global_2.member[bitcast<u32>(select(0i, _e5250, (_e5250 > 0i)))];
let _e5262 = ((_e5244 >> bitcast<u32>((_e5237 & 31u))) | ((_e5255 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5237) & 31u))));
let _e5263 = local_8.member_1[1u];
let _e5269 = f32(bitcast<i32>(((_e5262 >> bitcast<u32>((_e5263 & 31u))) & 255u)));
let _e5270 = local_8.member_1[2u];
let _e5277 = local_9[0u];
let _e5280 = (_e5269 + ((f32(bitcast<i32>(((_e5262 >> bitcast<u32>((_e5270 & 31u))) & 255u))) - _e5269) * _e5277));
let _e5282 = local_8.member[0u];
let _e5283 = ((_e5108 + _e5105) + _e5282);
let _e5285 = (_e5283 >> bitcast<u32>(2i));
let _e5288 = bitcast<u32>(((_e5283 & 3i) * 8i));
let _e5290 = select(_e5087, _e5285, (_e5285 < _e5087));
let _e5295 = global_2.member[bitcast<u32>(select(0i, _e5290, (_e5290 > 0i)))];
let _e5299 = (_e5285 + 1i);
let _e5301 = select(_e5087, _e5299, (_e5299 < _e5087));
let _e5306 = global_2.member[bitcast<u32>(select(0i, _e5301, (_e5301 > 0i)))];
let _e5313 = ((_e5295 >> bitcast<u32>((_e5288 & 31u))) | ((_e5306 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5288) & 31u))));
let _e5314 = local_8.member_1[1u];
let _e5320 = f32(bitcast<i32>(((_e5313 >> bitcast<u32>((_e5314 & 31u))) & 255u)));
let _e5321 = local_8.member_1[2u];
let _e5328 = local_9[0u];
let _e5332 = local_9[1u];
let _e5337 = local_9[2u];
let _e5344 = global_1.member.member_8.member_8;
let _e5348 = global_1.member.member_8.member_7;
let _e5350 = (((_e5229 + (((_e5280 + (((_e5320 + ((f32(bitcast<i32>(((_e5313 >> bitcast<u32>((_e5321 & 31u))) & 255u))) - _e5320) * _e5328)) - _e5280) * _e5332)) - _e5229) * _e5337)) - _e5344) * _e5348);
let _e5351 = -(1e9f);
let _e5353 = select(_e5351, _e5350, (_e5350 > _e5351));
let _e5358 = select(select(1e9f, _e5353, (_e5353 < 1e9f)), _e4869.member, (_e4916 != 0u));
let _e5361 = global_1.member.member_1;
let _e5363 = ((_e5361 & 16u) == 0u);
if _e5363 {
phi_10832_ = type_36(type_33(0f, 1f), type_33(0f, 1f), 1f);
} else {
let _e5367 = global_1.member.member_16.member;
let _e5378 = ((((_e5367.member.member * _e1184) + (_e5367.member.member_1 * _e1197)) + (_e5367.member.member_2 * _e1162)) + _e5367.member_1);
let _e5384 = ((((_e5367.member.member * _e1207) + (_e5367.member.member_1 * _e1212)) + (_e5367.member.member_2 * _e1201)) + _e5367.member_1);
let _e5391 = bitcast<f32>((bitcast<u32>((_e5378 - _e5384)) & 2147483647u));
let _e5394 = (bitcast<f32>((bitcast<u32>(_e5378) & 2147483647u)) / select(1e-30f, _e5391, (_e5391 > 1e-30f)));
let _e5396 = select(0f, _e5394, (_e5394 > 0f));
let _e5398 = select(1f, _e5396, (_e5396 < 1f));
let _e5399 = (_e5378 > 0f);
let _e5400 = (_e5384 > 0f);
let _e5402 = select(0f, select(_e5398, 1f, _e5400), _e5399);
let _e5404 = select(1f, select(_e5398, 1f, _e5399), _e5400);
let _e5408 = global_1.member.member_16.member_1;
let _e5409 = (_e5408 != 0u);
let _e5411 = select(_e5402, 0f, (0f > _e5402));
let _e5413 = select(_e5404, 1f, (1f < _e5404));
let _e5414 = select(0f, _e5402, _e5409);
let _e5415 = select(1f, _e5404, _e5409);
let _e5417 = select(_e5414, 0f, (0f > _e5414));
let _e5419 = select(_e5415, 1f, (1f < _e5415));
let _e5426 = global_1.member.member_17.member;
let _e5437 = ((((_e5426.member.member * _e1184) + (_e5426.member.member_1 * _e1197)) + (_e5426.member.member_2 * _e1162)) + _e5426.member_1);
let _e5443 = ((((_e5426.member.member * _e1207) + (_e5426.member.member_1 * _e1212)) + (_e5426.member.member_2 * _e1201)) + _e5426.member_1);
let _e5450 = bitcast<f32>((bitcast<u32>((_e5437 - _e5443)) & 2147483647u));
let _e5453 = (bitcast<f32>((bitcast<u32>(_e5437) & 2147483647u)) / select(1e-30f, _e5450, (_e5450 > 1e-30f)));
let _e5455 = select(0f, _e5453, (_e5453 > 0f));
let _e5457 = select(1f, _e5455, (_e5455 < 1f));
let _e5458 = (_e5437 > 0f);
let _e5459 = (_e5443 > 0f);
let _e5461 = select(0f, select(_e5457, 1f, _e5459), _e5458);
let _e5463 = select(1f, select(_e5457, 1f, _e5458), _e5459);
let _e5467 = global_1.member.member_17.member_1;
let _e5468 = (_e5467 != 0u);
let _e5470 = select(_e5461, _e5411, (_e5411 > _e5461));
let _e5472 = select(_e5463, _e5413, (_e5413 < _e5463));
let _e5473 = select(0f, _e5461, _e5468);
let _e5474 = select(1f, _e5463, _e5468);
let _e5476 = select(_e5473, _e5417, (_e5417 > _e5473));
let _e5478 = select(_e5474, _e5419, (_e5419 < _e5474));
let _e5485 = global_1.member.member_18.member;
let _e5496 = ((((_e5485.member.member * _e1184) + (_e5485.member.member_1 * _e1197)) + (_e5485.member.member_2 * _e1162)) + _e5485.member_1);
let _e5502 = ((((_e5485.member.member * _e1207) + (_e5485.member.member_1 * _e1212)) + (_e5485.member.member_2 * _e1201)) + _e5485.member_1);
let _e5509 = bitcast<f32>((bitcast<u32>((_e5496 - _e5502)) & 2147483647u));
let _e5512 = (bitcast<f32>((bitcast<u32>(_e5496) & 2147483647u)) / select(1e-30f, _e5509, (_e5509 > 1e-30f)));
let _e5514 = select(0f, _e5512, (_e5512 > 0f));
let _e5516 = select(1f, _e5514, (_e5514 < 1f));
let _e5517 = (_e5496 > 0f);
let _e5518 = (_e5502 > 0f);
let _e5520 = select(0f, select(_e5516, 1f, _e5518), _e5517);
let _e5522 = select(1f, select(_e5516, 1f, _e5517), _e5518);
let _e5526 = global_1.member.member_18.member_1;
let _e5527 = (_e5526 != 0u);
let _e5529 = select(_e5520, _e5470, (_e5470 > _e5520));
let _e5531 = select(_e5522, _e5472, (_e5472 < _e5522));
let _e5532 = select(0f, _e5520, _e5527);
let _e5533 = select(1f, _e5522, _e5527);
let _e5535 = select(_e5532, _e5476, (_e5476 > _e5532));
let _e5537 = select(_e5533, _e5478, (_e5478 < _e5533));
let _e5544 = global_1.member.member_19.member;
let _e5555 = ((((_e5544.member.member * _e1184) + (_e5544.member.member_1 * _e1197)) + (_e5544.member.member_2 * _e1162)) + _e5544.member_1);
let _e5561 = ((((_e5544.member.member * _e1207) + (_e5544.member.member_1 * _e1212)) + (_e5544.member.member_2 * _e1201)) + _e5544.member_1);
let _e5568 = bitcast<f32>((bitcast<u32>((_e5555 - _e5561)) & 2147483647u));
let _e5571 = (bitcast<f32>((bitcast<u32>(_e5555) & 2147483647u)) / select(1e-30f, _e5568, (_e5568 > 1e-30f)));
let _e5573 = select(0f, _e5571, (_e5571 > 0f));
let _e5575 = select(1f, _e5573, (_e5573 < 1f));
let _e5576 = (_e5555 > 0f);
let _e5577 = (_e5561 > 0f);
let _e5579 = select(0f, select(_e5575, 1f, _e5577), _e5576);
let _e5581 = select(1f, select(_e5575, 1f, _e5576), _e5577);
let _e5585 = global_1.member.member_19.member_1;
let _e5586 = (_e5585 != 0u);
let _e5591 = select(0f, _e5579, _e5586);
let _e5592 = select(1f, _e5581, _e5586);
phi_10832_ = type_36(type_33(select(_e5579, _e5529, (_e5529 > _e5579)), select(_e5581, _e5531, (_e5531 < _e5581))), type_33(select(_e5591, _e5535, (_e5535 > _e5591)), select(_e5592, _e5537, (_e5537 < _e5592))), ((((1f * select(1f, 0f, (_e5409 && _e5400))) * select(1f, 0f, (_e5468 && _e5459))) * select(1f, 0f, (_e5527 && _e5518))) * select(1f, 0f, (_e5586 && _e5577))));
}
let _e5604 = phi_10832_;
let _e5605 = (_e1263 - _e1227);
let _e5609 = (bitcast<f32>((bitcast<u32>(_e5605) & 2147483647u)) < 1e-12f);
let _e5611 = (1f / select(_e5605, 1f, _e5609));
let _e5612 = (_e4874 - _e1227);
let _e5613 = (_e5612 * _e5611);
let _e5615 = ((_e4879 - _e1227) * _e5611);
let _e5621 = select(_e5615, _e5613, (_e5613 < _e5615));
let _e5623 = select(0f, _e5621, (_e5621 > 0f));
let _e5626 = select(select(1f, _e5623, (_e5623 < 1f)), select(2f, 0f, ((_e1227 >= _e4874) && (_e1227 <= _e4879))), _e5609);
let _e5628 = select(_e5615, _e5613, (_e5613 > _e5615));
let _e5630 = select(0f, _e5628, (_e5628 > 0f));
let _e5633 = select(select(1f, _e5630, (_e5630 < 1f)), 1f, _e5609);
let _e5634 = (_e1269 - _e1242);
let _e5638 = (bitcast<f32>((bitcast<u32>(_e5634) & 2147483647u)) < 1e-12f);
let _e5640 = (1f / select(_e5634, 1f, _e5638));
let _e5641 = (_e4888 - _e1242);
let _e5642 = (_e5641 * _e5640);
let _e5644 = ((_e4893 - _e1242) * _e5640);
let _e5650 = select(_e5644, _e5642, (_e5642 < _e5644));
let _e5652 = select(0f, _e5650, (_e5650 > 0f));
let _e5655 = select(select(1f, _e5652, (_e5652 < 1f)), select(2f, 0f, ((_e1242 >= _e4888) && (_e1242 <= _e4893))), _e5638);
let _e5657 = select(_e5644, _e5642, (_e5642 > _e5644));
let _e5659 = select(0f, _e5657, (_e5657 > 0f));
let _e5662 = select(select(1f, _e5659, (_e5659 < 1f)), 1f, _e5638);
let _e5663 = (_e1275 - _e1257);
let _e5667 = (bitcast<f32>((bitcast<u32>(_e5663) & 2147483647u)) < 1e-12f);
let _e5669 = (1f / select(_e5663, 1f, _e5667));
let _e5670 = (_e4902 - _e1257);
let _e5671 = (_e5670 * _e5669);
let _e5673 = ((_e4907 - _e1257) * _e5669);
let _e5679 = select(_e5673, _e5671, (_e5671 < _e5673));
let _e5681 = select(0f, _e5679, (_e5679 > 0f));
let _e5684 = select(select(1f, _e5681, (_e5681 < 1f)), select(2f, 0f, ((_e1257 >= _e4902) && (_e1257 <= _e4907))), _e5667);
let _e5686 = select(_e5673, _e5671, (_e5671 > _e5673));
let _e5688 = select(0f, _e5686, (_e5686 > 0f));
let _e5691 = select(select(1f, _e5688, (_e5688 < 1f)), 1f, _e5667);
let _e5693 = select(_e5655, _e5626, (_e5626 > _e5655));
let _e5697 = select(_e5662, _e5633, (_e5633 < _e5662));
let _e5700 = (select(_e5691, _e5697, (_e5697 < _e5691)) - select(_e5684, _e5693, (_e5693 > _e5684)));
let _e5702 = select(0f, _e5700, (_e5700 > 0f));
let _e5703 = (_e1207 - _e1184);
let _e5704 = (_e1212 - _e1197);
let _e5705 = (_e1201 - _e1162);
let _e5710 = (((_e5703 * _e5703) + (_e5704 * _e5704)) + (_e5705 * _e5705));
let _e5718 = global_1.member.member_7.member_3;
let _e5719 = ((sqrt(select(0f, _e5710, (_e5710 > 0f))) * _e5702) * _e5718);
if (((_e191.member_2 == 3u) || (_e191.member_2 == 4u)) || _e1277) {
local_7 = _e5358;
let _e5724 = local_7;
let _e5726 = (bitcast<i32>(_e181) - 1i);
let _e5728 = select(_e5726, 263171i, (263171i < _e5726));
let _e5733 = global_3.member[bitcast<u32>(select(0i, _e5728, (_e5728 > 0i)))];
let _e5734 = bitcast<f32>(_e5733);
let _e5736 = select(_e5726, 263172i, (263172i < _e5726));
let _e5741 = global_3.member[bitcast<u32>(select(0i, _e5736, (_e5736 > 0i)))];
let _e5742 = bitcast<f32>(_e5741);
let _e5744 = select(_e5726, 263173i, (263173i < _e5726));
let _e5749 = global_3.member[bitcast<u32>(select(0i, _e5744, (_e5744 > 0i)))];
let _e5750 = bitcast<f32>(_e5749);
let _e5752 = ((_e5724 - _e5734) * _e5742);
let _e5754 = select(0f, _e5752, (_e5752 > 0f));
let _e5757 = local_7;
let _e5759 = select(_e5726, 263174i, (263174i < _e5726));
let _e5764 = global_3.member[bitcast<u32>(select(0i, _e5759, (_e5759 > 0i)))];
let _e5765 = bitcast<f32>(_e5764);
let _e5767 = select(_e5726, 263175i, (263175i < _e5726));
let _e5772 = global_3.member[bitcast<u32>(select(0i, _e5767, (_e5767 > 0i)))];
let _e5773 = bitcast<f32>(_e5772);
let _e5775 = select(_e5726, 263176i, (263176i < _e5726));
let _e5780 = global_3.member[bitcast<u32>(select(0i, _e5775, (_e5775 > 0i)))];
let _e5781 = bitcast<f32>(_e5780);
let _e5783 = ((_e5757 - _e5765) * _e5773);
let _e5785 = select(0f, _e5783, (_e5783 > 0f));
let _e5789 = local_7;
let _e5791 = select(_e5726, 263177i, (263177i < _e5726));
let _e5796 = global_3.member[bitcast<u32>(select(0i, _e5791, (_e5791 > 0i)))];
let _e5797 = bitcast<f32>(_e5796);
let _e5799 = select(_e5726, 263178i, (263178i < _e5726));
let _e5804 = global_3.member[bitcast<u32>(select(0i, _e5799, (_e5799 > 0i)))];
let _e5805 = bitcast<f32>(_e5804);
let _e5807 = select(_e5726, 263179i, (263179i < _e5726));
let _e5812 = global_3.member[bitcast<u32>(select(0i, _e5807, (_e5807 > 0i)))];
let _e5813 = bitcast<f32>(_e5812);
let _e5815 = ((_e5789 - _e5797) * _e5805);
let _e5817 = select(0f, _e5815, (_e5815 > 0f));
let _e5820 = local_7;
let _e5822 = select(_e5726, 263180i, (263180i < _e5726));
let _e5827 = global_3.member[bitcast<u32>(select(0i, _e5822, (_e5822 > 0i)))];
let _e5828 = bitcast<f32>(_e5827);
let _e5830 = select(_e5726, 263181i, (263181i < _e5726));
let _e5835 = global_3.member[bitcast<u32>(select(0i, _e5830, (_e5830 > 0i)))];
let _e5836 = bitcast<f32>(_e5835);
let _e5838 = select(_e5726, 263182i, (263182i < _e5726));
let _e5843 = global_3.member[bitcast<u32>(select(0i, _e5838, (_e5838 > 0i)))];
let _e5844 = bitcast<f32>(_e5843);
let _e5846 = ((_e5820 - _e5828) * _e5836);
let _e5848 = select(0f, _e5846, (_e5846 > 0f));
let _e5853 = local_7;
let _e5855 = select(_e5726, 263183i, (263183i < _e5726));
let _e5860 = global_3.member[bitcast<u32>(select(0i, _e5855, (_e5855 > 0i)))];
let _e5861 = bitcast<f32>(_e5860);
let _e5863 = select(_e5726, 263184i, (263184i < _e5726));
let _e5868 = global_3.member[bitcast<u32>(select(0i, _e5863, (_e5863 > 0i)))];
let _e5869 = bitcast<f32>(_e5868);
let _e5871 = select(_e5726, 263185i, (263185i < _e5726));
let _e5876 = global_3.member[bitcast<u32>(select(0i, _e5871, (_e5871 > 0i)))];
let _e5877 = bitcast<f32>(_e5876);
let _e5879 = ((_e5853 - _e5861) * _e5869);
let _e5881 = select(0f, _e5879, (_e5879 > 0f));
let _e5884 = local_7;
let _e5886 = select(_e5726, 263186i, (263186i < _e5726));
let _e5891 = global_3.member[bitcast<u32>(select(0i, _e5886, (_e5886 > 0i)))];
let _e5892 = bitcast<f32>(_e5891);
let _e5894 = select(_e5726, 263187i, (263187i < _e5726));
let _e5899 = global_3.member[bitcast<u32>(select(0i, _e5894, (_e5894 > 0i)))];
let _e5900 = bitcast<f32>(_e5899);
let _e5902 = select(_e5726, 263188i, (263188i < _e5726));
let _e5907 = global_3.member[bitcast<u32>(select(0i, _e5902, (_e5902 > 0i)))];
let _e5908 = bitcast<f32>(_e5907);
let _e5910 = ((_e5884 - _e5892) * _e5900);
let _e5912 = select(0f, _e5910, (_e5910 > 0f));
let _e5916 = local_7;
let _e5918 = select(_e5726, 263189i, (263189i < _e5726));
let _e5923 = global_3.member[bitcast<u32>(select(0i, _e5918, (_e5918 > 0i)))];
let _e5924 = bitcast<f32>(_e5923);
let _e5926 = select(_e5726, 263190i, (263190i < _e5726));
let _e5931 = global_3.member[bitcast<u32>(select(0i, _e5926, (_e5926 > 0i)))];
let _e5932 = bitcast<f32>(_e5931);
let _e5934 = select(_e5726, 263191i, (263191i < _e5726));
let _e5939 = global_3.member[bitcast<u32>(select(0i, _e5934, (_e5934 > 0i)))];
let _e5940 = bitcast<f32>(_e5939);
let _e5942 = ((_e5916 - _e5924) * _e5932);
let _e5944 = select(0f, _e5942, (_e5942 > 0f));
let _e5947 = local_7;
let _e5949 = select(_e5726, 263192i, (263192i < _e5726));
let _e5954 = global_3.member[bitcast<u32>(select(0i, _e5949, (_e5949 > 0i)))];
let _e5955 = bitcast<f32>(_e5954);
let _e5957 = select(_e5726, 263193i, (263193i < _e5726));
let _e5962 = global_3.member[bitcast<u32>(select(0i, _e5957, (_e5957 > 0i)))];
let _e5963 = bitcast<f32>(_e5962);
let _e5965 = select(_e5726, 263194i, (263194i < _e5726));
let _e5970 = global_3.member[bitcast<u32>(select(0i, _e5965, (_e5965 > 0i)))];
let _e5971 = bitcast<f32>(_e5970);
let _e5973 = ((_e5947 - _e5955) * _e5963);
let _e5975 = select(0f, _e5973, (_e5973 > 0f));
let _e5980 = (((select(_e5750, _e5754, (_e5754 < _e5750)) + select(_e5781, _e5785, (_e5785 < _e5781))) + (select(_e5813, _e5817, (_e5817 < _e5813)) + select(_e5844, _e5848, (_e5848 < _e5844)))) + ((select(_e5877, _e5881, (_e5881 < _e5877)) + select(_e5908, _e5912, (_e5912 < _e5908))) + (select(_e5940, _e5944, (_e5944 < _e5940)) + select(_e5971, _e5975, (_e5975 < _e5971)))));
local_6 = _e4869.member;
let _e5981 = local_6;
let _e5983 = ((_e5981 - _e5734) * _e5742);
let _e5985 = select(0f, _e5983, (_e5983 > 0f));
let _e5988 = local_6;
let _e5990 = ((_e5988 - _e5765) * _e5773);
let _e5992 = select(0f, _e5990, (_e5990 > 0f));
let _e5996 = local_6;
let _e5998 = ((_e5996 - _e5797) * _e5805);
let _e6000 = select(0f, _e5998, (_e5998 > 0f));
let _e6003 = local_6;
let _e6005 = ((_e6003 - _e5828) * _e5836);
let _e6007 = select(0f, _e6005, (_e6005 > 0f));
let _e6012 = local_6;
let _e6014 = ((_e6012 - _e5861) * _e5869);
let _e6016 = select(0f, _e6014, (_e6014 > 0f));
let _e6019 = local_6;
let _e6021 = ((_e6019 - _e5892) * _e5900);
let _e6023 = select(0f, _e6021, (_e6021 > 0f));
let _e6027 = local_6;
let _e6029 = ((_e6027 - _e5924) * _e5932);
let _e6031 = select(0f, _e6029, (_e6029 > 0f));
let _e6034 = local_6;
let _e6036 = ((_e6034 - _e5955) * _e5963);
let _e6038 = select(0f, _e6036, (_e6036 > 0f));
let _e6043 = (((select(_e5750, _e5985, (_e5985 < _e5750)) + select(_e5781, _e5992, (_e5992 < _e5781))) + (select(_e5813, _e6000, (_e6000 < _e5813)) + select(_e5844, _e6007, (_e6007 < _e5844)))) + ((select(_e5877, _e6016, (_e6016 < _e5877)) + select(_e5908, _e6023, (_e6023 < _e5908))) + (select(_e5940, _e6031, (_e6031 < _e5940)) + select(_e5971, _e6038, (_e6038 < _e5971)))));
let _e6044 = (255f - 1f);
let _e6046 = select(0f, _e5980, (_e5980 > 0f));
let _e6048 = select(_e6044, _e6046, (_e6046 < _e6044));
let _e6055 = select(0i, select(select(i32(_e6048), i32(-2147483648), (_e6048 < -2147483600f)), 2147483647i, (_e6048 > 2147483500f)), (_e6048 == _e6048));
let _e6059 = (_e6055 - select(0i, 1i, (_e6048 < f32(_e6055))));
let _e6061 = select(0f, _e6043, (_e6043 > 0f));
let _e6063 = select(_e6044, _e6061, (_e6061 < _e6044));
let _e6070 = select(0i, select(select(i32(_e6063), i32(-2147483648), (_e6063 < -2147483600f)), 2147483647i, (_e6063 > 2147483500f)), (_e6063 == _e6063));
let _e6074 = (_e6070 - select(0i, 1i, (_e6063 < f32(_e6070))));
let _e6076 = select(_e5726, 263195i, (263195i < _e5726));
let _e6082 = global_3.member[bitcast<u32>(select(0i, _e6076, (_e6076 > 0i)))];
let _e6083 = bitcast<f32>(_e6082);
let _e6085 = select(_e5726, 263196i, (263196i < _e5726));
let _e6091 = global_3.member[bitcast<u32>(select(0i, _e6085, (_e6085 > 0i)))];
let _e6092 = bitcast<f32>(_e6091);
let _e6093 = (_e4869.member - _e5358);
let _e6099 = (1f / select(_e6093, 1f, (bitcast<f32>((bitcast<u32>(_e6093) & 2147483647u)) < 1e-20f)));
let _e6105 = ((select(_e6083, _e4869.member, (_e4869.member < _e6083)) - select(_e6083, _e5358, (_e5358 < _e6083))) * _e6099);
let _e6111 = ((select(_e6092, _e4869.member, (_e4869.member > _e6092)) - select(_e6092, _e5358, (_e5358 > _e6092))) * _e6099);
let _e6114 = (((_e6059 * 256i) + _e6074) * 4i);
let _e6118 = (_e6043 - f32(_e6074));
let _e6121 = (_e6114 + 1i);
let _e6123 = select(_e5726, _e6121, (_e6121 < _e5726));
let _e6129 = global_3.member[bitcast<u32>(select(0i, _e6123, (_e6123 > 0i)))];
let _e6136 = (bitcast<f32>((((_e6129 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6137 = (_e6114 + 5i);
let _e6139 = select(_e5726, _e6137, (_e6137 < _e5726));
let _e6145 = global_3.member[bitcast<u32>(select(0i, _e6139, (_e6139 > 0i)))];
let _e6153 = (_e6114 + 1025i);
let _e6155 = select(_e5726, _e6153, (_e6153 < _e5726));
let _e6161 = global_3.member[bitcast<u32>(select(0i, _e6155, (_e6155 > 0i)))];
let _e6168 = (bitcast<f32>((((_e6161 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6169 = (_e6114 + 1029i);
let _e6171 = select(_e5726, _e6169, (_e6169 < _e5726));
let _e6177 = global_3.member[bitcast<u32>(select(0i, _e6171, (_e6171 > 0i)))];
let _e6187 = (_e6136 + (((bitcast<f32>((((_e6145 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6136) * _e6118));
let _e6195 = select(_e5726, 1i, (1i < _e5726));
let _e6201 = global_3.member[bitcast<u32>(select(0i, _e6195, (_e6195 > 0i)))];
let _e6210 = select(_e5726, 262141i, (262141i < _e5726));
let _e6216 = global_3.member[bitcast<u32>(select(0i, _e6210, (_e6210 > 0i)))];
let _e6228 = (((_e6187 + (((_e6168 + (((bitcast<f32>((((_e6177 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6168) * _e6118)) - _e6187) * (_e5980 - f32(_e6059)))) * (1f - (_e6105 + _e6111))) + (((bitcast<f32>((((_e6201 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6105) + ((bitcast<f32>((((_e6216 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6111)));
let _e6233 = (_e5604.member.member_1 - _e5604.member.member);
let _e6238 = -((_e6228 * (_e5719 * select(0f, _e6233, (_e6233 > 0f)))));
let _e6240 = select(-87f, _e6238, (_e6238 > -87f));
let _e6242 = select(88f, _e6240, (_e6240 < 88f));
let _e6244 = ((_e6242 * 1.442695f) + 0.5f);
let _e6246 = select(-127f, _e6244, (_e6244 > -127f));
let _e6248 = select(128f, _e6246, (_e6246 < 128f));
let _e6255 = select(0i, select(select(i32(_e6248), i32(-2147483648), (_e6248 < -2147483600f)), 2147483647i, (_e6248 > 2147483500f)), (_e6248 == _e6248));
let _e6259 = (_e6255 - select(0i, 1i, (_e6248 < f32(_e6255))));
let _e6260 = f32(_e6259);
let _e6264 = ((_e6242 - (_e6260 * 0.6933594f)) - (_e6260 * -2.1219444e-4f));
let _e6284 = ((1f + (_e6264 * (1f + (_e6264 * (0.5f + (_e6264 * (0.16666667f + (_e6264 * (0.041666668f + (_e6264 * (0.008333334f + (_e6264 * (0.001388889f + (_e6264 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6259 + 127i)) << bitcast<u32>(23i))));
let _e6285 = (1f - _e6284);
phi_14776_ = type_38(_e6284, _e6285, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e6285 / select(1e-12f, _e6228, (_e6228 > 1e-12f))))));
} else {
local_5 = _e5358;
let _e6292 = local_5;
let _e6294 = (bitcast<i32>(_e181) - 1i);
let _e6296 = select(_e6294, 263171i, (263171i < _e6294));
let _e6301 = global_3.member[bitcast<u32>(select(0i, _e6296, (_e6296 > 0i)))];
let _e6302 = bitcast<f32>(_e6301);
let _e6304 = select(_e6294, 263172i, (263172i < _e6294));
let _e6309 = global_3.member[bitcast<u32>(select(0i, _e6304, (_e6304 > 0i)))];
let _e6310 = bitcast<f32>(_e6309);
let _e6312 = select(_e6294, 263173i, (263173i < _e6294));
let _e6317 = global_3.member[bitcast<u32>(select(0i, _e6312, (_e6312 > 0i)))];
let _e6318 = bitcast<f32>(_e6317);
let _e6320 = ((_e6292 - _e6302) * _e6310);
let _e6322 = select(0f, _e6320, (_e6320 > 0f));
let _e6325 = local_5;
let _e6327 = select(_e6294, 263174i, (263174i < _e6294));
let _e6332 = global_3.member[bitcast<u32>(select(0i, _e6327, (_e6327 > 0i)))];
let _e6333 = bitcast<f32>(_e6332);
let _e6335 = select(_e6294, 263175i, (263175i < _e6294));
let _e6340 = global_3.member[bitcast<u32>(select(0i, _e6335, (_e6335 > 0i)))];
let _e6341 = bitcast<f32>(_e6340);
let _e6343 = select(_e6294, 263176i, (263176i < _e6294));
let _e6348 = global_3.member[bitcast<u32>(select(0i, _e6343, (_e6343 > 0i)))];
let _e6349 = bitcast<f32>(_e6348);
let _e6351 = ((_e6325 - _e6333) * _e6341);
let _e6353 = select(0f, _e6351, (_e6351 > 0f));
let _e6357 = local_5;
let _e6359 = select(_e6294, 263177i, (263177i < _e6294));
let _e6364 = global_3.member[bitcast<u32>(select(0i, _e6359, (_e6359 > 0i)))];
let _e6365 = bitcast<f32>(_e6364);
let _e6367 = select(_e6294, 263178i, (263178i < _e6294));
let _e6372 = global_3.member[bitcast<u32>(select(0i, _e6367, (_e6367 > 0i)))];
let _e6373 = bitcast<f32>(_e6372);
let _e6375 = select(_e6294, 263179i, (263179i < _e6294));
let _e6380 = global_3.member[bitcast<u32>(select(0i, _e6375, (_e6375 > 0i)))];
let _e6381 = bitcast<f32>(_e6380);
let _e6383 = ((_e6357 - _e6365) * _e6373);
let _e6385 = select(0f, _e6383, (_e6383 > 0f));
let _e6388 = local_5;
let _e6390 = select(_e6294, 263180i, (263180i < _e6294));
let _e6395 = global_3.member[bitcast<u32>(select(0i, _e6390, (_e6390 > 0i)))];
let _e6396 = bitcast<f32>(_e6395);
let _e6398 = select(_e6294, 263181i, (263181i < _e6294));
let _e6403 = global_3.member[bitcast<u32>(select(0i, _e6398, (_e6398 > 0i)))];
let _e6404 = bitcast<f32>(_e6403);
let _e6406 = select(_e6294, 263182i, (263182i < _e6294));
let _e6411 = global_3.member[bitcast<u32>(select(0i, _e6406, (_e6406 > 0i)))];
let _e6412 = bitcast<f32>(_e6411);
let _e6414 = ((_e6388 - _e6396) * _e6404);
let _e6416 = select(0f, _e6414, (_e6414 > 0f));
let _e6421 = local_5;
let _e6423 = select(_e6294, 263183i, (263183i < _e6294));
let _e6428 = global_3.member[bitcast<u32>(select(0i, _e6423, (_e6423 > 0i)))];
let _e6429 = bitcast<f32>(_e6428);
let _e6431 = select(_e6294, 263184i, (263184i < _e6294));
let _e6436 = global_3.member[bitcast<u32>(select(0i, _e6431, (_e6431 > 0i)))];
let _e6437 = bitcast<f32>(_e6436);
let _e6439 = select(_e6294, 263185i, (263185i < _e6294));
let _e6444 = global_3.member[bitcast<u32>(select(0i, _e6439, (_e6439 > 0i)))];
let _e6445 = bitcast<f32>(_e6444);
let _e6447 = ((_e6421 - _e6429) * _e6437);
let _e6449 = select(0f, _e6447, (_e6447 > 0f));
let _e6452 = local_5;
let _e6454 = select(_e6294, 263186i, (263186i < _e6294));
let _e6459 = global_3.member[bitcast<u32>(select(0i, _e6454, (_e6454 > 0i)))];
let _e6460 = bitcast<f32>(_e6459);
let _e6462 = select(_e6294, 263187i, (263187i < _e6294));
let _e6467 = global_3.member[bitcast<u32>(select(0i, _e6462, (_e6462 > 0i)))];
let _e6468 = bitcast<f32>(_e6467);
let _e6470 = select(_e6294, 263188i, (263188i < _e6294));
let _e6475 = global_3.member[bitcast<u32>(select(0i, _e6470, (_e6470 > 0i)))];
let _e6476 = bitcast<f32>(_e6475);
let _e6478 = ((_e6452 - _e6460) * _e6468);
let _e6480 = select(0f, _e6478, (_e6478 > 0f));
let _e6484 = local_5;
let _e6486 = select(_e6294, 263189i, (263189i < _e6294));
let _e6491 = global_3.member[bitcast<u32>(select(0i, _e6486, (_e6486 > 0i)))];
let _e6492 = bitcast<f32>(_e6491);
let _e6494 = select(_e6294, 263190i, (263190i < _e6294));
let _e6499 = global_3.member[bitcast<u32>(select(0i, _e6494, (_e6494 > 0i)))];
let _e6500 = bitcast<f32>(_e6499);
let _e6502 = select(_e6294, 263191i, (263191i < _e6294));
let _e6507 = global_3.member[bitcast<u32>(select(0i, _e6502, (_e6502 > 0i)))];
let _e6508 = bitcast<f32>(_e6507);
let _e6510 = ((_e6484 - _e6492) * _e6500);
let _e6512 = select(0f, _e6510, (_e6510 > 0f));
let _e6515 = local_5;
let _e6517 = select(_e6294, 263192i, (263192i < _e6294));
let _e6522 = global_3.member[bitcast<u32>(select(0i, _e6517, (_e6517 > 0i)))];
let _e6523 = bitcast<f32>(_e6522);
let _e6525 = select(_e6294, 263193i, (263193i < _e6294));
let _e6530 = global_3.member[bitcast<u32>(select(0i, _e6525, (_e6525 > 0i)))];
let _e6531 = bitcast<f32>(_e6530);
let _e6533 = select(_e6294, 263194i, (263194i < _e6294));
let _e6538 = global_3.member[bitcast<u32>(select(0i, _e6533, (_e6533 > 0i)))];
let _e6539 = bitcast<f32>(_e6538);
let _e6541 = ((_e6515 - _e6523) * _e6531);
let _e6543 = select(0f, _e6541, (_e6541 > 0f));
let _e6548 = (((select(_e6318, _e6322, (_e6322 < _e6318)) + select(_e6349, _e6353, (_e6353 < _e6349))) + (select(_e6381, _e6385, (_e6385 < _e6381)) + select(_e6412, _e6416, (_e6416 < _e6412)))) + ((select(_e6445, _e6449, (_e6449 < _e6445)) + select(_e6476, _e6480, (_e6480 < _e6476))) + (select(_e6508, _e6512, (_e6512 < _e6508)) + select(_e6539, _e6543, (_e6543 < _e6539)))));
local_4 = _e4869.member;
let _e6549 = local_4;
let _e6551 = ((_e6549 - _e6302) * _e6310);
let _e6553 = select(0f, _e6551, (_e6551 > 0f));
let _e6556 = local_4;
let _e6558 = ((_e6556 - _e6333) * _e6341);
let _e6560 = select(0f, _e6558, (_e6558 > 0f));
let _e6564 = local_4;
let _e6566 = ((_e6564 - _e6365) * _e6373);
let _e6568 = select(0f, _e6566, (_e6566 > 0f));
let _e6571 = local_4;
let _e6573 = ((_e6571 - _e6396) * _e6404);
let _e6575 = select(0f, _e6573, (_e6573 > 0f));
let _e6580 = local_4;
let _e6582 = ((_e6580 - _e6429) * _e6437);
let _e6584 = select(0f, _e6582, (_e6582 > 0f));
let _e6587 = local_4;
let _e6589 = ((_e6587 - _e6460) * _e6468);
let _e6591 = select(0f, _e6589, (_e6589 > 0f));
let _e6595 = local_4;
let _e6597 = ((_e6595 - _e6492) * _e6500);
let _e6599 = select(0f, _e6597, (_e6597 > 0f));
let _e6602 = local_4;
let _e6604 = ((_e6602 - _e6523) * _e6531);
let _e6606 = select(0f, _e6604, (_e6604 > 0f));
let _e6611 = (((select(_e6318, _e6553, (_e6553 < _e6318)) + select(_e6349, _e6560, (_e6560 < _e6349))) + (select(_e6381, _e6568, (_e6568 < _e6381)) + select(_e6412, _e6575, (_e6575 < _e6412)))) + ((select(_e6445, _e6584, (_e6584 < _e6445)) + select(_e6476, _e6591, (_e6591 < _e6476))) + (select(_e6508, _e6599, (_e6599 < _e6508)) + select(_e6539, _e6606, (_e6606 < _e6539)))));
let _e6612 = (255f - 1f);
let _e6614 = select(0f, _e6548, (_e6548 > 0f));
let _e6616 = select(_e6612, _e6614, (_e6614 < _e6612));
let _e6623 = select(0i, select(select(i32(_e6616), i32(-2147483648), (_e6616 < -2147483600f)), 2147483647i, (_e6616 > 2147483500f)), (_e6616 == _e6616));
let _e6627 = (_e6623 - select(0i, 1i, (_e6616 < f32(_e6623))));
let _e6629 = select(0f, _e6611, (_e6611 > 0f));
let _e6631 = select(_e6612, _e6629, (_e6629 < _e6612));
let _e6638 = select(0i, select(select(i32(_e6631), i32(-2147483648), (_e6631 < -2147483600f)), 2147483647i, (_e6631 > 2147483500f)), (_e6631 == _e6631));
let _e6642 = (_e6638 - select(0i, 1i, (_e6631 < f32(_e6638))));
let _e6644 = select(_e6294, 263195i, (263195i < _e6294));
let _e6650 = global_3.member[bitcast<u32>(select(0i, _e6644, (_e6644 > 0i)))];
let _e6651 = bitcast<f32>(_e6650);
let _e6653 = select(_e6294, 263196i, (263196i < _e6294));
let _e6659 = global_3.member[bitcast<u32>(select(0i, _e6653, (_e6653 > 0i)))];
let _e6660 = bitcast<f32>(_e6659);
let _e6661 = (_e4869.member - _e5358);
let _e6667 = (1f / select(_e6661, 1f, (bitcast<f32>((bitcast<u32>(_e6661) & 2147483647u)) < 1e-20f)));
let _e6673 = ((select(_e6651, _e4869.member, (_e4869.member < _e6651)) - select(_e6651, _e5358, (_e5358 < _e6651))) * _e6667);
let _e6679 = ((select(_e6660, _e4869.member, (_e4869.member > _e6660)) - select(_e6660, _e5358, (_e5358 > _e6660))) * _e6667);
let _e6682 = (((_e6627 * 256i) + _e6642) * 4i);
let _e6684 = (_e6548 - f32(_e6627));
let _e6686 = (_e6611 - f32(_e6642));
let _e6688 = (1f - (_e6673 + _e6679));
let _e6690 = select(_e6294, _e6682, (_e6682 < _e6294));
let _e6696 = global_3.member[bitcast<u32>(select(0i, _e6690, (_e6690 > 0i)))];
let _e6701 = (bitcast<f32>(((_e6696 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6708 = (bitcast<f32>((((_e6696 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6709 = (_e6682 + 4i);
let _e6711 = select(_e6294, _e6709, (_e6709 < _e6294));
let _e6717 = global_3.member[bitcast<u32>(select(0i, _e6711, (_e6711 > 0i)))];
let _e6730 = (_e6682 + 1024i);
let _e6732 = select(_e6294, _e6730, (_e6730 < _e6294));
let _e6738 = global_3.member[bitcast<u32>(select(0i, _e6732, (_e6732 > 0i)))];
let _e6743 = (bitcast<f32>(((_e6738 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6750 = (bitcast<f32>((((_e6738 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6751 = (_e6682 + 1028i);
let _e6753 = select(_e6294, _e6751, (_e6751 < _e6294));
let _e6759 = global_3.member[bitcast<u32>(select(0i, _e6753, (_e6753 > 0i)))];
let _e6774 = (_e6701 + (((bitcast<f32>(((_e6717 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6701) * _e6686));
let _e6783 = (_e6708 + (((bitcast<f32>((((_e6717 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6708) * _e6686));
let _e6791 = select(_e6294, 0i, (0i < _e6294));
let _e6797 = global_3.member[bitcast<u32>(select(0i, _e6791, (_e6791 > 0i)))];
let _e6811 = select(_e6294, 262140i, (262140i < _e6294));
let _e6817 = global_3.member[bitcast<u32>(select(0i, _e6811, (_e6811 > 0i)))];
let _e6840 = (_e6682 + 1i);
let _e6842 = select(_e6294, _e6840, (_e6840 < _e6294));
let _e6848 = global_3.member[bitcast<u32>(select(0i, _e6842, (_e6842 > 0i)))];
let _e6853 = (bitcast<f32>(((_e6848 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6860 = (bitcast<f32>((((_e6848 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6861 = (_e6682 + 5i);
let _e6863 = select(_e6294, _e6861, (_e6861 < _e6294));
let _e6869 = global_3.member[bitcast<u32>(select(0i, _e6863, (_e6863 > 0i)))];
let _e6882 = (_e6682 + 1025i);
let _e6884 = select(_e6294, _e6882, (_e6882 < _e6294));
let _e6890 = global_3.member[bitcast<u32>(select(0i, _e6884, (_e6884 > 0i)))];
let _e6895 = (bitcast<f32>(((_e6890 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6902 = (bitcast<f32>((((_e6890 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6903 = (_e6682 + 1029i);
let _e6905 = select(_e6294, _e6903, (_e6903 < _e6294));
let _e6911 = global_3.member[bitcast<u32>(select(0i, _e6905, (_e6905 > 0i)))];
let _e6926 = (_e6853 + (((bitcast<f32>(((_e6869 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6853) * _e6686));
let _e6935 = (_e6860 + (((bitcast<f32>((((_e6869 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6860) * _e6686));
let _e6943 = select(_e6294, 1i, (1i < _e6294));
let _e6949 = global_3.member[bitcast<u32>(select(0i, _e6943, (_e6943 > 0i)))];
let _e6963 = select(_e6294, 262141i, (262141i < _e6294));
let _e6969 = global_3.member[bitcast<u32>(select(0i, _e6963, (_e6963 > 0i)))];
let _e6991 = (((_e6935 + (((_e6902 + (((bitcast<f32>((((_e6911 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6902) * _e6686)) - _e6935) * _e6684)) * _e6688) + (((bitcast<f32>((((_e6949 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6673) + ((bitcast<f32>((((_e6969 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6679)));
let _e6996 = (_e5604.member.member_1 - _e5604.member.member);
let _e7004 = (_e5604.member_1.member_1 - _e5604.member_1.member);
let _e7007 = (_e5719 * select(0f, _e7004, (_e7004 > 0f)));
let _e7009 = -(((((_e6926 + (((_e6895 + (((bitcast<f32>(((_e6911 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6895) * _e6686)) - _e6926) * _e6684)) * _e6688) + (((bitcast<f32>(((_e6949 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6673) + ((bitcast<f32>(((_e6969 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6679))) * _e7007));
let _e7011 = select(-87f, _e7009, (_e7009 > -87f));
let _e7013 = select(88f, _e7011, (_e7011 < 88f));
let _e7015 = ((_e7013 * 1.442695f) + 0.5f);
let _e7017 = select(-127f, _e7015, (_e7015 > -127f));
let _e7019 = select(128f, _e7017, (_e7017 < 128f));
let _e7026 = select(0i, select(select(i32(_e7019), i32(-2147483648), (_e7019 < -2147483600f)), 2147483647i, (_e7019 > 2147483500f)), (_e7019 == _e7019));
let _e7030 = (_e7026 - select(0i, 1i, (_e7019 < f32(_e7026))));
let _e7031 = f32(_e7030);
let _e7035 = ((_e7013 - (_e7031 * 0.6933594f)) - (_e7031 * -2.1219444e-4f));
let _e7057 = -(((((_e6774 + (((_e6743 + (((bitcast<f32>(((_e6759 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6743) * _e6686)) - _e6774) * _e6684)) * _e6688) + (((bitcast<f32>(((_e6797 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6673) + ((bitcast<f32>(((_e6817 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6679))) * _e7007));
let _e7059 = select(-87f, _e7057, (_e7057 > -87f));
let _e7061 = select(88f, _e7059, (_e7059 < 88f));
let _e7063 = ((_e7061 * 1.442695f) + 0.5f);
let _e7065 = select(-127f, _e7063, (_e7063 > -127f));
let _e7067 = select(128f, _e7065, (_e7065 < 128f));
let _e7074 = select(0i, select(select(i32(_e7067), i32(-2147483648), (_e7067 < -2147483600f)), 2147483647i, (_e7067 > 2147483500f)), (_e7067 == _e7067));
let _e7078 = (_e7074 - select(0i, 1i, (_e7067 < f32(_e7074))));
let _e7079 = f32(_e7078);
let _e7083 = ((_e7061 - (_e7079 * 0.6933594f)) - (_e7079 * -2.1219444e-4f));
let _e7105 = -(((((_e6783 + (((_e6750 + (((bitcast<f32>((((_e6759 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6750) * _e6686)) - _e6783) * _e6684)) * _e6688) + (((bitcast<f32>((((_e6797 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6673) + ((bitcast<f32>((((_e6817 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6679))) * _e7007));
let _e7107 = select(-87f, _e7105, (_e7105 > -87f));
let _e7109 = select(88f, _e7107, (_e7107 < 88f));
let _e7111 = ((_e7109 * 1.442695f) + 0.5f);
let _e7113 = select(-127f, _e7111, (_e7111 > -127f));
let _e7115 = select(128f, _e7113, (_e7113 < 128f));
let _e7122 = select(0i, select(select(i32(_e7115), i32(-2147483648), (_e7115 < -2147483600f)), 2147483647i, (_e7115 > 2147483500f)), (_e7115 == _e7115));
let _e7126 = (_e7122 - select(0i, 1i, (_e7115 < f32(_e7122))));
let _e7127 = f32(_e7126);
let _e7131 = ((_e7109 - (_e7127 * 0.6933594f)) - (_e7127 * -2.1219444e-4f));
let _e7154 = -((_e6991 * (_e5719 * select(0f, _e6996, (_e6996 > 0f)))));
let _e7156 = select(-87f, _e7154, (_e7154 > -87f));
let _e7158 = select(88f, _e7156, (_e7156 < 88f));
let _e7160 = ((_e7158 * 1.442695f) + 0.5f);
let _e7162 = select(-127f, _e7160, (_e7160 > -127f));
let _e7164 = select(128f, _e7162, (_e7162 < 128f));
let _e7171 = select(0i, select(select(i32(_e7164), i32(-2147483648), (_e7164 < -2147483600f)), 2147483647i, (_e7164 > 2147483500f)), (_e7164 == _e7164));
let _e7175 = (_e7171 - select(0i, 1i, (_e7164 < f32(_e7171))));
let _e7176 = f32(_e7175);
let _e7180 = ((_e7158 - (_e7176 * 0.6933594f)) - (_e7176 * -2.1219444e-4f));
let _e7200 = ((1f + (_e7180 * (1f + (_e7180 * (0.5f + (_e7180 * (0.16666667f + (_e7180 * (0.041666668f + (_e7180 * (0.008333334f + (_e7180 * (0.001388889f + (_e7180 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7175 + 127i)) << bitcast<u32>(23i))));
let _e7201 = (1f - _e7200);
phi_14776_ = type_38(_e7200, _e7201, vec3<f32>(((1f + (_e7035 * (1f + (_e7035 * (0.5f + (_e7035 * (0.16666667f + (_e7035 * (0.041666668f + (_e7035 * (0.008333334f + (_e7035 * (0.001388889f + (_e7035 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7030 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e7083 * (1f + (_e7083 * (0.5f + (_e7083 * (0.16666667f + (_e7083 * (0.041666668f + (_e7083 * (0.008333334f + (_e7083 * (0.001388889f + (_e7083 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7078 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e7131 * (1f + (_e7131 * (0.5f + (_e7131 * (0.16666667f + (_e7131 * (0.041666668f + (_e7131 * (0.008333334f + (_e7131 * (0.001388889f + (_e7131 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7126 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e7201 / select(1e-12f, _e6991, (_e6991 > 1e-12f))))));
}
let _e7209 = phi_14776_;
if (false || ((_e5361 & 1024u) != 0u)) {
let _e7220 = (_e4869.member - _e5358);
let _e7223 = select(_e4869.member, (_e5358 + (_e7220 * _e5604.member.member)), (_e5604.member.member < 1f));
let _e7229 = select(_e7223, select(_e4869.member, (_e5358 + (_e7220 * _e5604.member.member_1)), (_e5604.member.member_1 < 1f)), (_e5604.member.member_1 > _e5604.member.member));
let _e7231 = (bitcast<i32>(_e181) - 1i);
let _e7233 = select(_e7231, 263211i, (263211i < _e7231));
let _e7239 = global_3.member[bitcast<u32>(select(0i, _e7233, (_e7233 > 0i)))];
let _e7240 = bitcast<f32>(_e7239);
let _e7244 = select(_e7231, 263212i, (263212i < _e7231));
let _e7250 = global_3.member[bitcast<u32>(select(0i, _e7244, (_e7244 > 0i)))];
let _e7251 = bitcast<f32>(_e7250);
let _e7256 = select(_e7231, 263213i, (263213i < _e7231));
let _e7262 = global_3.member[bitcast<u32>(select(0i, _e7256, (_e7256 > 0i)))];
let _e7263 = bitcast<f32>(_e7262);
let _e7267 = select(_e7231, 263214i, (263214i < _e7231));
let _e7273 = global_3.member[bitcast<u32>(select(0i, _e7267, (_e7267 > 0i)))];
let _e7274 = bitcast<f32>(_e7273);
let _e7280 = select(_e7231, 263215i, (263215i < _e7231));
let _e7286 = global_3.member[bitcast<u32>(select(0i, _e7280, (_e7280 > 0i)))];
let _e7287 = bitcast<f32>(_e7286);
let _e7291 = select(_e7231, 263216i, (263216i < _e7231));
let _e7297 = global_3.member[bitcast<u32>(select(0i, _e7291, (_e7291 > 0i)))];
let _e7298 = bitcast<f32>(_e7297);
let _e7303 = select(_e7231, 263217i, (263217i < _e7231));
let _e7309 = global_3.member[bitcast<u32>(select(0i, _e7303, (_e7303 > 0i)))];
let _e7310 = bitcast<f32>(_e7309);
let _e7314 = select(_e7231, 263218i, (263218i < _e7231));
let _e7320 = global_3.member[bitcast<u32>(select(0i, _e7314, (_e7314 > 0i)))];
let _e7321 = bitcast<f32>(_e7320);
let _e7353 = (263219i + ((((((select(0i, 1i, (_e7223 >= _e7240)) + select(0i, 1i, (_e7223 >= _e7251))) + (select(0i, 1i, (_e7223 >= _e7263)) + select(0i, 1i, (_e7223 >= _e7274)))) + ((select(0i, 1i, (_e7223 >= _e7287)) + select(0i, 1i, (_e7223 >= _e7298))) + (select(0i, 1i, (_e7223 >= _e7310)) + select(0i, 1i, (_e7223 >= _e7321))))) * 9i) + (((select(0i, 1i, (_e7229 >= _e7240)) + select(0i, 1i, (_e7229 >= _e7251))) + (select(0i, 1i, (_e7229 >= _e7263)) + select(0i, 1i, (_e7229 >= _e7274)))) + ((select(0i, 1i, (_e7229 >= _e7287)) + select(0i, 1i, (_e7229 >= _e7298))) + (select(0i, 1i, (_e7229 >= _e7310)) + select(0i, 1i, (_e7229 >= _e7321)))))) * 6i));
let _e7355 = select(_e7231, _e7353, (_e7353 < _e7231));
let _e7361 = global_3.member[bitcast<u32>(select(0i, _e7355, (_e7355 > 0i)))];
phi_15174_ = (_e7209.member * select(1f, bitcast<f32>(_e7361), (_e5702 > 0f)));
} else {
phi_15174_ = _e7209.member;
}
let _e7366 = phi_15174_;
if _e1284 {
let _e7371 = global_1.member.member_8.member.member;
let _e7379 = global_1.member.member_8.member_1.member;
let _e7387 = global_1.member.member_8.member_2.member;
let _e7391 = (_e4874 - _e1263);
let _e7392 = -(_e5612);
let _e7395 = (_e5612 - _e7391);
let _e7396 = (_e7391 - _e5612);
let _e7398 = select(_e7396, _e7395, (_e7395 > _e7396));
let _e7401 = (select(_e7392, _e5612, (_e5612 > _e7392)) / select(1e-30f, _e7398, (_e7398 > 1e-30f)));
let _e7403 = (_e7391 < 0f);
let _e7405 = select(0f, select(2f, _e7401, _e7403), (_e5612 > 0f));
let _e7406 = (_e7391 > 0f);
let _e7409 = select(2f, select(0f, _e7401, (_e5612 < 0f)), _e7406);
let _e7410 = (_e5612 > -1e30f);
let _e7414 = ((_e7405 > -1f) || ((_e7405 == -1f) && _e7410));
let _e7415 = (_e7409 < 2f);
let _e7416 = select(-1f, _e7405, _e7414);
let _e7420 = select(2f, _e7409, _e7415);
let _e7424 = select(-1e30f, _e5612, _e7410);
let _e7425 = (_e7391 > -1e30f);
let _e7426 = select(-1e30f, _e7391, _e7425);
let _e7430 = (_e1227 - _e4879);
let _e7431 = (_e1263 - _e4879);
let _e7432 = -(_e7430);
let _e7435 = (_e7430 - _e7431);
let _e7436 = (_e7431 - _e7430);
let _e7438 = select(_e7436, _e7435, (_e7435 > _e7436));
let _e7441 = (select(_e7432, _e7430, (_e7430 > _e7432)) / select(1e-30f, _e7438, (_e7438 > 1e-30f)));
let _e7443 = (_e7431 < 0f);
let _e7445 = select(0f, select(2f, _e7441, _e7443), (_e7430 > 0f));
let _e7446 = (_e7431 > 0f);
let _e7449 = select(2f, select(0f, _e7441, (_e7430 < 0f)), _e7446);
let _e7450 = (_e7430 > _e7424);
let _e7454 = ((_e7445 > _e7416) || ((_e7445 == _e7416) && _e7450));
let _e7455 = (_e7449 < _e7420);
let _e7456 = select(_e7416, _e7445, _e7454);
let _e7460 = select(_e7420, _e7449, _e7455);
let _e7464 = select(_e7424, _e7430, _e7450);
let _e7465 = (_e7431 > _e7426);
let _e7466 = select(_e7426, _e7431, _e7465);
let _e7470 = (_e4888 - _e1269);
let _e7471 = -(_e5641);
let _e7474 = (_e5641 - _e7470);
let _e7475 = (_e7470 - _e5641);
let _e7477 = select(_e7475, _e7474, (_e7474 > _e7475));
let _e7480 = (select(_e7471, _e5641, (_e5641 > _e7471)) / select(1e-30f, _e7477, (_e7477 > 1e-30f)));
let _e7482 = (_e7470 < 0f);
let _e7484 = select(0f, select(2f, _e7480, _e7482), (_e5641 > 0f));
let _e7485 = (_e7470 > 0f);
let _e7488 = select(2f, select(0f, _e7480, (_e5641 < 0f)), _e7485);
let _e7489 = (_e5641 > _e7464);
let _e7493 = ((_e7484 > _e7456) || ((_e7484 == _e7456) && _e7489));
let _e7494 = (_e7488 < _e7460);
let _e7495 = select(_e7456, _e7484, _e7493);
let _e7499 = select(_e7460, _e7488, _e7494);
let _e7503 = select(_e7464, _e5641, _e7489);
let _e7504 = (_e7470 > _e7466);
let _e7505 = select(_e7466, _e7470, _e7504);
let _e7509 = (_e1242 - _e4893);
let _e7510 = (_e1269 - _e4893);
let _e7511 = -(_e7509);
let _e7514 = (_e7509 - _e7510);
let _e7515 = (_e7510 - _e7509);
let _e7517 = select(_e7515, _e7514, (_e7514 > _e7515));
let _e7520 = (select(_e7511, _e7509, (_e7509 > _e7511)) / select(1e-30f, _e7517, (_e7517 > 1e-30f)));
let _e7522 = (_e7510 < 0f);
let _e7524 = select(0f, select(2f, _e7520, _e7522), (_e7509 > 0f));
let _e7525 = (_e7510 > 0f);
let _e7528 = select(2f, select(0f, _e7520, (_e7509 < 0f)), _e7525);
let _e7529 = (_e7509 > _e7503);
let _e7533 = ((_e7524 > _e7495) || ((_e7524 == _e7495) && _e7529));
let _e7534 = (_e7528 < _e7499);
let _e7535 = select(_e7495, _e7524, _e7533);
let _e7539 = select(_e7499, _e7528, _e7534);
let _e7543 = select(_e7503, _e7509, _e7529);
let _e7544 = (_e7510 > _e7505);
let _e7545 = select(_e7505, _e7510, _e7544);
let _e7549 = (_e4902 - _e1275);
let _e7550 = -(_e5670);
let _e7553 = (_e5670 - _e7549);
let _e7554 = (_e7549 - _e5670);
let _e7556 = select(_e7554, _e7553, (_e7553 > _e7554));
let _e7559 = (select(_e7550, _e5670, (_e5670 > _e7550)) / select(1e-30f, _e7556, (_e7556 > 1e-30f)));
let _e7561 = (_e7549 < 0f);
let _e7563 = select(0f, select(2f, _e7559, _e7561), (_e5670 > 0f));
let _e7564 = (_e7549 > 0f);
let _e7567 = select(2f, select(0f, _e7559, (_e5670 < 0f)), _e7564);
let _e7568 = (_e5670 > _e7543);
let _e7572 = ((_e7563 > _e7535) || ((_e7563 == _e7535) && _e7568));
let _e7573 = (_e7567 < _e7539);
let _e7574 = select(_e7535, _e7563, _e7572);
let _e7578 = select(_e7539, _e7567, _e7573);
let _e7582 = select(_e7543, _e5670, _e7568);
let _e7583 = (_e7549 > _e7545);
let _e7584 = select(_e7545, _e7549, _e7583);
let _e7588 = (_e1257 - _e4907);
let _e7589 = (_e1275 - _e4907);
let _e7590 = -(_e7588);
let _e7593 = (_e7588 - _e7589);
let _e7594 = (_e7589 - _e7588);
let _e7596 = select(_e7594, _e7593, (_e7593 > _e7594));
let _e7599 = (select(_e7590, _e7588, (_e7588 > _e7590)) / select(1e-30f, _e7596, (_e7596 > 1e-30f)));
let _e7601 = (_e7589 < 0f);
let _e7603 = select(0f, select(2f, _e7599, _e7601), (_e7588 > 0f));
let _e7604 = (_e7589 > 0f);
let _e7607 = select(2f, select(0f, _e7599, (_e7588 < 0f)), _e7604);
let _e7608 = (_e7588 > _e7582);
let _e7612 = ((_e7603 > _e7574) || ((_e7603 == _e7574) && _e7608));
let _e7613 = (_e7607 < _e7578);
let _e7614 = select(_e7574, _e7603, _e7612);
let _e7615 = select(select(select(select(select(select(0f, _e7371.member, _e7414), _e7371.member, _e7454), _e7379.member, _e7493), _e7379.member, _e7533), _e7387.member, _e7572), _e7387.member, _e7612);
let _e7616 = select(select(select(select(select(select(0f, _e7371.member_1, _e7414), _e7371.member_1, _e7454), _e7379.member_1, _e7493), _e7379.member_1, _e7533), _e7387.member_1, _e7572), _e7387.member_1, _e7612);
let _e7617 = select(select(select(select(select(select(1f, _e7371.member_2, _e7414), _e7371.member_2, _e7454), _e7379.member_2, _e7493), _e7379.member_2, _e7533), _e7387.member_2, _e7572), _e7387.member_2, _e7612);
let _e7619 = select(_e7578, _e7607, _e7613);
let _e7620 = select(select(select(select(select(select(0f, _e7371.member, _e7415), _e7371.member, _e7455), _e7379.member, _e7494), _e7379.member, _e7534), _e7387.member, _e7573), _e7387.member, _e7613);
let _e7621 = select(select(select(select(select(select(0f, _e7371.member_1, _e7415), _e7371.member_1, _e7455), _e7379.member_1, _e7494), _e7379.member_1, _e7534), _e7387.member_1, _e7573), _e7387.member_1, _e7613);
let _e7622 = select(select(select(select(select(select(1f, _e7371.member_2, _e7415), _e7371.member_2, _e7455), _e7379.member_2, _e7494), _e7379.member_2, _e7534), _e7387.member_2, _e7573), _e7387.member_2, _e7613);
let _e7624 = select(_e7582, _e7588, _e7608);
let _e7625 = (_e7589 > _e7584);
let _e7626 = select(_e7584, _e7589, _e7625);
let _e7627 = select(select(select(select(select(select(0f, _e7371.member, _e7410), _e7371.member, _e7450), _e7379.member, _e7489), _e7379.member, _e7529), _e7387.member, _e7568), _e7387.member, _e7608);
let _e7628 = select(select(select(select(select(select(0f, _e7371.member_1, _e7410), _e7371.member_1, _e7450), _e7379.member_1, _e7489), _e7379.member_1, _e7529), _e7387.member_1, _e7568), _e7387.member_1, _e7608);
let _e7629 = select(select(select(select(select(select(1f, _e7371.member_2, _e7410), _e7371.member_2, _e7450), _e7379.member_2, _e7489), _e7379.member_2, _e7529), _e7387.member_2, _e7568), _e7387.member_2, _e7608);
if _e5363 {
phi_16499_ = type_37(_e7614, vec3<f32>(_e7615, _e7616, _e7617), _e7619, vec3<f32>(_e7620, _e7621, _e7622), _e7624, _e7626, vec3<f32>(_e7627, _e7628, _e7629));
} else {
let _e7636 = (((_e7371.member * _e7371.member) + (_e7371.member_1 * _e7371.member_1)) + (_e7371.member_2 * _e7371.member_2));
let _e7639 = sqrt(select(0f, _e7636, (_e7636 > 0f)));
let _e7643 = global_1.member.member_16.member_1;
let _e7644 = (_e7643 != 0u);
let _e7648 = global_1.member.member_16.member;
let _e7668 = select(-1e6f, (((((_e7648.member.member * _e1184) + (_e7648.member.member_1 * _e1197)) + (_e7648.member.member_2 * _e1162)) + _e7648.member_1) * _e7639), _e7644);
let _e7669 = select(-1e6f, (((((_e7648.member.member * _e1207) + (_e7648.member.member_1 * _e1212)) + (_e7648.member.member_2 * _e1201)) + _e7648.member_1) * _e7639), _e7644);
let _e7674 = global_1.member.member_16.member.member;
let _e7678 = -(_e7668);
let _e7681 = (_e7668 - _e7669);
let _e7682 = (_e7669 - _e7668);
let _e7684 = select(_e7682, _e7681, (_e7681 > _e7682));
let _e7687 = (select(_e7678, _e7668, (_e7668 > _e7678)) / select(1e-30f, _e7684, (_e7684 > 1e-30f)));
let _e7691 = select(0f, select(2f, _e7687, (_e7669 < 0f)), (_e7668 > 0f));
let _e7695 = select(2f, select(0f, _e7687, (_e7668 < 0f)), (_e7669 > 0f));
let _e7696 = (_e7668 > _e7624);
let _e7700 = ((_e7691 > _e7614) || ((_e7691 == _e7614) && _e7696));
let _e7701 = (_e7695 < _e7619);
let _e7702 = select(_e7614, _e7691, _e7700);
let _e7706 = select(_e7619, _e7695, _e7701);
let _e7710 = select(_e7624, _e7668, _e7696);
let _e7712 = select(_e7626, _e7669, (_e7669 > _e7626));
let _e7719 = global_1.member.member_17.member_1;
let _e7720 = (_e7719 != 0u);
let _e7724 = global_1.member.member_17.member;
let _e7744 = select(-1e6f, (((((_e7724.member.member * _e1184) + (_e7724.member.member_1 * _e1197)) + (_e7724.member.member_2 * _e1162)) + _e7724.member_1) * _e7639), _e7720);
let _e7745 = select(-1e6f, (((((_e7724.member.member * _e1207) + (_e7724.member.member_1 * _e1212)) + (_e7724.member.member_2 * _e1201)) + _e7724.member_1) * _e7639), _e7720);
let _e7750 = global_1.member.member_17.member.member;
let _e7754 = -(_e7744);
let _e7757 = (_e7744 - _e7745);
let _e7758 = (_e7745 - _e7744);
let _e7760 = select(_e7758, _e7757, (_e7757 > _e7758));
let _e7763 = (select(_e7754, _e7744, (_e7744 > _e7754)) / select(1e-30f, _e7760, (_e7760 > 1e-30f)));
let _e7767 = select(0f, select(2f, _e7763, (_e7745 < 0f)), (_e7744 > 0f));
let _e7771 = select(2f, select(0f, _e7763, (_e7744 < 0f)), (_e7745 > 0f));
let _e7772 = (_e7744 > _e7710);
let _e7776 = ((_e7767 > _e7702) || ((_e7767 == _e7702) && _e7772));
let _e7777 = (_e7771 < _e7706);
let _e7778 = select(_e7702, _e7767, _e7776);
let _e7782 = select(_e7706, _e7771, _e7777);
let _e7786 = select(_e7710, _e7744, _e7772);
let _e7788 = select(_e7712, _e7745, (_e7745 > _e7712));
let _e7795 = global_1.member.member_18.member_1;
let _e7796 = (_e7795 != 0u);
let _e7800 = global_1.member.member_18.member;
let _e7820 = select(-1e6f, (((((_e7800.member.member * _e1184) + (_e7800.member.member_1 * _e1197)) + (_e7800.member.member_2 * _e1162)) + _e7800.member_1) * _e7639), _e7796);
let _e7821 = select(-1e6f, (((((_e7800.member.member * _e1207) + (_e7800.member.member_1 * _e1212)) + (_e7800.member.member_2 * _e1201)) + _e7800.member_1) * _e7639), _e7796);
let _e7826 = global_1.member.member_18.member.member;
let _e7830 = -(_e7820);
let _e7833 = (_e7820 - _e7821);
let _e7834 = (_e7821 - _e7820);
let _e7836 = select(_e7834, _e7833, (_e7833 > _e7834));
let _e7839 = (select(_e7830, _e7820, (_e7820 > _e7830)) / select(1e-30f, _e7836, (_e7836 > 1e-30f)));
let _e7843 = select(0f, select(2f, _e7839, (_e7821 < 0f)), (_e7820 > 0f));
let _e7847 = select(2f, select(0f, _e7839, (_e7820 < 0f)), (_e7821 > 0f));
let _e7848 = (_e7820 > _e7786);
let _e7852 = ((_e7843 > _e7778) || ((_e7843 == _e7778) && _e7848));
let _e7853 = (_e7847 < _e7782);
let _e7854 = select(_e7778, _e7843, _e7852);
let _e7858 = select(_e7782, _e7847, _e7853);
let _e7862 = select(_e7786, _e7820, _e7848);
let _e7864 = select(_e7788, _e7821, (_e7821 > _e7788));
let _e7871 = global_1.member.member_19.member_1;
let _e7872 = (_e7871 != 0u);
let _e7876 = global_1.member.member_19.member;
let _e7896 = select(-1e6f, (((((_e7876.member.member * _e1184) + (_e7876.member.member_1 * _e1197)) + (_e7876.member.member_2 * _e1162)) + _e7876.member_1) * _e7639), _e7872);
let _e7897 = select(-1e6f, (((((_e7876.member.member * _e1207) + (_e7876.member.member_1 * _e1212)) + (_e7876.member.member_2 * _e1201)) + _e7876.member_1) * _e7639), _e7872);
let _e7902 = global_1.member.member_19.member.member;
let _e7906 = -(_e7896);
let _e7909 = (_e7896 - _e7897);
let _e7910 = (_e7897 - _e7896);
let _e7912 = select(_e7910, _e7909, (_e7909 > _e7910));
let _e7915 = (select(_e7906, _e7896, (_e7896 > _e7906)) / select(1e-30f, _e7912, (_e7912 > 1e-30f)));
let _e7919 = select(0f, select(2f, _e7915, (_e7897 < 0f)), (_e7896 > 0f));
let _e7923 = select(2f, select(0f, _e7915, (_e7896 < 0f)), (_e7897 > 0f));
let _e7924 = (_e7896 > _e7862);
let _e7928 = ((_e7919 > _e7854) || ((_e7919 == _e7854) && _e7924));
let _e7929 = (_e7923 < _e7858);
phi_16499_ = type_37(select(_e7854, _e7919, _e7928), vec3<f32>(select(select(select(select(_e7615, _e7674.member, _e7700), _e7750.member, _e7776), _e7826.member, _e7852), _e7902.member, _e7928), select(select(select(select(_e7616, _e7674.member_1, _e7700), _e7750.member_1, _e7776), _e7826.member_1, _e7852), _e7902.member_1, _e7928), select(select(select(select(_e7617, _e7674.member_2, _e7700), _e7750.member_2, _e7776), _e7826.member_2, _e7852), _e7902.member_2, _e7928)), select(_e7858, _e7923, _e7929), vec3<f32>(select(select(select(select(_e7620, _e7674.member, _e7701), _e7750.member, _e7777), _e7826.member, _e7853), _e7902.member, _e7929), select(select(select(select(_e7621, _e7674.member_1, _e7701), _e7750.member_1, _e7777), _e7826.member_1, _e7853), _e7902.member_1, _e7929), select(select(select(select(_e7622, _e7674.member_2, _e7701), _e7750.member_2, _e7777), _e7826.member_2, _e7853), _e7902.member_2, _e7929)), select(_e7862, _e7896, _e7924), select(_e7864, _e7897, (_e7897 > _e7864)), vec3<f32>(select(select(select(select(_e7627, _e7674.member, _e7696), _e7750.member, _e7772), _e7826.member, _e7848), _e7902.member, _e7924), select(select(select(select(_e7628, _e7674.member_1, _e7696), _e7750.member_1, _e7772), _e7826.member_1, _e7848), _e7902.member_1, _e7924), select(select(select(select(_e7629, _e7674.member_2, _e7696), _e7750.member_2, _e7772), _e7826.member_2, _e7848), _e7902.member_2, _e7924)));
}
let _e7949 = phi_16499_;
let _e7951 = (_e7949.member_4 < 0f);
let _e7953 = (_e7949.member_5 < 0f);
let _e7954 = (_e7951 != _e7953);
if _e7951 {
phi_16512_ = _e7949.member_3;
phi_16513_ = _e7949.member_2;
} else {
phi_16512_ = _e7949.member_1;
phi_16513_ = _e7949.member;
}
let _e7960 = phi_16512_;
let _e7962 = phi_16513_;
let _e7971 = (((_e7371.member * _e7371.member) + (_e7371.member_1 * _e7371.member_1)) + (_e7371.member_2 * _e7371.member_2));
let _e7974 = sqrt(select(0f, _e7971, (_e7971 > 0f)));
let _e7975 = ((1.5f * _e1182) * _e7974);
let _e7980 = select(0f, _e7962, _e7954);
let _e7984 = (_e1184 + (_e5703 * _e7980));
let _e7985 = (_e1197 + (_e5704 * _e7980));
let _e7986 = (_e1162 + (_e5705 * _e7980));
let _e7992 = ((((_e1216.member.member * _e7984) + (_e1216.member.member_1 * _e7985)) + (_e1216.member.member_2 * _e7986)) + _e1216.member_1);
let _e7998 = ((((_e1231.member.member * _e7984) + (_e1231.member.member_1 * _e7985)) + (_e1231.member.member_2 * _e7986)) + _e1231.member_1);
let _e8004 = ((((_e1246.member.member * _e7984) + (_e1246.member.member_1 * _e7985)) + (_e1246.member.member_2 * _e7986)) + _e1246.member_1);
let _e8006 = select(_e4874, _e7992, (_e7992 > _e4874));
let _e8008 = select(_e4879, _e8006, (_e8006 < _e4879));
let _e8010 = select(_e4888, _e7998, (_e7998 > _e4888));
let _e8012 = select(_e4893, _e8010, (_e8010 < _e4893));
let _e8014 = select(_e4902, _e8004, (_e8004 > _e4902));
let _e8016 = select(_e4907, _e8014, (_e8014 < _e4907));
if _e4917 {
phi_16743_ = vec3<f32>(_e8008, _e8012, _e8016);
} else {
let _e8018 = (_e8008 + 0.5f);
let _e8019 = (_e4995 - 1f);
let _e8021 = select(0f, _e8018, (_e8018 > 0f));
let _e8023 = select(_e8019, _e8021, (_e8021 < _e8019));
let _e8030 = select(0i, select(select(i32(_e8023), i32(-2147483648), (_e8023 < -2147483600f)), 2147483647i, (_e8023 > 2147483500f)), (_e8023 == _e8023));
let _e8036 = (_e8012 + 0.5f);
let _e8037 = (_e5016 - 1f);
let _e8039 = select(0f, _e8036, (_e8036 > 0f));
let _e8041 = select(_e8037, _e8039, (_e8039 < _e8037));
let _e8048 = select(0i, select(select(i32(_e8041), i32(-2147483648), (_e8041 < -2147483600f)), 2147483647i, (_e8041 > 2147483500f)), (_e8041 == _e8041));
let _e8054 = (_e8016 + 0.5f);
let _e8055 = (_e5037 - 1f);
let _e8057 = select(0f, _e8054, (_e8054 > 0f));
let _e8059 = select(_e8055, _e8057, (_e8057 < _e8055));
let _e8066 = select(0i, select(select(i32(_e8059), i32(-2147483648), (_e8059 < -2147483600f)), 2147483647i, (_e8059 > 2147483500f)), (_e8059 == _e8059));
phi_16743_ = vec3<f32>(f32((_e8030 - select(0i, 1i, (_e8023 < f32(_e8030))))), f32((_e8048 - select(0i, 1i, (_e8041 < f32(_e8048))))), f32((_e8066 - select(0i, 1i, (_e8059 < f32(_e8066))))));
}
let _e8074 = phi_16743_;
let _e8077 = select(-1f, _e8074.x, (_e8074.x > -1f));
let _e8079 = select(_e4995, _e8077, (_e8077 < _e4995));
let _e8086 = select(0i, select(select(i32(_e8079), i32(-2147483648), (_e8079 < -2147483600f)), 2147483647i, (_e8079 > 2147483500f)), (_e8079 == _e8079));
let _e8090 = (_e8086 - select(0i, 1i, (_e8079 < f32(_e8086))));
let _e8093 = select(-1f, _e8074.y, (_e8074.y > -1f));
let _e8095 = select(_e5016, _e8093, (_e8093 < _e5016));
let _e8102 = select(0i, select(select(i32(_e8095), i32(-2147483648), (_e8095 < -2147483600f)), 2147483647i, (_e8095 > 2147483500f)), (_e8095 == _e8095));
let _e8106 = (_e8102 - select(0i, 1i, (_e8095 < f32(_e8102))));
let _e8109 = select(-1f, _e8074.z, (_e8074.z > -1f));
let _e8111 = select(_e5037, _e8109, (_e8109 < _e5037));
let _e8118 = select(0i, select(select(i32(_e8111), i32(-2147483648), (_e8111 < -2147483600f)), 2147483647i, (_e8111 > 2147483500f)), (_e8111 == _e8111));
let _e8122 = (_e8118 - select(0i, 1i, (_e8111 < f32(_e8118))));
let _e8123 = (_e8090 + 1i);
let _e8124 = (_e8106 + 1i);
let _e8125 = (_e8122 + 1i);
let _e8135 = ((_e8123 >> bitcast<u32>(4i)) + (_e5069 * ((_e8124 >> bitcast<u32>(4i)) + (_e5075 * (_e8125 >> bitcast<u32>(4i))))));
let _e8137 = select(_e5087, _e8135, (_e8135 < _e5087));
let _e8143 = global_2.member[bitcast<u32>(select(0i, _e8137, (_e8137 > 0i)))];
let _e8145 = (_e8123 & 15i);
let _e8148 = ((_e8124 & 15i) * _e5056);
let _e8150 = (bitcast<i32>(_e8143) + ((_e8125 & 15i) * _e5060));
let _e8151 = (_e8148 + _e5056);
let _e8152 = (_e8148 + _e5104);
let _e8153 = (_e8150 + _e5060);
let _e8154 = (_e8150 + _e5107);
local_2 = type_30(array<i32, 4>(_e8145, _e8145, _e8145, _e8145), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = (_e8074 - vec3<f32>(f32(_e8090), f32(_e8106), f32(_e8122)));
let _e8166 = local_2.member[0u];
let _e8167 = ((_e8153 + _e8151) + _e8166);
let _e8169 = (_e8167 >> bitcast<u32>(2i));
let _e8172 = bitcast<u32>(((_e8167 & 3i) * 8i));
let _e8174 = select(_e5087, _e8169, (_e8169 < _e5087));
let _e8179 = global_2.member[bitcast<u32>(select(0i, _e8174, (_e8174 > 0i)))];
let _e8183 = (_e8169 + 1i);
let _e8185 = select(_e5087, _e8183, (_e8183 < _e5087));
let _e8190 = global_2.member[bitcast<u32>(select(0i, _e8185, (_e8185 > 0i)))];
let _e8197 = ((_e8179 >> bitcast<u32>((_e8172 & 31u))) | ((_e8190 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8172) & 31u))));
let _e8200 = local_2.member_1[1u];
let _e8206 = f32(bitcast<i32>(((_e8197 >> bitcast<u32>((_e8200 & 31u))) & 255u)));
let _e8209 = local_2.member_1[2u];
let _e8216 = local_3[0u];
let _e8219 = (_e8206 + ((f32(bitcast<i32>(((_e8197 >> bitcast<u32>((_e8209 & 31u))) & 255u))) - _e8206) * _e8216));
let _e8221 = local_2.member[0u];
let _e8222 = ((_e8153 + _e8152) + _e8221);
let _e8224 = (_e8222 >> bitcast<u32>(2i));
let _e8227 = bitcast<u32>(((_e8222 & 3i) * 8i));
let _e8229 = select(_e5087, _e8224, (_e8224 < _e5087));
let _e8234 = global_2.member[bitcast<u32>(select(0i, _e8229, (_e8229 > 0i)))];
let _e8238 = (_e8224 + 1i);
let _e8240 = select(_e5087, _e8238, (_e8238 < _e5087));
let _e8245 = global_2.member[bitcast<u32>(select(0i, _e8240, (_e8240 > 0i)))];
let _e8252 = ((_e8234 >> bitcast<u32>((_e8227 & 31u))) | ((_e8245 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8227) & 31u))));
let _e8253 = local_2.member_1[1u];
let _e8259 = f32(bitcast<i32>(((_e8252 >> bitcast<u32>((_e8253 & 31u))) & 255u)));
let _e8260 = local_2.member_1[2u];
let _e8267 = local_3[0u];
let _e8272 = local_3[1u];
let _e8275 = (_e8219 + (((_e8259 + ((f32(bitcast<i32>(((_e8252 >> bitcast<u32>((_e8260 & 31u))) & 255u))) - _e8259) * _e8267)) - _e8219) * _e8272));
let _e8277 = local_2.member[0u];
let _e8278 = ((_e8154 + _e8151) + _e8277);
let _e8280 = (_e8278 >> bitcast<u32>(2i));
let _e8283 = bitcast<u32>(((_e8278 & 3i) * 8i));
let _e8285 = select(_e5087, _e8280, (_e8280 < _e5087));
let _e8290 = global_2.member[bitcast<u32>(select(0i, _e8285, (_e8285 > 0i)))];
let _e8294 = (_e8280 + 1i);
let _e8296 = select(_e5087, _e8294, (_e8294 < _e5087));
let _e8301 = global_2.member[bitcast<u32>(select(0i, _e8296, (_e8296 > 0i)))];
let _e8308 = ((_e8290 >> bitcast<u32>((_e8283 & 31u))) | ((_e8301 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8283) & 31u))));
let _e8309 = local_2.member_1[1u];
let _e8315 = f32(bitcast<i32>(((_e8308 >> bitcast<u32>((_e8309 & 31u))) & 255u)));
let _e8316 = local_2.member_1[2u];
let _e8323 = local_3[0u];
let _e8326 = (_e8315 + ((f32(bitcast<i32>(((_e8308 >> bitcast<u32>((_e8316 & 31u))) & 255u))) - _e8315) * _e8323));
let _e8328 = local_2.member[0u];
let _e8329 = ((_e8154 + _e8152) + _e8328);
let _e8331 = (_e8329 >> bitcast<u32>(2i));
let _e8334 = bitcast<u32>(((_e8329 & 3i) * 8i));
let _e8336 = select(_e5087, _e8331, (_e8331 < _e5087));
let _e8341 = global_2.member[bitcast<u32>(select(0i, _e8336, (_e8336 > 0i)))];
let _e8345 = (_e8331 + 1i);
let _e8347 = select(_e5087, _e8345, (_e8345 < _e5087));
let _e8352 = global_2.member[bitcast<u32>(select(0i, _e8347, (_e8347 > 0i)))];
let _e8359 = ((_e8341 >> bitcast<u32>((_e8334 & 31u))) | ((_e8352 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8334) & 31u))));
let _e8360 = local_2.member_1[1u];
let _e8366 = f32(bitcast<i32>(((_e8359 >> bitcast<u32>((_e8360 & 31u))) & 255u)));
let _e8367 = local_2.member_1[2u];
let _e8374 = local_3[0u];
let _e8378 = local_3[1u];
let _e8383 = local_3[2u];
let _e8388 = (((_e8275 + (((_e8326 + (((_e8366 + ((f32(bitcast<i32>(((_e8359 >> bitcast<u32>((_e8367 & 31u))) & 255u))) - _e8366) * _e8374)) - _e8326) * _e8378)) - _e8275) * _e8383)) - _e5344) * _e5348);
let _e8390 = select(_e5351, _e8388, (_e8388 > _e5351));
local = select(1e9f, _e8390, (_e8390 < 1e9f));
let _e8393 = local;
local_1 = _e8393;
let _e8394 = local_1;
let _e8396 = (bitcast<i32>(_e181) - 1i);
let _e8398 = select(_e8396, 263197i, (263197i < _e8396));
let _e8403 = global_3.member[bitcast<u32>(select(0i, _e8398, (_e8398 > 0i)))];
let _e8406 = select(_e8396, 263198i, (263198i < _e8396));
let _e8411 = global_3.member[bitcast<u32>(select(0i, _e8406, (_e8406 > 0i)))];
let _e8414 = select(_e8396, 263199i, (263199i < _e8396));
let _e8419 = global_3.member[bitcast<u32>(select(0i, _e8414, (_e8414 > 0i)))];
let _e8420 = bitcast<f32>(_e8419);
let _e8422 = ((_e8394 - bitcast<f32>(_e8403)) * bitcast<f32>(_e8411));
let _e8424 = select(0f, _e8422, (_e8422 > 0f));
let _e8427 = local_1;
let _e8429 = select(_e8396, 263200i, (263200i < _e8396));
let _e8434 = global_3.member[bitcast<u32>(select(0i, _e8429, (_e8429 > 0i)))];
let _e8437 = select(_e8396, 263201i, (263201i < _e8396));
let _e8442 = global_3.member[bitcast<u32>(select(0i, _e8437, (_e8437 > 0i)))];
let _e8445 = select(_e8396, 263202i, (263202i < _e8396));
let _e8450 = global_3.member[bitcast<u32>(select(0i, _e8445, (_e8445 > 0i)))];
let _e8451 = bitcast<f32>(_e8450);
let _e8453 = ((_e8427 - bitcast<f32>(_e8434)) * bitcast<f32>(_e8442));
let _e8455 = select(0f, _e8453, (_e8453 > 0f));
let _e8459 = local_1;
let _e8461 = select(_e8396, 263203i, (263203i < _e8396));
let _e8466 = global_3.member[bitcast<u32>(select(0i, _e8461, (_e8461 > 0i)))];
let _e8469 = select(_e8396, 263204i, (263204i < _e8396));
let _e8474 = global_3.member[bitcast<u32>(select(0i, _e8469, (_e8469 > 0i)))];
let _e8477 = select(_e8396, 263205i, (263205i < _e8396));
let _e8482 = global_3.member[bitcast<u32>(select(0i, _e8477, (_e8477 > 0i)))];
let _e8483 = bitcast<f32>(_e8482);
let _e8485 = ((_e8459 - bitcast<f32>(_e8466)) * bitcast<f32>(_e8474));
let _e8487 = select(0f, _e8485, (_e8485 > 0f));
let _e8490 = local_1;
let _e8492 = select(_e8396, 263206i, (263206i < _e8396));
let _e8497 = global_3.member[bitcast<u32>(select(0i, _e8492, (_e8492 > 0i)))];
let _e8500 = select(_e8396, 263207i, (263207i < _e8396));
let _e8505 = global_3.member[bitcast<u32>(select(0i, _e8500, (_e8500 > 0i)))];
let _e8508 = select(_e8396, 263208i, (263208i < _e8396));
let _e8513 = global_3.member[bitcast<u32>(select(0i, _e8508, (_e8508 > 0i)))];
let _e8514 = bitcast<f32>(_e8513);
let _e8516 = ((_e8490 - bitcast<f32>(_e8497)) * bitcast<f32>(_e8505));
let _e8518 = select(0f, _e8516, (_e8516 > 0f));
let _e8522 = ((select(_e8420, _e8424, (_e8424 < _e8420)) + select(_e8451, _e8455, (_e8455 < _e8451))) + (select(_e8483, _e8487, (_e8487 < _e8483)) + select(_e8514, _e8518, (_e8518 < _e8514))));
let _e8524 = select(0f, _e8522, (_e8522 > 0f));
let _e8526 = select(1023f, _e8524, (_e8524 < 1023f));
let _e8533 = select(0i, select(select(i32(_e8526), i32(-2147483648), (_e8526 < -2147483600f)), 2147483647i, (_e8526 > 2147483500f)), (_e8526 == _e8526));
let _e8537 = (_e8533 - select(0i, 1i, (_e8526 < f32(_e8533))));
let _e8538 = (262147i + _e8537);
let _e8540 = select(_e8396, _e8538, (_e8538 < _e8396));
let _e8546 = global_3.member[bitcast<u32>(select(0i, _e8540, (_e8540 > 0i)))];
let _e8556 = select(_e8396, 262146i, (262146i < _e8396));
let _e8562 = global_3.member[bitcast<u32>(select(0i, _e8556, (_e8556 > 0i)))];
let _e8566 = select(_e8396, 262144i, (262144i < _e8396));
let _e8572 = global_3.member[bitcast<u32>(select(0i, _e8566, (_e8566 > 0i)))];
let _e8575 = select(_e8396, 262145i, (262145i < _e8396));
let _e8581 = global_3.member[bitcast<u32>(select(0i, _e8575, (_e8575 > 0i)))];
let _e8588 = ((bitcast<f32>(_e8572) + (f32(bitcast<i32>((_e8546 >> bitcast<u32>(12u)))) * bitcast<f32>(_e8581))) + ((f32((bitcast<i32>((_e8546 & 4095u)) - 2048i)) * bitcast<f32>(_e8562)) * (_e8522 - f32(_e8537))));
let _e8592 = select(_e7949.member_6.x, _e7960.x, _e7954);
let _e8595 = select(_e7949.member_6.y, _e7960.y, _e7954);
let _e8598 = select(_e7949.member_6.z, _e7960.z, _e7954);
let _e8599 = select(1f, _e8588, _e7953);
let _e8604 = (((_e8592 * _e8592) + (_e8595 * _e8595)) + (_e8598 * _e8598));
let _e8607 = sqrt(select(0f, _e8604, (_e8604 > 0f)));
let _e8610 = (1f / select(1e-20f, _e8607, (_e8607 > 1e-20f)));
let _e8611 = (_e8592 * _e8610);
let _e8612 = (_e8595 * _e8610);
let _e8613 = (_e8598 * _e8610);
let _e8618 = (((_e249 * _e8611) + (_e260 * _e8612)) + (_e271 * _e8613));
let _e8623 = (((_e249 * _e249) + (_e260 * _e260)) + (_e271 * _e271));
let _e8625 = ((_e8599 * _e8599) - _e8623);
let _e8626 = (_e8618 * _e8618);
let _e8627 = (_e8626 + _e8625);
let _e8630 = sqrt(select(0f, _e8627, (_e8627 > 0f)));
let _e8634 = (_e8627 <= 0f);
let _e8637 = select((select(_e8630, -(_e8630), (_e8618 < 0f)) - _e8618), (-2f * _e8618), _e8634);
let _e8638 = (_e8625 == 0f);
let _e8649 = (_e8634 && (_e8625 != 0f));
let _e8655 = (!(_e7954) && (_e8649 || (_e8626 < ((0.1f * 0.1f) * _e8623))));
let _e8657 = select(1e-12f, _e8623, (_e8623 > 1e-12f));
let _e8661 = (_e8599 / sqrt(select(0f, _e8657, (_e8657 > 0f))));
let _e8673 = ((_e7954 || (bitcast<f32>((bitcast<u32>(_e7949.member_4) & 2147483647u)) < select(1f, _e7975, (_e7975 < 1f)))) && (_e8588 != 1f));
let _e8674 = select(_e249, select(select(select((_e249 + (_e8611 * _e8637)), _e249, _e8638), _e249, _e8649), (_e249 * _e8661), _e8655), _e8673);
let _e8675 = select(_e260, select(select(select((_e260 + (_e8612 * _e8637)), _e260, _e8638), _e260, _e8649), (_e260 * _e8661), _e8655), _e8673);
let _e8676 = select(_e271, select(select(select((_e271 + (_e8613 * _e8637)), _e271, _e8638), _e271, _e8649), (_e271 * _e8661), _e8655), _e8673);
let _e8688 = global_1.member.member_7.member_2;
let _e8691 = (_e8688 / select(1e-6f, _e8676, (_e8676 > 1e-6f)));
let _e8695 = (_e1207 + (_e8674 * _e8691));
let _e8696 = (_e1212 + (_e8675 * _e8691));
let _e8697 = (_e1201 + (_e8676 * _e8691));
let _e8703 = ((((_e1216.member.member * _e8695) + (_e1216.member.member_1 * _e8696)) + (_e1216.member.member_2 * _e8697)) + _e1216.member_1);
let _e8709 = ((((_e1231.member.member * _e8695) + (_e1231.member.member_1 * _e8696)) + (_e1231.member.member_2 * _e8697)) + _e1231.member_1);
let _e8715 = ((((_e1246.member.member * _e8695) + (_e1246.member.member_1 * _e8696)) + (_e1246.member.member_2 * _e8697)) + _e1246.member_1);
let _e8716 = (_e4874 - _e8703);
let _e8717 = -(_e7391);
let _e8720 = (_e7391 - _e8716);
let _e8721 = (_e8716 - _e7391);
let _e8723 = select(_e8721, _e8720, (_e8720 > _e8721));
let _e8726 = (select(_e8717, _e7391, (_e7391 > _e8717)) / select(1e-30f, _e8723, (_e8723 > 1e-30f)));
let _e8729 = select(0f, select(2f, _e8726, (_e8716 < 0f)), _e7406);
let _e8732 = select(2f, select(0f, _e8726, _e7403), (_e8716 > 0f));
let _e8736 = ((_e8729 > -1f) || ((_e8729 == -1f) && _e7425));
let _e8737 = (_e8732 < 2f);
let _e8738 = select(-1f, _e8729, _e8736);
let _e8742 = select(2f, _e8732, _e8737);
let _e8747 = select(-1e30f, _e8716, (_e8716 > -1e30f));
let _e8751 = (_e8703 - _e4879);
let _e8752 = -(_e7431);
let _e8755 = (_e7431 - _e8751);
let _e8756 = (_e8751 - _e7431);
let _e8758 = select(_e8756, _e8755, (_e8755 > _e8756));
let _e8761 = (select(_e8752, _e7431, (_e7431 > _e8752)) / select(1e-30f, _e8758, (_e8758 > 1e-30f)));
let _e8764 = select(0f, select(2f, _e8761, (_e8751 < 0f)), _e7446);
let _e8767 = select(2f, select(0f, _e8761, _e7443), (_e8751 > 0f));
let _e8771 = ((_e8764 > _e8738) || ((_e8764 == _e8738) && _e7465));
let _e8772 = (_e8767 < _e8742);
let _e8773 = select(_e8738, _e8764, _e8771);
let _e8777 = select(_e8742, _e8767, _e8772);
let _e8782 = select(_e8747, _e8751, (_e8751 > _e8747));
let _e8786 = (_e4888 - _e8709);
let _e8787 = -(_e7470);
let _e8790 = (_e7470 - _e8786);
let _e8791 = (_e8786 - _e7470);
let _e8793 = select(_e8791, _e8790, (_e8790 > _e8791));
let _e8796 = (select(_e8787, _e7470, (_e7470 > _e8787)) / select(1e-30f, _e8793, (_e8793 > 1e-30f)));
let _e8799 = select(0f, select(2f, _e8796, (_e8786 < 0f)), _e7485);
let _e8802 = select(2f, select(0f, _e8796, _e7482), (_e8786 > 0f));
let _e8806 = ((_e8799 > _e8773) || ((_e8799 == _e8773) && _e7504));
let _e8807 = (_e8802 < _e8777);
let _e8808 = select(_e8773, _e8799, _e8806);
let _e8812 = select(_e8777, _e8802, _e8807);
let _e8817 = select(_e8782, _e8786, (_e8786 > _e8782));
let _e8821 = (_e8709 - _e4893);
let _e8822 = -(_e7510);
let _e8825 = (_e7510 - _e8821);
let _e8826 = (_e8821 - _e7510);
let _e8828 = select(_e8826, _e8825, (_e8825 > _e8826));
let _e8831 = (select(_e8822, _e7510, (_e7510 > _e8822)) / select(1e-30f, _e8828, (_e8828 > 1e-30f)));
let _e8834 = select(0f, select(2f, _e8831, (_e8821 < 0f)), _e7525);
let _e8837 = select(2f, select(0f, _e8831, _e7522), (_e8821 > 0f));
let _e8841 = ((_e8834 > _e8808) || ((_e8834 == _e8808) && _e7544));
let _e8842 = (_e8837 < _e8812);
let _e8843 = select(_e8808, _e8834, _e8841);
let _e8847 = select(_e8812, _e8837, _e8842);
let _e8852 = select(_e8817, _e8821, (_e8821 > _e8817));
let _e8856 = (_e4902 - _e8715);
let _e8857 = -(_e7549);
let _e8860 = (_e7549 - _e8856);
let _e8861 = (_e8856 - _e7549);
let _e8863 = select(_e8861, _e8860, (_e8860 > _e8861));
let _e8866 = (select(_e8857, _e7549, (_e7549 > _e8857)) / select(1e-30f, _e8863, (_e8863 > 1e-30f)));
let _e8869 = select(0f, select(2f, _e8866, (_e8856 < 0f)), _e7564);
let _e8872 = select(2f, select(0f, _e8866, _e7561), (_e8856 > 0f));
let _e8876 = ((_e8869 > _e8843) || ((_e8869 == _e8843) && _e7583));
let _e8877 = (_e8872 < _e8847);
let _e8878 = select(_e8843, _e8869, _e8876);
let _e8882 = select(_e8847, _e8872, _e8877);
let _e8887 = select(_e8852, _e8856, (_e8856 > _e8852));
let _e8891 = (_e8715 - _e4907);
let _e8892 = -(_e7589);
let _e8895 = (_e7589 - _e8891);
let _e8896 = (_e8891 - _e7589);
let _e8898 = select(_e8896, _e8895, (_e8895 > _e8896));
let _e8901 = (select(_e8892, _e7589, (_e7589 > _e8892)) / select(1e-30f, _e8898, (_e8898 > 1e-30f)));
let _e8904 = select(0f, select(2f, _e8901, (_e8891 < 0f)), _e7604);
let _e8907 = select(2f, select(0f, _e8901, _e7601), (_e8891 > 0f));
let _e8911 = ((_e8904 > _e8878) || ((_e8904 == _e8878) && _e7625));
let _e8912 = (_e8907 < _e8882);
let _e8913 = select(_e8878, _e8904, _e8911);
let _e8914 = select(select(select(select(select(select(0f, _e7371.member, _e8736), _e7371.member, _e8771), _e7379.member, _e8806), _e7379.member, _e8841), _e7387.member, _e8876), _e7387.member, _e8911);
let _e8915 = select(select(select(select(select(select(0f, _e7371.member_1, _e8736), _e7371.member_1, _e8771), _e7379.member_1, _e8806), _e7379.member_1, _e8841), _e7387.member_1, _e8876), _e7387.member_1, _e8911);
let _e8916 = select(select(select(select(select(select(1f, _e7371.member_2, _e8736), _e7371.member_2, _e8771), _e7379.member_2, _e8806), _e7379.member_2, _e8841), _e7387.member_2, _e8876), _e7387.member_2, _e8911);
let _e8918 = select(_e8882, _e8907, _e8912);
let _e8919 = select(select(select(select(select(select(0f, _e7371.member, _e8737), _e7371.member, _e8772), _e7379.member, _e8807), _e7379.member, _e8842), _e7387.member, _e8877), _e7387.member, _e8912);
let _e8920 = select(select(select(select(select(select(0f, _e7371.member_1, _e8737), _e7371.member_1, _e8772), _e7379.member_1, _e8807), _e7379.member_1, _e8842), _e7387.member_1, _e8877), _e7387.member_1, _e8912);
let _e8921 = select(select(select(select(select(select(1f, _e7371.member_2, _e8737), _e7371.member_2, _e8772), _e7379.member_2, _e8807), _e7379.member_2, _e8842), _e7387.member_2, _e8877), _e7387.member_2, _e8912);
let _e8924 = select(_e8887, _e8891, (_e8891 > _e8887));
let _e8925 = select(select(select(select(select(select(0f, _e7371.member, _e7425), _e7371.member, _e7465), _e7379.member, _e7504), _e7379.member, _e7544), _e7387.member, _e7583), _e7387.member, _e7625);
let _e8926 = select(select(select(select(select(select(0f, _e7371.member_1, _e7425), _e7371.member_1, _e7465), _e7379.member_1, _e7504), _e7379.member_1, _e7544), _e7387.member_1, _e7583), _e7387.member_1, _e7625);
let _e8927 = select(select(select(select(select(select(1f, _e7371.member_2, _e7425), _e7371.member_2, _e7465), _e7379.member_2, _e7504), _e7379.member_2, _e7544), _e7387.member_2, _e7583), _e7387.member_2, _e7625);
if _e5363 {
phi_19294_ = type_37(_e8913, vec3<f32>(_e8914, _e8915, _e8916), _e8918, vec3<f32>(_e8919, _e8920, _e8921), _e7626, _e8924, vec3<f32>(_e8925, _e8926, _e8927));
} else {
let _e8933 = global_1.member.member_16.member_1;
let _e8934 = (_e8933 != 0u);
let _e8938 = global_1.member.member_16.member;
let _e8958 = select(-1e6f, (((((_e8938.member.member * _e1207) + (_e8938.member.member_1 * _e1212)) + (_e8938.member.member_2 * _e1201)) + _e8938.member_1) * _e7974), _e8934);
let _e8959 = select(-1e6f, (((((_e8938.member.member * _e8695) + (_e8938.member.member_1 * _e8696)) + (_e8938.member.member_2 * _e8697)) + _e8938.member_1) * _e7974), _e8934);
let _e8964 = global_1.member.member_16.member.member;
let _e8968 = -(_e8958);
let _e8971 = (_e8958 - _e8959);
let _e8972 = (_e8959 - _e8958);
let _e8974 = select(_e8972, _e8971, (_e8971 > _e8972));
let _e8977 = (select(_e8968, _e8958, (_e8958 > _e8968)) / select(1e-30f, _e8974, (_e8974 > 1e-30f)));
let _e8981 = select(0f, select(2f, _e8977, (_e8959 < 0f)), (_e8958 > 0f));
let _e8985 = select(2f, select(0f, _e8977, (_e8958 < 0f)), (_e8959 > 0f));
let _e8986 = (_e8958 > _e7626);
let _e8990 = ((_e8981 > _e8913) || ((_e8981 == _e8913) && _e8986));
let _e8991 = (_e8985 < _e8918);
let _e8992 = select(_e8913, _e8981, _e8990);
let _e8996 = select(_e8918, _e8985, _e8991);
let _e9000 = select(_e7626, _e8958, _e8986);
let _e9002 = select(_e8924, _e8959, (_e8959 > _e8924));
let _e9009 = global_1.member.member_17.member_1;
let _e9010 = (_e9009 != 0u);
let _e9014 = global_1.member.member_17.member;
let _e9034 = select(-1e6f, (((((_e9014.member.member * _e1207) + (_e9014.member.member_1 * _e1212)) + (_e9014.member.member_2 * _e1201)) + _e9014.member_1) * _e7974), _e9010);
let _e9035 = select(-1e6f, (((((_e9014.member.member * _e8695) + (_e9014.member.member_1 * _e8696)) + (_e9014.member.member_2 * _e8697)) + _e9014.member_1) * _e7974), _e9010);
let _e9040 = global_1.member.member_17.member.member;
let _e9044 = -(_e9034);
let _e9047 = (_e9034 - _e9035);
let _e9048 = (_e9035 - _e9034);
let _e9050 = select(_e9048, _e9047, (_e9047 > _e9048));
let _e9053 = (select(_e9044, _e9034, (_e9034 > _e9044)) / select(1e-30f, _e9050, (_e9050 > 1e-30f)));
let _e9057 = select(0f, select(2f, _e9053, (_e9035 < 0f)), (_e9034 > 0f));
let _e9061 = select(2f, select(0f, _e9053, (_e9034 < 0f)), (_e9035 > 0f));
let _e9062 = (_e9034 > _e9000);
let _e9066 = ((_e9057 > _e8992) || ((_e9057 == _e8992) && _e9062));
let _e9067 = (_e9061 < _e8996);
let _e9068 = select(_e8992, _e9057, _e9066);
let _e9072 = select(_e8996, _e9061, _e9067);
let _e9076 = select(_e9000, _e9034, _e9062);
let _e9078 = select(_e9002, _e9035, (_e9035 > _e9002));
let _e9085 = global_1.member.member_18.member_1;
let _e9086 = (_e9085 != 0u);
let _e9090 = global_1.member.member_18.member;
let _e9110 = select(-1e6f, (((((_e9090.member.member * _e1207) + (_e9090.member.member_1 * _e1212)) + (_e9090.member.member_2 * _e1201)) + _e9090.member_1) * _e7974), _e9086);
let _e9111 = select(-1e6f, (((((_e9090.member.member * _e8695) + (_e9090.member.member_1 * _e8696)) + (_e9090.member.member_2 * _e8697)) + _e9090.member_1) * _e7974), _e9086);
let _e9116 = global_1.member.member_18.member.member;
let _e9120 = -(_e9110);
let _e9123 = (_e9110 - _e9111);
let _e9124 = (_e9111 - _e9110);
let _e9126 = select(_e9124, _e9123, (_e9123 > _e9124));
let _e9129 = (select(_e9120, _e9110, (_e9110 > _e9120)) / select(1e-30f, _e9126, (_e9126 > 1e-30f)));
let _e9133 = select(0f, select(2f, _e9129, (_e9111 < 0f)), (_e9110 > 0f));
let _e9137 = select(2f, select(0f, _e9129, (_e9110 < 0f)), (_e9111 > 0f));
let _e9138 = (_e9110 > _e9076);
let _e9142 = ((_e9133 > _e9068) || ((_e9133 == _e9068) && _e9138));
let _e9143 = (_e9137 < _e9072);
let _e9144 = select(_e9068, _e9133, _e9142);
let _e9148 = select(_e9072, _e9137, _e9143);
let _e9152 = select(_e9076, _e9110, _e9138);
let _e9154 = select(_e9078, _e9111, (_e9111 > _e9078));
let _e9161 = global_1.member.member_19.member_1;
let _e9162 = (_e9161 != 0u);
let _e9166 = global_1.member.member_19.member;
let _e9186 = select(-1e6f, (((((_e9166.member.member * _e1207) + (_e9166.member.member_1 * _e1212)) + (_e9166.member.member_2 * _e1201)) + _e9166.member_1) * _e7974), _e9162);
let _e9187 = select(-1e6f, (((((_e9166.member.member * _e8695) + (_e9166.member.member_1 * _e8696)) + (_e9166.member.member_2 * _e8697)) + _e9166.member_1) * _e7974), _e9162);
let _e9192 = global_1.member.member_19.member.member;
let _e9196 = -(_e9186);
let _e9199 = (_e9186 - _e9187);
let _e9200 = (_e9187 - _e9186);
let _e9202 = select(_e9200, _e9199, (_e9199 > _e9200));
let _e9205 = (select(_e9196, _e9186, (_e9186 > _e9196)) / select(1e-30f, _e9202, (_e9202 > 1e-30f)));
let _e9209 = select(0f, select(2f, _e9205, (_e9187 < 0f)), (_e9186 > 0f));
let _e9213 = select(2f, select(0f, _e9205, (_e9186 < 0f)), (_e9187 > 0f));
let _e9214 = (_e9186 > _e9152);
let _e9218 = ((_e9209 > _e9144) || ((_e9209 == _e9144) && _e9214));
let _e9219 = (_e9213 < _e9148);
phi_19294_ = type_37(select(_e9144, _e9209, _e9218), vec3<f32>(select(select(select(select(_e8914, _e8964.member, _e8990), _e9040.member, _e9066), _e9116.member, _e9142), _e9192.member, _e9218), select(select(select(select(_e8915, _e8964.member_1, _e8990), _e9040.member_1, _e9066), _e9116.member_1, _e9142), _e9192.member_1, _e9218), select(select(select(select(_e8916, _e8964.member_2, _e8990), _e9040.member_2, _e9066), _e9116.member_2, _e9142), _e9192.member_2, _e9218)), select(_e9148, _e9213, _e9219), vec3<f32>(select(select(select(select(_e8919, _e8964.member, _e8991), _e9040.member, _e9067), _e9116.member, _e9143), _e9192.member, _e9219), select(select(select(select(_e8920, _e8964.member_1, _e8991), _e9040.member_1, _e9067), _e9116.member_1, _e9143), _e9192.member_1, _e9219), select(select(select(select(_e8921, _e8964.member_2, _e8991), _e9040.member_2, _e9067), _e9116.member_2, _e9143), _e9192.member_2, _e9219)), select(_e9152, _e9186, _e9214), select(_e9154, _e9187, (_e9187 > _e9154)), vec3<f32>(select(select(select(select(_e8925, _e8964.member, _e8986), _e9040.member, _e9062), _e9116.member, _e9138), _e9192.member, _e9214), select(select(select(select(_e8926, _e8964.member_1, _e8986), _e9040.member_1, _e9062), _e9116.member_1, _e9138), _e9192.member_1, _e9214), select(select(select(select(_e8927, _e8964.member_2, _e8986), _e9040.member_2, _e9062), _e9116.member_2, _e9138), _e9192.member_2, _e9214)));
}
let _e9239 = phi_19294_;
let _e9248 = global_1.member.member_7.member_4;
let _e9251 = (_e4869.member_4.x * _e5604.member_2);
let _e9253 = (_e4869.member_4.y * _e5604.member_2);
let _e9255 = (_e4869.member_4.z * _e5604.member_2);
let _e9256 = (0.5f * (_e8691 * select(1f, (2f * (1f - _e7962)), (_e7954 && _e7953))));
let _e9260 = (_e8674 + (_e9251 * _e9256));
let _e9261 = (_e8675 + (_e9253 * _e9256));
let _e9262 = (_e8676 + (_e9255 * _e9256));
let _e9264 = (2f * _e8688);
let _e9266 = ((_e9262 * _e9262) + (_e9264 * _e9255));
let _e9270 = (_e9262 + sqrt(select(0f, _e9266, (_e9266 > 0f))));
let _e9274 = (select(0.5f, _e9239.member_2, (_e9239.member_2 < 1f)) * (_e9264 / select(1e-6f, _e9270, (_e9270 > 1e-6f))));
let _e9278 = (_e9260 + (_e9251 * _e9274));
let _e9279 = (_e9261 + (_e9253 * _e9274));
let _e9280 = (_e9262 + (_e9255 * _e9274));
let _e9284 = (_e9248 * _e9248);
let _e9286 = (_e9280 * _e9280);
let _e9294 = (((_e9262 <= 0f) || (_e9266 <= 0f)) || ((_e9280 <= 0f) || (_e9286 <= (_e9284 * (((_e9278 * _e9278) + (_e9279 * _e9279)) + _e9286)))));
let _e9308 = (_e8674 + ((_e4869.member_5.x * _e5604.member_2) * _e8688));
let _e9309 = (_e8675 + ((_e4869.member_5.y * _e5604.member_2) * _e8688));
let _e9310 = (_e8676 + ((_e4869.member_5.z * _e5604.member_2) * _e8688));
let _e9312 = (_e9310 * _e9310);
let _e9321 = ((_e5361 & 1u) != 0u);
let _e9326 = (select(_e9294, ((_e9310 <= 0f) || (_e9312 <= (_e9284 * (((_e9308 * _e9308) + (_e9309 * _e9309)) + _e9312)))), _e9321) || (_e8673 && ((_e8649 && _e7954) || (_e7954 && (_e8676 <= 0f)))));
phi_19446_ = vec3<f32>(select(select(select(_e9278, _e9260, _e9294), _e9308, _e9321), _e249, _e9326), select(select(select(_e9279, _e9261, _e9294), _e9309, _e9321), _e260, _e9326), select(select(select(_e9280, _e9262, _e9294), _e9310, _e9321), _e271, _e9326));
phi_19447_ = select(1f, 0f, _e9326);
} else {
phi_19446_ = vec3<f32>(_e249, _e260, _e271);
phi_19447_ = 1f;
}
let _e9333 = phi_19446_;
let _e9335 = phi_19447_;
let _e9337 = (_e7366 * _e9335);
global_4.member[_e206] = (_e217 * (_e7209.member_2.x * _e9337));
global_4.member[_e218] = (_e227 * (_e7209.member_2.y * _e9337));
global_4.member[_e229] = (_e238 * (_e7209.member_2.z * _e9337));
global_4.member[_e240] = _e9333.x;
global_4.member[_e251] = _e9333.y;
global_4.member[_e262] = _e9333.z;
global_4.member[_e273] = _e282;
global_4.member[_e284] = _e293;
global_4.member[_e295] = _e304;
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
