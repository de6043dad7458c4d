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
var phi_1679_: u32;
var phi_2052_: vec3<f32>;
var phi_7373_: type_34;
var phi_7720_: vec3<f32>;
var phi_9223_: vec3<f32>;
var phi_9692_: f32;
var phi_9693_: vec3<f32>;
var phi_9695_: type_35;
var phi_9841_: vec3<f32>;
var phi_10830_: type_36;
var phi_14774_: type_38;
var phi_15172_: f32;
var phi_16497_: type_37;
var phi_16510_: vec3<f32>;
var phi_16511_: f32;
var phi_16741_: vec3<f32>;
var phi_19292_: type_37;
var phi_19444_: vec3<f32>;
var phi_19445_: f32;
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
let _e958 = global_1.member.member_8.member_6;
let _e960 = select(_e495, _e478, (_e478 > _e495));
let _e962 = select(_e502, _e960, (_e960 < _e502));
let _e964 = select(_e510, _e484, (_e484 > _e510));
let _e966 = select(_e518, _e964, (_e964 < _e518));
let _e968 = select(_e526, _e490, (_e490 > _e526));
let _e970 = select(_e534, _e968, (_e968 < _e534));
let _e976 = bitcast<f32>((bitcast<u32>((_e478 - _e442)) & 2147483647u));
let _e979 = bitcast<f32>((bitcast<u32>((_e484 - _e457)) & 2147483647u));
let _e981 = select(_e979, _e976, (_e976 > _e979));
let _e984 = bitcast<f32>((bitcast<u32>((_e490 - _e472)) & 2147483647u));
let _e993 = bitcast<f32>((bitcast<u32>((_e478 - _e962)) & 2147483647u));
let _e996 = bitcast<f32>((bitcast<u32>((_e484 - _e966)) & 2147483647u));
let _e998 = select(_e996, _e993, (_e993 > _e996));
let _e1001 = bitcast<f32>((bitcast<u32>((_e490 - _e970)) & 2147483647u));
let _e1009 = global_1.member.member_8.member_3.member;
let _e1010 = (_e962 + 0.5f);
let _e1011 = (_e1009 - 1f);
let _e1013 = select(0f, _e1010, (_e1010 > 0f));
let _e1015 = select(_e1011, _e1013, (_e1013 < _e1011));
let _e1022 = select(0i, select(select(i32(_e1015), i32(-2147483648), (_e1015 < -2147483600f)), 2147483647i, (_e1015 > 2147483500f)), (_e1015 == _e1015));
let _e1030 = global_1.member.member_8.member_14;
let _e1031 = (_e1030 & 31u);
let _e1038 = global_1.member.member_8.member_3.member_1;
let _e1039 = (_e966 + 0.5f);
let _e1040 = (_e1038 - 1f);
let _e1042 = select(0f, _e1039, (_e1039 > 0f));
let _e1044 = select(_e1040, _e1042, (_e1042 < _e1040));
let _e1051 = select(0i, select(select(i32(_e1044), i32(-2147483648), (_e1044 < -2147483600f)), 2147483647i, (_e1044 > 2147483500f)), (_e1044 == _e1044));
let _e1062 = global_1.member.member_8.member_3.member_2;
let _e1063 = (_e970 + 0.5f);
let _e1064 = (_e1062 - 1f);
let _e1066 = select(0f, _e1063, (_e1063 > 0f));
let _e1068 = select(_e1064, _e1066, (_e1066 < _e1064));
let _e1075 = select(0i, select(select(i32(_e1068), i32(-2147483648), (_e1068 < -2147483600f)), 2147483647i, (_e1068 > 2147483500f)), (_e1068 == _e1068));
let _e1086 = global_1.member.member_8.member_11.member;
let _e1092 = global_1.member.member_8.member_11.member_1;
let _e1097 = global_1.member.member_8.member_12;
let _e1103 = ((bitcast<i32>(_e1097) + ((_e1022 - select(0i, 1i, (_e1015 < f32(_e1022)))) >> bitcast<u32>(_e1031))) + (bitcast<i32>(_e1086) * (((_e1051 - select(0i, 1i, (_e1044 < f32(_e1051)))) >> bitcast<u32>(_e1031)) + (bitcast<i32>(_e1092) * ((_e1075 - select(0i, 1i, (_e1068 < f32(_e1075)))) >> bitcast<u32>(_e1031))))));
let _e1105 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1107 = select(_e1105, _e1103, (_e1103 < _e1105));
let _e1113 = global_5.member[bitcast<u32>(select(0i, _e1107, (_e1107 > 0i)))];
phi_1679_ = select(select(7u, 3u, ((_e811 && (!(_e558) || _e948)) && ((_e850 & 1024u) == 0u))), 1u, (((_e850 & 64u) != 0u) || ((((select(_e984, _e981, (_e981 > _e984)) <= _e958) && ((select(_e1001, _e998, (_e998 > _e1001)) > _e958) || (_e1113 != 0u))) && true) && ((_e850 & 32u) != 0u))));
} else {
phi_1679_ = 7u;
}
let _e1126 = phi_1679_;
if (_e1126 > 1u) {
let _e1131 = bitcast<i32>(((_e201 * _e309) + _e199));
let _e1134 = (bitcast<i32>(_e183) - 1i);
let _e1136 = select(_e1134, _e1131, (_e1131 < _e1134));
let _e1142 = global_6.member[bitcast<u32>(select(0i, _e1136, (_e1136 > 0i)))];
let _e1143 = (bitcast<i32>(_e314) + _e1131);
let _e1145 = select(_e1134, _e1143, (_e1143 < _e1134));
let _e1151 = global_6.member[bitcast<u32>(select(0i, _e1145, (_e1145 > 0i)))];
let _e1153 = f32(bitcast<i32>(_e199));
let _e1155 = f32(bitcast<i32>(_e201));
let _e1161 = global_1.member.member_7.member;
let _e1165 = global_1.member.member_10.member_8;
let _e1166 = (_e1161 - _e1165);
let _e1170 = global_1.member.member_10.member_2;
let _e1174 = global_1.member.member_10.member_6;
let _e1181 = global_1.member.member_10.member_4;
let _e1183 = ((_e1170 + (_e1174 * _e1166)) + (((_e1153 - _e1142) + 0.5f) * _e1181));
let _e1187 = global_1.member.member_10.member_3;
let _e1191 = global_1.member.member_10.member_7;
let _e1196 = ((_e1187 + (_e1191 * _e1166)) + (((_e1155 - _e1151) + 0.5f) * _e1181));
let _e1200 = global_1.member.member_7.member_1;
let _e1201 = (_e1200 - _e1165);
let _e1206 = ((_e1170 + (_e1174 * _e1201)) + ((_e1153 + 0.5f) * _e1181));
let _e1211 = ((_e1187 + (_e1191 * _e1201)) + ((_e1155 + 0.5f) * _e1181));
let _e1215 = global_1.member.member_8.member;
let _e1226 = ((((_e1215.member.member * _e1183) + (_e1215.member.member_1 * _e1196)) + (_e1215.member.member_2 * _e1161)) + _e1215.member_1);
let _e1230 = global_1.member.member_8.member_1;
let _e1241 = ((((_e1230.member.member * _e1183) + (_e1230.member.member_1 * _e1196)) + (_e1230.member.member_2 * _e1161)) + _e1230.member_1);
let _e1245 = global_1.member.member_8.member_2;
let _e1256 = ((((_e1245.member.member * _e1183) + (_e1245.member.member_1 * _e1196)) + (_e1245.member.member_2 * _e1161)) + _e1245.member_1);
let _e1262 = ((((_e1215.member.member * _e1206) + (_e1215.member.member_1 * _e1211)) + (_e1215.member.member_2 * _e1200)) + _e1215.member_1);
let _e1268 = ((((_e1230.member.member * _e1206) + (_e1230.member.member_1 * _e1211)) + (_e1230.member.member_2 * _e1200)) + _e1230.member_1);
let _e1274 = ((((_e1245.member.member * _e1206) + (_e1245.member.member_1 * _e1211)) + (_e1245.member.member_2 * _e1200)) + _e1245.member_1);
let _e1276 = (_e191.member_2 == 5u);
let _e1282 = ((_e191.member_2 == 2u) || (_e191.member_2 == 7u));
let _e1283 = ((((_e191.member_2 == 1u) || _e1276) || (_e191.member_2 == 6u)) || _e1282);
if _e1283 {
let _e1288 = global_1.member.member_8.member_4.member;
let _e1293 = global_1.member.member_8.member_5.member;
let _e1295 = select(_e1288, _e1262, (_e1262 > _e1288));
let _e1297 = select(_e1293, _e1295, (_e1295 < _e1293));
let _e1302 = global_1.member.member_8.member_4.member_1;
let _e1307 = global_1.member.member_8.member_5.member_1;
let _e1309 = select(_e1302, _e1268, (_e1268 > _e1302));
let _e1311 = select(_e1307, _e1309, (_e1309 < _e1307));
let _e1316 = global_1.member.member_8.member_4.member_2;
let _e1321 = global_1.member.member_8.member_5.member_2;
let _e1323 = select(_e1316, _e1274, (_e1274 > _e1316));
let _e1325 = select(_e1321, _e1323, (_e1323 < _e1321));
let _e1330 = global_1.member.member_8.member_15;
if (_e1330 == 0u) {
phi_2052_ = vec3<f32>(_e1297, _e1311, _e1325);
} else {
let _e1332 = (_e1297 + 0.5f);
let _e1337 = global_1.member.member_8.member_3.member;
let _e1338 = (_e1337 - 1f);
let _e1340 = select(0f, _e1332, (_e1332 > 0f));
let _e1342 = select(_e1338, _e1340, (_e1340 < _e1338));
let _e1349 = select(0i, select(select(i32(_e1342), i32(-2147483648), (_e1342 < -2147483600f)), 2147483647i, (_e1342 > 2147483500f)), (_e1342 == _e1342));
let _e1355 = (_e1311 + 0.5f);
let _e1360 = global_1.member.member_8.member_3.member_1;
let _e1361 = (_e1360 - 1f);
let _e1363 = select(0f, _e1355, (_e1355 > 0f));
let _e1365 = select(_e1361, _e1363, (_e1363 < _e1361));
let _e1372 = select(0i, select(select(i32(_e1365), i32(-2147483648), (_e1365 < -2147483600f)), 2147483647i, (_e1365 > 2147483500f)), (_e1365 == _e1365));
let _e1378 = (_e1325 + 0.5f);
let _e1383 = global_1.member.member_8.member_3.member_2;
let _e1384 = (_e1383 - 1f);
let _e1386 = select(0f, _e1378, (_e1378 > 0f));
let _e1388 = select(_e1384, _e1386, (_e1386 < _e1384));
let _e1395 = select(0i, select(select(i32(_e1388), i32(-2147483648), (_e1388 < -2147483600f)), 2147483647i, (_e1388 > 2147483500f)), (_e1388 == _e1388));
phi_2052_ = vec3<f32>(f32((_e1349 - select(0i, 1i, (_e1342 < f32(_e1349))))), f32((_e1372 - select(0i, 1i, (_e1365 < f32(_e1372))))), f32((_e1395 - select(0i, 1i, (_e1388 < f32(_e1395))))));
}
let _e1403 = phi_2052_;
let _e1409 = global_1.member.member_8.member_3.member;
let _e1411 = select(-1f, _e1403.x, (_e1403.x > -1f));
let _e1413 = select(_e1409, _e1411, (_e1411 < _e1409));
let _e1420 = select(0i, select(select(i32(_e1413), i32(-2147483648), (_e1413 < -2147483600f)), 2147483647i, (_e1413 > 2147483500f)), (_e1413 == _e1413));
let _e1424 = (_e1420 - select(0i, 1i, (_e1413 < f32(_e1420))));
let _e1430 = global_1.member.member_8.member_3.member_1;
let _e1432 = select(-1f, _e1403.y, (_e1403.y > -1f));
let _e1434 = select(_e1430, _e1432, (_e1432 < _e1430));
let _e1441 = select(0i, select(select(i32(_e1434), i32(-2147483648), (_e1434 < -2147483600f)), 2147483647i, (_e1434 > 2147483500f)), (_e1434 == _e1434));
let _e1445 = (_e1441 - select(0i, 1i, (_e1434 < f32(_e1441))));
let _e1451 = global_1.member.member_8.member_3.member_2;
let _e1453 = select(-1f, _e1403.z, (_e1403.z > -1f));
let _e1455 = select(_e1451, _e1453, (_e1453 < _e1451));
let _e1462 = select(0i, select(select(i32(_e1455), i32(-2147483648), (_e1455 < -2147483600f)), 2147483647i, (_e1455 > 2147483500f)), (_e1455 == _e1455));
let _e1466 = (_e1462 - select(0i, 1i, (_e1455 < f32(_e1462))));
let _e1470 = global_1.member.member_8.member_9;
let _e1474 = global_1.member.member_8.member_10;
let _e1475 = (_e1424 + 1i);
let _e1476 = (_e1445 + 1i);
let _e1477 = (_e1466 + 1i);
let _e1482 = global_1.member.member_8.member_13.member;
let _e1488 = global_1.member.member_8.member_13.member_1;
let _e1499 = ((_e1475 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1482) * ((_e1476 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1488) * (_e1477 >> bitcast<u32>(4i))))));
let _e1501 = (bitcast<i32>(_e176) - 1i);
let _e1503 = select(_e1501, _e1499, (_e1499 < _e1501));
let _e1509 = global_2.member[bitcast<u32>(select(0i, _e1503, (_e1503 > 0i)))];
let _e1511 = (_e1475 & 15i);
let _e1514 = ((_e1476 & 15i) * _e1470);
let _e1516 = (bitcast<i32>(_e1509) + ((_e1477 & 15i) * _e1474));
let _e1517 = (_e1514 + _e1470);
let _e1519 = (_e1514 + (2i * _e1470));
let _e1521 = (_e1514 + (3i * _e1470));
let _e1522 = (_e1516 + _e1474);
let _e1524 = (_e1516 + (2i * _e1474));
let _e1526 = (_e1516 + (3i * _e1474));
local_28 = type_30(array<i32, 4>(_e1511, _e1511, _e1511, _e1511), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_29 = (_e1403 - vec3<f32>(f32(_e1424), f32(_e1445), f32(_e1466)));
let _e1538 = local_28.member[0u];
let _e1539 = ((_e1522 + _e1517) + _e1538);
let _e1541 = (_e1539 >> bitcast<u32>(2i));
let _e1544 = bitcast<u32>(((_e1539 & 3i) * 8i));
let _e1546 = select(_e1501, _e1541, (_e1541 < _e1501));
let _e1551 = global_2.member[bitcast<u32>(select(0i, _e1546, (_e1546 > 0i)))];
let _e1555 = (_e1541 + 1i);
let _e1557 = select(_e1501, _e1555, (_e1555 < _e1501));
let _e1562 = global_2.member[bitcast<u32>(select(0i, _e1557, (_e1557 > 0i)))];
let _e1569 = ((_e1551 >> bitcast<u32>((_e1544 & 31u))) | ((_e1562 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1544) & 31u))));
let _e1572 = local_28.member_1[0u];
let _e1578 = f32(bitcast<i32>(((_e1569 >> bitcast<u32>((_e1572 & 31u))) & 255u)));
let _e1581 = local_28.member_1[1u];
let _e1587 = f32(bitcast<i32>(((_e1569 >> bitcast<u32>((_e1581 & 31u))) & 255u)));
let _e1590 = local_28.member_1[2u];
let _e1596 = f32(bitcast<i32>(((_e1569 >> bitcast<u32>((_e1590 & 31u))) & 255u)));
let _e1599 = local_28.member_1[3u];
let _e1606 = local_29[0u];
let _e1609 = (_e1578 + ((_e1587 - _e1578) * _e1606));
let _e1610 = local_29[0u];
let _e1613 = (_e1587 + ((_e1596 - _e1587) * _e1610));
let _e1614 = local_29[0u];
let _e1617 = (_e1596 + ((f32(bitcast<i32>(((_e1569 >> bitcast<u32>((_e1599 & 31u))) & 255u))) - _e1596) * _e1614));
let _e1619 = local_28.member[0u];
let _e1620 = ((_e1522 + _e1519) + _e1619);
let _e1622 = (_e1620 >> bitcast<u32>(2i));
let _e1625 = bitcast<u32>(((_e1620 & 3i) * 8i));
let _e1627 = select(_e1501, _e1622, (_e1622 < _e1501));
let _e1632 = global_2.member[bitcast<u32>(select(0i, _e1627, (_e1627 > 0i)))];
let _e1636 = (_e1622 + 1i);
let _e1638 = select(_e1501, _e1636, (_e1636 < _e1501));
let _e1643 = global_2.member[bitcast<u32>(select(0i, _e1638, (_e1638 > 0i)))];
let _e1650 = ((_e1632 >> bitcast<u32>((_e1625 & 31u))) | ((_e1643 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1625) & 31u))));
let _e1651 = local_28.member_1[0u];
let _e1657 = f32(bitcast<i32>(((_e1650 >> bitcast<u32>((_e1651 & 31u))) & 255u)));
let _e1658 = local_28.member_1[1u];
let _e1664 = f32(bitcast<i32>(((_e1650 >> bitcast<u32>((_e1658 & 31u))) & 255u)));
let _e1665 = local_28.member_1[2u];
let _e1671 = f32(bitcast<i32>(((_e1650 >> bitcast<u32>((_e1665 & 31u))) & 255u)));
let _e1672 = local_28.member_1[3u];
let _e1679 = local_29[0u];
let _e1683 = local_29[0u];
let _e1686 = (_e1664 + ((_e1671 - _e1664) * _e1683));
let _e1687 = local_29[0u];
let _e1692 = local_28.member[0u];
let _e1693 = ((_e1524 + _e1517) + _e1692);
let _e1695 = (_e1693 >> bitcast<u32>(2i));
let _e1698 = bitcast<u32>(((_e1693 & 3i) * 8i));
let _e1700 = select(_e1501, _e1695, (_e1695 < _e1501));
let _e1705 = global_2.member[bitcast<u32>(select(0i, _e1700, (_e1700 > 0i)))];
let _e1709 = (_e1695 + 1i);
let _e1711 = select(_e1501, _e1709, (_e1709 < _e1501));
let _e1716 = global_2.member[bitcast<u32>(select(0i, _e1711, (_e1711 > 0i)))];
let _e1723 = ((_e1705 >> bitcast<u32>((_e1698 & 31u))) | ((_e1716 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1698) & 31u))));
let _e1724 = local_28.member_1[0u];
let _e1730 = f32(bitcast<i32>(((_e1723 >> bitcast<u32>((_e1724 & 31u))) & 255u)));
let _e1731 = local_28.member_1[1u];
let _e1737 = f32(bitcast<i32>(((_e1723 >> bitcast<u32>((_e1731 & 31u))) & 255u)));
let _e1738 = local_28.member_1[2u];
let _e1744 = f32(bitcast<i32>(((_e1723 >> bitcast<u32>((_e1738 & 31u))) & 255u)));
let _e1745 = local_28.member_1[3u];
let _e1752 = local_29[0u];
let _e1755 = (_e1730 + ((_e1737 - _e1730) * _e1752));
let _e1756 = local_29[0u];
let _e1759 = (_e1737 + ((_e1744 - _e1737) * _e1756));
let _e1760 = local_29[0u];
let _e1763 = (_e1744 + ((f32(bitcast<i32>(((_e1723 >> bitcast<u32>((_e1745 & 31u))) & 255u))) - _e1744) * _e1760));
let _e1765 = local_28.member[0u];
let _e1766 = ((_e1524 + _e1519) + _e1765);
let _e1768 = (_e1766 >> bitcast<u32>(2i));
let _e1771 = bitcast<u32>(((_e1766 & 3i) * 8i));
let _e1773 = select(_e1501, _e1768, (_e1768 < _e1501));
let _e1778 = global_2.member[bitcast<u32>(select(0i, _e1773, (_e1773 > 0i)))];
let _e1782 = (_e1768 + 1i);
let _e1784 = select(_e1501, _e1782, (_e1782 < _e1501));
let _e1789 = global_2.member[bitcast<u32>(select(0i, _e1784, (_e1784 > 0i)))];
let _e1796 = ((_e1778 >> bitcast<u32>((_e1771 & 31u))) | ((_e1789 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1771) & 31u))));
let _e1797 = local_28.member_1[0u];
let _e1803 = f32(bitcast<i32>(((_e1796 >> bitcast<u32>((_e1797 & 31u))) & 255u)));
let _e1804 = local_28.member_1[1u];
let _e1810 = f32(bitcast<i32>(((_e1796 >> bitcast<u32>((_e1804 & 31u))) & 255u)));
let _e1811 = local_28.member_1[2u];
let _e1817 = f32(bitcast<i32>(((_e1796 >> bitcast<u32>((_e1811 & 31u))) & 255u)));
let _e1818 = local_28.member_1[3u];
let _e1825 = local_29[0u];
let _e1829 = local_29[0u];
let _e1832 = (_e1810 + ((_e1817 - _e1810) * _e1829));
let _e1833 = local_29[0u];
let _e1838 = local_28.member[0u];
let _e1839 = ((_e1522 + _e1514) + _e1838);
let _e1841 = (_e1839 >> bitcast<u32>(2i));
let _e1844 = bitcast<u32>(((_e1839 & 3i) * 8i));
let _e1846 = select(_e1501, _e1841, (_e1841 < _e1501));
let _e1851 = global_2.member[bitcast<u32>(select(0i, _e1846, (_e1846 > 0i)))];
let _e1855 = (_e1841 + 1i);
let _e1857 = select(_e1501, _e1855, (_e1855 < _e1501));
let _e1862 = global_2.member[bitcast<u32>(select(0i, _e1857, (_e1857 > 0i)))];
let _e1869 = ((_e1851 >> bitcast<u32>((_e1844 & 31u))) | ((_e1862 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1844) & 31u))));
let _e1870 = local_28.member_1[1u];
let _e1876 = f32(bitcast<i32>(((_e1869 >> bitcast<u32>((_e1870 & 31u))) & 255u)));
let _e1877 = local_28.member_1[2u];
let _e1884 = local_29[0u];
let _e1887 = (_e1876 + ((f32(bitcast<i32>(((_e1869 >> bitcast<u32>((_e1877 & 31u))) & 255u))) - _e1876) * _e1884));
let _e1889 = local_28.member[0u];
let _e1890 = ((_e1522 + _e1521) + _e1889);
let _e1892 = (_e1890 >> bitcast<u32>(2i));
let _e1895 = bitcast<u32>(((_e1890 & 3i) * 8i));
let _e1897 = select(_e1501, _e1892, (_e1892 < _e1501));
let _e1902 = global_2.member[bitcast<u32>(select(0i, _e1897, (_e1897 > 0i)))];
let _e1906 = (_e1892 + 1i);
let _e1908 = select(_e1501, _e1906, (_e1906 < _e1501));
let _e1913 = global_2.member[bitcast<u32>(select(0i, _e1908, (_e1908 > 0i)))];
let _e1920 = ((_e1902 >> bitcast<u32>((_e1895 & 31u))) | ((_e1913 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1895) & 31u))));
let _e1921 = local_28.member_1[1u];
let _e1927 = f32(bitcast<i32>(((_e1920 >> bitcast<u32>((_e1921 & 31u))) & 255u)));
let _e1928 = local_28.member_1[2u];
let _e1935 = local_29[0u];
let _e1940 = local_28.member[0u];
let _e1941 = ((_e1524 + _e1514) + _e1940);
let _e1943 = (_e1941 >> bitcast<u32>(2i));
let _e1946 = bitcast<u32>(((_e1941 & 3i) * 8i));
let _e1948 = select(_e1501, _e1943, (_e1943 < _e1501));
let _e1953 = global_2.member[bitcast<u32>(select(0i, _e1948, (_e1948 > 0i)))];
let _e1957 = (_e1943 + 1i);
let _e1959 = select(_e1501, _e1957, (_e1957 < _e1501));
let _e1964 = global_2.member[bitcast<u32>(select(0i, _e1959, (_e1959 > 0i)))];
let _e1971 = ((_e1953 >> bitcast<u32>((_e1946 & 31u))) | ((_e1964 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1946) & 31u))));
let _e1972 = local_28.member_1[1u];
let _e1978 = f32(bitcast<i32>(((_e1971 >> bitcast<u32>((_e1972 & 31u))) & 255u)));
let _e1979 = local_28.member_1[2u];
let _e1986 = local_29[0u];
let _e1989 = (_e1978 + ((f32(bitcast<i32>(((_e1971 >> bitcast<u32>((_e1979 & 31u))) & 255u))) - _e1978) * _e1986));
let _e1991 = local_28.member[0u];
let _e1992 = ((_e1524 + _e1521) + _e1991);
let _e1994 = (_e1992 >> bitcast<u32>(2i));
let _e1997 = bitcast<u32>(((_e1992 & 3i) * 8i));
let _e1999 = select(_e1501, _e1994, (_e1994 < _e1501));
let _e2004 = global_2.member[bitcast<u32>(select(0i, _e1999, (_e1999 > 0i)))];
let _e2008 = (_e1994 + 1i);
let _e2010 = select(_e1501, _e2008, (_e2008 < _e1501));
let _e2015 = global_2.member[bitcast<u32>(select(0i, _e2010, (_e2010 > 0i)))];
let _e2022 = ((_e2004 >> bitcast<u32>((_e1997 & 31u))) | ((_e2015 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1997) & 31u))));
let _e2023 = local_28.member_1[1u];
let _e2029 = f32(bitcast<i32>(((_e2022 >> bitcast<u32>((_e2023 & 31u))) & 255u)));
let _e2030 = local_28.member_1[2u];
let _e2037 = local_29[0u];
let _e2042 = local_28.member[0u];
let _e2043 = ((_e1516 + _e1517) + _e2042);
let _e2045 = (_e2043 >> bitcast<u32>(2i));
let _e2048 = bitcast<u32>(((_e2043 & 3i) * 8i));
let _e2050 = select(_e1501, _e2045, (_e2045 < _e1501));
let _e2055 = global_2.member[bitcast<u32>(select(0i, _e2050, (_e2050 > 0i)))];
let _e2059 = (_e2045 + 1i);
let _e2061 = select(_e1501, _e2059, (_e2059 < _e1501));
let _e2066 = global_2.member[bitcast<u32>(select(0i, _e2061, (_e2061 > 0i)))];
let _e2073 = ((_e2055 >> bitcast<u32>((_e2048 & 31u))) | ((_e2066 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2048) & 31u))));
let _e2074 = local_28.member_1[1u];
let _e2080 = f32(bitcast<i32>(((_e2073 >> bitcast<u32>((_e2074 & 31u))) & 255u)));
let _e2081 = local_28.member_1[2u];
let _e2088 = local_29[0u];
let _e2091 = (_e2080 + ((f32(bitcast<i32>(((_e2073 >> bitcast<u32>((_e2081 & 31u))) & 255u))) - _e2080) * _e2088));
let _e2093 = local_28.member[0u];
let _e2094 = ((_e1526 + _e1517) + _e2093);
let _e2096 = (_e2094 >> bitcast<u32>(2i));
let _e2099 = bitcast<u32>(((_e2094 & 3i) * 8i));
let _e2101 = select(_e1501, _e2096, (_e2096 < _e1501));
let _e2106 = global_2.member[bitcast<u32>(select(0i, _e2101, (_e2101 > 0i)))];
let _e2110 = (_e2096 + 1i);
let _e2112 = select(_e1501, _e2110, (_e2110 < _e1501));
let _e2117 = global_2.member[bitcast<u32>(select(0i, _e2112, (_e2112 > 0i)))];
let _e2124 = ((_e2106 >> bitcast<u32>((_e2099 & 31u))) | ((_e2117 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2099) & 31u))));
let _e2125 = local_28.member_1[1u];
let _e2131 = f32(bitcast<i32>(((_e2124 >> bitcast<u32>((_e2125 & 31u))) & 255u)));
let _e2132 = local_28.member_1[2u];
let _e2139 = local_29[0u];
let _e2142 = (_e2131 + ((f32(bitcast<i32>(((_e2124 >> bitcast<u32>((_e2132 & 31u))) & 255u))) - _e2131) * _e2139));
let _e2144 = local_28.member[0u];
let _e2145 = ((_e1516 + _e1519) + _e2144);
let _e2147 = (_e2145 >> bitcast<u32>(2i));
let _e2150 = bitcast<u32>(((_e2145 & 3i) * 8i));
let _e2152 = select(_e1501, _e2147, (_e2147 < _e1501));
let _e2157 = global_2.member[bitcast<u32>(select(0i, _e2152, (_e2152 > 0i)))];
let _e2161 = (_e2147 + 1i);
let _e2163 = select(_e1501, _e2161, (_e2161 < _e1501));
let _e2168 = global_2.member[bitcast<u32>(select(0i, _e2163, (_e2163 > 0i)))];
let _e2175 = ((_e2157 >> bitcast<u32>((_e2150 & 31u))) | ((_e2168 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2150) & 31u))));
let _e2176 = local_28.member_1[1u];
let _e2182 = f32(bitcast<i32>(((_e2175 >> bitcast<u32>((_e2176 & 31u))) & 255u)));
let _e2183 = local_28.member_1[2u];
let _e2190 = local_29[0u];
let _e2195 = local_28.member[0u];
let _e2196 = ((_e1526 + _e1519) + _e2195);
let _e2198 = (_e2196 >> bitcast<u32>(2i));
let _e2201 = bitcast<u32>(((_e2196 & 3i) * 8i));
let _e2203 = select(_e1501, _e2198, (_e2198 < _e1501));
let _e2208 = global_2.member[bitcast<u32>(select(0i, _e2203, (_e2203 > 0i)))];
let _e2212 = (_e2198 + 1i);
let _e2214 = select(_e1501, _e2212, (_e2212 < _e1501));
let _e2219 = global_2.member[bitcast<u32>(select(0i, _e2214, (_e2214 > 0i)))];
let _e2226 = ((_e2208 >> bitcast<u32>((_e2201 & 31u))) | ((_e2219 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2201) & 31u))));
let _e2227 = local_28.member_1[1u];
let _e2233 = f32(bitcast<i32>(((_e2226 >> bitcast<u32>((_e2227 & 31u))) & 255u)));
let _e2234 = local_28.member_1[2u];
let _e2241 = local_29[0u];
let _e2246 = local_29[1u];
let _e2249 = (_e1613 + ((_e1686 - _e1613) * _e2246));
let _e2250 = local_29[1u];
let _e2253 = (_e1759 + ((_e1832 - _e1759) * _e2250));
let _e2254 = local_29[1u];
let _e2257 = (_e1609 + (((_e1657 + ((_e1664 - _e1657) * _e1679)) - _e1609) * _e2254));
let _e2258 = local_29[1u];
let _e2263 = local_29[2u];
let _e2267 = local_29[1u];
let _e2270 = (_e1617 + (((_e1671 + ((f32(bitcast<i32>(((_e1650 >> bitcast<u32>((_e1672 & 31u))) & 255u))) - _e1671) * _e1687)) - _e1617) * _e2267));
let _e2271 = local_29[1u];
let _e2275 = local_29[2u];
let _e2279 = local_29[1u];
let _e2282 = (_e1887 + ((_e1613 - _e1887) * _e2279));
let _e2283 = local_29[1u];
let _e2287 = local_29[2u];
let _e2291 = local_29[1u];
let _e2294 = (_e1686 + (((_e1927 + ((f32(bitcast<i32>(((_e1920 >> bitcast<u32>((_e1928 & 31u))) & 255u))) - _e1927) * _e1935)) - _e1686) * _e2291));
let _e2295 = local_29[1u];
let _e2299 = local_29[2u];
let _e2303 = local_29[1u];
let _e2306 = (_e2091 + (((_e2182 + ((f32(bitcast<i32>(((_e2175 >> bitcast<u32>((_e2183 & 31u))) & 255u))) - _e2182) * _e2190)) - _e2091) * _e2303));
let _e2307 = local_29[2u];
let _e2311 = local_29[1u];
let _e2315 = local_29[2u];
let _e2319 = local_29[2u];
let _e2326 = global_1.member.member_8.member_8;
let _e2330 = global_1.member.member_8.member_7;
let _e2332 = (((_e2249 + ((_e2253 - _e2249) * _e2319)) - _e2326) * _e2330);
let _e2333 = -(1e9f);
let _e2335 = select(_e2333, _e2332, (_e2332 > _e2333));
let _e2337 = select(1e9f, _e2335, (_e2335 < 1e9f));
let _e2339 = (((_e2257 + (((_e1755 + (((_e1803 + ((_e1810 - _e1803) * _e1825)) - _e1755) * _e2258)) - _e2257) * _e2263)) - _e2326) * _e2330);
let _e2341 = select(_e2333, _e2339, (_e2339 > _e2333));
let _e2343 = select(1e9f, _e2341, (_e2341 < 1e9f));
let _e2345 = (((_e2270 + (((_e1763 + (((_e1817 + ((f32(bitcast<i32>(((_e1796 >> bitcast<u32>((_e1818 & 31u))) & 255u))) - _e1817) * _e1833)) - _e1763) * _e2271)) - _e2270) * _e2275)) - _e2326) * _e2330);
let _e2347 = select(_e2333, _e2345, (_e2345 > _e2333));
let _e2349 = select(1e9f, _e2347, (_e2347 < 1e9f));
let _e2351 = (((_e2282 + (((_e1989 + ((_e1759 - _e1989) * _e2283)) - _e2282) * _e2287)) - _e2326) * _e2330);
let _e2353 = select(_e2333, _e2351, (_e2351 > _e2333));
let _e2355 = select(1e9f, _e2353, (_e2353 < 1e9f));
let _e2357 = (((_e2294 + (((_e1832 + (((_e2029 + ((f32(bitcast<i32>(((_e2022 >> bitcast<u32>((_e2030 & 31u))) & 255u))) - _e2029) * _e2037)) - _e1832) * _e2295)) - _e2294) * _e2299)) - _e2326) * _e2330);
let _e2359 = select(_e2333, _e2357, (_e2357 > _e2333));
let _e2361 = select(1e9f, _e2359, (_e2359 < 1e9f));
let _e2363 = (((_e2306 + ((_e2249 - _e2306) * _e2307)) - _e2326) * _e2330);
let _e2365 = select(_e2333, _e2363, (_e2363 > _e2333));
let _e2367 = select(1e9f, _e2365, (_e2365 < 1e9f));
let _e2369 = (((_e2253 + (((_e2142 + (((_e2233 + ((f32(bitcast<i32>(((_e2226 >> bitcast<u32>((_e2234 & 31u))) & 255u))) - _e2233) * _e2241)) - _e2142) * _e2311)) - _e2253) * _e2315)) - _e2326) * _e2330);
let _e2371 = select(_e2333, _e2369, (_e2369 > _e2333));
let _e2373 = select(1e9f, _e2371, (_e2371 < 1e9f));
local_26 = _e2337;
let _e2374 = local_26;
local_27 = _e2374;
let _e2375 = local_27;
let _e2377 = (bitcast<i32>(_e181) - 1i);
let _e2379 = select(_e2377, 263197i, (263197i < _e2377));
let _e2384 = global_3.member[bitcast<u32>(select(0i, _e2379, (_e2379 > 0i)))];
let _e2385 = bitcast<f32>(_e2384);
let _e2387 = select(_e2377, 263198i, (263198i < _e2377));
let _e2390 = bitcast<u32>(select(0i, _e2387, (_e2387 > 0i)));
let _e2392 = global_3.member[_e2390];
let _e2393 = bitcast<f32>(_e2392);
let _e2395 = select(_e2377, 263199i, (263199i < _e2377));
let _e2400 = global_3.member[bitcast<u32>(select(0i, _e2395, (_e2395 > 0i)))];
let _e2401 = bitcast<f32>(_e2400);
let _e2403 = ((_e2375 - _e2385) * _e2393);
let _e2405 = select(0f, _e2403, (_e2403 > 0f));
let _e2408 = local_27;
let _e2410 = select(_e2377, 263200i, (263200i < _e2377));
let _e2415 = global_3.member[bitcast<u32>(select(0i, _e2410, (_e2410 > 0i)))];
let _e2416 = bitcast<f32>(_e2415);
let _e2418 = select(_e2377, 263201i, (263201i < _e2377));
let _e2423 = global_3.member[bitcast<u32>(select(0i, _e2418, (_e2418 > 0i)))];
let _e2424 = bitcast<f32>(_e2423);
let _e2426 = select(_e2377, 263202i, (263202i < _e2377));
let _e2431 = global_3.member[bitcast<u32>(select(0i, _e2426, (_e2426 > 0i)))];
let _e2432 = bitcast<f32>(_e2431);
let _e2434 = ((_e2408 - _e2416) * _e2424);
let _e2436 = select(0f, _e2434, (_e2434 > 0f));
let _e2440 = local_27;
let _e2442 = select(_e2377, 263203i, (263203i < _e2377));
let _e2447 = global_3.member[bitcast<u32>(select(0i, _e2442, (_e2442 > 0i)))];
let _e2448 = bitcast<f32>(_e2447);
let _e2450 = select(_e2377, 263204i, (263204i < _e2377));
let _e2455 = global_3.member[bitcast<u32>(select(0i, _e2450, (_e2450 > 0i)))];
let _e2456 = bitcast<f32>(_e2455);
let _e2458 = select(_e2377, 263205i, (263205i < _e2377));
let _e2463 = global_3.member[bitcast<u32>(select(0i, _e2458, (_e2458 > 0i)))];
let _e2464 = bitcast<f32>(_e2463);
let _e2466 = ((_e2440 - _e2448) * _e2456);
let _e2468 = select(0f, _e2466, (_e2466 > 0f));
let _e2471 = local_27;
let _e2473 = select(_e2377, 263206i, (263206i < _e2377));
let _e2478 = global_3.member[bitcast<u32>(select(0i, _e2473, (_e2473 > 0i)))];
let _e2479 = bitcast<f32>(_e2478);
let _e2481 = select(_e2377, 263207i, (263207i < _e2377));
let _e2486 = global_3.member[bitcast<u32>(select(0i, _e2481, (_e2481 > 0i)))];
let _e2487 = bitcast<f32>(_e2486);
let _e2489 = select(_e2377, 263208i, (263208i < _e2377));
let _e2494 = global_3.member[bitcast<u32>(select(0i, _e2489, (_e2489 > 0i)))];
let _e2495 = bitcast<f32>(_e2494);
let _e2497 = ((_e2471 - _e2479) * _e2487);
let _e2499 = select(0f, _e2497, (_e2497 > 0f));
let _e2503 = ((select(_e2401, _e2405, (_e2405 < _e2401)) + select(_e2432, _e2436, (_e2436 < _e2432))) + (select(_e2464, _e2468, (_e2468 < _e2464)) + select(_e2495, _e2499, (_e2499 < _e2495))));
let _e2505 = select(0f, _e2503, (_e2503 > 0f));
let _e2507 = select(1023f, _e2505, (_e2505 < 1023f));
let _e2514 = select(0i, select(select(i32(_e2507), i32(-2147483648), (_e2507 < -2147483600f)), 2147483647i, (_e2507 > 2147483500f)), (_e2507 == _e2507));
let _e2518 = (_e2514 - select(0i, 1i, (_e2507 < f32(_e2514))));
let _e2519 = (262147i + _e2518);
let _e2521 = select(_e2377, _e2519, (_e2519 < _e2377));
let _e2527 = global_3.member[bitcast<u32>(select(0i, _e2521, (_e2521 > 0i)))];
let _e2537 = select(_e2377, 262146i, (262146i < _e2377));
let _e2543 = global_3.member[bitcast<u32>(select(0i, _e2537, (_e2537 > 0i)))];
let _e2544 = bitcast<f32>(_e2543);
let _e2545 = (f32((bitcast<i32>((_e2527 & 4095u)) - 2048i)) * _e2544);
let _e2547 = select(_e2377, 262144i, (262144i < _e2377));
let _e2553 = global_3.member[bitcast<u32>(select(0i, _e2547, (_e2547 > 0i)))];
let _e2554 = bitcast<f32>(_e2553);
let _e2556 = select(_e2377, 262145i, (262145i < _e2377));
let _e2562 = global_3.member[bitcast<u32>(select(0i, _e2556, (_e2556 > 0i)))];
let _e2563 = bitcast<f32>(_e2562);
let _e2569 = ((_e2554 + (f32(bitcast<i32>((_e2527 >> bitcast<u32>(12u)))) * _e2563)) + (_e2545 * (_e2503 - f32(_e2518))));
let _e2572 = global_3.member[_e2390];
let _e2574 = local_26;
let _e2577 = local_26;
let _e2580 = local_26;
let _e2584 = select(_e2377, 263209i, (263209i < _e2377));
let _e2590 = global_3.member[bitcast<u32>(select(0i, _e2584, (_e2584 > 0i)))];
let _e2592 = local_26;
let _e2595 = select(_e2377, 263210i, (263210i < _e2377));
let _e2601 = global_3.member[bitcast<u32>(select(0i, _e2595, (_e2595 > 0i)))];
let _e2603 = local_26;
let _e2607 = (_e2545 * select(0f, select(select(select(bitcast<f32>(_e2572), _e2424, (_e2574 >= _e2416)), _e2456, (_e2577 >= _e2448)), _e2487, (_e2580 >= _e2479)), ((_e2592 >= bitcast<f32>(_e2590)) && (_e2603 <= bitcast<f32>(_e2601)))));
if _e1282 {
let _e2614 = ((0.5f * (_e2349 - _e2343)) * _e2607);
let _e2615 = ((0.5f * (_e2361 - _e2355)) * _e2607);
let _e2616 = ((0.5f * (_e2373 - _e2367)) * _e2607);
phi_7373_ = type_34(_e2569, vec3<f32>(_e2614, _e2615, _e2616), vec3<f32>((_e2614 * _e2569), (_e2615 * _e2569), (_e2616 * _e2569)));
} else {
local_24 = _e2343;
let _e2623 = local_24;
local_25 = _e2623;
let _e2624 = local_25;
let _e2626 = ((_e2624 - _e2385) * _e2393);
let _e2628 = select(0f, _e2626, (_e2626 > 0f));
let _e2631 = local_25;
let _e2633 = ((_e2631 - _e2416) * _e2424);
let _e2635 = select(0f, _e2633, (_e2633 > 0f));
let _e2639 = local_25;
let _e2641 = ((_e2639 - _e2448) * _e2456);
let _e2643 = select(0f, _e2641, (_e2641 > 0f));
let _e2646 = local_25;
let _e2648 = ((_e2646 - _e2479) * _e2487);
let _e2650 = select(0f, _e2648, (_e2648 > 0f));
let _e2654 = ((select(_e2401, _e2628, (_e2628 < _e2401)) + select(_e2432, _e2635, (_e2635 < _e2432))) + (select(_e2464, _e2643, (_e2643 < _e2464)) + select(_e2495, _e2650, (_e2650 < _e2495))));
let _e2656 = select(0f, _e2654, (_e2654 > 0f));
let _e2658 = select(1023f, _e2656, (_e2656 < 1023f));
let _e2665 = select(0i, select(select(i32(_e2658), i32(-2147483648), (_e2658 < -2147483600f)), 2147483647i, (_e2658 > 2147483500f)), (_e2658 == _e2658));
let _e2669 = (_e2665 - select(0i, 1i, (_e2658 < f32(_e2665))));
let _e2670 = (262147i + _e2669);
let _e2672 = select(_e2377, _e2670, (_e2670 < _e2377));
let _e2678 = global_3.member[bitcast<u32>(select(0i, _e2672, (_e2672 > 0i)))];
let _e2693 = ((_e2554 + (f32(bitcast<i32>((_e2678 >> bitcast<u32>(12u)))) * _e2563)) + ((f32((bitcast<i32>((_e2678 & 4095u)) - 2048i)) * _e2544) * (_e2654 - f32(_e2669))));
local_22 = _e2349;
let _e2694 = local_22;
local_23 = _e2694;
let _e2695 = local_23;
let _e2697 = ((_e2695 - _e2385) * _e2393);
let _e2699 = select(0f, _e2697, (_e2697 > 0f));
let _e2702 = local_23;
let _e2704 = ((_e2702 - _e2416) * _e2424);
let _e2706 = select(0f, _e2704, (_e2704 > 0f));
let _e2710 = local_23;
let _e2712 = ((_e2710 - _e2448) * _e2456);
let _e2714 = select(0f, _e2712, (_e2712 > 0f));
let _e2717 = local_23;
let _e2719 = ((_e2717 - _e2479) * _e2487);
let _e2721 = select(0f, _e2719, (_e2719 > 0f));
let _e2725 = ((select(_e2401, _e2699, (_e2699 < _e2401)) + select(_e2432, _e2706, (_e2706 < _e2432))) + (select(_e2464, _e2714, (_e2714 < _e2464)) + select(_e2495, _e2721, (_e2721 < _e2495))));
let _e2727 = select(0f, _e2725, (_e2725 > 0f));
let _e2729 = select(1023f, _e2727, (_e2727 < 1023f));
let _e2736 = select(0i, select(select(i32(_e2729), i32(-2147483648), (_e2729 < -2147483600f)), 2147483647i, (_e2729 > 2147483500f)), (_e2729 == _e2729));
let _e2740 = (_e2736 - select(0i, 1i, (_e2729 < f32(_e2736))));
let _e2741 = (262147i + _e2740);
let _e2743 = select(_e2377, _e2741, (_e2741 < _e2377));
let _e2749 = global_3.member[bitcast<u32>(select(0i, _e2743, (_e2743 > 0i)))];
let _e2764 = ((_e2554 + (f32(bitcast<i32>((_e2749 >> bitcast<u32>(12u)))) * _e2563)) + ((f32((bitcast<i32>((_e2749 & 4095u)) - 2048i)) * _e2544) * (_e2725 - f32(_e2740))));
local_20 = _e2355;
let _e2765 = local_20;
local_21 = _e2765;
let _e2766 = local_21;
let _e2768 = ((_e2766 - _e2385) * _e2393);
let _e2770 = select(0f, _e2768, (_e2768 > 0f));
let _e2773 = local_21;
let _e2775 = ((_e2773 - _e2416) * _e2424);
let _e2777 = select(0f, _e2775, (_e2775 > 0f));
let _e2781 = local_21;
let _e2783 = ((_e2781 - _e2448) * _e2456);
let _e2785 = select(0f, _e2783, (_e2783 > 0f));
let _e2788 = local_21;
let _e2790 = ((_e2788 - _e2479) * _e2487);
let _e2792 = select(0f, _e2790, (_e2790 > 0f));
let _e2796 = ((select(_e2401, _e2770, (_e2770 < _e2401)) + select(_e2432, _e2777, (_e2777 < _e2432))) + (select(_e2464, _e2785, (_e2785 < _e2464)) + select(_e2495, _e2792, (_e2792 < _e2495))));
let _e2798 = select(0f, _e2796, (_e2796 > 0f));
let _e2800 = select(1023f, _e2798, (_e2798 < 1023f));
let _e2807 = select(0i, select(select(i32(_e2800), i32(-2147483648), (_e2800 < -2147483600f)), 2147483647i, (_e2800 > 2147483500f)), (_e2800 == _e2800));
let _e2811 = (_e2807 - select(0i, 1i, (_e2800 < f32(_e2807))));
let _e2812 = (262147i + _e2811);
let _e2814 = select(_e2377, _e2812, (_e2812 < _e2377));
let _e2820 = global_3.member[bitcast<u32>(select(0i, _e2814, (_e2814 > 0i)))];
let _e2835 = ((_e2554 + (f32(bitcast<i32>((_e2820 >> bitcast<u32>(12u)))) * _e2563)) + ((f32((bitcast<i32>((_e2820 & 4095u)) - 2048i)) * _e2544) * (_e2796 - f32(_e2811))));
local_18 = _e2361;
let _e2836 = local_18;
local_19 = _e2836;
let _e2837 = local_19;
let _e2839 = ((_e2837 - _e2385) * _e2393);
let _e2841 = select(0f, _e2839, (_e2839 > 0f));
let _e2844 = local_19;
let _e2846 = ((_e2844 - _e2416) * _e2424);
let _e2848 = select(0f, _e2846, (_e2846 > 0f));
let _e2852 = local_19;
let _e2854 = ((_e2852 - _e2448) * _e2456);
let _e2856 = select(0f, _e2854, (_e2854 > 0f));
let _e2859 = local_19;
let _e2861 = ((_e2859 - _e2479) * _e2487);
let _e2863 = select(0f, _e2861, (_e2861 > 0f));
let _e2867 = ((select(_e2401, _e2841, (_e2841 < _e2401)) + select(_e2432, _e2848, (_e2848 < _e2432))) + (select(_e2464, _e2856, (_e2856 < _e2464)) + select(_e2495, _e2863, (_e2863 < _e2495))));
let _e2869 = select(0f, _e2867, (_e2867 > 0f));
let _e2871 = select(1023f, _e2869, (_e2869 < 1023f));
let _e2878 = select(0i, select(select(i32(_e2871), i32(-2147483648), (_e2871 < -2147483600f)), 2147483647i, (_e2871 > 2147483500f)), (_e2871 == _e2871));
let _e2882 = (_e2878 - select(0i, 1i, (_e2871 < f32(_e2878))));
let _e2883 = (262147i + _e2882);
let _e2885 = select(_e2377, _e2883, (_e2883 < _e2377));
let _e2891 = global_3.member[bitcast<u32>(select(0i, _e2885, (_e2885 > 0i)))];
let _e2906 = ((_e2554 + (f32(bitcast<i32>((_e2891 >> bitcast<u32>(12u)))) * _e2563)) + ((f32((bitcast<i32>((_e2891 & 4095u)) - 2048i)) * _e2544) * (_e2867 - f32(_e2882))));
local_16 = _e2367;
let _e2907 = local_16;
local_17 = _e2907;
let _e2908 = local_17;
let _e2910 = ((_e2908 - _e2385) * _e2393);
let _e2912 = select(0f, _e2910, (_e2910 > 0f));
let _e2915 = local_17;
let _e2917 = ((_e2915 - _e2416) * _e2424);
let _e2919 = select(0f, _e2917, (_e2917 > 0f));
let _e2923 = local_17;
let _e2925 = ((_e2923 - _e2448) * _e2456);
let _e2927 = select(0f, _e2925, (_e2925 > 0f));
let _e2930 = local_17;
let _e2932 = ((_e2930 - _e2479) * _e2487);
let _e2934 = select(0f, _e2932, (_e2932 > 0f));
let _e2938 = ((select(_e2401, _e2912, (_e2912 < _e2401)) + select(_e2432, _e2919, (_e2919 < _e2432))) + (select(_e2464, _e2927, (_e2927 < _e2464)) + select(_e2495, _e2934, (_e2934 < _e2495))));
let _e2940 = select(0f, _e2938, (_e2938 > 0f));
let _e2942 = select(1023f, _e2940, (_e2940 < 1023f));
let _e2949 = select(0i, select(select(i32(_e2942), i32(-2147483648), (_e2942 < -2147483600f)), 2147483647i, (_e2942 > 2147483500f)), (_e2942 == _e2942));
let _e2953 = (_e2949 - select(0i, 1i, (_e2942 < f32(_e2949))));
let _e2954 = (262147i + _e2953);
let _e2956 = select(_e2377, _e2954, (_e2954 < _e2377));
let _e2962 = global_3.member[bitcast<u32>(select(0i, _e2956, (_e2956 > 0i)))];
let _e2977 = ((_e2554 + (f32(bitcast<i32>((_e2962 >> bitcast<u32>(12u)))) * _e2563)) + ((f32((bitcast<i32>((_e2962 & 4095u)) - 2048i)) * _e2544) * (_e2938 - f32(_e2953))));
local_14 = _e2373;
let _e2978 = local_14;
local_15 = _e2978;
let _e2979 = local_15;
let _e2981 = ((_e2979 - _e2385) * _e2393);
let _e2983 = select(0f, _e2981, (_e2981 > 0f));
let _e2986 = local_15;
let _e2988 = ((_e2986 - _e2416) * _e2424);
let _e2990 = select(0f, _e2988, (_e2988 > 0f));
let _e2994 = local_15;
let _e2996 = ((_e2994 - _e2448) * _e2456);
let _e2998 = select(0f, _e2996, (_e2996 > 0f));
let _e3001 = local_15;
let _e3003 = ((_e3001 - _e2479) * _e2487);
let _e3005 = select(0f, _e3003, (_e3003 > 0f));
let _e3009 = ((select(_e2401, _e2983, (_e2983 < _e2401)) + select(_e2432, _e2990, (_e2990 < _e2432))) + (select(_e2464, _e2998, (_e2998 < _e2464)) + select(_e2495, _e3005, (_e3005 < _e2495))));
let _e3011 = select(0f, _e3009, (_e3009 > 0f));
let _e3013 = select(1023f, _e3011, (_e3011 < 1023f));
let _e3020 = select(0i, select(select(i32(_e3013), i32(-2147483648), (_e3013 < -2147483600f)), 2147483647i, (_e3013 > 2147483500f)), (_e3013 == _e3013));
let _e3024 = (_e3020 - select(0i, 1i, (_e3013 < f32(_e3020))));
let _e3025 = (262147i + _e3024);
let _e3027 = select(_e2377, _e3025, (_e3025 < _e2377));
let _e3033 = global_3.member[bitcast<u32>(select(0i, _e3027, (_e3027 > 0i)))];
let _e3048 = ((_e2554 + (f32(bitcast<i32>((_e3033 >> bitcast<u32>(12u)))) * _e2563)) + ((f32((bitcast<i32>((_e3033 & 4095u)) - 2048i)) * _e2544) * (_e3009 - f32(_e3024))));
let _e3049 = (_e2764 - _e2693);
let _e3051 = (_e2906 - _e2835);
let _e3053 = (_e3048 - _e2977);
phi_7373_ = type_34(_e2569, vec3<f32>((0.5f * _e3049), (0.5f * _e3051), (0.5f * _e3053)), vec3<f32>((0.25f * (_e3049 * (_e2764 + _e2693))), (0.25f * (_e3051 * (_e2906 + _e2835))), (0.25f * (_e3053 * (_e3048 + _e2977)))));
}
let _e3068 = phi_7373_;
let _e3083 = select(0f, 1f, ((((((_e1262 >= _e1288) && (_e1262 <= _e1293)) && (_e1268 >= _e1302)) && (_e1268 <= _e1307)) && (_e1274 >= _e1316)) && (_e1274 <= _e1321)));
let _e3085 = (0.5f * (_e2349 - _e2343));
let _e3087 = (0.5f * (_e2361 - _e2355));
let _e3089 = (0.5f * (_e2373 - _e2367));
let _e3095 = global_1.member.member_8.member.member.member;
let _e3101 = global_1.member.member_8.member.member.member_1;
let _e3107 = global_1.member.member_8.member.member.member_2;
let _e3113 = global_1.member.member_8.member_1.member.member;
let _e3119 = global_1.member.member_8.member_1.member.member_1;
let _e3125 = global_1.member.member_8.member_1.member.member_2;
let _e3131 = global_1.member.member_8.member_2.member.member;
let _e3137 = global_1.member.member_8.member_2.member.member_1;
let _e3143 = global_1.member.member_8.member_2.member.member_2;
let _e3148 = (((_e3095 * _e3085) + (_e3113 * _e3087)) + (_e3131 * _e3089));
let _e3153 = (((_e3101 * _e3085) + (_e3119 * _e3087)) + (_e3137 * _e3089));
let _e3158 = (((_e3107 * _e3085) + (_e3125 * _e3087)) + (_e3143 * _e3089));
phi_9695_ = type_35(_e2337, vec3<f32>((_e3148 * _e3083), (_e3153 * _e3083), (_e3158 * _e3083)), vec3<f32>(_e3148, _e3153, _e3158), _e3068.member, vec3<f32>(((((_e3095 * _e3068.member_2.x) + (_e3113 * _e3068.member_2.y)) + (_e3131 * _e3068.member_2.z)) * _e3083), ((((_e3101 * _e3068.member_2.x) + (_e3119 * _e3068.member_2.y)) + (_e3137 * _e3068.member_2.z)) * _e3083), ((((_e3107 * _e3068.member_2.x) + (_e3125 * _e3068.member_2.y)) + (_e3143 * _e3068.member_2.z)) * _e3083)), vec3<f32>(((((_e3095 * _e3068.member_1.x) + (_e3113 * _e3068.member_1.y)) + (_e3131 * _e3068.member_1.z)) * _e3083), ((((_e3101 * _e3068.member_1.x) + (_e3119 * _e3068.member_1.y)) + (_e3137 * _e3068.member_1.z)) * _e3083), ((((_e3107 * _e3068.member_1.x) + (_e3125 * _e3068.member_1.y)) + (_e3143 * _e3068.member_1.z)) * _e3083)));
} else {
if (_e191.member_2 == 8u) {
let _e3214 = global_1.member.member_8.member_4.member;
let _e3219 = global_1.member.member_8.member_5.member;
let _e3221 = select(_e3214, _e1262, (_e1262 > _e3214));
let _e3223 = select(_e3219, _e3221, (_e3221 < _e3219));
let _e3228 = global_1.member.member_8.member_4.member_1;
let _e3233 = global_1.member.member_8.member_5.member_1;
let _e3235 = select(_e3228, _e1268, (_e1268 > _e3228));
let _e3237 = select(_e3233, _e3235, (_e3235 < _e3233));
let _e3242 = global_1.member.member_8.member_4.member_2;
let _e3247 = global_1.member.member_8.member_5.member_2;
let _e3249 = select(_e3242, _e1274, (_e1274 > _e3242));
let _e3251 = select(_e3247, _e3249, (_e3249 < _e3247));
let _e3256 = global_1.member.member_8.member_15;
if (_e3256 == 0u) {
phi_7720_ = vec3<f32>(_e3223, _e3237, _e3251);
} else {
let _e3258 = (_e3223 + 0.5f);
let _e3263 = global_1.member.member_8.member_3.member;
let _e3264 = (_e3263 - 1f);
let _e3266 = select(0f, _e3258, (_e3258 > 0f));
let _e3268 = select(_e3264, _e3266, (_e3266 < _e3264));
let _e3275 = select(0i, select(select(i32(_e3268), i32(-2147483648), (_e3268 < -2147483600f)), 2147483647i, (_e3268 > 2147483500f)), (_e3268 == _e3268));
let _e3281 = (_e3237 + 0.5f);
let _e3286 = global_1.member.member_8.member_3.member_1;
let _e3287 = (_e3286 - 1f);
let _e3289 = select(0f, _e3281, (_e3281 > 0f));
let _e3291 = select(_e3287, _e3289, (_e3289 < _e3287));
let _e3298 = select(0i, select(select(i32(_e3291), i32(-2147483648), (_e3291 < -2147483600f)), 2147483647i, (_e3291 > 2147483500f)), (_e3291 == _e3291));
let _e3304 = (_e3251 + 0.5f);
let _e3309 = global_1.member.member_8.member_3.member_2;
let _e3310 = (_e3309 - 1f);
let _e3312 = select(0f, _e3304, (_e3304 > 0f));
let _e3314 = select(_e3310, _e3312, (_e3312 < _e3310));
let _e3321 = select(0i, select(select(i32(_e3314), i32(-2147483648), (_e3314 < -2147483600f)), 2147483647i, (_e3314 > 2147483500f)), (_e3314 == _e3314));
phi_7720_ = vec3<f32>(f32((_e3275 - select(0i, 1i, (_e3268 < f32(_e3275))))), f32((_e3298 - select(0i, 1i, (_e3291 < f32(_e3298))))), f32((_e3321 - select(0i, 1i, (_e3314 < f32(_e3321))))));
}
let _e3329 = phi_7720_;
let _e3335 = global_1.member.member_8.member_3.member;
let _e3337 = select(-1f, _e3329.x, (_e3329.x > -1f));
let _e3339 = select(_e3335, _e3337, (_e3337 < _e3335));
let _e3346 = select(0i, select(select(i32(_e3339), i32(-2147483648), (_e3339 < -2147483600f)), 2147483647i, (_e3339 > 2147483500f)), (_e3339 == _e3339));
let _e3350 = (_e3346 - select(0i, 1i, (_e3339 < f32(_e3346))));
let _e3356 = global_1.member.member_8.member_3.member_1;
let _e3358 = select(-1f, _e3329.y, (_e3329.y > -1f));
let _e3360 = select(_e3356, _e3358, (_e3358 < _e3356));
let _e3367 = select(0i, select(select(i32(_e3360), i32(-2147483648), (_e3360 < -2147483600f)), 2147483647i, (_e3360 > 2147483500f)), (_e3360 == _e3360));
let _e3371 = (_e3367 - select(0i, 1i, (_e3360 < f32(_e3367))));
let _e3377 = global_1.member.member_8.member_3.member_2;
let _e3379 = select(-1f, _e3329.z, (_e3329.z > -1f));
let _e3381 = select(_e3377, _e3379, (_e3379 < _e3377));
let _e3388 = select(0i, select(select(i32(_e3381), i32(-2147483648), (_e3381 < -2147483600f)), 2147483647i, (_e3381 > 2147483500f)), (_e3381 == _e3381));
let _e3392 = (_e3388 - select(0i, 1i, (_e3381 < f32(_e3388))));
let _e3396 = global_1.member.member_8.member_9;
let _e3400 = global_1.member.member_8.member_10;
let _e3401 = (_e3350 + 1i);
let _e3402 = (_e3371 + 1i);
let _e3403 = (_e3392 + 1i);
let _e3408 = global_1.member.member_8.member_13.member;
let _e3414 = global_1.member.member_8.member_13.member_1;
let _e3425 = ((_e3401 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3408) * ((_e3402 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3414) * (_e3403 >> bitcast<u32>(4i))))));
let _e3427 = (bitcast<i32>(_e176) - 1i);
let _e3429 = select(_e3427, _e3425, (_e3425 < _e3427));
let _e3435 = global_2.member[bitcast<u32>(select(0i, _e3429, (_e3429 > 0i)))];
let _e3437 = (_e3401 & 15i);
let _e3440 = ((_e3402 & 15i) * _e3396);
let _e3442 = (bitcast<i32>(_e3435) + ((_e3403 & 15i) * _e3400));
let _e3443 = (_e3440 + _e3396);
let _e3445 = (_e3440 + (2i * _e3396));
let _e3447 = (_e3440 + (3i * _e3396));
let _e3448 = (_e3442 + _e3400);
let _e3450 = (_e3442 + (2i * _e3400));
let _e3452 = (_e3442 + (3i * _e3400));
local_12 = type_30(array<i32, 4>(_e3437, _e3437, _e3437, _e3437), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_13 = (_e3329 - vec3<f32>(f32(_e3350), f32(_e3371), f32(_e3392)));
let _e3464 = local_12.member[0u];
let _e3465 = ((_e3448 + _e3443) + _e3464);
let _e3467 = (_e3465 >> bitcast<u32>(2i));
let _e3470 = bitcast<u32>(((_e3465 & 3i) * 8i));
let _e3472 = select(_e3427, _e3467, (_e3467 < _e3427));
let _e3477 = global_2.member[bitcast<u32>(select(0i, _e3472, (_e3472 > 0i)))];
let _e3481 = (_e3467 + 1i);
let _e3483 = select(_e3427, _e3481, (_e3481 < _e3427));
let _e3488 = global_2.member[bitcast<u32>(select(0i, _e3483, (_e3483 > 0i)))];
let _e3495 = ((_e3477 >> bitcast<u32>((_e3470 & 31u))) | ((_e3488 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3470) & 31u))));
let _e3498 = local_12.member_1[0u];
let _e3504 = f32(bitcast<i32>(((_e3495 >> bitcast<u32>((_e3498 & 31u))) & 255u)));
let _e3507 = local_12.member_1[1u];
let _e3513 = f32(bitcast<i32>(((_e3495 >> bitcast<u32>((_e3507 & 31u))) & 255u)));
let _e3516 = local_12.member_1[2u];
let _e3522 = f32(bitcast<i32>(((_e3495 >> bitcast<u32>((_e3516 & 31u))) & 255u)));
let _e3525 = local_12.member_1[3u];
let _e3532 = local_13[0u];
let _e3535 = (_e3504 + ((_e3513 - _e3504) * _e3532));
let _e3536 = local_13[0u];
let _e3539 = (_e3513 + ((_e3522 - _e3513) * _e3536));
let _e3540 = local_13[0u];
let _e3543 = (_e3522 + ((f32(bitcast<i32>(((_e3495 >> bitcast<u32>((_e3525 & 31u))) & 255u))) - _e3522) * _e3540));
let _e3545 = local_12.member[0u];
let _e3546 = ((_e3448 + _e3445) + _e3545);
let _e3548 = (_e3546 >> bitcast<u32>(2i));
let _e3551 = bitcast<u32>(((_e3546 & 3i) * 8i));
let _e3553 = select(_e3427, _e3548, (_e3548 < _e3427));
let _e3558 = global_2.member[bitcast<u32>(select(0i, _e3553, (_e3553 > 0i)))];
let _e3562 = (_e3548 + 1i);
let _e3564 = select(_e3427, _e3562, (_e3562 < _e3427));
let _e3569 = global_2.member[bitcast<u32>(select(0i, _e3564, (_e3564 > 0i)))];
let _e3576 = ((_e3558 >> bitcast<u32>((_e3551 & 31u))) | ((_e3569 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3551) & 31u))));
let _e3577 = local_12.member_1[0u];
let _e3583 = f32(bitcast<i32>(((_e3576 >> bitcast<u32>((_e3577 & 31u))) & 255u)));
let _e3584 = local_12.member_1[1u];
let _e3590 = f32(bitcast<i32>(((_e3576 >> bitcast<u32>((_e3584 & 31u))) & 255u)));
let _e3591 = local_12.member_1[2u];
let _e3597 = f32(bitcast<i32>(((_e3576 >> bitcast<u32>((_e3591 & 31u))) & 255u)));
let _e3598 = local_12.member_1[3u];
let _e3605 = local_13[0u];
let _e3609 = local_13[0u];
let _e3612 = (_e3590 + ((_e3597 - _e3590) * _e3609));
let _e3613 = local_13[0u];
let _e3618 = local_12.member[0u];
let _e3619 = ((_e3450 + _e3443) + _e3618);
let _e3621 = (_e3619 >> bitcast<u32>(2i));
let _e3624 = bitcast<u32>(((_e3619 & 3i) * 8i));
let _e3626 = select(_e3427, _e3621, (_e3621 < _e3427));
let _e3631 = global_2.member[bitcast<u32>(select(0i, _e3626, (_e3626 > 0i)))];
let _e3635 = (_e3621 + 1i);
let _e3637 = select(_e3427, _e3635, (_e3635 < _e3427));
let _e3642 = global_2.member[bitcast<u32>(select(0i, _e3637, (_e3637 > 0i)))];
let _e3649 = ((_e3631 >> bitcast<u32>((_e3624 & 31u))) | ((_e3642 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3624) & 31u))));
let _e3650 = local_12.member_1[0u];
let _e3656 = f32(bitcast<i32>(((_e3649 >> bitcast<u32>((_e3650 & 31u))) & 255u)));
let _e3657 = local_12.member_1[1u];
let _e3663 = f32(bitcast<i32>(((_e3649 >> bitcast<u32>((_e3657 & 31u))) & 255u)));
let _e3664 = local_12.member_1[2u];
let _e3670 = f32(bitcast<i32>(((_e3649 >> bitcast<u32>((_e3664 & 31u))) & 255u)));
let _e3671 = local_12.member_1[3u];
let _e3678 = local_13[0u];
let _e3681 = (_e3656 + ((_e3663 - _e3656) * _e3678));
let _e3682 = local_13[0u];
let _e3685 = (_e3663 + ((_e3670 - _e3663) * _e3682));
let _e3686 = local_13[0u];
let _e3689 = (_e3670 + ((f32(bitcast<i32>(((_e3649 >> bitcast<u32>((_e3671 & 31u))) & 255u))) - _e3670) * _e3686));
let _e3691 = local_12.member[0u];
let _e3692 = ((_e3450 + _e3445) + _e3691);
let _e3694 = (_e3692 >> bitcast<u32>(2i));
let _e3697 = bitcast<u32>(((_e3692 & 3i) * 8i));
let _e3699 = select(_e3427, _e3694, (_e3694 < _e3427));
let _e3704 = global_2.member[bitcast<u32>(select(0i, _e3699, (_e3699 > 0i)))];
let _e3708 = (_e3694 + 1i);
let _e3710 = select(_e3427, _e3708, (_e3708 < _e3427));
let _e3715 = global_2.member[bitcast<u32>(select(0i, _e3710, (_e3710 > 0i)))];
let _e3722 = ((_e3704 >> bitcast<u32>((_e3697 & 31u))) | ((_e3715 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3697) & 31u))));
let _e3723 = local_12.member_1[0u];
let _e3729 = f32(bitcast<i32>(((_e3722 >> bitcast<u32>((_e3723 & 31u))) & 255u)));
let _e3730 = local_12.member_1[1u];
let _e3736 = f32(bitcast<i32>(((_e3722 >> bitcast<u32>((_e3730 & 31u))) & 255u)));
let _e3737 = local_12.member_1[2u];
let _e3743 = f32(bitcast<i32>(((_e3722 >> bitcast<u32>((_e3737 & 31u))) & 255u)));
let _e3744 = local_12.member_1[3u];
let _e3751 = local_13[0u];
let _e3755 = local_13[0u];
let _e3758 = (_e3736 + ((_e3743 - _e3736) * _e3755));
let _e3759 = local_13[0u];
let _e3764 = local_12.member[0u];
let _e3765 = ((_e3448 + _e3440) + _e3764);
let _e3767 = (_e3765 >> bitcast<u32>(2i));
let _e3770 = bitcast<u32>(((_e3765 & 3i) * 8i));
let _e3772 = select(_e3427, _e3767, (_e3767 < _e3427));
let _e3777 = global_2.member[bitcast<u32>(select(0i, _e3772, (_e3772 > 0i)))];
let _e3781 = (_e3767 + 1i);
let _e3783 = select(_e3427, _e3781, (_e3781 < _e3427));
let _e3788 = global_2.member[bitcast<u32>(select(0i, _e3783, (_e3783 > 0i)))];
let _e3795 = ((_e3777 >> bitcast<u32>((_e3770 & 31u))) | ((_e3788 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3770) & 31u))));
let _e3796 = local_12.member_1[1u];
let _e3802 = f32(bitcast<i32>(((_e3795 >> bitcast<u32>((_e3796 & 31u))) & 255u)));
let _e3803 = local_12.member_1[2u];
let _e3810 = local_13[0u];
let _e3813 = (_e3802 + ((f32(bitcast<i32>(((_e3795 >> bitcast<u32>((_e3803 & 31u))) & 255u))) - _e3802) * _e3810));
let _e3815 = local_12.member[0u];
let _e3816 = ((_e3448 + _e3447) + _e3815);
let _e3818 = (_e3816 >> bitcast<u32>(2i));
let _e3821 = bitcast<u32>(((_e3816 & 3i) * 8i));
let _e3823 = select(_e3427, _e3818, (_e3818 < _e3427));
let _e3828 = global_2.member[bitcast<u32>(select(0i, _e3823, (_e3823 > 0i)))];
let _e3832 = (_e3818 + 1i);
let _e3834 = select(_e3427, _e3832, (_e3832 < _e3427));
let _e3839 = global_2.member[bitcast<u32>(select(0i, _e3834, (_e3834 > 0i)))];
let _e3846 = ((_e3828 >> bitcast<u32>((_e3821 & 31u))) | ((_e3839 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3821) & 31u))));
let _e3847 = local_12.member_1[1u];
let _e3853 = f32(bitcast<i32>(((_e3846 >> bitcast<u32>((_e3847 & 31u))) & 255u)));
let _e3854 = local_12.member_1[2u];
let _e3861 = local_13[0u];
let _e3866 = local_12.member[0u];
let _e3867 = ((_e3450 + _e3440) + _e3866);
let _e3869 = (_e3867 >> bitcast<u32>(2i));
let _e3872 = bitcast<u32>(((_e3867 & 3i) * 8i));
let _e3874 = select(_e3427, _e3869, (_e3869 < _e3427));
let _e3879 = global_2.member[bitcast<u32>(select(0i, _e3874, (_e3874 > 0i)))];
let _e3883 = (_e3869 + 1i);
let _e3885 = select(_e3427, _e3883, (_e3883 < _e3427));
let _e3890 = global_2.member[bitcast<u32>(select(0i, _e3885, (_e3885 > 0i)))];
let _e3897 = ((_e3879 >> bitcast<u32>((_e3872 & 31u))) | ((_e3890 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3872) & 31u))));
let _e3898 = local_12.member_1[1u];
let _e3904 = f32(bitcast<i32>(((_e3897 >> bitcast<u32>((_e3898 & 31u))) & 255u)));
let _e3905 = local_12.member_1[2u];
let _e3912 = local_13[0u];
let _e3915 = (_e3904 + ((f32(bitcast<i32>(((_e3897 >> bitcast<u32>((_e3905 & 31u))) & 255u))) - _e3904) * _e3912));
let _e3917 = local_12.member[0u];
let _e3918 = ((_e3450 + _e3447) + _e3917);
let _e3920 = (_e3918 >> bitcast<u32>(2i));
let _e3923 = bitcast<u32>(((_e3918 & 3i) * 8i));
let _e3925 = select(_e3427, _e3920, (_e3920 < _e3427));
let _e3930 = global_2.member[bitcast<u32>(select(0i, _e3925, (_e3925 > 0i)))];
let _e3934 = (_e3920 + 1i);
let _e3936 = select(_e3427, _e3934, (_e3934 < _e3427));
let _e3941 = global_2.member[bitcast<u32>(select(0i, _e3936, (_e3936 > 0i)))];
let _e3948 = ((_e3930 >> bitcast<u32>((_e3923 & 31u))) | ((_e3941 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3923) & 31u))));
let _e3949 = local_12.member_1[1u];
let _e3955 = f32(bitcast<i32>(((_e3948 >> bitcast<u32>((_e3949 & 31u))) & 255u)));
let _e3956 = local_12.member_1[2u];
let _e3963 = local_13[0u];
let _e3968 = local_12.member[0u];
let _e3969 = ((_e3442 + _e3443) + _e3968);
let _e3971 = (_e3969 >> bitcast<u32>(2i));
let _e3974 = bitcast<u32>(((_e3969 & 3i) * 8i));
let _e3976 = select(_e3427, _e3971, (_e3971 < _e3427));
let _e3981 = global_2.member[bitcast<u32>(select(0i, _e3976, (_e3976 > 0i)))];
let _e3985 = (_e3971 + 1i);
let _e3987 = select(_e3427, _e3985, (_e3985 < _e3427));
let _e3992 = global_2.member[bitcast<u32>(select(0i, _e3987, (_e3987 > 0i)))];
let _e3999 = ((_e3981 >> bitcast<u32>((_e3974 & 31u))) | ((_e3992 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3974) & 31u))));
let _e4000 = local_12.member_1[1u];
let _e4006 = f32(bitcast<i32>(((_e3999 >> bitcast<u32>((_e4000 & 31u))) & 255u)));
let _e4007 = local_12.member_1[2u];
let _e4014 = local_13[0u];
let _e4017 = (_e4006 + ((f32(bitcast<i32>(((_e3999 >> bitcast<u32>((_e4007 & 31u))) & 255u))) - _e4006) * _e4014));
let _e4019 = local_12.member[0u];
let _e4020 = ((_e3452 + _e3443) + _e4019);
let _e4022 = (_e4020 >> bitcast<u32>(2i));
let _e4025 = bitcast<u32>(((_e4020 & 3i) * 8i));
let _e4027 = select(_e3427, _e4022, (_e4022 < _e3427));
let _e4032 = global_2.member[bitcast<u32>(select(0i, _e4027, (_e4027 > 0i)))];
let _e4036 = (_e4022 + 1i);
let _e4038 = select(_e3427, _e4036, (_e4036 < _e3427));
let _e4043 = global_2.member[bitcast<u32>(select(0i, _e4038, (_e4038 > 0i)))];
let _e4050 = ((_e4032 >> bitcast<u32>((_e4025 & 31u))) | ((_e4043 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4025) & 31u))));
let _e4051 = local_12.member_1[1u];
let _e4057 = f32(bitcast<i32>(((_e4050 >> bitcast<u32>((_e4051 & 31u))) & 255u)));
let _e4058 = local_12.member_1[2u];
let _e4065 = local_13[0u];
let _e4068 = (_e4057 + ((f32(bitcast<i32>(((_e4050 >> bitcast<u32>((_e4058 & 31u))) & 255u))) - _e4057) * _e4065));
let _e4070 = local_12.member[0u];
let _e4071 = ((_e3442 + _e3445) + _e4070);
let _e4073 = (_e4071 >> bitcast<u32>(2i));
let _e4076 = bitcast<u32>(((_e4071 & 3i) * 8i));
let _e4078 = select(_e3427, _e4073, (_e4073 < _e3427));
let _e4083 = global_2.member[bitcast<u32>(select(0i, _e4078, (_e4078 > 0i)))];
let _e4087 = (_e4073 + 1i);
let _e4089 = select(_e3427, _e4087, (_e4087 < _e3427));
let _e4094 = global_2.member[bitcast<u32>(select(0i, _e4089, (_e4089 > 0i)))];
let _e4101 = ((_e4083 >> bitcast<u32>((_e4076 & 31u))) | ((_e4094 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4076) & 31u))));
let _e4102 = local_12.member_1[1u];
let _e4108 = f32(bitcast<i32>(((_e4101 >> bitcast<u32>((_e4102 & 31u))) & 255u)));
let _e4109 = local_12.member_1[2u];
let _e4116 = local_13[0u];
let _e4121 = local_12.member[0u];
let _e4122 = ((_e3452 + _e3445) + _e4121);
let _e4124 = (_e4122 >> bitcast<u32>(2i));
let _e4127 = bitcast<u32>(((_e4122 & 3i) * 8i));
let _e4129 = select(_e3427, _e4124, (_e4124 < _e3427));
let _e4134 = global_2.member[bitcast<u32>(select(0i, _e4129, (_e4129 > 0i)))];
let _e4138 = (_e4124 + 1i);
let _e4140 = select(_e3427, _e4138, (_e4138 < _e3427));
let _e4145 = global_2.member[bitcast<u32>(select(0i, _e4140, (_e4140 > 0i)))];
let _e4152 = ((_e4134 >> bitcast<u32>((_e4127 & 31u))) | ((_e4145 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4127) & 31u))));
let _e4153 = local_12.member_1[1u];
let _e4159 = f32(bitcast<i32>(((_e4152 >> bitcast<u32>((_e4153 & 31u))) & 255u)));
let _e4160 = local_12.member_1[2u];
let _e4167 = local_13[0u];
let _e4172 = local_13[1u];
let _e4175 = (_e3539 + ((_e3612 - _e3539) * _e4172));
let _e4176 = local_13[1u];
let _e4179 = (_e3685 + ((_e3758 - _e3685) * _e4176));
let _e4180 = local_13[1u];
let _e4183 = (_e3535 + (((_e3583 + ((_e3590 - _e3583) * _e3605)) - _e3535) * _e4180));
let _e4184 = local_13[1u];
let _e4189 = local_13[2u];
let _e4193 = local_13[1u];
let _e4196 = (_e3543 + (((_e3597 + ((f32(bitcast<i32>(((_e3576 >> bitcast<u32>((_e3598 & 31u))) & 255u))) - _e3597) * _e3613)) - _e3543) * _e4193));
let _e4197 = local_13[1u];
let _e4201 = local_13[2u];
let _e4205 = local_13[1u];
let _e4208 = (_e3813 + ((_e3539 - _e3813) * _e4205));
let _e4209 = local_13[1u];
let _e4213 = local_13[2u];
let _e4217 = local_13[1u];
let _e4220 = (_e3612 + (((_e3853 + ((f32(bitcast<i32>(((_e3846 >> bitcast<u32>((_e3854 & 31u))) & 255u))) - _e3853) * _e3861)) - _e3612) * _e4217));
let _e4221 = local_13[1u];
let _e4225 = local_13[2u];
let _e4229 = local_13[1u];
let _e4232 = (_e4017 + (((_e4108 + ((f32(bitcast<i32>(((_e4101 >> bitcast<u32>((_e4109 & 31u))) & 255u))) - _e4108) * _e4116)) - _e4017) * _e4229));
let _e4233 = local_13[2u];
let _e4237 = local_13[1u];
let _e4241 = local_13[2u];
let _e4245 = local_13[2u];
let _e4252 = global_1.member.member_8.member_8;
let _e4256 = global_1.member.member_8.member_7;
let _e4258 = (((_e4175 + ((_e4179 - _e4175) * _e4245)) - _e4252) * _e4256);
let _e4259 = -(1e9f);
let _e4261 = select(_e4259, _e4258, (_e4258 > _e4259));
let _e4265 = (((_e4183 + (((_e3681 + (((_e3729 + ((_e3736 - _e3729) * _e3751)) - _e3681) * _e4184)) - _e4183) * _e4189)) - _e4252) * _e4256);
let _e4267 = select(_e4259, _e4265, (_e4265 > _e4259));
let _e4271 = (((_e4196 + (((_e3689 + (((_e3743 + ((f32(bitcast<i32>(((_e3722 >> bitcast<u32>((_e3744 & 31u))) & 255u))) - _e3743) * _e3759)) - _e3689) * _e4197)) - _e4196) * _e4201)) - _e4252) * _e4256);
let _e4273 = select(_e4259, _e4271, (_e4271 > _e4259));
let _e4277 = (((_e4208 + (((_e3915 + ((_e3685 - _e3915) * _e4209)) - _e4208) * _e4213)) - _e4252) * _e4256);
let _e4279 = select(_e4259, _e4277, (_e4277 > _e4259));
let _e4283 = (((_e4220 + (((_e3758 + (((_e3955 + ((f32(bitcast<i32>(((_e3948 >> bitcast<u32>((_e3956 & 31u))) & 255u))) - _e3955) * _e3963)) - _e3758) * _e4221)) - _e4220) * _e4225)) - _e4252) * _e4256);
let _e4285 = select(_e4259, _e4283, (_e4283 > _e4259));
let _e4289 = (((_e4232 + ((_e4175 - _e4232) * _e4233)) - _e4252) * _e4256);
let _e4291 = select(_e4259, _e4289, (_e4289 > _e4259));
let _e4295 = (((_e4179 + (((_e4068 + (((_e4159 + ((f32(bitcast<i32>(((_e4152 >> bitcast<u32>((_e4160 & 31u))) & 255u))) - _e4159) * _e4167)) - _e4068) * _e4237)) - _e4179) * _e4241)) - _e4252) * _e4256);
let _e4297 = select(_e4259, _e4295, (_e4295 > _e4259));
let _e4301 = (0.5f * (select(1e9f, _e4273, (_e4273 < 1e9f)) - select(1e9f, _e4267, (_e4267 < 1e9f))));
let _e4303 = (0.5f * (select(1e9f, _e4285, (_e4285 < 1e9f)) - select(1e9f, _e4279, (_e4279 < 1e9f))));
let _e4305 = (0.5f * (select(1e9f, _e4297, (_e4297 < 1e9f)) - select(1e9f, _e4291, (_e4291 < 1e9f))));
let _e4311 = global_1.member.member_8.member.member.member;
let _e4317 = global_1.member.member_8.member.member.member_1;
let _e4323 = global_1.member.member_8.member.member.member_2;
let _e4329 = global_1.member.member_8.member_1.member.member;
let _e4335 = global_1.member.member_8.member_1.member.member_1;
let _e4341 = global_1.member.member_8.member_1.member.member_2;
let _e4347 = global_1.member.member_8.member_2.member.member;
let _e4353 = global_1.member.member_8.member_2.member.member_1;
let _e4359 = global_1.member.member_8.member_2.member.member_2;
phi_9692_ = select(1e9f, _e4261, (_e4261 < 1e9f));
phi_9693_ = vec3<f32>((((_e4311 * _e4301) + (_e4329 * _e4303)) + (_e4347 * _e4305)), (((_e4317 * _e4301) + (_e4335 * _e4303)) + (_e4353 * _e4305)), (((_e4323 * _e4301) + (_e4341 * _e4303)) + (_e4359 * _e4305)));
} else {
let _e4380 = global_1.member.member_8.member_4.member;
let _e4385 = global_1.member.member_8.member_5.member;
let _e4387 = select(_e4380, _e1262, (_e1262 > _e4380));
let _e4389 = select(_e4385, _e4387, (_e4387 < _e4385));
let _e4394 = global_1.member.member_8.member_4.member_1;
let _e4399 = global_1.member.member_8.member_5.member_1;
let _e4401 = select(_e4394, _e1268, (_e1268 > _e4394));
let _e4403 = select(_e4399, _e4401, (_e4401 < _e4399));
let _e4408 = global_1.member.member_8.member_4.member_2;
let _e4413 = global_1.member.member_8.member_5.member_2;
let _e4415 = select(_e4408, _e1274, (_e1274 > _e4408));
let _e4417 = select(_e4413, _e4415, (_e4415 < _e4413));
let _e4422 = global_1.member.member_8.member_15;
if (_e4422 == 0u) {
phi_9223_ = vec3<f32>(_e4389, _e4403, _e4417);
} else {
let _e4424 = (_e4389 + 0.5f);
let _e4429 = global_1.member.member_8.member_3.member;
let _e4430 = (_e4429 - 1f);
let _e4432 = select(0f, _e4424, (_e4424 > 0f));
let _e4434 = select(_e4430, _e4432, (_e4432 < _e4430));
let _e4441 = select(0i, select(select(i32(_e4434), i32(-2147483648), (_e4434 < -2147483600f)), 2147483647i, (_e4434 > 2147483500f)), (_e4434 == _e4434));
let _e4447 = (_e4403 + 0.5f);
let _e4452 = global_1.member.member_8.member_3.member_1;
let _e4453 = (_e4452 - 1f);
let _e4455 = select(0f, _e4447, (_e4447 > 0f));
let _e4457 = select(_e4453, _e4455, (_e4455 < _e4453));
let _e4464 = select(0i, select(select(i32(_e4457), i32(-2147483648), (_e4457 < -2147483600f)), 2147483647i, (_e4457 > 2147483500f)), (_e4457 == _e4457));
let _e4470 = (_e4417 + 0.5f);
let _e4475 = global_1.member.member_8.member_3.member_2;
let _e4476 = (_e4475 - 1f);
let _e4478 = select(0f, _e4470, (_e4470 > 0f));
let _e4480 = select(_e4476, _e4478, (_e4478 < _e4476));
let _e4487 = select(0i, select(select(i32(_e4480), i32(-2147483648), (_e4480 < -2147483600f)), 2147483647i, (_e4480 > 2147483500f)), (_e4480 == _e4480));
phi_9223_ = vec3<f32>(f32((_e4441 - select(0i, 1i, (_e4434 < f32(_e4441))))), f32((_e4464 - select(0i, 1i, (_e4457 < f32(_e4464))))), f32((_e4487 - select(0i, 1i, (_e4480 < f32(_e4487))))));
}
let _e4495 = phi_9223_;
let _e4501 = global_1.member.member_8.member_3.member;
let _e4503 = select(-1f, _e4495.x, (_e4495.x > -1f));
let _e4505 = select(_e4501, _e4503, (_e4503 < _e4501));
let _e4512 = select(0i, select(select(i32(_e4505), i32(-2147483648), (_e4505 < -2147483600f)), 2147483647i, (_e4505 > 2147483500f)), (_e4505 == _e4505));
let _e4516 = (_e4512 - select(0i, 1i, (_e4505 < f32(_e4512))));
let _e4522 = global_1.member.member_8.member_3.member_1;
let _e4524 = select(-1f, _e4495.y, (_e4495.y > -1f));
let _e4526 = select(_e4522, _e4524, (_e4524 < _e4522));
let _e4533 = select(0i, select(select(i32(_e4526), i32(-2147483648), (_e4526 < -2147483600f)), 2147483647i, (_e4526 > 2147483500f)), (_e4526 == _e4526));
let _e4537 = (_e4533 - select(0i, 1i, (_e4526 < f32(_e4533))));
let _e4543 = global_1.member.member_8.member_3.member_2;
let _e4545 = select(-1f, _e4495.z, (_e4495.z > -1f));
let _e4547 = select(_e4543, _e4545, (_e4545 < _e4543));
let _e4554 = select(0i, select(select(i32(_e4547), i32(-2147483648), (_e4547 < -2147483600f)), 2147483647i, (_e4547 > 2147483500f)), (_e4547 == _e4547));
let _e4558 = (_e4554 - select(0i, 1i, (_e4547 < f32(_e4554))));
let _e4562 = global_1.member.member_8.member_9;
let _e4566 = global_1.member.member_8.member_10;
let _e4567 = (_e4516 + 1i);
let _e4568 = (_e4537 + 1i);
let _e4569 = (_e4558 + 1i);
let _e4574 = global_1.member.member_8.member_13.member;
let _e4580 = global_1.member.member_8.member_13.member_1;
let _e4591 = ((_e4567 >> bitcast<u32>(4i)) + (bitcast<i32>(_e4574) * ((_e4568 >> bitcast<u32>(4i)) + (bitcast<i32>(_e4580) * (_e4569 >> bitcast<u32>(4i))))));
let _e4593 = (bitcast<i32>(_e176) - 1i);
let _e4595 = select(_e4593, _e4591, (_e4591 < _e4593));
let _e4601 = global_2.member[bitcast<u32>(select(0i, _e4595, (_e4595 > 0i)))];
let _e4603 = (_e4567 & 15i);
let _e4606 = ((_e4568 & 15i) * _e4562);
let _e4608 = (bitcast<i32>(_e4601) + ((_e4569 & 15i) * _e4566));
let _e4609 = (_e4606 + _e4562);
let _e4611 = (_e4606 + (2i * _e4562));
let _e4612 = (_e4608 + _e4566);
let _e4614 = (_e4608 + (2i * _e4566));
local_10 = type_30(array<i32, 4>(_e4603, _e4603, _e4603, _e4603), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_11 = (_e4495 - vec3<f32>(f32(_e4516), f32(_e4537), f32(_e4558)));
let _e4626 = local_10.member[0u];
let _e4627 = ((_e4612 + _e4609) + _e4626);
let _e4629 = (_e4627 >> bitcast<u32>(2i));
let _e4632 = bitcast<u32>(((_e4627 & 3i) * 8i));
let _e4634 = select(_e4593, _e4629, (_e4629 < _e4593));
let _e4639 = global_2.member[bitcast<u32>(select(0i, _e4634, (_e4634 > 0i)))];
let _e4643 = (_e4629 + 1i);
let _e4645 = select(_e4593, _e4643, (_e4643 < _e4593));
let _e4650 = global_2.member[bitcast<u32>(select(0i, _e4645, (_e4645 > 0i)))];
let _e4657 = ((_e4639 >> bitcast<u32>((_e4632 & 31u))) | ((_e4650 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4632) & 31u))));
let _e4660 = local_10.member_1[1u];
let _e4666 = f32(bitcast<i32>(((_e4657 >> bitcast<u32>((_e4660 & 31u))) & 255u)));
let _e4669 = local_10.member_1[2u];
let _e4676 = local_11[0u];
let _e4679 = (_e4666 + ((f32(bitcast<i32>(((_e4657 >> bitcast<u32>((_e4669 & 31u))) & 255u))) - _e4666) * _e4676));
let _e4681 = local_10.member[0u];
let _e4682 = ((_e4612 + _e4611) + _e4681);
let _e4684 = (_e4682 >> bitcast<u32>(2i));
let _e4687 = bitcast<u32>(((_e4682 & 3i) * 8i));
let _e4689 = select(_e4593, _e4684, (_e4684 < _e4593));
let _e4694 = global_2.member[bitcast<u32>(select(0i, _e4689, (_e4689 > 0i)))];
let _e4698 = (_e4684 + 1i);
let _e4700 = select(_e4593, _e4698, (_e4698 < _e4593));
let _e4705 = global_2.member[bitcast<u32>(select(0i, _e4700, (_e4700 > 0i)))];
let _e4712 = ((_e4694 >> bitcast<u32>((_e4687 & 31u))) | ((_e4705 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4687) & 31u))));
let _e4713 = local_10.member_1[1u];
let _e4719 = f32(bitcast<i32>(((_e4712 >> bitcast<u32>((_e4713 & 31u))) & 255u)));
let _e4720 = local_10.member_1[2u];
let _e4727 = local_11[0u];
let _e4732 = local_11[1u];
let _e4735 = (_e4679 + (((_e4719 + ((f32(bitcast<i32>(((_e4712 >> bitcast<u32>((_e4720 & 31u))) & 255u))) - _e4719) * _e4727)) - _e4679) * _e4732));
let _e4737 = local_10.member[0u];
let _e4738 = ((_e4614 + _e4609) + _e4737);
let _e4740 = (_e4738 >> bitcast<u32>(2i));
let _e4743 = bitcast<u32>(((_e4738 & 3i) * 8i));
let _e4745 = select(_e4593, _e4740, (_e4740 < _e4593));
let _e4750 = global_2.member[bitcast<u32>(select(0i, _e4745, (_e4745 > 0i)))];
let _e4754 = (_e4740 + 1i);
let _e4756 = select(_e4593, _e4754, (_e4754 < _e4593));
let _e4761 = global_2.member[bitcast<u32>(select(0i, _e4756, (_e4756 > 0i)))];
let _e4768 = ((_e4750 >> bitcast<u32>((_e4743 & 31u))) | ((_e4761 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4743) & 31u))));
let _e4769 = local_10.member_1[1u];
let _e4775 = f32(bitcast<i32>(((_e4768 >> bitcast<u32>((_e4769 & 31u))) & 255u)));
let _e4776 = local_10.member_1[2u];
let _e4783 = local_11[0u];
let _e4786 = (_e4775 + ((f32(bitcast<i32>(((_e4768 >> bitcast<u32>((_e4776 & 31u))) & 255u))) - _e4775) * _e4783));
let _e4788 = local_10.member[0u];
let _e4789 = ((_e4614 + _e4611) + _e4788);
let _e4791 = (_e4789 >> bitcast<u32>(2i));
let _e4794 = bitcast<u32>(((_e4789 & 3i) * 8i));
let _e4796 = select(_e4593, _e4791, (_e4791 < _e4593));
let _e4801 = global_2.member[bitcast<u32>(select(0i, _e4796, (_e4796 > 0i)))];
let _e4805 = (_e4791 + 1i);
let _e4807 = select(_e4593, _e4805, (_e4805 < _e4593));
let _e4812 = global_2.member[bitcast<u32>(select(0i, _e4807, (_e4807 > 0i)))];
let _e4819 = ((_e4801 >> bitcast<u32>((_e4794 & 31u))) | ((_e4812 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4794) & 31u))));
let _e4820 = local_10.member_1[1u];
let _e4826 = f32(bitcast<i32>(((_e4819 >> bitcast<u32>((_e4820 & 31u))) & 255u)));
let _e4827 = local_10.member_1[2u];
let _e4834 = local_11[0u];
let _e4838 = local_11[1u];
let _e4843 = local_11[2u];
let _e4850 = global_1.member.member_8.member_8;
let _e4854 = global_1.member.member_8.member_7;
let _e4856 = (((_e4735 + (((_e4786 + (((_e4826 + ((f32(bitcast<i32>(((_e4819 >> bitcast<u32>((_e4827 & 31u))) & 255u))) - _e4826) * _e4834)) - _e4786) * _e4838)) - _e4735) * _e4843)) - _e4850) * _e4854);
let _e4857 = -(1e9f);
let _e4859 = select(_e4857, _e4856, (_e4856 > _e4857));
phi_9692_ = select(1e9f, _e4859, (_e4859 < 1e9f));
phi_9693_ = vec3<f32>(0f, 0f, 0f);
}
let _e4863 = phi_9692_;
let _e4865 = phi_9693_;
phi_9695_ = type_35(_e4863, vec3<f32>(0f, 0f, 0f), _e4865, 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e4868 = phi_9695_;
let _e4873 = global_1.member.member_8.member_4.member;
let _e4878 = global_1.member.member_8.member_5.member;
let _e4880 = select(_e4873, _e1226, (_e1226 > _e4873));
let _e4882 = select(_e4878, _e4880, (_e4880 < _e4878));
let _e4887 = global_1.member.member_8.member_4.member_1;
let _e4892 = global_1.member.member_8.member_5.member_1;
let _e4894 = select(_e4887, _e1241, (_e1241 > _e4887));
let _e4896 = select(_e4892, _e4894, (_e4894 < _e4892));
let _e4901 = global_1.member.member_8.member_4.member_2;
let _e4906 = global_1.member.member_8.member_5.member_2;
let _e4908 = select(_e4901, _e1256, (_e1256 > _e4901));
let _e4910 = select(_e4906, _e4908, (_e4908 < _e4906));
let _e4915 = global_1.member.member_8.member_15;
let _e4916 = (_e4915 == 0u);
if _e4916 {
phi_9841_ = vec3<f32>(_e4882, _e4896, _e4910);
} else {
let _e4917 = (_e4882 + 0.5f);
let _e4922 = global_1.member.member_8.member_3.member;
let _e4923 = (_e4922 - 1f);
let _e4925 = select(0f, _e4917, (_e4917 > 0f));
let _e4927 = select(_e4923, _e4925, (_e4925 < _e4923));
let _e4934 = select(0i, select(select(i32(_e4927), i32(-2147483648), (_e4927 < -2147483600f)), 2147483647i, (_e4927 > 2147483500f)), (_e4927 == _e4927));
let _e4940 = (_e4896 + 0.5f);
let _e4945 = global_1.member.member_8.member_3.member_1;
let _e4946 = (_e4945 - 1f);
let _e4948 = select(0f, _e4940, (_e4940 > 0f));
let _e4950 = select(_e4946, _e4948, (_e4948 < _e4946));
let _e4957 = select(0i, select(select(i32(_e4950), i32(-2147483648), (_e4950 < -2147483600f)), 2147483647i, (_e4950 > 2147483500f)), (_e4950 == _e4950));
let _e4963 = (_e4910 + 0.5f);
let _e4968 = global_1.member.member_8.member_3.member_2;
let _e4969 = (_e4968 - 1f);
let _e4971 = select(0f, _e4963, (_e4963 > 0f));
let _e4973 = select(_e4969, _e4971, (_e4971 < _e4969));
let _e4980 = select(0i, select(select(i32(_e4973), i32(-2147483648), (_e4973 < -2147483600f)), 2147483647i, (_e4973 > 2147483500f)), (_e4973 == _e4973));
phi_9841_ = vec3<f32>(f32((_e4934 - select(0i, 1i, (_e4927 < f32(_e4934))))), f32((_e4957 - select(0i, 1i, (_e4950 < f32(_e4957))))), f32((_e4980 - select(0i, 1i, (_e4973 < f32(_e4980))))));
}
let _e4988 = phi_9841_;
let _e4994 = global_1.member.member_8.member_3.member;
let _e4996 = select(-1f, _e4988.x, (_e4988.x > -1f));
let _e4998 = select(_e4994, _e4996, (_e4996 < _e4994));
let _e5005 = select(0i, select(select(i32(_e4998), i32(-2147483648), (_e4998 < -2147483600f)), 2147483647i, (_e4998 > 2147483500f)), (_e4998 == _e4998));
let _e5009 = (_e5005 - select(0i, 1i, (_e4998 < f32(_e5005))));
let _e5015 = global_1.member.member_8.member_3.member_1;
let _e5017 = select(-1f, _e4988.y, (_e4988.y > -1f));
let _e5019 = select(_e5015, _e5017, (_e5017 < _e5015));
let _e5026 = select(0i, select(select(i32(_e5019), i32(-2147483648), (_e5019 < -2147483600f)), 2147483647i, (_e5019 > 2147483500f)), (_e5019 == _e5019));
let _e5030 = (_e5026 - select(0i, 1i, (_e5019 < f32(_e5026))));
let _e5036 = global_1.member.member_8.member_3.member_2;
let _e5038 = select(-1f, _e4988.z, (_e4988.z > -1f));
let _e5040 = select(_e5036, _e5038, (_e5038 < _e5036));
let _e5047 = select(0i, select(select(i32(_e5040), i32(-2147483648), (_e5040 < -2147483600f)), 2147483647i, (_e5040 > 2147483500f)), (_e5040 == _e5040));
let _e5051 = (_e5047 - select(0i, 1i, (_e5040 < f32(_e5047))));
let _e5055 = global_1.member.member_8.member_9;
let _e5059 = global_1.member.member_8.member_10;
let _e5060 = (_e5009 + 1i);
let _e5061 = (_e5030 + 1i);
let _e5062 = (_e5051 + 1i);
let _e5067 = global_1.member.member_8.member_13.member;
let _e5068 = bitcast<i32>(_e5067);
let _e5073 = global_1.member.member_8.member_13.member_1;
let _e5074 = bitcast<i32>(_e5073);
let _e5084 = ((_e5060 >> bitcast<u32>(4i)) + (_e5068 * ((_e5061 >> bitcast<u32>(4i)) + (_e5074 * (_e5062 >> bitcast<u32>(4i))))));
let _e5086 = (bitcast<i32>(_e176) - 1i);
let _e5088 = select(_e5086, _e5084, (_e5084 < _e5086));
let _e5094 = global_2.member[bitcast<u32>(select(0i, _e5088, (_e5088 > 0i)))];
let _e5096 = (_e5060 & 15i);
let _e5099 = ((_e5061 & 15i) * _e5055);
let _e5101 = (bitcast<i32>(_e5094) + ((_e5062 & 15i) * _e5059));
let _e5102 = (_e5099 + _e5055);
let _e5103 = (2i * _e5055);
let _e5104 = (_e5099 + _e5103);
let _e5105 = (_e5101 + _e5059);
let _e5106 = (2i * _e5059);
let _e5107 = (_e5101 + _e5106);
local_8 = type_30(array<i32, 4>(_e5096, _e5096, _e5096, _e5096), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_9 = (_e4988 - vec3<f32>(f32(_e5009), f32(_e5030), f32(_e5051)));
let _e5119 = local_8.member[0u];
let _e5120 = ((_e5105 + _e5102) + _e5119);
let _e5122 = (_e5120 >> bitcast<u32>(2i));
let _e5125 = bitcast<u32>(((_e5120 & 3i) * 8i));
let _e5127 = select(_e5086, _e5122, (_e5122 < _e5086));
let _e5132 = global_2.member[bitcast<u32>(select(0i, _e5127, (_e5127 > 0i)))];
let _e5136 = (_e5122 + 1i);
let _e5138 = select(_e5086, _e5136, (_e5136 < _e5086));
let _e5143 = global_2.member[bitcast<u32>(select(0i, _e5138, (_e5138 > 0i)))];
let _e5150 = ((_e5132 >> bitcast<u32>((_e5125 & 31u))) | ((_e5143 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5125) & 31u))));
let _e5153 = local_8.member_1[1u];
let _e5159 = f32(bitcast<i32>(((_e5150 >> bitcast<u32>((_e5153 & 31u))) & 255u)));
let _e5162 = local_8.member_1[2u];
let _e5169 = local_9[0u];
let _e5172 = (_e5159 + ((f32(bitcast<i32>(((_e5150 >> bitcast<u32>((_e5162 & 31u))) & 255u))) - _e5159) * _e5169));
let _e5174 = local_8.member[0u];
let _e5175 = ((_e5105 + _e5104) + _e5174);
let _e5177 = (_e5175 >> bitcast<u32>(2i));
let _e5180 = bitcast<u32>(((_e5175 & 3i) * 8i));
let _e5182 = select(_e5086, _e5177, (_e5177 < _e5086));
let _e5187 = global_2.member[bitcast<u32>(select(0i, _e5182, (_e5182 > 0i)))];
let _e5191 = (_e5177 + 1i);
let _e5193 = select(_e5086, _e5191, (_e5191 < _e5086));
let _e5198 = global_2.member[bitcast<u32>(select(0i, _e5193, (_e5193 > 0i)))];
let _e5205 = ((_e5187 >> bitcast<u32>((_e5180 & 31u))) | ((_e5198 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5180) & 31u))));
let _e5206 = local_8.member_1[1u];
let _e5212 = f32(bitcast<i32>(((_e5205 >> bitcast<u32>((_e5206 & 31u))) & 255u)));
let _e5213 = local_8.member_1[2u];
let _e5220 = local_9[0u];
let _e5225 = local_9[1u];
let _e5228 = (_e5172 + (((_e5212 + ((f32(bitcast<i32>(((_e5205 >> bitcast<u32>((_e5213 & 31u))) & 255u))) - _e5212) * _e5220)) - _e5172) * _e5225));
let _e5230 = local_8.member[0u];
let _e5231 = ((_e5107 + _e5102) + _e5230);
let _e5233 = (_e5231 >> bitcast<u32>(2i));
let _e5236 = bitcast<u32>(((_e5231 & 3i) * 8i));
let _e5238 = select(_e5086, _e5233, (_e5233 < _e5086));
let _e5243 = global_2.member[bitcast<u32>(select(0i, _e5238, (_e5238 > 0i)))];
let _e5247 = (_e5233 + 1i);
let _e5249 = select(_e5086, _e5247, (_e5247 < _e5086));
let _e5254 = global_2.member[bitcast<u32>(select(0i, _e5249, (_e5249 > 0i)))];
let _e5261 = ((_e5243 >> bitcast<u32>((_e5236 & 31u))) | ((_e5254 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5236) & 31u))));
let _e5262 = local_8.member_1[1u];
let _e5268 = f32(bitcast<i32>(((_e5261 >> bitcast<u32>((_e5262 & 31u))) & 255u)));
let _e5269 = local_8.member_1[2u];
let _e5276 = local_9[0u];
let _e5279 = (_e5268 + ((f32(bitcast<i32>(((_e5261 >> bitcast<u32>((_e5269 & 31u))) & 255u))) - _e5268) * _e5276));
let _e5281 = local_8.member[0u];
let _e5282 = ((_e5107 + _e5104) + _e5281);
let _e5284 = (_e5282 >> bitcast<u32>(2i));
let _e5287 = bitcast<u32>(((_e5282 & 3i) * 8i));
let _e5289 = select(_e5086, _e5284, (_e5284 < _e5086));
let _e5294 = global_2.member[bitcast<u32>(select(0i, _e5289, (_e5289 > 0i)))];
let _e5298 = (_e5284 + 1i);
let _e5300 = select(_e5086, _e5298, (_e5298 < _e5086));
let _e5305 = global_2.member[bitcast<u32>(select(0i, _e5300, (_e5300 > 0i)))];
let _e5312 = ((_e5294 >> bitcast<u32>((_e5287 & 31u))) | ((_e5305 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5287) & 31u))));
let _e5313 = local_8.member_1[1u];
let _e5319 = f32(bitcast<i32>(((_e5312 >> bitcast<u32>((_e5313 & 31u))) & 255u)));
let _e5320 = local_8.member_1[2u];
let _e5327 = local_9[0u];
let _e5331 = local_9[1u];
let _e5336 = local_9[2u];
let _e5343 = global_1.member.member_8.member_8;
let _e5347 = global_1.member.member_8.member_7;
let _e5349 = (((_e5228 + (((_e5279 + (((_e5319 + ((f32(bitcast<i32>(((_e5312 >> bitcast<u32>((_e5320 & 31u))) & 255u))) - _e5319) * _e5327)) - _e5279) * _e5331)) - _e5228) * _e5336)) - _e5343) * _e5347);
let _e5350 = -(1e9f);
let _e5352 = select(_e5350, _e5349, (_e5349 > _e5350));
let _e5357 = select(select(1e9f, _e5352, (_e5352 < 1e9f)), _e4868.member, (_e4915 != 0u));
let _e5360 = global_1.member.member_1;
let _e5362 = ((_e5360 & 16u) == 0u);
if _e5362 {
phi_10830_ = type_36(type_33(0f, 1f), type_33(0f, 1f), 1f);
} else {
let _e5366 = global_1.member.member_16.member;
let _e5377 = ((((_e5366.member.member * _e1183) + (_e5366.member.member_1 * _e1196)) + (_e5366.member.member_2 * _e1161)) + _e5366.member_1);
let _e5383 = ((((_e5366.member.member * _e1206) + (_e5366.member.member_1 * _e1211)) + (_e5366.member.member_2 * _e1200)) + _e5366.member_1);
let _e5390 = bitcast<f32>((bitcast<u32>((_e5377 - _e5383)) & 2147483647u));
let _e5393 = (bitcast<f32>((bitcast<u32>(_e5377) & 2147483647u)) / select(1e-30f, _e5390, (_e5390 > 1e-30f)));
let _e5395 = select(0f, _e5393, (_e5393 > 0f));
let _e5397 = select(1f, _e5395, (_e5395 < 1f));
let _e5398 = (_e5377 > 0f);
let _e5399 = (_e5383 > 0f);
let _e5401 = select(0f, select(_e5397, 1f, _e5399), _e5398);
let _e5403 = select(1f, select(_e5397, 1f, _e5398), _e5399);
let _e5407 = global_1.member.member_16.member_1;
let _e5408 = (_e5407 != 0u);
let _e5410 = select(_e5401, 0f, (0f > _e5401));
let _e5412 = select(_e5403, 1f, (1f < _e5403));
let _e5413 = select(0f, _e5401, _e5408);
let _e5414 = select(1f, _e5403, _e5408);
let _e5416 = select(_e5413, 0f, (0f > _e5413));
let _e5418 = select(_e5414, 1f, (1f < _e5414));
let _e5425 = global_1.member.member_17.member;
let _e5436 = ((((_e5425.member.member * _e1183) + (_e5425.member.member_1 * _e1196)) + (_e5425.member.member_2 * _e1161)) + _e5425.member_1);
let _e5442 = ((((_e5425.member.member * _e1206) + (_e5425.member.member_1 * _e1211)) + (_e5425.member.member_2 * _e1200)) + _e5425.member_1);
let _e5449 = bitcast<f32>((bitcast<u32>((_e5436 - _e5442)) & 2147483647u));
let _e5452 = (bitcast<f32>((bitcast<u32>(_e5436) & 2147483647u)) / select(1e-30f, _e5449, (_e5449 > 1e-30f)));
let _e5454 = select(0f, _e5452, (_e5452 > 0f));
let _e5456 = select(1f, _e5454, (_e5454 < 1f));
let _e5457 = (_e5436 > 0f);
let _e5458 = (_e5442 > 0f);
let _e5460 = select(0f, select(_e5456, 1f, _e5458), _e5457);
let _e5462 = select(1f, select(_e5456, 1f, _e5457), _e5458);
let _e5466 = global_1.member.member_17.member_1;
let _e5467 = (_e5466 != 0u);
let _e5469 = select(_e5460, _e5410, (_e5410 > _e5460));
let _e5471 = select(_e5462, _e5412, (_e5412 < _e5462));
let _e5472 = select(0f, _e5460, _e5467);
let _e5473 = select(1f, _e5462, _e5467);
let _e5475 = select(_e5472, _e5416, (_e5416 > _e5472));
let _e5477 = select(_e5473, _e5418, (_e5418 < _e5473));
let _e5484 = global_1.member.member_18.member;
let _e5495 = ((((_e5484.member.member * _e1183) + (_e5484.member.member_1 * _e1196)) + (_e5484.member.member_2 * _e1161)) + _e5484.member_1);
let _e5501 = ((((_e5484.member.member * _e1206) + (_e5484.member.member_1 * _e1211)) + (_e5484.member.member_2 * _e1200)) + _e5484.member_1);
let _e5508 = bitcast<f32>((bitcast<u32>((_e5495 - _e5501)) & 2147483647u));
let _e5511 = (bitcast<f32>((bitcast<u32>(_e5495) & 2147483647u)) / select(1e-30f, _e5508, (_e5508 > 1e-30f)));
let _e5513 = select(0f, _e5511, (_e5511 > 0f));
let _e5515 = select(1f, _e5513, (_e5513 < 1f));
let _e5516 = (_e5495 > 0f);
let _e5517 = (_e5501 > 0f);
let _e5519 = select(0f, select(_e5515, 1f, _e5517), _e5516);
let _e5521 = select(1f, select(_e5515, 1f, _e5516), _e5517);
let _e5525 = global_1.member.member_18.member_1;
let _e5526 = (_e5525 != 0u);
let _e5528 = select(_e5519, _e5469, (_e5469 > _e5519));
let _e5530 = select(_e5521, _e5471, (_e5471 < _e5521));
let _e5531 = select(0f, _e5519, _e5526);
let _e5532 = select(1f, _e5521, _e5526);
let _e5534 = select(_e5531, _e5475, (_e5475 > _e5531));
let _e5536 = select(_e5532, _e5477, (_e5477 < _e5532));
let _e5543 = global_1.member.member_19.member;
let _e5554 = ((((_e5543.member.member * _e1183) + (_e5543.member.member_1 * _e1196)) + (_e5543.member.member_2 * _e1161)) + _e5543.member_1);
let _e5560 = ((((_e5543.member.member * _e1206) + (_e5543.member.member_1 * _e1211)) + (_e5543.member.member_2 * _e1200)) + _e5543.member_1);
let _e5567 = bitcast<f32>((bitcast<u32>((_e5554 - _e5560)) & 2147483647u));
let _e5570 = (bitcast<f32>((bitcast<u32>(_e5554) & 2147483647u)) / select(1e-30f, _e5567, (_e5567 > 1e-30f)));
let _e5572 = select(0f, _e5570, (_e5570 > 0f));
let _e5574 = select(1f, _e5572, (_e5572 < 1f));
let _e5575 = (_e5554 > 0f);
let _e5576 = (_e5560 > 0f);
let _e5578 = select(0f, select(_e5574, 1f, _e5576), _e5575);
let _e5580 = select(1f, select(_e5574, 1f, _e5575), _e5576);
let _e5584 = global_1.member.member_19.member_1;
let _e5585 = (_e5584 != 0u);
let _e5590 = select(0f, _e5578, _e5585);
let _e5591 = select(1f, _e5580, _e5585);
phi_10830_ = type_36(type_33(select(_e5578, _e5528, (_e5528 > _e5578)), select(_e5580, _e5530, (_e5530 < _e5580))), type_33(select(_e5590, _e5534, (_e5534 > _e5590)), select(_e5591, _e5536, (_e5536 < _e5591))), ((((1f * select(1f, 0f, (_e5408 && _e5399))) * select(1f, 0f, (_e5467 && _e5458))) * select(1f, 0f, (_e5526 && _e5517))) * select(1f, 0f, (_e5585 && _e5576))));
}
let _e5603 = phi_10830_;
let _e5604 = (_e1262 - _e1226);
let _e5608 = (bitcast<f32>((bitcast<u32>(_e5604) & 2147483647u)) < 1e-12f);
let _e5610 = (1f / select(_e5604, 1f, _e5608));
let _e5611 = (_e4873 - _e1226);
let _e5612 = (_e5611 * _e5610);
let _e5614 = ((_e4878 - _e1226) * _e5610);
let _e5620 = select(_e5614, _e5612, (_e5612 < _e5614));
let _e5622 = select(0f, _e5620, (_e5620 > 0f));
let _e5625 = select(select(1f, _e5622, (_e5622 < 1f)), select(2f, 0f, ((_e1226 >= _e4873) && (_e1226 <= _e4878))), _e5608);
let _e5627 = select(_e5614, _e5612, (_e5612 > _e5614));
let _e5629 = select(0f, _e5627, (_e5627 > 0f));
let _e5632 = select(select(1f, _e5629, (_e5629 < 1f)), 1f, _e5608);
let _e5633 = (_e1268 - _e1241);
let _e5637 = (bitcast<f32>((bitcast<u32>(_e5633) & 2147483647u)) < 1e-12f);
let _e5639 = (1f / select(_e5633, 1f, _e5637));
let _e5640 = (_e4887 - _e1241);
let _e5641 = (_e5640 * _e5639);
let _e5643 = ((_e4892 - _e1241) * _e5639);
let _e5649 = select(_e5643, _e5641, (_e5641 < _e5643));
let _e5651 = select(0f, _e5649, (_e5649 > 0f));
let _e5654 = select(select(1f, _e5651, (_e5651 < 1f)), select(2f, 0f, ((_e1241 >= _e4887) && (_e1241 <= _e4892))), _e5637);
let _e5656 = select(_e5643, _e5641, (_e5641 > _e5643));
let _e5658 = select(0f, _e5656, (_e5656 > 0f));
let _e5661 = select(select(1f, _e5658, (_e5658 < 1f)), 1f, _e5637);
let _e5662 = (_e1274 - _e1256);
let _e5666 = (bitcast<f32>((bitcast<u32>(_e5662) & 2147483647u)) < 1e-12f);
let _e5668 = (1f / select(_e5662, 1f, _e5666));
let _e5669 = (_e4901 - _e1256);
let _e5670 = (_e5669 * _e5668);
let _e5672 = ((_e4906 - _e1256) * _e5668);
let _e5678 = select(_e5672, _e5670, (_e5670 < _e5672));
let _e5680 = select(0f, _e5678, (_e5678 > 0f));
let _e5683 = select(select(1f, _e5680, (_e5680 < 1f)), select(2f, 0f, ((_e1256 >= _e4901) && (_e1256 <= _e4906))), _e5666);
let _e5685 = select(_e5672, _e5670, (_e5670 > _e5672));
let _e5687 = select(0f, _e5685, (_e5685 > 0f));
let _e5690 = select(select(1f, _e5687, (_e5687 < 1f)), 1f, _e5666);
let _e5692 = select(_e5654, _e5625, (_e5625 > _e5654));
let _e5696 = select(_e5661, _e5632, (_e5632 < _e5661));
let _e5699 = (select(_e5690, _e5696, (_e5696 < _e5690)) - select(_e5683, _e5692, (_e5692 > _e5683)));
let _e5701 = select(0f, _e5699, (_e5699 > 0f));
let _e5702 = (_e1206 - _e1183);
let _e5703 = (_e1211 - _e1196);
let _e5704 = (_e1200 - _e1161);
let _e5709 = (((_e5702 * _e5702) + (_e5703 * _e5703)) + (_e5704 * _e5704));
let _e5717 = global_1.member.member_7.member_3;
let _e5718 = ((sqrt(select(0f, _e5709, (_e5709 > 0f))) * _e5701) * _e5717);
if (((_e191.member_2 == 3u) || (_e191.member_2 == 4u)) || _e1276) {
local_7 = _e5357;
let _e5723 = local_7;
let _e5725 = (bitcast<i32>(_e181) - 1i);
let _e5727 = select(_e5725, 263171i, (263171i < _e5725));
let _e5732 = global_3.member[bitcast<u32>(select(0i, _e5727, (_e5727 > 0i)))];
let _e5733 = bitcast<f32>(_e5732);
let _e5735 = select(_e5725, 263172i, (263172i < _e5725));
let _e5740 = global_3.member[bitcast<u32>(select(0i, _e5735, (_e5735 > 0i)))];
let _e5741 = bitcast<f32>(_e5740);
let _e5743 = select(_e5725, 263173i, (263173i < _e5725));
let _e5748 = global_3.member[bitcast<u32>(select(0i, _e5743, (_e5743 > 0i)))];
let _e5749 = bitcast<f32>(_e5748);
let _e5751 = ((_e5723 - _e5733) * _e5741);
let _e5753 = select(0f, _e5751, (_e5751 > 0f));
let _e5756 = local_7;
let _e5758 = select(_e5725, 263174i, (263174i < _e5725));
let _e5763 = global_3.member[bitcast<u32>(select(0i, _e5758, (_e5758 > 0i)))];
let _e5764 = bitcast<f32>(_e5763);
let _e5766 = select(_e5725, 263175i, (263175i < _e5725));
let _e5771 = global_3.member[bitcast<u32>(select(0i, _e5766, (_e5766 > 0i)))];
let _e5772 = bitcast<f32>(_e5771);
let _e5774 = select(_e5725, 263176i, (263176i < _e5725));
let _e5779 = global_3.member[bitcast<u32>(select(0i, _e5774, (_e5774 > 0i)))];
let _e5780 = bitcast<f32>(_e5779);
let _e5782 = ((_e5756 - _e5764) * _e5772);
let _e5784 = select(0f, _e5782, (_e5782 > 0f));
let _e5788 = local_7;
let _e5790 = select(_e5725, 263177i, (263177i < _e5725));
let _e5795 = global_3.member[bitcast<u32>(select(0i, _e5790, (_e5790 > 0i)))];
let _e5796 = bitcast<f32>(_e5795);
let _e5798 = select(_e5725, 263178i, (263178i < _e5725));
let _e5803 = global_3.member[bitcast<u32>(select(0i, _e5798, (_e5798 > 0i)))];
let _e5804 = bitcast<f32>(_e5803);
let _e5806 = select(_e5725, 263179i, (263179i < _e5725));
let _e5811 = global_3.member[bitcast<u32>(select(0i, _e5806, (_e5806 > 0i)))];
let _e5812 = bitcast<f32>(_e5811);
let _e5814 = ((_e5788 - _e5796) * _e5804);
let _e5816 = select(0f, _e5814, (_e5814 > 0f));
let _e5819 = local_7;
let _e5821 = select(_e5725, 263180i, (263180i < _e5725));
let _e5826 = global_3.member[bitcast<u32>(select(0i, _e5821, (_e5821 > 0i)))];
let _e5827 = bitcast<f32>(_e5826);
let _e5829 = select(_e5725, 263181i, (263181i < _e5725));
let _e5834 = global_3.member[bitcast<u32>(select(0i, _e5829, (_e5829 > 0i)))];
let _e5835 = bitcast<f32>(_e5834);
let _e5837 = select(_e5725, 263182i, (263182i < _e5725));
let _e5842 = global_3.member[bitcast<u32>(select(0i, _e5837, (_e5837 > 0i)))];
let _e5843 = bitcast<f32>(_e5842);
let _e5845 = ((_e5819 - _e5827) * _e5835);
let _e5847 = select(0f, _e5845, (_e5845 > 0f));
let _e5852 = local_7;
let _e5854 = select(_e5725, 263183i, (263183i < _e5725));
let _e5859 = global_3.member[bitcast<u32>(select(0i, _e5854, (_e5854 > 0i)))];
let _e5860 = bitcast<f32>(_e5859);
let _e5862 = select(_e5725, 263184i, (263184i < _e5725));
let _e5867 = global_3.member[bitcast<u32>(select(0i, _e5862, (_e5862 > 0i)))];
let _e5868 = bitcast<f32>(_e5867);
let _e5870 = select(_e5725, 263185i, (263185i < _e5725));
let _e5875 = global_3.member[bitcast<u32>(select(0i, _e5870, (_e5870 > 0i)))];
let _e5876 = bitcast<f32>(_e5875);
let _e5878 = ((_e5852 - _e5860) * _e5868);
let _e5880 = select(0f, _e5878, (_e5878 > 0f));
let _e5883 = local_7;
let _e5885 = select(_e5725, 263186i, (263186i < _e5725));
let _e5890 = global_3.member[bitcast<u32>(select(0i, _e5885, (_e5885 > 0i)))];
let _e5891 = bitcast<f32>(_e5890);
let _e5893 = select(_e5725, 263187i, (263187i < _e5725));
let _e5898 = global_3.member[bitcast<u32>(select(0i, _e5893, (_e5893 > 0i)))];
let _e5899 = bitcast<f32>(_e5898);
let _e5901 = select(_e5725, 263188i, (263188i < _e5725));
let _e5906 = global_3.member[bitcast<u32>(select(0i, _e5901, (_e5901 > 0i)))];
let _e5907 = bitcast<f32>(_e5906);
let _e5909 = ((_e5883 - _e5891) * _e5899);
let _e5911 = select(0f, _e5909, (_e5909 > 0f));
let _e5915 = local_7;
let _e5917 = select(_e5725, 263189i, (263189i < _e5725));
let _e5922 = global_3.member[bitcast<u32>(select(0i, _e5917, (_e5917 > 0i)))];
let _e5923 = bitcast<f32>(_e5922);
let _e5925 = select(_e5725, 263190i, (263190i < _e5725));
let _e5930 = global_3.member[bitcast<u32>(select(0i, _e5925, (_e5925 > 0i)))];
let _e5931 = bitcast<f32>(_e5930);
let _e5933 = select(_e5725, 263191i, (263191i < _e5725));
let _e5938 = global_3.member[bitcast<u32>(select(0i, _e5933, (_e5933 > 0i)))];
let _e5939 = bitcast<f32>(_e5938);
let _e5941 = ((_e5915 - _e5923) * _e5931);
let _e5943 = select(0f, _e5941, (_e5941 > 0f));
let _e5946 = local_7;
let _e5948 = select(_e5725, 263192i, (263192i < _e5725));
let _e5953 = global_3.member[bitcast<u32>(select(0i, _e5948, (_e5948 > 0i)))];
let _e5954 = bitcast<f32>(_e5953);
let _e5956 = select(_e5725, 263193i, (263193i < _e5725));
let _e5961 = global_3.member[bitcast<u32>(select(0i, _e5956, (_e5956 > 0i)))];
let _e5962 = bitcast<f32>(_e5961);
let _e5964 = select(_e5725, 263194i, (263194i < _e5725));
let _e5969 = global_3.member[bitcast<u32>(select(0i, _e5964, (_e5964 > 0i)))];
let _e5970 = bitcast<f32>(_e5969);
let _e5972 = ((_e5946 - _e5954) * _e5962);
let _e5974 = select(0f, _e5972, (_e5972 > 0f));
let _e5979 = (((select(_e5749, _e5753, (_e5753 < _e5749)) + select(_e5780, _e5784, (_e5784 < _e5780))) + (select(_e5812, _e5816, (_e5816 < _e5812)) + select(_e5843, _e5847, (_e5847 < _e5843)))) + ((select(_e5876, _e5880, (_e5880 < _e5876)) + select(_e5907, _e5911, (_e5911 < _e5907))) + (select(_e5939, _e5943, (_e5943 < _e5939)) + select(_e5970, _e5974, (_e5974 < _e5970)))));
local_6 = _e4868.member;
let _e5980 = local_6;
let _e5982 = ((_e5980 - _e5733) * _e5741);
let _e5984 = select(0f, _e5982, (_e5982 > 0f));
let _e5987 = local_6;
let _e5989 = ((_e5987 - _e5764) * _e5772);
let _e5991 = select(0f, _e5989, (_e5989 > 0f));
let _e5995 = local_6;
let _e5997 = ((_e5995 - _e5796) * _e5804);
let _e5999 = select(0f, _e5997, (_e5997 > 0f));
let _e6002 = local_6;
let _e6004 = ((_e6002 - _e5827) * _e5835);
let _e6006 = select(0f, _e6004, (_e6004 > 0f));
let _e6011 = local_6;
let _e6013 = ((_e6011 - _e5860) * _e5868);
let _e6015 = select(0f, _e6013, (_e6013 > 0f));
let _e6018 = local_6;
let _e6020 = ((_e6018 - _e5891) * _e5899);
let _e6022 = select(0f, _e6020, (_e6020 > 0f));
let _e6026 = local_6;
let _e6028 = ((_e6026 - _e5923) * _e5931);
let _e6030 = select(0f, _e6028, (_e6028 > 0f));
let _e6033 = local_6;
let _e6035 = ((_e6033 - _e5954) * _e5962);
let _e6037 = select(0f, _e6035, (_e6035 > 0f));
let _e6042 = (((select(_e5749, _e5984, (_e5984 < _e5749)) + select(_e5780, _e5991, (_e5991 < _e5780))) + (select(_e5812, _e5999, (_e5999 < _e5812)) + select(_e5843, _e6006, (_e6006 < _e5843)))) + ((select(_e5876, _e6015, (_e6015 < _e5876)) + select(_e5907, _e6022, (_e6022 < _e5907))) + (select(_e5939, _e6030, (_e6030 < _e5939)) + select(_e5970, _e6037, (_e6037 < _e5970)))));
let _e6043 = (255f - 1f);
let _e6045 = select(0f, _e5979, (_e5979 > 0f));
let _e6047 = select(_e6043, _e6045, (_e6045 < _e6043));
let _e6054 = select(0i, select(select(i32(_e6047), i32(-2147483648), (_e6047 < -2147483600f)), 2147483647i, (_e6047 > 2147483500f)), (_e6047 == _e6047));
let _e6058 = (_e6054 - select(0i, 1i, (_e6047 < f32(_e6054))));
let _e6060 = select(0f, _e6042, (_e6042 > 0f));
let _e6062 = select(_e6043, _e6060, (_e6060 < _e6043));
let _e6069 = select(0i, select(select(i32(_e6062), i32(-2147483648), (_e6062 < -2147483600f)), 2147483647i, (_e6062 > 2147483500f)), (_e6062 == _e6062));
let _e6073 = (_e6069 - select(0i, 1i, (_e6062 < f32(_e6069))));
let _e6075 = select(_e5725, 263195i, (263195i < _e5725));
let _e6081 = global_3.member[bitcast<u32>(select(0i, _e6075, (_e6075 > 0i)))];
let _e6082 = bitcast<f32>(_e6081);
let _e6084 = select(_e5725, 263196i, (263196i < _e5725));
let _e6090 = global_3.member[bitcast<u32>(select(0i, _e6084, (_e6084 > 0i)))];
let _e6091 = bitcast<f32>(_e6090);
let _e6092 = (_e4868.member - _e5357);
let _e6098 = (1f / select(_e6092, 1f, (bitcast<f32>((bitcast<u32>(_e6092) & 2147483647u)) < 1e-20f)));
let _e6104 = ((select(_e6082, _e4868.member, (_e4868.member < _e6082)) - select(_e6082, _e5357, (_e5357 < _e6082))) * _e6098);
let _e6110 = ((select(_e6091, _e4868.member, (_e4868.member > _e6091)) - select(_e6091, _e5357, (_e5357 > _e6091))) * _e6098);
let _e6113 = (((_e6058 * 256i) + _e6073) * 4i);
let _e6117 = (_e6042 - f32(_e6073));
let _e6120 = (_e6113 + 1i);
let _e6122 = select(_e5725, _e6120, (_e6120 < _e5725));
let _e6128 = global_3.member[bitcast<u32>(select(0i, _e6122, (_e6122 > 0i)))];
let _e6135 = (bitcast<f32>((((_e6128 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6136 = (_e6113 + 5i);
let _e6138 = select(_e5725, _e6136, (_e6136 < _e5725));
let _e6144 = global_3.member[bitcast<u32>(select(0i, _e6138, (_e6138 > 0i)))];
let _e6152 = (_e6113 + 1025i);
let _e6154 = select(_e5725, _e6152, (_e6152 < _e5725));
let _e6160 = global_3.member[bitcast<u32>(select(0i, _e6154, (_e6154 > 0i)))];
let _e6167 = (bitcast<f32>((((_e6160 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6168 = (_e6113 + 1029i);
let _e6170 = select(_e5725, _e6168, (_e6168 < _e5725));
let _e6176 = global_3.member[bitcast<u32>(select(0i, _e6170, (_e6170 > 0i)))];
let _e6186 = (_e6135 + (((bitcast<f32>((((_e6144 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6135) * _e6117));
let _e6194 = select(_e5725, 1i, (1i < _e5725));
let _e6200 = global_3.member[bitcast<u32>(select(0i, _e6194, (_e6194 > 0i)))];
let _e6209 = select(_e5725, 262141i, (262141i < _e5725));
let _e6215 = global_3.member[bitcast<u32>(select(0i, _e6209, (_e6209 > 0i)))];
let _e6227 = (((_e6186 + (((_e6167 + (((bitcast<f32>((((_e6176 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6167) * _e6117)) - _e6186) * (_e5979 - f32(_e6058)))) * (1f - (_e6104 + _e6110))) + (((bitcast<f32>((((_e6200 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6104) + ((bitcast<f32>((((_e6215 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6110)));
let _e6232 = (_e5603.member.member_1 - _e5603.member.member);
let _e6237 = -((_e6227 * (_e5718 * select(0f, _e6232, (_e6232 > 0f)))));
let _e6239 = select(-87f, _e6237, (_e6237 > -87f));
let _e6241 = select(88f, _e6239, (_e6239 < 88f));
let _e6243 = ((_e6241 * 1.442695f) + 0.5f);
let _e6245 = select(-127f, _e6243, (_e6243 > -127f));
let _e6247 = select(128f, _e6245, (_e6245 < 128f));
let _e6254 = select(0i, select(select(i32(_e6247), i32(-2147483648), (_e6247 < -2147483600f)), 2147483647i, (_e6247 > 2147483500f)), (_e6247 == _e6247));
let _e6258 = (_e6254 - select(0i, 1i, (_e6247 < f32(_e6254))));
let _e6259 = f32(_e6258);
let _e6263 = ((_e6241 - (_e6259 * 0.6933594f)) - (_e6259 * -2.1219444e-4f));
let _e6283 = ((1f + (_e6263 * (1f + (_e6263 * (0.5f + (_e6263 * (0.16666667f + (_e6263 * (0.041666668f + (_e6263 * (0.008333334f + (_e6263 * (0.001388889f + (_e6263 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6258 + 127i)) << bitcast<u32>(23i))));
let _e6284 = (1f - _e6283);
phi_14774_ = type_38(_e6283, _e6284, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e6284 / select(1e-12f, _e6227, (_e6227 > 1e-12f))))));
} else {
local_5 = _e5357;
let _e6291 = local_5;
let _e6293 = (bitcast<i32>(_e181) - 1i);
let _e6295 = select(_e6293, 263171i, (263171i < _e6293));
let _e6300 = global_3.member[bitcast<u32>(select(0i, _e6295, (_e6295 > 0i)))];
let _e6301 = bitcast<f32>(_e6300);
let _e6303 = select(_e6293, 263172i, (263172i < _e6293));
let _e6308 = global_3.member[bitcast<u32>(select(0i, _e6303, (_e6303 > 0i)))];
let _e6309 = bitcast<f32>(_e6308);
let _e6311 = select(_e6293, 263173i, (263173i < _e6293));
let _e6316 = global_3.member[bitcast<u32>(select(0i, _e6311, (_e6311 > 0i)))];
let _e6317 = bitcast<f32>(_e6316);
let _e6319 = ((_e6291 - _e6301) * _e6309);
let _e6321 = select(0f, _e6319, (_e6319 > 0f));
let _e6324 = local_5;
let _e6326 = select(_e6293, 263174i, (263174i < _e6293));
let _e6331 = global_3.member[bitcast<u32>(select(0i, _e6326, (_e6326 > 0i)))];
let _e6332 = bitcast<f32>(_e6331);
let _e6334 = select(_e6293, 263175i, (263175i < _e6293));
let _e6339 = global_3.member[bitcast<u32>(select(0i, _e6334, (_e6334 > 0i)))];
let _e6340 = bitcast<f32>(_e6339);
let _e6342 = select(_e6293, 263176i, (263176i < _e6293));
let _e6347 = global_3.member[bitcast<u32>(select(0i, _e6342, (_e6342 > 0i)))];
let _e6348 = bitcast<f32>(_e6347);
let _e6350 = ((_e6324 - _e6332) * _e6340);
let _e6352 = select(0f, _e6350, (_e6350 > 0f));
let _e6356 = local_5;
let _e6358 = select(_e6293, 263177i, (263177i < _e6293));
let _e6363 = global_3.member[bitcast<u32>(select(0i, _e6358, (_e6358 > 0i)))];
let _e6364 = bitcast<f32>(_e6363);
let _e6366 = select(_e6293, 263178i, (263178i < _e6293));
let _e6371 = global_3.member[bitcast<u32>(select(0i, _e6366, (_e6366 > 0i)))];
let _e6372 = bitcast<f32>(_e6371);
let _e6374 = select(_e6293, 263179i, (263179i < _e6293));
let _e6379 = global_3.member[bitcast<u32>(select(0i, _e6374, (_e6374 > 0i)))];
let _e6380 = bitcast<f32>(_e6379);
let _e6382 = ((_e6356 - _e6364) * _e6372);
let _e6384 = select(0f, _e6382, (_e6382 > 0f));
let _e6387 = local_5;
let _e6389 = select(_e6293, 263180i, (263180i < _e6293));
let _e6394 = global_3.member[bitcast<u32>(select(0i, _e6389, (_e6389 > 0i)))];
let _e6395 = bitcast<f32>(_e6394);
let _e6397 = select(_e6293, 263181i, (263181i < _e6293));
let _e6402 = global_3.member[bitcast<u32>(select(0i, _e6397, (_e6397 > 0i)))];
let _e6403 = bitcast<f32>(_e6402);
let _e6405 = select(_e6293, 263182i, (263182i < _e6293));
let _e6410 = global_3.member[bitcast<u32>(select(0i, _e6405, (_e6405 > 0i)))];
let _e6411 = bitcast<f32>(_e6410);
let _e6413 = ((_e6387 - _e6395) * _e6403);
let _e6415 = select(0f, _e6413, (_e6413 > 0f));
let _e6420 = local_5;
let _e6422 = select(_e6293, 263183i, (263183i < _e6293));
let _e6427 = global_3.member[bitcast<u32>(select(0i, _e6422, (_e6422 > 0i)))];
let _e6428 = bitcast<f32>(_e6427);
let _e6430 = select(_e6293, 263184i, (263184i < _e6293));
let _e6435 = global_3.member[bitcast<u32>(select(0i, _e6430, (_e6430 > 0i)))];
let _e6436 = bitcast<f32>(_e6435);
let _e6438 = select(_e6293, 263185i, (263185i < _e6293));
let _e6443 = global_3.member[bitcast<u32>(select(0i, _e6438, (_e6438 > 0i)))];
let _e6444 = bitcast<f32>(_e6443);
let _e6446 = ((_e6420 - _e6428) * _e6436);
let _e6448 = select(0f, _e6446, (_e6446 > 0f));
let _e6451 = local_5;
let _e6453 = select(_e6293, 263186i, (263186i < _e6293));
let _e6458 = global_3.member[bitcast<u32>(select(0i, _e6453, (_e6453 > 0i)))];
let _e6459 = bitcast<f32>(_e6458);
let _e6461 = select(_e6293, 263187i, (263187i < _e6293));
let _e6466 = global_3.member[bitcast<u32>(select(0i, _e6461, (_e6461 > 0i)))];
let _e6467 = bitcast<f32>(_e6466);
let _e6469 = select(_e6293, 263188i, (263188i < _e6293));
let _e6474 = global_3.member[bitcast<u32>(select(0i, _e6469, (_e6469 > 0i)))];
let _e6475 = bitcast<f32>(_e6474);
let _e6477 = ((_e6451 - _e6459) * _e6467);
let _e6479 = select(0f, _e6477, (_e6477 > 0f));
let _e6483 = local_5;
let _e6485 = select(_e6293, 263189i, (263189i < _e6293));
let _e6490 = global_3.member[bitcast<u32>(select(0i, _e6485, (_e6485 > 0i)))];
let _e6491 = bitcast<f32>(_e6490);
let _e6493 = select(_e6293, 263190i, (263190i < _e6293));
let _e6498 = global_3.member[bitcast<u32>(select(0i, _e6493, (_e6493 > 0i)))];
let _e6499 = bitcast<f32>(_e6498);
let _e6501 = select(_e6293, 263191i, (263191i < _e6293));
let _e6506 = global_3.member[bitcast<u32>(select(0i, _e6501, (_e6501 > 0i)))];
let _e6507 = bitcast<f32>(_e6506);
let _e6509 = ((_e6483 - _e6491) * _e6499);
let _e6511 = select(0f, _e6509, (_e6509 > 0f));
let _e6514 = local_5;
let _e6516 = select(_e6293, 263192i, (263192i < _e6293));
let _e6521 = global_3.member[bitcast<u32>(select(0i, _e6516, (_e6516 > 0i)))];
let _e6522 = bitcast<f32>(_e6521);
let _e6524 = select(_e6293, 263193i, (263193i < _e6293));
let _e6529 = global_3.member[bitcast<u32>(select(0i, _e6524, (_e6524 > 0i)))];
let _e6530 = bitcast<f32>(_e6529);
let _e6532 = select(_e6293, 263194i, (263194i < _e6293));
let _e6537 = global_3.member[bitcast<u32>(select(0i, _e6532, (_e6532 > 0i)))];
let _e6538 = bitcast<f32>(_e6537);
let _e6540 = ((_e6514 - _e6522) * _e6530);
let _e6542 = select(0f, _e6540, (_e6540 > 0f));
let _e6547 = (((select(_e6317, _e6321, (_e6321 < _e6317)) + select(_e6348, _e6352, (_e6352 < _e6348))) + (select(_e6380, _e6384, (_e6384 < _e6380)) + select(_e6411, _e6415, (_e6415 < _e6411)))) + ((select(_e6444, _e6448, (_e6448 < _e6444)) + select(_e6475, _e6479, (_e6479 < _e6475))) + (select(_e6507, _e6511, (_e6511 < _e6507)) + select(_e6538, _e6542, (_e6542 < _e6538)))));
local_4 = _e4868.member;
let _e6548 = local_4;
let _e6550 = ((_e6548 - _e6301) * _e6309);
let _e6552 = select(0f, _e6550, (_e6550 > 0f));
let _e6555 = local_4;
let _e6557 = ((_e6555 - _e6332) * _e6340);
let _e6559 = select(0f, _e6557, (_e6557 > 0f));
let _e6563 = local_4;
let _e6565 = ((_e6563 - _e6364) * _e6372);
let _e6567 = select(0f, _e6565, (_e6565 > 0f));
let _e6570 = local_4;
let _e6572 = ((_e6570 - _e6395) * _e6403);
let _e6574 = select(0f, _e6572, (_e6572 > 0f));
let _e6579 = local_4;
let _e6581 = ((_e6579 - _e6428) * _e6436);
let _e6583 = select(0f, _e6581, (_e6581 > 0f));
let _e6586 = local_4;
let _e6588 = ((_e6586 - _e6459) * _e6467);
let _e6590 = select(0f, _e6588, (_e6588 > 0f));
let _e6594 = local_4;
let _e6596 = ((_e6594 - _e6491) * _e6499);
let _e6598 = select(0f, _e6596, (_e6596 > 0f));
let _e6601 = local_4;
let _e6603 = ((_e6601 - _e6522) * _e6530);
let _e6605 = select(0f, _e6603, (_e6603 > 0f));
let _e6610 = (((select(_e6317, _e6552, (_e6552 < _e6317)) + select(_e6348, _e6559, (_e6559 < _e6348))) + (select(_e6380, _e6567, (_e6567 < _e6380)) + select(_e6411, _e6574, (_e6574 < _e6411)))) + ((select(_e6444, _e6583, (_e6583 < _e6444)) + select(_e6475, _e6590, (_e6590 < _e6475))) + (select(_e6507, _e6598, (_e6598 < _e6507)) + select(_e6538, _e6605, (_e6605 < _e6538)))));
let _e6611 = (255f - 1f);
let _e6613 = select(0f, _e6547, (_e6547 > 0f));
let _e6615 = select(_e6611, _e6613, (_e6613 < _e6611));
let _e6622 = select(0i, select(select(i32(_e6615), i32(-2147483648), (_e6615 < -2147483600f)), 2147483647i, (_e6615 > 2147483500f)), (_e6615 == _e6615));
let _e6626 = (_e6622 - select(0i, 1i, (_e6615 < f32(_e6622))));
let _e6628 = select(0f, _e6610, (_e6610 > 0f));
let _e6630 = select(_e6611, _e6628, (_e6628 < _e6611));
let _e6637 = select(0i, select(select(i32(_e6630), i32(-2147483648), (_e6630 < -2147483600f)), 2147483647i, (_e6630 > 2147483500f)), (_e6630 == _e6630));
let _e6641 = (_e6637 - select(0i, 1i, (_e6630 < f32(_e6637))));
let _e6643 = select(_e6293, 263195i, (263195i < _e6293));
let _e6649 = global_3.member[bitcast<u32>(select(0i, _e6643, (_e6643 > 0i)))];
let _e6650 = bitcast<f32>(_e6649);
let _e6652 = select(_e6293, 263196i, (263196i < _e6293));
let _e6658 = global_3.member[bitcast<u32>(select(0i, _e6652, (_e6652 > 0i)))];
let _e6659 = bitcast<f32>(_e6658);
let _e6660 = (_e4868.member - _e5357);
let _e6666 = (1f / select(_e6660, 1f, (bitcast<f32>((bitcast<u32>(_e6660) & 2147483647u)) < 1e-20f)));
let _e6672 = ((select(_e6650, _e4868.member, (_e4868.member < _e6650)) - select(_e6650, _e5357, (_e5357 < _e6650))) * _e6666);
let _e6678 = ((select(_e6659, _e4868.member, (_e4868.member > _e6659)) - select(_e6659, _e5357, (_e5357 > _e6659))) * _e6666);
let _e6681 = (((_e6626 * 256i) + _e6641) * 4i);
let _e6683 = (_e6547 - f32(_e6626));
let _e6685 = (_e6610 - f32(_e6641));
let _e6687 = (1f - (_e6672 + _e6678));
let _e6689 = select(_e6293, _e6681, (_e6681 < _e6293));
let _e6695 = global_3.member[bitcast<u32>(select(0i, _e6689, (_e6689 > 0i)))];
let _e6700 = (bitcast<f32>(((_e6695 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6707 = (bitcast<f32>((((_e6695 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6708 = (_e6681 + 4i);
let _e6710 = select(_e6293, _e6708, (_e6708 < _e6293));
let _e6716 = global_3.member[bitcast<u32>(select(0i, _e6710, (_e6710 > 0i)))];
let _e6729 = (_e6681 + 1024i);
let _e6731 = select(_e6293, _e6729, (_e6729 < _e6293));
let _e6737 = global_3.member[bitcast<u32>(select(0i, _e6731, (_e6731 > 0i)))];
let _e6742 = (bitcast<f32>(((_e6737 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6749 = (bitcast<f32>((((_e6737 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6750 = (_e6681 + 1028i);
let _e6752 = select(_e6293, _e6750, (_e6750 < _e6293));
let _e6758 = global_3.member[bitcast<u32>(select(0i, _e6752, (_e6752 > 0i)))];
let _e6773 = (_e6700 + (((bitcast<f32>(((_e6716 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6700) * _e6685));
let _e6782 = (_e6707 + (((bitcast<f32>((((_e6716 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6707) * _e6685));
let _e6790 = select(_e6293, 0i, (0i < _e6293));
let _e6796 = global_3.member[bitcast<u32>(select(0i, _e6790, (_e6790 > 0i)))];
let _e6810 = select(_e6293, 262140i, (262140i < _e6293));
let _e6816 = global_3.member[bitcast<u32>(select(0i, _e6810, (_e6810 > 0i)))];
let _e6839 = (_e6681 + 1i);
let _e6841 = select(_e6293, _e6839, (_e6839 < _e6293));
let _e6847 = global_3.member[bitcast<u32>(select(0i, _e6841, (_e6841 > 0i)))];
let _e6852 = (bitcast<f32>(((_e6847 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6859 = (bitcast<f32>((((_e6847 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6860 = (_e6681 + 5i);
let _e6862 = select(_e6293, _e6860, (_e6860 < _e6293));
let _e6868 = global_3.member[bitcast<u32>(select(0i, _e6862, (_e6862 > 0i)))];
let _e6881 = (_e6681 + 1025i);
let _e6883 = select(_e6293, _e6881, (_e6881 < _e6293));
let _e6889 = global_3.member[bitcast<u32>(select(0i, _e6883, (_e6883 > 0i)))];
let _e6894 = (bitcast<f32>(((_e6889 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6901 = (bitcast<f32>((((_e6889 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6902 = (_e6681 + 1029i);
let _e6904 = select(_e6293, _e6902, (_e6902 < _e6293));
let _e6910 = global_3.member[bitcast<u32>(select(0i, _e6904, (_e6904 > 0i)))];
let _e6925 = (_e6852 + (((bitcast<f32>(((_e6868 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6852) * _e6685));
let _e6934 = (_e6859 + (((bitcast<f32>((((_e6868 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6859) * _e6685));
let _e6942 = select(_e6293, 1i, (1i < _e6293));
let _e6948 = global_3.member[bitcast<u32>(select(0i, _e6942, (_e6942 > 0i)))];
let _e6962 = select(_e6293, 262141i, (262141i < _e6293));
let _e6968 = global_3.member[bitcast<u32>(select(0i, _e6962, (_e6962 > 0i)))];
let _e6990 = (((_e6934 + (((_e6901 + (((bitcast<f32>((((_e6910 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6901) * _e6685)) - _e6934) * _e6683)) * _e6687) + (((bitcast<f32>((((_e6948 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6672) + ((bitcast<f32>((((_e6968 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6678)));
let _e6995 = (_e5603.member.member_1 - _e5603.member.member);
let _e7003 = (_e5603.member_1.member_1 - _e5603.member_1.member);
let _e7006 = (_e5718 * select(0f, _e7003, (_e7003 > 0f)));
let _e7008 = -(((((_e6925 + (((_e6894 + (((bitcast<f32>(((_e6910 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6894) * _e6685)) - _e6925) * _e6683)) * _e6687) + (((bitcast<f32>(((_e6948 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6672) + ((bitcast<f32>(((_e6968 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6678))) * _e7006));
let _e7010 = select(-87f, _e7008, (_e7008 > -87f));
let _e7012 = select(88f, _e7010, (_e7010 < 88f));
let _e7014 = ((_e7012 * 1.442695f) + 0.5f);
let _e7016 = select(-127f, _e7014, (_e7014 > -127f));
let _e7018 = select(128f, _e7016, (_e7016 < 128f));
let _e7025 = select(0i, select(select(i32(_e7018), i32(-2147483648), (_e7018 < -2147483600f)), 2147483647i, (_e7018 > 2147483500f)), (_e7018 == _e7018));
let _e7029 = (_e7025 - select(0i, 1i, (_e7018 < f32(_e7025))));
let _e7030 = f32(_e7029);
let _e7034 = ((_e7012 - (_e7030 * 0.6933594f)) - (_e7030 * -2.1219444e-4f));
let _e7056 = -(((((_e6773 + (((_e6742 + (((bitcast<f32>(((_e6758 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6742) * _e6685)) - _e6773) * _e6683)) * _e6687) + (((bitcast<f32>(((_e6796 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6672) + ((bitcast<f32>(((_e6816 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6678))) * _e7006));
let _e7058 = select(-87f, _e7056, (_e7056 > -87f));
let _e7060 = select(88f, _e7058, (_e7058 < 88f));
let _e7062 = ((_e7060 * 1.442695f) + 0.5f);
let _e7064 = select(-127f, _e7062, (_e7062 > -127f));
let _e7066 = select(128f, _e7064, (_e7064 < 128f));
let _e7073 = select(0i, select(select(i32(_e7066), i32(-2147483648), (_e7066 < -2147483600f)), 2147483647i, (_e7066 > 2147483500f)), (_e7066 == _e7066));
let _e7077 = (_e7073 - select(0i, 1i, (_e7066 < f32(_e7073))));
let _e7078 = f32(_e7077);
let _e7082 = ((_e7060 - (_e7078 * 0.6933594f)) - (_e7078 * -2.1219444e-4f));
let _e7104 = -(((((_e6782 + (((_e6749 + (((bitcast<f32>((((_e6758 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6749) * _e6685)) - _e6782) * _e6683)) * _e6687) + (((bitcast<f32>((((_e6796 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6672) + ((bitcast<f32>((((_e6816 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e6678))) * _e7006));
let _e7106 = select(-87f, _e7104, (_e7104 > -87f));
let _e7108 = select(88f, _e7106, (_e7106 < 88f));
let _e7110 = ((_e7108 * 1.442695f) + 0.5f);
let _e7112 = select(-127f, _e7110, (_e7110 > -127f));
let _e7114 = select(128f, _e7112, (_e7112 < 128f));
let _e7121 = select(0i, select(select(i32(_e7114), i32(-2147483648), (_e7114 < -2147483600f)), 2147483647i, (_e7114 > 2147483500f)), (_e7114 == _e7114));
let _e7125 = (_e7121 - select(0i, 1i, (_e7114 < f32(_e7121))));
let _e7126 = f32(_e7125);
let _e7130 = ((_e7108 - (_e7126 * 0.6933594f)) - (_e7126 * -2.1219444e-4f));
let _e7153 = -((_e6990 * (_e5718 * select(0f, _e6995, (_e6995 > 0f)))));
let _e7155 = select(-87f, _e7153, (_e7153 > -87f));
let _e7157 = select(88f, _e7155, (_e7155 < 88f));
let _e7159 = ((_e7157 * 1.442695f) + 0.5f);
let _e7161 = select(-127f, _e7159, (_e7159 > -127f));
let _e7163 = select(128f, _e7161, (_e7161 < 128f));
let _e7170 = select(0i, select(select(i32(_e7163), i32(-2147483648), (_e7163 < -2147483600f)), 2147483647i, (_e7163 > 2147483500f)), (_e7163 == _e7163));
let _e7174 = (_e7170 - select(0i, 1i, (_e7163 < f32(_e7170))));
let _e7175 = f32(_e7174);
let _e7179 = ((_e7157 - (_e7175 * 0.6933594f)) - (_e7175 * -2.1219444e-4f));
let _e7199 = ((1f + (_e7179 * (1f + (_e7179 * (0.5f + (_e7179 * (0.16666667f + (_e7179 * (0.041666668f + (_e7179 * (0.008333334f + (_e7179 * (0.001388889f + (_e7179 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7174 + 127i)) << bitcast<u32>(23i))));
let _e7200 = (1f - _e7199);
phi_14774_ = type_38(_e7199, _e7200, vec3<f32>(((1f + (_e7034 * (1f + (_e7034 * (0.5f + (_e7034 * (0.16666667f + (_e7034 * (0.041666668f + (_e7034 * (0.008333334f + (_e7034 * (0.001388889f + (_e7034 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7029 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e7082 * (1f + (_e7082 * (0.5f + (_e7082 * (0.16666667f + (_e7082 * (0.041666668f + (_e7082 * (0.008333334f + (_e7082 * (0.001388889f + (_e7082 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7077 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e7130 * (1f + (_e7130 * (0.5f + (_e7130 * (0.16666667f + (_e7130 * (0.041666668f + (_e7130 * (0.008333334f + (_e7130 * (0.001388889f + (_e7130 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7125 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e7200 / select(1e-12f, _e6990, (_e6990 > 1e-12f))))));
}
let _e7208 = phi_14774_;
if (false || ((_e5360 & 1024u) != 0u)) {
let _e7219 = (_e4868.member - _e5357);
let _e7222 = select(_e4868.member, (_e5357 + (_e7219 * _e5603.member.member)), (_e5603.member.member < 1f));
let _e7228 = select(_e7222, select(_e4868.member, (_e5357 + (_e7219 * _e5603.member.member_1)), (_e5603.member.member_1 < 1f)), (_e5603.member.member_1 > _e5603.member.member));
let _e7230 = (bitcast<i32>(_e181) - 1i);
let _e7232 = select(_e7230, 263211i, (263211i < _e7230));
let _e7238 = global_3.member[bitcast<u32>(select(0i, _e7232, (_e7232 > 0i)))];
let _e7239 = bitcast<f32>(_e7238);
let _e7243 = select(_e7230, 263212i, (263212i < _e7230));
let _e7249 = global_3.member[bitcast<u32>(select(0i, _e7243, (_e7243 > 0i)))];
let _e7250 = bitcast<f32>(_e7249);
let _e7255 = select(_e7230, 263213i, (263213i < _e7230));
let _e7261 = global_3.member[bitcast<u32>(select(0i, _e7255, (_e7255 > 0i)))];
let _e7262 = bitcast<f32>(_e7261);
let _e7266 = select(_e7230, 263214i, (263214i < _e7230));
let _e7272 = global_3.member[bitcast<u32>(select(0i, _e7266, (_e7266 > 0i)))];
let _e7273 = bitcast<f32>(_e7272);
let _e7279 = select(_e7230, 263215i, (263215i < _e7230));
let _e7285 = global_3.member[bitcast<u32>(select(0i, _e7279, (_e7279 > 0i)))];
let _e7286 = bitcast<f32>(_e7285);
let _e7290 = select(_e7230, 263216i, (263216i < _e7230));
let _e7296 = global_3.member[bitcast<u32>(select(0i, _e7290, (_e7290 > 0i)))];
let _e7297 = bitcast<f32>(_e7296);
let _e7302 = select(_e7230, 263217i, (263217i < _e7230));
let _e7308 = global_3.member[bitcast<u32>(select(0i, _e7302, (_e7302 > 0i)))];
let _e7309 = bitcast<f32>(_e7308);
let _e7313 = select(_e7230, 263218i, (263218i < _e7230));
let _e7319 = global_3.member[bitcast<u32>(select(0i, _e7313, (_e7313 > 0i)))];
let _e7320 = bitcast<f32>(_e7319);
let _e7352 = (263219i + ((((((select(0i, 1i, (_e7222 >= _e7239)) + select(0i, 1i, (_e7222 >= _e7250))) + (select(0i, 1i, (_e7222 >= _e7262)) + select(0i, 1i, (_e7222 >= _e7273)))) + ((select(0i, 1i, (_e7222 >= _e7286)) + select(0i, 1i, (_e7222 >= _e7297))) + (select(0i, 1i, (_e7222 >= _e7309)) + select(0i, 1i, (_e7222 >= _e7320))))) * 9i) + (((select(0i, 1i, (_e7228 >= _e7239)) + select(0i, 1i, (_e7228 >= _e7250))) + (select(0i, 1i, (_e7228 >= _e7262)) + select(0i, 1i, (_e7228 >= _e7273)))) + ((select(0i, 1i, (_e7228 >= _e7286)) + select(0i, 1i, (_e7228 >= _e7297))) + (select(0i, 1i, (_e7228 >= _e7309)) + select(0i, 1i, (_e7228 >= _e7320)))))) * 6i));
let _e7354 = select(_e7230, _e7352, (_e7352 < _e7230));
let _e7360 = global_3.member[bitcast<u32>(select(0i, _e7354, (_e7354 > 0i)))];
phi_15172_ = (_e7208.member * select(1f, bitcast<f32>(_e7360), (_e5701 > 0f)));
} else {
phi_15172_ = _e7208.member;
}
let _e7365 = phi_15172_;
if _e1283 {
let _e7370 = global_1.member.member_8.member.member;
let _e7378 = global_1.member.member_8.member_1.member;
let _e7386 = global_1.member.member_8.member_2.member;
let _e7390 = (_e4873 - _e1262);
let _e7391 = -(_e5611);
let _e7394 = (_e5611 - _e7390);
let _e7395 = (_e7390 - _e5611);
let _e7397 = select(_e7395, _e7394, (_e7394 > _e7395));
let _e7400 = (select(_e7391, _e5611, (_e5611 > _e7391)) / select(1e-30f, _e7397, (_e7397 > 1e-30f)));
let _e7402 = (_e7390 < 0f);
let _e7404 = select(0f, select(2f, _e7400, _e7402), (_e5611 > 0f));
let _e7405 = (_e7390 > 0f);
let _e7408 = select(2f, select(0f, _e7400, (_e5611 < 0f)), _e7405);
let _e7409 = (_e5611 > -1e30f);
let _e7413 = ((_e7404 > -1f) || ((_e7404 == -1f) && _e7409));
let _e7414 = (_e7408 < 2f);
let _e7415 = select(-1f, _e7404, _e7413);
let _e7419 = select(2f, _e7408, _e7414);
let _e7423 = select(-1e30f, _e5611, _e7409);
let _e7424 = (_e7390 > -1e30f);
let _e7425 = select(-1e30f, _e7390, _e7424);
let _e7429 = (_e1226 - _e4878);
let _e7430 = (_e1262 - _e4878);
let _e7431 = -(_e7429);
let _e7434 = (_e7429 - _e7430);
let _e7435 = (_e7430 - _e7429);
let _e7437 = select(_e7435, _e7434, (_e7434 > _e7435));
let _e7440 = (select(_e7431, _e7429, (_e7429 > _e7431)) / select(1e-30f, _e7437, (_e7437 > 1e-30f)));
let _e7442 = (_e7430 < 0f);
let _e7444 = select(0f, select(2f, _e7440, _e7442), (_e7429 > 0f));
let _e7445 = (_e7430 > 0f);
let _e7448 = select(2f, select(0f, _e7440, (_e7429 < 0f)), _e7445);
let _e7449 = (_e7429 > _e7423);
let _e7453 = ((_e7444 > _e7415) || ((_e7444 == _e7415) && _e7449));
let _e7454 = (_e7448 < _e7419);
let _e7455 = select(_e7415, _e7444, _e7453);
let _e7459 = select(_e7419, _e7448, _e7454);
let _e7463 = select(_e7423, _e7429, _e7449);
let _e7464 = (_e7430 > _e7425);
let _e7465 = select(_e7425, _e7430, _e7464);
let _e7469 = (_e4887 - _e1268);
let _e7470 = -(_e5640);
let _e7473 = (_e5640 - _e7469);
let _e7474 = (_e7469 - _e5640);
let _e7476 = select(_e7474, _e7473, (_e7473 > _e7474));
let _e7479 = (select(_e7470, _e5640, (_e5640 > _e7470)) / select(1e-30f, _e7476, (_e7476 > 1e-30f)));
let _e7481 = (_e7469 < 0f);
let _e7483 = select(0f, select(2f, _e7479, _e7481), (_e5640 > 0f));
let _e7484 = (_e7469 > 0f);
let _e7487 = select(2f, select(0f, _e7479, (_e5640 < 0f)), _e7484);
let _e7488 = (_e5640 > _e7463);
let _e7492 = ((_e7483 > _e7455) || ((_e7483 == _e7455) && _e7488));
let _e7493 = (_e7487 < _e7459);
let _e7494 = select(_e7455, _e7483, _e7492);
let _e7498 = select(_e7459, _e7487, _e7493);
let _e7502 = select(_e7463, _e5640, _e7488);
let _e7503 = (_e7469 > _e7465);
let _e7504 = select(_e7465, _e7469, _e7503);
let _e7508 = (_e1241 - _e4892);
let _e7509 = (_e1268 - _e4892);
let _e7510 = -(_e7508);
let _e7513 = (_e7508 - _e7509);
let _e7514 = (_e7509 - _e7508);
let _e7516 = select(_e7514, _e7513, (_e7513 > _e7514));
let _e7519 = (select(_e7510, _e7508, (_e7508 > _e7510)) / select(1e-30f, _e7516, (_e7516 > 1e-30f)));
let _e7521 = (_e7509 < 0f);
let _e7523 = select(0f, select(2f, _e7519, _e7521), (_e7508 > 0f));
let _e7524 = (_e7509 > 0f);
let _e7527 = select(2f, select(0f, _e7519, (_e7508 < 0f)), _e7524);
let _e7528 = (_e7508 > _e7502);
let _e7532 = ((_e7523 > _e7494) || ((_e7523 == _e7494) && _e7528));
let _e7533 = (_e7527 < _e7498);
let _e7534 = select(_e7494, _e7523, _e7532);
let _e7538 = select(_e7498, _e7527, _e7533);
let _e7542 = select(_e7502, _e7508, _e7528);
let _e7543 = (_e7509 > _e7504);
let _e7544 = select(_e7504, _e7509, _e7543);
let _e7548 = (_e4901 - _e1274);
let _e7549 = -(_e5669);
let _e7552 = (_e5669 - _e7548);
let _e7553 = (_e7548 - _e5669);
let _e7555 = select(_e7553, _e7552, (_e7552 > _e7553));
let _e7558 = (select(_e7549, _e5669, (_e5669 > _e7549)) / select(1e-30f, _e7555, (_e7555 > 1e-30f)));
let _e7560 = (_e7548 < 0f);
let _e7562 = select(0f, select(2f, _e7558, _e7560), (_e5669 > 0f));
let _e7563 = (_e7548 > 0f);
let _e7566 = select(2f, select(0f, _e7558, (_e5669 < 0f)), _e7563);
let _e7567 = (_e5669 > _e7542);
let _e7571 = ((_e7562 > _e7534) || ((_e7562 == _e7534) && _e7567));
let _e7572 = (_e7566 < _e7538);
let _e7573 = select(_e7534, _e7562, _e7571);
let _e7577 = select(_e7538, _e7566, _e7572);
let _e7581 = select(_e7542, _e5669, _e7567);
let _e7582 = (_e7548 > _e7544);
let _e7583 = select(_e7544, _e7548, _e7582);
let _e7587 = (_e1256 - _e4906);
let _e7588 = (_e1274 - _e4906);
let _e7589 = -(_e7587);
let _e7592 = (_e7587 - _e7588);
let _e7593 = (_e7588 - _e7587);
let _e7595 = select(_e7593, _e7592, (_e7592 > _e7593));
let _e7598 = (select(_e7589, _e7587, (_e7587 > _e7589)) / select(1e-30f, _e7595, (_e7595 > 1e-30f)));
let _e7600 = (_e7588 < 0f);
let _e7602 = select(0f, select(2f, _e7598, _e7600), (_e7587 > 0f));
let _e7603 = (_e7588 > 0f);
let _e7606 = select(2f, select(0f, _e7598, (_e7587 < 0f)), _e7603);
let _e7607 = (_e7587 > _e7581);
let _e7611 = ((_e7602 > _e7573) || ((_e7602 == _e7573) && _e7607));
let _e7612 = (_e7606 < _e7577);
let _e7613 = select(_e7573, _e7602, _e7611);
let _e7614 = select(select(select(select(select(select(0f, _e7370.member, _e7413), _e7370.member, _e7453), _e7378.member, _e7492), _e7378.member, _e7532), _e7386.member, _e7571), _e7386.member, _e7611);
let _e7615 = select(select(select(select(select(select(0f, _e7370.member_1, _e7413), _e7370.member_1, _e7453), _e7378.member_1, _e7492), _e7378.member_1, _e7532), _e7386.member_1, _e7571), _e7386.member_1, _e7611);
let _e7616 = select(select(select(select(select(select(1f, _e7370.member_2, _e7413), _e7370.member_2, _e7453), _e7378.member_2, _e7492), _e7378.member_2, _e7532), _e7386.member_2, _e7571), _e7386.member_2, _e7611);
let _e7618 = select(_e7577, _e7606, _e7612);
let _e7619 = select(select(select(select(select(select(0f, _e7370.member, _e7414), _e7370.member, _e7454), _e7378.member, _e7493), _e7378.member, _e7533), _e7386.member, _e7572), _e7386.member, _e7612);
let _e7620 = select(select(select(select(select(select(0f, _e7370.member_1, _e7414), _e7370.member_1, _e7454), _e7378.member_1, _e7493), _e7378.member_1, _e7533), _e7386.member_1, _e7572), _e7386.member_1, _e7612);
let _e7621 = select(select(select(select(select(select(1f, _e7370.member_2, _e7414), _e7370.member_2, _e7454), _e7378.member_2, _e7493), _e7378.member_2, _e7533), _e7386.member_2, _e7572), _e7386.member_2, _e7612);
let _e7623 = select(_e7581, _e7587, _e7607);
let _e7624 = (_e7588 > _e7583);
let _e7625 = select(_e7583, _e7588, _e7624);
let _e7626 = select(select(select(select(select(select(0f, _e7370.member, _e7409), _e7370.member, _e7449), _e7378.member, _e7488), _e7378.member, _e7528), _e7386.member, _e7567), _e7386.member, _e7607);
let _e7627 = select(select(select(select(select(select(0f, _e7370.member_1, _e7409), _e7370.member_1, _e7449), _e7378.member_1, _e7488), _e7378.member_1, _e7528), _e7386.member_1, _e7567), _e7386.member_1, _e7607);
let _e7628 = select(select(select(select(select(select(1f, _e7370.member_2, _e7409), _e7370.member_2, _e7449), _e7378.member_2, _e7488), _e7378.member_2, _e7528), _e7386.member_2, _e7567), _e7386.member_2, _e7607);
if _e5362 {
phi_16497_ = type_37(_e7613, vec3<f32>(_e7614, _e7615, _e7616), _e7618, vec3<f32>(_e7619, _e7620, _e7621), _e7623, _e7625, vec3<f32>(_e7626, _e7627, _e7628));
} else {
let _e7635 = (((_e7370.member * _e7370.member) + (_e7370.member_1 * _e7370.member_1)) + (_e7370.member_2 * _e7370.member_2));
let _e7638 = sqrt(select(0f, _e7635, (_e7635 > 0f)));
let _e7642 = global_1.member.member_16.member_1;
let _e7643 = (_e7642 != 0u);
let _e7647 = global_1.member.member_16.member;
let _e7667 = select(-1e6f, (((((_e7647.member.member * _e1183) + (_e7647.member.member_1 * _e1196)) + (_e7647.member.member_2 * _e1161)) + _e7647.member_1) * _e7638), _e7643);
let _e7668 = select(-1e6f, (((((_e7647.member.member * _e1206) + (_e7647.member.member_1 * _e1211)) + (_e7647.member.member_2 * _e1200)) + _e7647.member_1) * _e7638), _e7643);
let _e7673 = global_1.member.member_16.member.member;
let _e7677 = -(_e7667);
let _e7680 = (_e7667 - _e7668);
let _e7681 = (_e7668 - _e7667);
let _e7683 = select(_e7681, _e7680, (_e7680 > _e7681));
let _e7686 = (select(_e7677, _e7667, (_e7667 > _e7677)) / select(1e-30f, _e7683, (_e7683 > 1e-30f)));
let _e7690 = select(0f, select(2f, _e7686, (_e7668 < 0f)), (_e7667 > 0f));
let _e7694 = select(2f, select(0f, _e7686, (_e7667 < 0f)), (_e7668 > 0f));
let _e7695 = (_e7667 > _e7623);
let _e7699 = ((_e7690 > _e7613) || ((_e7690 == _e7613) && _e7695));
let _e7700 = (_e7694 < _e7618);
let _e7701 = select(_e7613, _e7690, _e7699);
let _e7705 = select(_e7618, _e7694, _e7700);
let _e7709 = select(_e7623, _e7667, _e7695);
let _e7711 = select(_e7625, _e7668, (_e7668 > _e7625));
let _e7718 = global_1.member.member_17.member_1;
let _e7719 = (_e7718 != 0u);
let _e7723 = global_1.member.member_17.member;
let _e7743 = select(-1e6f, (((((_e7723.member.member * _e1183) + (_e7723.member.member_1 * _e1196)) + (_e7723.member.member_2 * _e1161)) + _e7723.member_1) * _e7638), _e7719);
let _e7744 = select(-1e6f, (((((_e7723.member.member * _e1206) + (_e7723.member.member_1 * _e1211)) + (_e7723.member.member_2 * _e1200)) + _e7723.member_1) * _e7638), _e7719);
let _e7749 = global_1.member.member_17.member.member;
let _e7753 = -(_e7743);
let _e7756 = (_e7743 - _e7744);
let _e7757 = (_e7744 - _e7743);
let _e7759 = select(_e7757, _e7756, (_e7756 > _e7757));
let _e7762 = (select(_e7753, _e7743, (_e7743 > _e7753)) / select(1e-30f, _e7759, (_e7759 > 1e-30f)));
let _e7766 = select(0f, select(2f, _e7762, (_e7744 < 0f)), (_e7743 > 0f));
let _e7770 = select(2f, select(0f, _e7762, (_e7743 < 0f)), (_e7744 > 0f));
let _e7771 = (_e7743 > _e7709);
let _e7775 = ((_e7766 > _e7701) || ((_e7766 == _e7701) && _e7771));
let _e7776 = (_e7770 < _e7705);
let _e7777 = select(_e7701, _e7766, _e7775);
let _e7781 = select(_e7705, _e7770, _e7776);
let _e7785 = select(_e7709, _e7743, _e7771);
let _e7787 = select(_e7711, _e7744, (_e7744 > _e7711));
let _e7794 = global_1.member.member_18.member_1;
let _e7795 = (_e7794 != 0u);
let _e7799 = global_1.member.member_18.member;
let _e7819 = select(-1e6f, (((((_e7799.member.member * _e1183) + (_e7799.member.member_1 * _e1196)) + (_e7799.member.member_2 * _e1161)) + _e7799.member_1) * _e7638), _e7795);
let _e7820 = select(-1e6f, (((((_e7799.member.member * _e1206) + (_e7799.member.member_1 * _e1211)) + (_e7799.member.member_2 * _e1200)) + _e7799.member_1) * _e7638), _e7795);
let _e7825 = global_1.member.member_18.member.member;
let _e7829 = -(_e7819);
let _e7832 = (_e7819 - _e7820);
let _e7833 = (_e7820 - _e7819);
let _e7835 = select(_e7833, _e7832, (_e7832 > _e7833));
let _e7838 = (select(_e7829, _e7819, (_e7819 > _e7829)) / select(1e-30f, _e7835, (_e7835 > 1e-30f)));
let _e7842 = select(0f, select(2f, _e7838, (_e7820 < 0f)), (_e7819 > 0f));
let _e7846 = select(2f, select(0f, _e7838, (_e7819 < 0f)), (_e7820 > 0f));
let _e7847 = (_e7819 > _e7785);
let _e7851 = ((_e7842 > _e7777) || ((_e7842 == _e7777) && _e7847));
let _e7852 = (_e7846 < _e7781);
let _e7853 = select(_e7777, _e7842, _e7851);
let _e7857 = select(_e7781, _e7846, _e7852);
let _e7861 = select(_e7785, _e7819, _e7847);
let _e7863 = select(_e7787, _e7820, (_e7820 > _e7787));
let _e7870 = global_1.member.member_19.member_1;
let _e7871 = (_e7870 != 0u);
let _e7875 = global_1.member.member_19.member;
let _e7895 = select(-1e6f, (((((_e7875.member.member * _e1183) + (_e7875.member.member_1 * _e1196)) + (_e7875.member.member_2 * _e1161)) + _e7875.member_1) * _e7638), _e7871);
let _e7896 = select(-1e6f, (((((_e7875.member.member * _e1206) + (_e7875.member.member_1 * _e1211)) + (_e7875.member.member_2 * _e1200)) + _e7875.member_1) * _e7638), _e7871);
let _e7901 = global_1.member.member_19.member.member;
let _e7905 = -(_e7895);
let _e7908 = (_e7895 - _e7896);
let _e7909 = (_e7896 - _e7895);
let _e7911 = select(_e7909, _e7908, (_e7908 > _e7909));
let _e7914 = (select(_e7905, _e7895, (_e7895 > _e7905)) / select(1e-30f, _e7911, (_e7911 > 1e-30f)));
let _e7918 = select(0f, select(2f, _e7914, (_e7896 < 0f)), (_e7895 > 0f));
let _e7922 = select(2f, select(0f, _e7914, (_e7895 < 0f)), (_e7896 > 0f));
let _e7923 = (_e7895 > _e7861);
let _e7927 = ((_e7918 > _e7853) || ((_e7918 == _e7853) && _e7923));
let _e7928 = (_e7922 < _e7857);
phi_16497_ = type_37(select(_e7853, _e7918, _e7927), vec3<f32>(select(select(select(select(_e7614, _e7673.member, _e7699), _e7749.member, _e7775), _e7825.member, _e7851), _e7901.member, _e7927), select(select(select(select(_e7615, _e7673.member_1, _e7699), _e7749.member_1, _e7775), _e7825.member_1, _e7851), _e7901.member_1, _e7927), select(select(select(select(_e7616, _e7673.member_2, _e7699), _e7749.member_2, _e7775), _e7825.member_2, _e7851), _e7901.member_2, _e7927)), select(_e7857, _e7922, _e7928), vec3<f32>(select(select(select(select(_e7619, _e7673.member, _e7700), _e7749.member, _e7776), _e7825.member, _e7852), _e7901.member, _e7928), select(select(select(select(_e7620, _e7673.member_1, _e7700), _e7749.member_1, _e7776), _e7825.member_1, _e7852), _e7901.member_1, _e7928), select(select(select(select(_e7621, _e7673.member_2, _e7700), _e7749.member_2, _e7776), _e7825.member_2, _e7852), _e7901.member_2, _e7928)), select(_e7861, _e7895, _e7923), select(_e7863, _e7896, (_e7896 > _e7863)), vec3<f32>(select(select(select(select(_e7626, _e7673.member, _e7695), _e7749.member, _e7771), _e7825.member, _e7847), _e7901.member, _e7923), select(select(select(select(_e7627, _e7673.member_1, _e7695), _e7749.member_1, _e7771), _e7825.member_1, _e7847), _e7901.member_1, _e7923), select(select(select(select(_e7628, _e7673.member_2, _e7695), _e7749.member_2, _e7771), _e7825.member_2, _e7847), _e7901.member_2, _e7923)));
}
let _e7948 = phi_16497_;
let _e7950 = (_e7948.member_4 < 0f);
let _e7952 = (_e7948.member_5 < 0f);
let _e7953 = (_e7950 != _e7952);
if _e7950 {
phi_16510_ = _e7948.member_3;
phi_16511_ = _e7948.member_2;
} else {
phi_16510_ = _e7948.member_1;
phi_16511_ = _e7948.member;
}
let _e7959 = phi_16510_;
let _e7961 = phi_16511_;
let _e7970 = (((_e7370.member * _e7370.member) + (_e7370.member_1 * _e7370.member_1)) + (_e7370.member_2 * _e7370.member_2));
let _e7973 = sqrt(select(0f, _e7970, (_e7970 > 0f)));
let _e7974 = ((1.5f * _e1181) * _e7973);
let _e7979 = select(0f, _e7961, _e7953);
let _e7983 = (_e1183 + (_e5702 * _e7979));
let _e7984 = (_e1196 + (_e5703 * _e7979));
let _e7985 = (_e1161 + (_e5704 * _e7979));
let _e7991 = ((((_e1215.member.member * _e7983) + (_e1215.member.member_1 * _e7984)) + (_e1215.member.member_2 * _e7985)) + _e1215.member_1);
let _e7997 = ((((_e1230.member.member * _e7983) + (_e1230.member.member_1 * _e7984)) + (_e1230.member.member_2 * _e7985)) + _e1230.member_1);
let _e8003 = ((((_e1245.member.member * _e7983) + (_e1245.member.member_1 * _e7984)) + (_e1245.member.member_2 * _e7985)) + _e1245.member_1);
let _e8005 = select(_e4873, _e7991, (_e7991 > _e4873));
let _e8007 = select(_e4878, _e8005, (_e8005 < _e4878));
let _e8009 = select(_e4887, _e7997, (_e7997 > _e4887));
let _e8011 = select(_e4892, _e8009, (_e8009 < _e4892));
let _e8013 = select(_e4901, _e8003, (_e8003 > _e4901));
let _e8015 = select(_e4906, _e8013, (_e8013 < _e4906));
if _e4916 {
phi_16741_ = vec3<f32>(_e8007, _e8011, _e8015);
} else {
let _e8017 = (_e8007 + 0.5f);
let _e8018 = (_e4994 - 1f);
let _e8020 = select(0f, _e8017, (_e8017 > 0f));
let _e8022 = select(_e8018, _e8020, (_e8020 < _e8018));
let _e8029 = select(0i, select(select(i32(_e8022), i32(-2147483648), (_e8022 < -2147483600f)), 2147483647i, (_e8022 > 2147483500f)), (_e8022 == _e8022));
let _e8035 = (_e8011 + 0.5f);
let _e8036 = (_e5015 - 1f);
let _e8038 = select(0f, _e8035, (_e8035 > 0f));
let _e8040 = select(_e8036, _e8038, (_e8038 < _e8036));
let _e8047 = select(0i, select(select(i32(_e8040), i32(-2147483648), (_e8040 < -2147483600f)), 2147483647i, (_e8040 > 2147483500f)), (_e8040 == _e8040));
let _e8053 = (_e8015 + 0.5f);
let _e8054 = (_e5036 - 1f);
let _e8056 = select(0f, _e8053, (_e8053 > 0f));
let _e8058 = select(_e8054, _e8056, (_e8056 < _e8054));
let _e8065 = select(0i, select(select(i32(_e8058), i32(-2147483648), (_e8058 < -2147483600f)), 2147483647i, (_e8058 > 2147483500f)), (_e8058 == _e8058));
phi_16741_ = vec3<f32>(f32((_e8029 - select(0i, 1i, (_e8022 < f32(_e8029))))), f32((_e8047 - select(0i, 1i, (_e8040 < f32(_e8047))))), f32((_e8065 - select(0i, 1i, (_e8058 < f32(_e8065))))));
}
let _e8073 = phi_16741_;
let _e8076 = select(-1f, _e8073.x, (_e8073.x > -1f));
let _e8078 = select(_e4994, _e8076, (_e8076 < _e4994));
let _e8085 = select(0i, select(select(i32(_e8078), i32(-2147483648), (_e8078 < -2147483600f)), 2147483647i, (_e8078 > 2147483500f)), (_e8078 == _e8078));
let _e8089 = (_e8085 - select(0i, 1i, (_e8078 < f32(_e8085))));
let _e8092 = select(-1f, _e8073.y, (_e8073.y > -1f));
let _e8094 = select(_e5015, _e8092, (_e8092 < _e5015));
let _e8101 = select(0i, select(select(i32(_e8094), i32(-2147483648), (_e8094 < -2147483600f)), 2147483647i, (_e8094 > 2147483500f)), (_e8094 == _e8094));
let _e8105 = (_e8101 - select(0i, 1i, (_e8094 < f32(_e8101))));
let _e8108 = select(-1f, _e8073.z, (_e8073.z > -1f));
let _e8110 = select(_e5036, _e8108, (_e8108 < _e5036));
let _e8117 = select(0i, select(select(i32(_e8110), i32(-2147483648), (_e8110 < -2147483600f)), 2147483647i, (_e8110 > 2147483500f)), (_e8110 == _e8110));
let _e8121 = (_e8117 - select(0i, 1i, (_e8110 < f32(_e8117))));
let _e8122 = (_e8089 + 1i);
let _e8123 = (_e8105 + 1i);
let _e8124 = (_e8121 + 1i);
let _e8134 = ((_e8122 >> bitcast<u32>(4i)) + (_e5068 * ((_e8123 >> bitcast<u32>(4i)) + (_e5074 * (_e8124 >> bitcast<u32>(4i))))));
let _e8136 = select(_e5086, _e8134, (_e8134 < _e5086));
let _e8142 = global_2.member[bitcast<u32>(select(0i, _e8136, (_e8136 > 0i)))];
let _e8144 = (_e8122 & 15i);
let _e8147 = ((_e8123 & 15i) * _e5055);
let _e8149 = (bitcast<i32>(_e8142) + ((_e8124 & 15i) * _e5059));
let _e8150 = (_e8147 + _e5055);
let _e8151 = (_e8147 + _e5103);
let _e8152 = (_e8149 + _e5059);
let _e8153 = (_e8149 + _e5106);
local_2 = type_30(array<i32, 4>(_e8144, _e8144, _e8144, _e8144), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = (_e8073 - vec3<f32>(f32(_e8089), f32(_e8105), f32(_e8121)));
let _e8165 = local_2.member[0u];
let _e8166 = ((_e8152 + _e8150) + _e8165);
let _e8168 = (_e8166 >> bitcast<u32>(2i));
let _e8171 = bitcast<u32>(((_e8166 & 3i) * 8i));
let _e8173 = select(_e5086, _e8168, (_e8168 < _e5086));
let _e8178 = global_2.member[bitcast<u32>(select(0i, _e8173, (_e8173 > 0i)))];
let _e8182 = (_e8168 + 1i);
let _e8184 = select(_e5086, _e8182, (_e8182 < _e5086));
let _e8189 = global_2.member[bitcast<u32>(select(0i, _e8184, (_e8184 > 0i)))];
let _e8196 = ((_e8178 >> bitcast<u32>((_e8171 & 31u))) | ((_e8189 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8171) & 31u))));
let _e8199 = local_2.member_1[1u];
let _e8205 = f32(bitcast<i32>(((_e8196 >> bitcast<u32>((_e8199 & 31u))) & 255u)));
let _e8208 = local_2.member_1[2u];
let _e8215 = local_3[0u];
let _e8218 = (_e8205 + ((f32(bitcast<i32>(((_e8196 >> bitcast<u32>((_e8208 & 31u))) & 255u))) - _e8205) * _e8215));
let _e8220 = local_2.member[0u];
let _e8221 = ((_e8152 + _e8151) + _e8220);
let _e8223 = (_e8221 >> bitcast<u32>(2i));
let _e8226 = bitcast<u32>(((_e8221 & 3i) * 8i));
let _e8228 = select(_e5086, _e8223, (_e8223 < _e5086));
let _e8233 = global_2.member[bitcast<u32>(select(0i, _e8228, (_e8228 > 0i)))];
let _e8237 = (_e8223 + 1i);
let _e8239 = select(_e5086, _e8237, (_e8237 < _e5086));
let _e8244 = global_2.member[bitcast<u32>(select(0i, _e8239, (_e8239 > 0i)))];
let _e8251 = ((_e8233 >> bitcast<u32>((_e8226 & 31u))) | ((_e8244 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8226) & 31u))));
let _e8252 = local_2.member_1[1u];
let _e8258 = f32(bitcast<i32>(((_e8251 >> bitcast<u32>((_e8252 & 31u))) & 255u)));
let _e8259 = local_2.member_1[2u];
let _e8266 = local_3[0u];
let _e8271 = local_3[1u];
let _e8274 = (_e8218 + (((_e8258 + ((f32(bitcast<i32>(((_e8251 >> bitcast<u32>((_e8259 & 31u))) & 255u))) - _e8258) * _e8266)) - _e8218) * _e8271));
let _e8276 = local_2.member[0u];
let _e8277 = ((_e8153 + _e8150) + _e8276);
let _e8279 = (_e8277 >> bitcast<u32>(2i));
let _e8282 = bitcast<u32>(((_e8277 & 3i) * 8i));
let _e8284 = select(_e5086, _e8279, (_e8279 < _e5086));
let _e8289 = global_2.member[bitcast<u32>(select(0i, _e8284, (_e8284 > 0i)))];
let _e8293 = (_e8279 + 1i);
let _e8295 = select(_e5086, _e8293, (_e8293 < _e5086));
let _e8300 = global_2.member[bitcast<u32>(select(0i, _e8295, (_e8295 > 0i)))];
let _e8307 = ((_e8289 >> bitcast<u32>((_e8282 & 31u))) | ((_e8300 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8282) & 31u))));
let _e8308 = local_2.member_1[1u];
let _e8314 = f32(bitcast<i32>(((_e8307 >> bitcast<u32>((_e8308 & 31u))) & 255u)));
let _e8315 = local_2.member_1[2u];
let _e8322 = local_3[0u];
let _e8325 = (_e8314 + ((f32(bitcast<i32>(((_e8307 >> bitcast<u32>((_e8315 & 31u))) & 255u))) - _e8314) * _e8322));
let _e8327 = local_2.member[0u];
let _e8328 = ((_e8153 + _e8151) + _e8327);
let _e8330 = (_e8328 >> bitcast<u32>(2i));
let _e8333 = bitcast<u32>(((_e8328 & 3i) * 8i));
let _e8335 = select(_e5086, _e8330, (_e8330 < _e5086));
let _e8340 = global_2.member[bitcast<u32>(select(0i, _e8335, (_e8335 > 0i)))];
let _e8344 = (_e8330 + 1i);
let _e8346 = select(_e5086, _e8344, (_e8344 < _e5086));
let _e8351 = global_2.member[bitcast<u32>(select(0i, _e8346, (_e8346 > 0i)))];
let _e8358 = ((_e8340 >> bitcast<u32>((_e8333 & 31u))) | ((_e8351 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8333) & 31u))));
let _e8359 = local_2.member_1[1u];
let _e8365 = f32(bitcast<i32>(((_e8358 >> bitcast<u32>((_e8359 & 31u))) & 255u)));
let _e8366 = local_2.member_1[2u];
let _e8373 = local_3[0u];
let _e8377 = local_3[1u];
let _e8382 = local_3[2u];
let _e8387 = (((_e8274 + (((_e8325 + (((_e8365 + ((f32(bitcast<i32>(((_e8358 >> bitcast<u32>((_e8366 & 31u))) & 255u))) - _e8365) * _e8373)) - _e8325) * _e8377)) - _e8274) * _e8382)) - _e5343) * _e5347);
let _e8389 = select(_e5350, _e8387, (_e8387 > _e5350));
local = select(1e9f, _e8389, (_e8389 < 1e9f));
let _e8392 = local;
local_1 = _e8392;
let _e8393 = local_1;
let _e8395 = (bitcast<i32>(_e181) - 1i);
let _e8397 = select(_e8395, 263197i, (263197i < _e8395));
let _e8402 = global_3.member[bitcast<u32>(select(0i, _e8397, (_e8397 > 0i)))];
let _e8405 = select(_e8395, 263198i, (263198i < _e8395));
let _e8410 = global_3.member[bitcast<u32>(select(0i, _e8405, (_e8405 > 0i)))];
let _e8413 = select(_e8395, 263199i, (263199i < _e8395));
let _e8418 = global_3.member[bitcast<u32>(select(0i, _e8413, (_e8413 > 0i)))];
let _e8419 = bitcast<f32>(_e8418);
let _e8421 = ((_e8393 - bitcast<f32>(_e8402)) * bitcast<f32>(_e8410));
let _e8423 = select(0f, _e8421, (_e8421 > 0f));
let _e8426 = local_1;
let _e8428 = select(_e8395, 263200i, (263200i < _e8395));
let _e8433 = global_3.member[bitcast<u32>(select(0i, _e8428, (_e8428 > 0i)))];
let _e8436 = select(_e8395, 263201i, (263201i < _e8395));
let _e8441 = global_3.member[bitcast<u32>(select(0i, _e8436, (_e8436 > 0i)))];
let _e8444 = select(_e8395, 263202i, (263202i < _e8395));
let _e8449 = global_3.member[bitcast<u32>(select(0i, _e8444, (_e8444 > 0i)))];
let _e8450 = bitcast<f32>(_e8449);
let _e8452 = ((_e8426 - bitcast<f32>(_e8433)) * bitcast<f32>(_e8441));
let _e8454 = select(0f, _e8452, (_e8452 > 0f));
let _e8458 = local_1;
let _e8460 = select(_e8395, 263203i, (263203i < _e8395));
let _e8465 = global_3.member[bitcast<u32>(select(0i, _e8460, (_e8460 > 0i)))];
let _e8468 = select(_e8395, 263204i, (263204i < _e8395));
let _e8473 = global_3.member[bitcast<u32>(select(0i, _e8468, (_e8468 > 0i)))];
let _e8476 = select(_e8395, 263205i, (263205i < _e8395));
let _e8481 = global_3.member[bitcast<u32>(select(0i, _e8476, (_e8476 > 0i)))];
let _e8482 = bitcast<f32>(_e8481);
let _e8484 = ((_e8458 - bitcast<f32>(_e8465)) * bitcast<f32>(_e8473));
let _e8486 = select(0f, _e8484, (_e8484 > 0f));
let _e8489 = local_1;
let _e8491 = select(_e8395, 263206i, (263206i < _e8395));
let _e8496 = global_3.member[bitcast<u32>(select(0i, _e8491, (_e8491 > 0i)))];
let _e8499 = select(_e8395, 263207i, (263207i < _e8395));
let _e8504 = global_3.member[bitcast<u32>(select(0i, _e8499, (_e8499 > 0i)))];
let _e8507 = select(_e8395, 263208i, (263208i < _e8395));
let _e8512 = global_3.member[bitcast<u32>(select(0i, _e8507, (_e8507 > 0i)))];
let _e8513 = bitcast<f32>(_e8512);
let _e8515 = ((_e8489 - bitcast<f32>(_e8496)) * bitcast<f32>(_e8504));
let _e8517 = select(0f, _e8515, (_e8515 > 0f));
let _e8521 = ((select(_e8419, _e8423, (_e8423 < _e8419)) + select(_e8450, _e8454, (_e8454 < _e8450))) + (select(_e8482, _e8486, (_e8486 < _e8482)) + select(_e8513, _e8517, (_e8517 < _e8513))));
let _e8523 = select(0f, _e8521, (_e8521 > 0f));
let _e8525 = select(1023f, _e8523, (_e8523 < 1023f));
let _e8532 = select(0i, select(select(i32(_e8525), i32(-2147483648), (_e8525 < -2147483600f)), 2147483647i, (_e8525 > 2147483500f)), (_e8525 == _e8525));
let _e8536 = (_e8532 - select(0i, 1i, (_e8525 < f32(_e8532))));
let _e8537 = (262147i + _e8536);
let _e8539 = select(_e8395, _e8537, (_e8537 < _e8395));
let _e8545 = global_3.member[bitcast<u32>(select(0i, _e8539, (_e8539 > 0i)))];
let _e8555 = select(_e8395, 262146i, (262146i < _e8395));
let _e8561 = global_3.member[bitcast<u32>(select(0i, _e8555, (_e8555 > 0i)))];
let _e8565 = select(_e8395, 262144i, (262144i < _e8395));
let _e8571 = global_3.member[bitcast<u32>(select(0i, _e8565, (_e8565 > 0i)))];
let _e8574 = select(_e8395, 262145i, (262145i < _e8395));
let _e8580 = global_3.member[bitcast<u32>(select(0i, _e8574, (_e8574 > 0i)))];
let _e8587 = ((bitcast<f32>(_e8571) + (f32(bitcast<i32>((_e8545 >> bitcast<u32>(12u)))) * bitcast<f32>(_e8580))) + ((f32((bitcast<i32>((_e8545 & 4095u)) - 2048i)) * bitcast<f32>(_e8561)) * (_e8521 - f32(_e8536))));
let _e8591 = select(_e7948.member_6.x, _e7959.x, _e7953);
let _e8594 = select(_e7948.member_6.y, _e7959.y, _e7953);
let _e8597 = select(_e7948.member_6.z, _e7959.z, _e7953);
let _e8598 = select(1f, _e8587, _e7952);
let _e8603 = (((_e8591 * _e8591) + (_e8594 * _e8594)) + (_e8597 * _e8597));
let _e8606 = sqrt(select(0f, _e8603, (_e8603 > 0f)));
let _e8609 = (1f / select(1e-20f, _e8606, (_e8606 > 1e-20f)));
let _e8610 = (_e8591 * _e8609);
let _e8611 = (_e8594 * _e8609);
let _e8612 = (_e8597 * _e8609);
let _e8617 = (((_e249 * _e8610) + (_e260 * _e8611)) + (_e271 * _e8612));
let _e8622 = (((_e249 * _e249) + (_e260 * _e260)) + (_e271 * _e271));
let _e8624 = ((_e8598 * _e8598) - _e8622);
let _e8625 = (_e8617 * _e8617);
let _e8626 = (_e8625 + _e8624);
let _e8629 = sqrt(select(0f, _e8626, (_e8626 > 0f)));
let _e8633 = (_e8626 <= 0f);
let _e8636 = select((select(_e8629, -(_e8629), (_e8617 < 0f)) - _e8617), (-2f * _e8617), _e8633);
let _e8637 = (_e8624 == 0f);
let _e8648 = (_e8633 && (_e8624 != 0f));
let _e8654 = (!(_e7953) && (_e8648 || (_e8625 < ((0.1f * 0.1f) * _e8622))));
let _e8656 = select(1e-12f, _e8622, (_e8622 > 1e-12f));
let _e8660 = (_e8598 / sqrt(select(0f, _e8656, (_e8656 > 0f))));
let _e8672 = ((_e7953 || (bitcast<f32>((bitcast<u32>(_e7948.member_4) & 2147483647u)) < select(1f, _e7974, (_e7974 < 1f)))) && (_e8587 != 1f));
let _e8673 = select(_e249, select(select(select((_e249 + (_e8610 * _e8636)), _e249, _e8637), _e249, _e8648), (_e249 * _e8660), _e8654), _e8672);
let _e8674 = select(_e260, select(select(select((_e260 + (_e8611 * _e8636)), _e260, _e8637), _e260, _e8648), (_e260 * _e8660), _e8654), _e8672);
let _e8675 = select(_e271, select(select(select((_e271 + (_e8612 * _e8636)), _e271, _e8637), _e271, _e8648), (_e271 * _e8660), _e8654), _e8672);
let _e8687 = global_1.member.member_7.member_2;
let _e8690 = (_e8687 / select(1e-6f, _e8675, (_e8675 > 1e-6f)));
let _e8694 = (_e1206 + (_e8673 * _e8690));
let _e8695 = (_e1211 + (_e8674 * _e8690));
let _e8696 = (_e1200 + (_e8675 * _e8690));
let _e8702 = ((((_e1215.member.member * _e8694) + (_e1215.member.member_1 * _e8695)) + (_e1215.member.member_2 * _e8696)) + _e1215.member_1);
let _e8708 = ((((_e1230.member.member * _e8694) + (_e1230.member.member_1 * _e8695)) + (_e1230.member.member_2 * _e8696)) + _e1230.member_1);
let _e8714 = ((((_e1245.member.member * _e8694) + (_e1245.member.member_1 * _e8695)) + (_e1245.member.member_2 * _e8696)) + _e1245.member_1);
let _e8715 = (_e4873 - _e8702);
let _e8716 = -(_e7390);
let _e8719 = (_e7390 - _e8715);
let _e8720 = (_e8715 - _e7390);
let _e8722 = select(_e8720, _e8719, (_e8719 > _e8720));
let _e8725 = (select(_e8716, _e7390, (_e7390 > _e8716)) / select(1e-30f, _e8722, (_e8722 > 1e-30f)));
let _e8728 = select(0f, select(2f, _e8725, (_e8715 < 0f)), _e7405);
let _e8731 = select(2f, select(0f, _e8725, _e7402), (_e8715 > 0f));
let _e8735 = ((_e8728 > -1f) || ((_e8728 == -1f) && _e7424));
let _e8736 = (_e8731 < 2f);
let _e8737 = select(-1f, _e8728, _e8735);
let _e8741 = select(2f, _e8731, _e8736);
let _e8746 = select(-1e30f, _e8715, (_e8715 > -1e30f));
let _e8750 = (_e8702 - _e4878);
let _e8751 = -(_e7430);
let _e8754 = (_e7430 - _e8750);
let _e8755 = (_e8750 - _e7430);
let _e8757 = select(_e8755, _e8754, (_e8754 > _e8755));
let _e8760 = (select(_e8751, _e7430, (_e7430 > _e8751)) / select(1e-30f, _e8757, (_e8757 > 1e-30f)));
let _e8763 = select(0f, select(2f, _e8760, (_e8750 < 0f)), _e7445);
let _e8766 = select(2f, select(0f, _e8760, _e7442), (_e8750 > 0f));
let _e8770 = ((_e8763 > _e8737) || ((_e8763 == _e8737) && _e7464));
let _e8771 = (_e8766 < _e8741);
let _e8772 = select(_e8737, _e8763, _e8770);
let _e8776 = select(_e8741, _e8766, _e8771);
let _e8781 = select(_e8746, _e8750, (_e8750 > _e8746));
let _e8785 = (_e4887 - _e8708);
let _e8786 = -(_e7469);
let _e8789 = (_e7469 - _e8785);
let _e8790 = (_e8785 - _e7469);
let _e8792 = select(_e8790, _e8789, (_e8789 > _e8790));
let _e8795 = (select(_e8786, _e7469, (_e7469 > _e8786)) / select(1e-30f, _e8792, (_e8792 > 1e-30f)));
let _e8798 = select(0f, select(2f, _e8795, (_e8785 < 0f)), _e7484);
let _e8801 = select(2f, select(0f, _e8795, _e7481), (_e8785 > 0f));
let _e8805 = ((_e8798 > _e8772) || ((_e8798 == _e8772) && _e7503));
let _e8806 = (_e8801 < _e8776);
let _e8807 = select(_e8772, _e8798, _e8805);
let _e8811 = select(_e8776, _e8801, _e8806);
let _e8816 = select(_e8781, _e8785, (_e8785 > _e8781));
let _e8820 = (_e8708 - _e4892);
let _e8821 = -(_e7509);
let _e8824 = (_e7509 - _e8820);
let _e8825 = (_e8820 - _e7509);
let _e8827 = select(_e8825, _e8824, (_e8824 > _e8825));
let _e8830 = (select(_e8821, _e7509, (_e7509 > _e8821)) / select(1e-30f, _e8827, (_e8827 > 1e-30f)));
let _e8833 = select(0f, select(2f, _e8830, (_e8820 < 0f)), _e7524);
let _e8836 = select(2f, select(0f, _e8830, _e7521), (_e8820 > 0f));
let _e8840 = ((_e8833 > _e8807) || ((_e8833 == _e8807) && _e7543));
let _e8841 = (_e8836 < _e8811);
let _e8842 = select(_e8807, _e8833, _e8840);
let _e8846 = select(_e8811, _e8836, _e8841);
let _e8851 = select(_e8816, _e8820, (_e8820 > _e8816));
let _e8855 = (_e4901 - _e8714);
let _e8856 = -(_e7548);
let _e8859 = (_e7548 - _e8855);
let _e8860 = (_e8855 - _e7548);
let _e8862 = select(_e8860, _e8859, (_e8859 > _e8860));
let _e8865 = (select(_e8856, _e7548, (_e7548 > _e8856)) / select(1e-30f, _e8862, (_e8862 > 1e-30f)));
let _e8868 = select(0f, select(2f, _e8865, (_e8855 < 0f)), _e7563);
let _e8871 = select(2f, select(0f, _e8865, _e7560), (_e8855 > 0f));
let _e8875 = ((_e8868 > _e8842) || ((_e8868 == _e8842) && _e7582));
let _e8876 = (_e8871 < _e8846);
let _e8877 = select(_e8842, _e8868, _e8875);
let _e8881 = select(_e8846, _e8871, _e8876);
let _e8886 = select(_e8851, _e8855, (_e8855 > _e8851));
let _e8890 = (_e8714 - _e4906);
let _e8891 = -(_e7588);
let _e8894 = (_e7588 - _e8890);
let _e8895 = (_e8890 - _e7588);
let _e8897 = select(_e8895, _e8894, (_e8894 > _e8895));
let _e8900 = (select(_e8891, _e7588, (_e7588 > _e8891)) / select(1e-30f, _e8897, (_e8897 > 1e-30f)));
let _e8903 = select(0f, select(2f, _e8900, (_e8890 < 0f)), _e7603);
let _e8906 = select(2f, select(0f, _e8900, _e7600), (_e8890 > 0f));
let _e8910 = ((_e8903 > _e8877) || ((_e8903 == _e8877) && _e7624));
let _e8911 = (_e8906 < _e8881);
let _e8912 = select(_e8877, _e8903, _e8910);
let _e8913 = select(select(select(select(select(select(0f, _e7370.member, _e8735), _e7370.member, _e8770), _e7378.member, _e8805), _e7378.member, _e8840), _e7386.member, _e8875), _e7386.member, _e8910);
let _e8914 = select(select(select(select(select(select(0f, _e7370.member_1, _e8735), _e7370.member_1, _e8770), _e7378.member_1, _e8805), _e7378.member_1, _e8840), _e7386.member_1, _e8875), _e7386.member_1, _e8910);
let _e8915 = select(select(select(select(select(select(1f, _e7370.member_2, _e8735), _e7370.member_2, _e8770), _e7378.member_2, _e8805), _e7378.member_2, _e8840), _e7386.member_2, _e8875), _e7386.member_2, _e8910);
let _e8917 = select(_e8881, _e8906, _e8911);
let _e8918 = select(select(select(select(select(select(0f, _e7370.member, _e8736), _e7370.member, _e8771), _e7378.member, _e8806), _e7378.member, _e8841), _e7386.member, _e8876), _e7386.member, _e8911);
let _e8919 = select(select(select(select(select(select(0f, _e7370.member_1, _e8736), _e7370.member_1, _e8771), _e7378.member_1, _e8806), _e7378.member_1, _e8841), _e7386.member_1, _e8876), _e7386.member_1, _e8911);
let _e8920 = select(select(select(select(select(select(1f, _e7370.member_2, _e8736), _e7370.member_2, _e8771), _e7378.member_2, _e8806), _e7378.member_2, _e8841), _e7386.member_2, _e8876), _e7386.member_2, _e8911);
let _e8923 = select(_e8886, _e8890, (_e8890 > _e8886));
let _e8924 = select(select(select(select(select(select(0f, _e7370.member, _e7424), _e7370.member, _e7464), _e7378.member, _e7503), _e7378.member, _e7543), _e7386.member, _e7582), _e7386.member, _e7624);
let _e8925 = select(select(select(select(select(select(0f, _e7370.member_1, _e7424), _e7370.member_1, _e7464), _e7378.member_1, _e7503), _e7378.member_1, _e7543), _e7386.member_1, _e7582), _e7386.member_1, _e7624);
let _e8926 = select(select(select(select(select(select(1f, _e7370.member_2, _e7424), _e7370.member_2, _e7464), _e7378.member_2, _e7503), _e7378.member_2, _e7543), _e7386.member_2, _e7582), _e7386.member_2, _e7624);
if _e5362 {
phi_19292_ = type_37(_e8912, vec3<f32>(_e8913, _e8914, _e8915), _e8917, vec3<f32>(_e8918, _e8919, _e8920), _e7625, _e8923, vec3<f32>(_e8924, _e8925, _e8926));
} else {
let _e8932 = global_1.member.member_16.member_1;
let _e8933 = (_e8932 != 0u);
let _e8937 = global_1.member.member_16.member;
let _e8957 = select(-1e6f, (((((_e8937.member.member * _e1206) + (_e8937.member.member_1 * _e1211)) + (_e8937.member.member_2 * _e1200)) + _e8937.member_1) * _e7973), _e8933);
let _e8958 = select(-1e6f, (((((_e8937.member.member * _e8694) + (_e8937.member.member_1 * _e8695)) + (_e8937.member.member_2 * _e8696)) + _e8937.member_1) * _e7973), _e8933);
let _e8963 = global_1.member.member_16.member.member;
let _e8967 = -(_e8957);
let _e8970 = (_e8957 - _e8958);
let _e8971 = (_e8958 - _e8957);
let _e8973 = select(_e8971, _e8970, (_e8970 > _e8971));
let _e8976 = (select(_e8967, _e8957, (_e8957 > _e8967)) / select(1e-30f, _e8973, (_e8973 > 1e-30f)));
let _e8980 = select(0f, select(2f, _e8976, (_e8958 < 0f)), (_e8957 > 0f));
let _e8984 = select(2f, select(0f, _e8976, (_e8957 < 0f)), (_e8958 > 0f));
let _e8985 = (_e8957 > _e7625);
let _e8989 = ((_e8980 > _e8912) || ((_e8980 == _e8912) && _e8985));
let _e8990 = (_e8984 < _e8917);
let _e8991 = select(_e8912, _e8980, _e8989);
let _e8995 = select(_e8917, _e8984, _e8990);
let _e8999 = select(_e7625, _e8957, _e8985);
let _e9001 = select(_e8923, _e8958, (_e8958 > _e8923));
let _e9008 = global_1.member.member_17.member_1;
let _e9009 = (_e9008 != 0u);
let _e9013 = global_1.member.member_17.member;
let _e9033 = select(-1e6f, (((((_e9013.member.member * _e1206) + (_e9013.member.member_1 * _e1211)) + (_e9013.member.member_2 * _e1200)) + _e9013.member_1) * _e7973), _e9009);
let _e9034 = select(-1e6f, (((((_e9013.member.member * _e8694) + (_e9013.member.member_1 * _e8695)) + (_e9013.member.member_2 * _e8696)) + _e9013.member_1) * _e7973), _e9009);
let _e9039 = global_1.member.member_17.member.member;
let _e9043 = -(_e9033);
let _e9046 = (_e9033 - _e9034);
let _e9047 = (_e9034 - _e9033);
let _e9049 = select(_e9047, _e9046, (_e9046 > _e9047));
let _e9052 = (select(_e9043, _e9033, (_e9033 > _e9043)) / select(1e-30f, _e9049, (_e9049 > 1e-30f)));
let _e9056 = select(0f, select(2f, _e9052, (_e9034 < 0f)), (_e9033 > 0f));
let _e9060 = select(2f, select(0f, _e9052, (_e9033 < 0f)), (_e9034 > 0f));
let _e9061 = (_e9033 > _e8999);
let _e9065 = ((_e9056 > _e8991) || ((_e9056 == _e8991) && _e9061));
let _e9066 = (_e9060 < _e8995);
let _e9067 = select(_e8991, _e9056, _e9065);
let _e9071 = select(_e8995, _e9060, _e9066);
let _e9075 = select(_e8999, _e9033, _e9061);
let _e9077 = select(_e9001, _e9034, (_e9034 > _e9001));
let _e9084 = global_1.member.member_18.member_1;
let _e9085 = (_e9084 != 0u);
let _e9089 = global_1.member.member_18.member;
let _e9109 = select(-1e6f, (((((_e9089.member.member * _e1206) + (_e9089.member.member_1 * _e1211)) + (_e9089.member.member_2 * _e1200)) + _e9089.member_1) * _e7973), _e9085);
let _e9110 = select(-1e6f, (((((_e9089.member.member * _e8694) + (_e9089.member.member_1 * _e8695)) + (_e9089.member.member_2 * _e8696)) + _e9089.member_1) * _e7973), _e9085);
let _e9115 = global_1.member.member_18.member.member;
let _e9119 = -(_e9109);
let _e9122 = (_e9109 - _e9110);
let _e9123 = (_e9110 - _e9109);
let _e9125 = select(_e9123, _e9122, (_e9122 > _e9123));
let _e9128 = (select(_e9119, _e9109, (_e9109 > _e9119)) / select(1e-30f, _e9125, (_e9125 > 1e-30f)));
let _e9132 = select(0f, select(2f, _e9128, (_e9110 < 0f)), (_e9109 > 0f));
let _e9136 = select(2f, select(0f, _e9128, (_e9109 < 0f)), (_e9110 > 0f));
let _e9137 = (_e9109 > _e9075);
let _e9141 = ((_e9132 > _e9067) || ((_e9132 == _e9067) && _e9137));
let _e9142 = (_e9136 < _e9071);
let _e9143 = select(_e9067, _e9132, _e9141);
let _e9147 = select(_e9071, _e9136, _e9142);
let _e9151 = select(_e9075, _e9109, _e9137);
let _e9153 = select(_e9077, _e9110, (_e9110 > _e9077));
let _e9160 = global_1.member.member_19.member_1;
let _e9161 = (_e9160 != 0u);
let _e9165 = global_1.member.member_19.member;
let _e9185 = select(-1e6f, (((((_e9165.member.member * _e1206) + (_e9165.member.member_1 * _e1211)) + (_e9165.member.member_2 * _e1200)) + _e9165.member_1) * _e7973), _e9161);
let _e9186 = select(-1e6f, (((((_e9165.member.member * _e8694) + (_e9165.member.member_1 * _e8695)) + (_e9165.member.member_2 * _e8696)) + _e9165.member_1) * _e7973), _e9161);
let _e9191 = global_1.member.member_19.member.member;
let _e9195 = -(_e9185);
let _e9198 = (_e9185 - _e9186);
let _e9199 = (_e9186 - _e9185);
let _e9201 = select(_e9199, _e9198, (_e9198 > _e9199));
let _e9204 = (select(_e9195, _e9185, (_e9185 > _e9195)) / select(1e-30f, _e9201, (_e9201 > 1e-30f)));
let _e9208 = select(0f, select(2f, _e9204, (_e9186 < 0f)), (_e9185 > 0f));
let _e9212 = select(2f, select(0f, _e9204, (_e9185 < 0f)), (_e9186 > 0f));
let _e9213 = (_e9185 > _e9151);
let _e9217 = ((_e9208 > _e9143) || ((_e9208 == _e9143) && _e9213));
let _e9218 = (_e9212 < _e9147);
phi_19292_ = type_37(select(_e9143, _e9208, _e9217), vec3<f32>(select(select(select(select(_e8913, _e8963.member, _e8989), _e9039.member, _e9065), _e9115.member, _e9141), _e9191.member, _e9217), select(select(select(select(_e8914, _e8963.member_1, _e8989), _e9039.member_1, _e9065), _e9115.member_1, _e9141), _e9191.member_1, _e9217), select(select(select(select(_e8915, _e8963.member_2, _e8989), _e9039.member_2, _e9065), _e9115.member_2, _e9141), _e9191.member_2, _e9217)), select(_e9147, _e9212, _e9218), vec3<f32>(select(select(select(select(_e8918, _e8963.member, _e8990), _e9039.member, _e9066), _e9115.member, _e9142), _e9191.member, _e9218), select(select(select(select(_e8919, _e8963.member_1, _e8990), _e9039.member_1, _e9066), _e9115.member_1, _e9142), _e9191.member_1, _e9218), select(select(select(select(_e8920, _e8963.member_2, _e8990), _e9039.member_2, _e9066), _e9115.member_2, _e9142), _e9191.member_2, _e9218)), select(_e9151, _e9185, _e9213), select(_e9153, _e9186, (_e9186 > _e9153)), vec3<f32>(select(select(select(select(_e8924, _e8963.member, _e8985), _e9039.member, _e9061), _e9115.member, _e9137), _e9191.member, _e9213), select(select(select(select(_e8925, _e8963.member_1, _e8985), _e9039.member_1, _e9061), _e9115.member_1, _e9137), _e9191.member_1, _e9213), select(select(select(select(_e8926, _e8963.member_2, _e8985), _e9039.member_2, _e9061), _e9115.member_2, _e9137), _e9191.member_2, _e9213)));
}
let _e9238 = phi_19292_;
let _e9247 = global_1.member.member_7.member_4;
let _e9250 = (_e4868.member_4.x * _e5603.member_2);
let _e9252 = (_e4868.member_4.y * _e5603.member_2);
let _e9254 = (_e4868.member_4.z * _e5603.member_2);
let _e9255 = (0.5f * (_e8690 * select(1f, (2f * (1f - _e7961)), (_e7953 && _e7952))));
let _e9259 = (_e8673 + (_e9250 * _e9255));
let _e9260 = (_e8674 + (_e9252 * _e9255));
let _e9261 = (_e8675 + (_e9254 * _e9255));
let _e9263 = (2f * _e8687);
let _e9265 = ((_e9261 * _e9261) + (_e9263 * _e9254));
let _e9269 = (_e9261 + sqrt(select(0f, _e9265, (_e9265 > 0f))));
let _e9273 = (select(0.5f, _e9238.member_2, (_e9238.member_2 < 1f)) * (_e9263 / select(1e-6f, _e9269, (_e9269 > 1e-6f))));
let _e9277 = (_e9259 + (_e9250 * _e9273));
let _e9278 = (_e9260 + (_e9252 * _e9273));
let _e9279 = (_e9261 + (_e9254 * _e9273));
let _e9283 = (_e9247 * _e9247);
let _e9285 = (_e9279 * _e9279);
let _e9293 = (((_e9261 <= 0f) || (_e9265 <= 0f)) || ((_e9279 <= 0f) || (_e9285 <= (_e9283 * (((_e9277 * _e9277) + (_e9278 * _e9278)) + _e9285)))));
let _e9307 = (_e8673 + ((_e4868.member_5.x * _e5603.member_2) * _e8687));
let _e9308 = (_e8674 + ((_e4868.member_5.y * _e5603.member_2) * _e8687));
let _e9309 = (_e8675 + ((_e4868.member_5.z * _e5603.member_2) * _e8687));
let _e9311 = (_e9309 * _e9309);
let _e9320 = ((_e5360 & 1u) != 0u);
let _e9325 = (select(_e9293, ((_e9309 <= 0f) || (_e9311 <= (_e9283 * (((_e9307 * _e9307) + (_e9308 * _e9308)) + _e9311)))), _e9320) || (_e8672 && ((_e8648 && _e7953) || (_e7953 && (_e8675 <= 0f)))));
phi_19444_ = vec3<f32>(select(select(select(_e9277, _e9259, _e9293), _e9307, _e9320), _e249, _e9325), select(select(select(_e9278, _e9260, _e9293), _e9308, _e9320), _e260, _e9325), select(select(select(_e9279, _e9261, _e9293), _e9309, _e9320), _e271, _e9325));
phi_19445_ = select(1f, 0f, _e9325);
} else {
phi_19444_ = vec3<f32>(_e249, _e260, _e271);
phi_19445_ = 1f;
}
let _e9332 = phi_19444_;
let _e9334 = phi_19445_;
let _e9336 = (_e7365 * _e9334);
global_4.member[_e206] = (_e217 * (_e7208.member_2.x * _e9336));
global_4.member[_e218] = (_e227 * (_e7208.member_2.y * _e9336));
global_4.member[_e229] = (_e238 * (_e7208.member_2.z * _e9336));
global_4.member[_e240] = _e9332.x;
global_4.member[_e251] = _e9332.y;
global_4.member[_e262] = _e9332.z;
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
